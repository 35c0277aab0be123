#include "membrane/forces/Forces.h"

#include <algorithm>
#include <cmath>

#include "core/Clock.h"
#include "core/Parallel.h"
#include "membrane/forces/Attraction.h"
#include "membrane/forces/Corridor.h"
#include "membrane/forces/FinerSource.h"
#include "membrane/forces/FrameBox.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/forces/Limit.h"
#include "membrane/forces/SidedPush.h"
#include "membrane/forces/Stakes.h"

namespace velum::membrane {

namespace {

/// Where more voxels are protected the least cut is looked for on a coarser lattice: a gigabyte.
constexpr double kMostProtected = 48e6;
/// And where something attracts, of which all nodes count, with so many nodes: a quarter of a gigabyte.
constexpr double kMostDrawn = 32e6;
/// Boxes of streamed volumes with more nodes than this are solved in two looks; volumes in memory as they ever were.
constexpr std::size_t kTwoLooks = 1000000;
/// So far the sheet may go from one time step to the next to follow what moves, in mean edges of the rest plane: 10
/// over a heart, whose walls move up to 7 mm in an eighth of a beat; with half of it the sheet lost them.
constexpr double kFollowShare = 1.0 / 16.0;
constexpr int kMostStepsFollowed = 4;

/// Previews look at so many blocks along an edge, and solve so many nodes exactly: some 30 ms.
constexpr int kPreviewAlongEdge = 128;
constexpr std::size_t kPreviewNodes = 30000;
constexpr int kPreviewKernels = 64, kCoarsestKernels = 6;

/// What the kernels depend on, without rule, side and reach.
scene::ForceField kernelPart(scene::ForceField field) {
  field.rule = {};
  field.side = {};
  field.areaOfEffect = {};
  field.kernels.clear();
  field.strokes.clear();
  field.byValueBefore.clear();
  return field;
}

/// What the sides depend on: the frame, what is protected, and the kernels put in to repel. A pin, or a kernel that
/// attracts, is dragged about without another least cut.
scene::Cut sidesPart(const scene::Cut& cut) {
  scene::Cut part;
  part.shape = cut.shape;
  part.membrane.emplace();
  part.centre = cut.centre;
  part.axis = cut.axis;
  part.spinDeg = cut.spinDeg;
  part.size = cut.size;
  part.membrane->field = kernelPart(cut.membrane->field);
  part.membrane->field.side = cut.membrane->field.side;
  part.membrane->field.kernels = cut.membrane->field.kernels;
  std::erase_if(part.membrane->field.kernels, [](const auto& kernel) { return kernel.strength <= 0.0; });
  return part;
}

/// Kernels of previews are so coarse.
int previewLevel(const scene::ForceField& field, glm::ivec3 dims) {
  int level = field.level;
  while (level < kCoarsestKernels && std::max(dims.x, std::max(dims.y, dims.z)) >> level > kPreviewKernels) ++level;
  return level;
}

/// The kernels that can reach the rest plane's box, in a lattice of their own.
PushField cropKernels(const KernelGrid& grid, const scene::Cut& cut) {
  PushField field;
  field.areaOfEffect = cut.membrane->field.areaOfEffect;
  glm::dmat4 kernelFromLocal = glm::inverse(grid.worldFromKernel) * scene::worldFromCut(cut);
  glm::dvec3 middle(kernelFromLocal[3]), half(field.areaOfEffect);
  for (int axis = 0; axis < 3; ++axis) half += glm::abs(glm::dvec3(kernelFromLocal[axis])) * cut.size[axis] * 0.5;
  glm::ivec3 low(glm::clamp(glm::ceil(middle - half), glm::dvec3(0.0), glm::dvec3(grid.dims)));
  glm::ivec3 high(glm::clamp(glm::floor(middle + half) + 1.0, glm::dvec3(low), glm::dvec3(grid.dims)));
  field.dims = high - low;
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(-glm::dvec3(low), 1.0);
  field.kernelFromLocal = shift * kernelFromLocal;
  glm::ivec3 n = field.dims;
  field.strengths.resize(std::size_t(n.x) * std::size_t(n.y) * std::size_t(n.z));
  parallelFor(0, n.z, [&](int z) {
    glm::vec2* to = field.strengths.data() + std::size_t(z) * std::size_t(n.y) * std::size_t(n.x);
    for (int y = 0; y < n.y; ++y) {
      glm::ivec3 at = low + glm::ivec3(0, y, z);
      const float* row = grid.strengths.data() +
                         (std::size_t(at.z) * std::size_t(grid.dims.y) + std::size_t(at.y)) * std::size_t(grid.dims.x);
      for (int x = 0; x < n.x; ++x) *to++ = {0.0f, row[at.x + x]};
    }
  });
  return field;
}

std::vector<PlacedKernel> placeKernels(const scene::Cut& cut) {
  std::vector<PlacedKernel> placed;
  glm::dmat4 localFromWorld = glm::inverse(scene::worldFromCut(cut));
  for (const auto& kernel : cut.membrane->field.kernels) {
    glm::dvec3 centre(localFromWorld * glm::dvec4(kernel.centre, 1.0));
    placed.push_back({centre, std::max(kernel.radius, 1e-6 * meanEdge(cut.size * 0.5)), 0.0, kernel.strength});
  }
  return placed;
}

/// Balls that were put in to repel are protected like the data's own structures.
void protectPlaced(ProtectedVoxels& voxels, const scene::ForceField& field) {
  glm::dmat4 worldFromVoxel = voxels.worldFromVoxel;
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  for (const auto& kernel : field.kernels) {
    if (kernel.strength <= 0.0) continue;
    std::uint8_t weight = weightOf(kernel.strength, strongestOf(field));
    parallelFor(0, size.z, [&](int z) {
      std::size_t i = std::size_t(z) * std::size_t(size.y) * std::size_t(size.x);
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x, ++i) {
          glm::dvec4 voxel(glm::dvec3(voxels.box.min + glm::ivec3(x, y, z)), 1.0);
          if (glm::length(glm::dvec3(worldFromVoxel * voxel) - kernel.centre) >= kernel.radius) continue;
          if (!voxels.mask[i]) voxels.mask[i] = ProtectedVoxels::kPlaced;
          if (!voxels.weight.empty()) voxels.weight[i] = std::max(voxels.weight[i], weight);
        }
    });
  }
}

/// Leads a corridor around a ball, on the side on which its middle lies not, or on which there is room for it.
void passBy(Corridor& corridor, const PlacedKernel& ball, double reach) {
  double radius = ball.halfWidth;
  glm::dvec3 c = ball.centre;
  glm::ivec2 low(glm::ceil((glm::dvec2(c) - radius - corridor.origin) / corridor.step));
  glm::ivec2 high(glm::floor((glm::dvec2(c) + radius - corridor.origin) / corridor.step));
  low = glm::max(low, glm::ivec2(0));
  high = glm::min(high, corridor.dims - 1);
  glm::ivec2 at((glm::dvec2(c) - corridor.origin) / corridor.step + 0.5);
  at = glm::clamp(at, glm::ivec2(0), corridor.dims - 1);
  bool over = c.z <= double(corridor.height[std::size_t(at.y * corridor.dims.x + at.x)]);
  if (over ? c.z + radius > reach && c.z - radius >= -reach : c.z - radius < -reach && c.z + radius <= reach)
    over = !over;
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x) {
      glm::dvec2 away = corridor.origin + glm::dvec2(x, y) * corridor.step - glm::dvec2(c);
      double rest = radius * radius - glm::dot(away, away);
      if (rest <= 0.0) continue;
      auto i = std::size_t(y * corridor.dims.x + x);
      auto face = float(std::clamp(c.z + (over ? 1.0 : -1.0) * std::sqrt(rest), -reach, reach));
      auto past = [&](float z) { return over ? std::max(z, face) : std::min(z, face); };
      corridor.room[i] = {past(corridor.room[i].x), past(corridor.room[i].y)};
      corridor.height[i] = past(corridor.height[i]);
    }
}

std::vector<int> belowSheet(const CutLattice& lattice, const HeightOver& height) {
  std::vector<int> below;
  for (int y = 0; y < lattice.dims.y; ++y)
    for (int x = 0; x < lattice.dims.x; ++x) {
      glm::dvec2 place = glm::dvec2(lattice.origin) + glm::dvec2(x, y) * glm::dvec2(lattice.step);
      double layers = (height(place) - lattice.origin.z) / lattice.step.z;
      below.push_back(std::clamp(int(std::floor(layers)) + 1, 1, std::max(1, lattice.dims.z - 1)));
    }
  return below;
}

}  // namespace

ForceVoxels voxelsOf(const Potential& potential) {
  return {potential.source().level, std::abs(glm::determinant(glm::dmat3(potential.worldFromVoxel())))};
}

/// What makes forces in a box of finer voxels.
struct ForceMaker::Finer {
  FinerBox of;
  ForceMaker maker;
};

ForceMaker::ForceMaker(Potential potential, int timeStep, int timeSteps)
    : mPotential(std::move(potential)), mTimeStep(timeStep), mTimeSteps(timeSteps), mIsFiner(true) {}
ForceMaker::~ForceMaker() = default;

/// Null where the data in memory are the finest.
ForceMaker* ForceMaker::finerFor(const scene::Cut& cut, Progress& progress) {
  std::optional<FinerBox> box = finerBoxOf(mPotential.source(), cut);
  if (!box) return nullptr;
  if (!mFiner || mFiner->of != *box) {
    mFiner.reset();  // the old box goes before the new one comes
    Potential potential(finerSource(mPotential.source(), *box, progress));
    mFiner.reset(new Finer{*box, ForceMaker(std::move(potential), mTimeStep, mTimeSteps)});
  }
  return &mFiner->maker;
}

const Potential& ForceMaker::potentialFor(const scene::Cut& cut, Progress& progress) {
  ForceMaker* finer = finerFor(cut, progress);
  return finer ? finer->mPotential : mPotential;
}

ForceMaker::ForceMaker(const scene::Scene& scene) : mPotential(scene) {
  if (!scene.volume.data) return;
  mTimeSteps = std::max(1, scene.volume.data->timeSteps);
  mTimeStep = std::clamp(scene.volume.timeStep, 0, mTimeSteps - 1);
}

/// The sides of a sheet that is there. From another time step it is looked for near where it was; time may go round.
LeastCut ForceMaker::cutByCurrent(const CutLattice& lattice, const scene::Cut& cut, const CurrentSheet& current,
                                  Progress& progress) const {
  std::vector<int> below = belowSheet(lattice, current.height);
  int apart = current.timeStep < 0 ? 0 : std::abs(mTimeStep - current.timeStep) % mTimeSteps;
  apart = std::min({apart, mTimeSteps - apart, kMostStepsFollowed});
  if (apart == 0) return sheetAt(lattice, std::move(below));
  double follow = kFollowShare * 0.5 * (cut.size.x + cut.size.y) * apart;
  int band = std::max(2, int(std::ceil(follow / lattice.step.z)));
  return computeLeastCutNear(lattice, cut.membrane->field.side, CutMetric::Smooth, below, band, progress);
}

const std::vector<KernelGrid>& ForceMaker::kernelsOf(const scene::ForceField& field, double& ms, Progress& progress) {
  scene::ForceField part = kernelPart(field);
  if (!mField || !(*mField == part)) {
    auto start = Clock::now();
    mKernels = mPotential.computeLevels(part, part.level,
                                        isLarge() ? previewLevel(part, mPotential.dims()) : part.level, progress);
    mField = part;
    ms = msSince(start);
  }
  return mKernels;
}

const ProtectedVoxels& ForceMaker::voxelsOf(const scene::Cut& cut, Progress& progress) {
  scene::Cut asked = sidesPart(cut);
  asked.membrane->field.kernels.clear();
  if (!mVoxelsCut || !(*mVoxelsCut == asked)) {
    mVoxels = mPotential.computeProtected(asked.membrane->field, voxelsInReach(mPotential, cut), progress);
    mVoxelsCut = asked;
  }
  return mVoxels;
}

Corridor ForceMaker::corridorOf(const scene::Cut& cut, const CurrentSheet& current, double& ms, Progress& progress) {
  auto start = Clock::now();
  scene::Cut asked = sidesPart(cut);
  Sides& known = asked.membrane->field.kernels.empty() ? mDataSides : mSides;
  if (!current.height && known.cut && *known.cut == asked) return known.corridor;
  const ProtectedVoxels& data = voxelsOf(cut, progress);
  std::optional<ProtectedVoxels> changed;
  const scene::ForceField& field = asked.membrane->field;
  if (!field.kernels.empty() || !isAlike(field)) {
    changed = data;
    if (!isAlike(field)) changed->weight = mPotential.computeWeights(field, data.box, strongestOf(field), progress);
    protectPlaced(*changed, field);
  }
  const ProtectedVoxels& voxels = changed ? *changed : data;
  auto count = double(voxels.mask.size() - std::size_t(std::count(voxels.mask.begin(), voxels.mask.end(), 0)));
  double coarsening = std::max(1.0, std::ceil(std::cbrt(count / kMostProtected)));
  CutLattice lattice = gatherLattice(voxels, cut, coarsening);
  std::optional<Attraction> attraction;
  if (attracts(field)) {
    glm::dvec3 n(lattice.dims);
    if (n.x * n.y * n.z > kMostDrawn)
      lattice = gatherLattice(voxels, cut, coarsening * std::cbrt(n.x * n.y * n.z / kMostDrawn));
    attraction.emplace(lattice, mPotential.computeStrengths(field, data.box, progress), data, cut);
    if (!attraction->isAnywhere()) attraction.reset();
  }
  auto around = [&](LeastCut least) {
    if (attraction) least = drawnCut(lattice, least, *attraction, progress);
    Corridor corridor = corridorAround(lattice, least);
    std::vector<int> flat(least.below.size(), flatCount(lattice));
    corridor.leastShare = least.cutPairs / std::max(countCutPairs(lattice, flat), 1.0);
    corridor.stakes = stakesOf(voxels, cut, lattice, least, corridor);
    // What stakes say of each voxel need not be said of nodes, which lie up to half a layer off.
    auto off = corridor.stakes.empty() ? 0.0f : float(0.5 * lattice.step.z);
    for (auto& room : corridor.room) room += glm::vec2(-off, off);
    if (attraction) leadTo(corridor, lattice, least, *attraction);
    ms = msSince(start);
    return corridor;
  };
  if (current.height) return around(cutByCurrent(lattice, cut, current, progress));
  bool inTwoLooks = mIsFiner && lattice.layer.size() > kTwoLooks;
  known.corridor = around(inTwoLooks ? computeSmoothNearPairs(lattice, field.side, progress)
                                     : computeCutInBands(lattice, field.side, CutMetric::Smooth, progress));
  known.cut = asked;
  return known.corridor;
}

bool ForceMaker::isLarge() const {
  glm::dvec3 n(mPotential.dims());
  return n.x * n.y * n.z > kLargeVoxels;
}

/// The corridor among blocks of voxels.
Corridor ForceMaker::coarseCorridorOf(const scene::Cut& cut, double& ms, Progress& progress) {
  auto start = Clock::now();
  scene::ForceField part = kernelPart(cut.membrane->field);
  if (!mCoarseField || !(*mCoarseField == part)) {
    mCoarse = coarseVoxels(mPotential, withoutGradients(part), kPreviewAlongEdge, progress);
    mCoarseField = part;
  }
  CutLattice lattice = gatherLattice(mCoarse.grid, cut);
  LeastCut least = computeCutInBands(lattice, cut.membrane->field.side, CutMetric::Smooth, progress, kPreviewNodes);
  Corridor corridor = corridorAround(lattice, least);
  ms = msSince(start);
  return corridor;
}

Forces ForceMaker::kernelForces(const scene::Cut& cut, bool isPreview, Progress& progress) {
  Forces forces;
  forces.isPreview = isPreview;
  forces.voxels = membrane::voxelsOf(mPotential);
  const std::vector<KernelGrid>& kernels = kernelsOf(cut.membrane->field, forces.kernelsMs, progress);
  forces.kernels = kernels.front().count;
  forces.field = cropKernels(isPreview ? kernels.back() : kernels.front(), cut);
  forces.field.placed = placeKernels(cut);
  return forces;
}

Forces ForceMaker::compute(const scene::Cut& cut, const CurrentSheet& current, Progress& progress) {
  ForceMaker* finer = finerFor(cut, progress);
  return (finer ? *finer : *this).computeHere(cut, current, progress);
}

Forces ForceMaker::preview(const scene::Cut& cut, Progress& progress) {
  Forces forces = previewHere(cut, progress);
  if (finerBoxOf(mPotential.source(), cut)) forces.isPreview = true;
  return forces;
}

Forces ForceMaker::computeHere(const scene::Cut& cut, const CurrentSheet& current, Progress& progress) {
  if (mPotential.dims().x == 0) return {};
  Forces forces = kernelForces(cut, false, progress);
  if (cut.membrane->field.rule == scene::KernelRule::Paper) return forces;
  forces.corridor = corridorOf(cut, current, forces.leastCutMs, progress);
  turnToSides(forces.field, forces.corridor);
  return forces;
}

Forces ForceMaker::previewHere(const scene::Cut& cut, Progress& progress) {
  if (mPotential.dims().x == 0 || cut.membrane->field.rule == scene::KernelRule::Paper)
    return computeHere(cut, {}, progress);
  scene::Cut data = cut;
  data.membrane->field.kernels.clear();
  bool isKnown = mDataSides.cut && *mDataSides.cut == sidesPart(data);
  Forces forces = kernelForces(cut, isLarge() && !isKnown, progress);
  forces.corridor = forces.isPreview ? coarseCorridorOf(data, forces.leastCutMs, progress)
                                     : corridorOf(data, {}, forces.leastCutMs, progress);
  for (const auto& kernel : forces.field.placed)
    if (kernel.pull > 0.0) {
      passBy(forces.corridor, kernel, cut.size.z * 0.5);
      forces.corridor.stakes.clear();
      forces.isPreview = true;
    }
  turnToSides(forces.field, forces.corridor);
  return forces;
}

}  // namespace velum::membrane
