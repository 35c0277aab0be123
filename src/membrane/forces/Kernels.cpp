#include "membrane/forces/Kernels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <optional>

#include "core/Assert.h"
#include "core/Parallel.h"
#include "membrane/forces/Denoise.h"
#include "membrane/forces/Pieces.h"
#include "membrane/forces/PotentialSource.h"
#include "membrane/forces/StrengthRows.h"
#include "membrane/forces/TypeGrid.h"
#include "scene/Shown.h"

namespace velum::membrane {

namespace {

constexpr int kCoarsestLevel = 6;

std::size_t nodeCount(glm::ivec3 dims) { return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z); }

/// Super-voxels of a level along each axis.
glm::ivec3 dimsOfLevel(glm::ivec3 dims, int level) { return (dims + ((1 << level) - 1)) >> level; }

/// Adds runs of Size strengths to the sums of a row of super-voxels. The last run may be shorter.
template <int Size>
void addRuns(const float* row, int count, double* sums) {
  int whole = count / Size;
  for (int k = 0; k < whole; ++k) {
    float sum = 0.0f;
    for (int i = 0; i < Size; ++i) sum += row[k * Size + i];
    sums[k] += double(sum);
  }
  for (int i = whole * Size; i < count; ++i) sums[whole] += double(row[i]);
}

using AddRuns = void (*)(const float*, int, double*);
constexpr AddRuns kAddRuns[kCoarsestLevel + 1] = {addRuns<1>,  addRuns<2>,  addRuns<4>, addRuns<8>,
                                                  addRuns<16>, addRuns<32>, addRuns<64>};

/// Voxels that super-voxel `k` of a level holds along an axis.
int heldAlong(int k, int level, int dim) { return std::min(1 << level, dim - (k << level)); }

/// Means of one row of super-voxels.
void averageRow(const StrengthRows& rows, glm::ivec3 dims, int level, int ky, int kz, float* means) {
  VELUM_ASSERT(level >= 0 && level <= kCoarsestLevel, "the level is one of the octree");
  thread_local std::vector<float> row;
  thread_local std::vector<double> sums;
  row.resize(std::size_t(dims.x));
  sums.assign(std::size_t(dimsOfLevel(dims, level).x), 0.0);
  int ny = heldAlong(ky, level, dims.y), nz = heldAlong(kz, level, dims.z);
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y) {
      rows.fill(0, dims.x, (ky << level) + y, (kz << level) + z, row.data());
      kAddRuns[level](row.data(), dims.x, sums.data());
    }
  for (int k = 0; k < int(sums.size()); ++k)
    means[k] = float(sums[std::size_t(k)] / (double(heldAlong(k, level, dims.x)) * ny * nz));
}

/// Calls body(index of the row's first voxel in the box, strengths) for each row of a box, on all cores.
template <class Body>
void forRows(const StrengthRows& rows, VoxelBox box, const Progress& progress, Body body) {
  glm::ivec3 size = box.end - box.min;
  if (size.x <= 0) return;
  parallelFor(0, size.y * size.z, [&](int row) {
    if (progress.isCancelled()) return;
    thread_local std::vector<float> strengths;
    strengths.resize(std::size_t(size.x));
    rows.fill(box.min.x, box.end.x, box.min.y + row % size.y, box.min.z + row / size.y, strengths.data());
    body(std::size_t(row) * std::size_t(size.x), strengths);
  });
  progress.throwIfCancelled();
}

/// The next coarser means, weighted by the voxels that each super-voxel holds.
std::vector<float> coarsen(const std::vector<float>& fine, glm::ivec3 dims, int level) {
  glm::ivec3 from = dimsOfLevel(dims, level), to = dimsOfLevel(dims, level + 1);
  std::vector<float> means(nodeCount(to));
  parallelFor(0, to.z, [&](int z) {
    for (int y = 0; y < to.y; ++y)
      for (int x = 0; x < to.x; ++x) {
        double sum = 0.0, held = 0.0;
        for (int child = 0; child < 8; ++child) {
          glm::ivec3 c = glm::ivec3(x, y, z) * 2 + glm::ivec3(child & 1, child >> 1 & 1, child >> 2);
          if (c.x >= from.x || c.y >= from.y || c.z >= from.z) continue;
          double weight =
              double(heldAlong(c.x, level, dims.x)) * heldAlong(c.y, level, dims.y) * heldAlong(c.z, level, dims.z);
          sum +=
              weight * double(fine[(std::size_t(c.z) * std::size_t(from.y) + std::size_t(c.y)) * std::size_t(from.x) +
                                   std::size_t(c.x)]);
          held += weight;
        }
        means[(std::size_t(z) * std::size_t(to.y) + std::size_t(y)) * std::size_t(to.x) + std::size_t(x)] =
            float(sum / held);
      }
  });
  return means;
}

/// Kernels of means: those weaker than the threshold are left out.
KernelGrid toKernels(std::vector<float> means, glm::ivec3 dims, int level, const glm::dmat4& worldFromVoxel,
                     double threshold) {
  KernelGrid grid;
  grid.dims = dimsOfLevel(dims, level);
  grid.level = level;
  double size = double(1 << level);
  glm::dmat4 voxelFromKernel(size);
  voxelFromKernel[3] = glm::dvec4(glm::dvec3((size - 1.0) * 0.5), 1.0);
  grid.worldFromKernel = worldFromVoxel * voxelFromKernel;
  grid.count = parallelReduce(
      std::size_t(0), means.size(), std::size_t(1) << 16, std::size_t(0),
      [&](std::size_t first, std::size_t end) {
        std::size_t count = 0;
        for (std::size_t i = first; i < end; ++i) {
          bool has = means[i] != 0.0f && std::abs(double(means[i])) >= threshold;
          means[i] = has ? means[i] : 0.0f;
          count += has;
        }
        return count;
      },
      std::plus<>());
  grid.strengths = std::move(means);
  return grid;
}

}  // namespace

struct Potential::Data {
  PotentialSource source;
  // Made when first asked for. Isolated: while a thread waits for its helpers it must not take up a task that wants the
  // same lock.
  struct KnownPieces {
    scene::ForceField field;  ///< what of it they depend on
    std::shared_ptr<const SmallPieces> small;
  };
  static constexpr std::size_t kPiecesKept = 3;  ///< of so many curves: those of a scene's membranes
  mutable std::mutex calmLock, gradientLock, piecesLock, typesLock;
  mutable std::optional<PotentialSource> calm;    ///< the source with its noise taken out
  mutable std::optional<Gradients> gradients[2];  ///< of the source, and of the calm one
  mutable std::vector<KnownPieces> pieces;        ///< that last asked for at the end
  mutable Shared<LabelVolume> types;              ///< of the model

  bool isCalm(const scene::ForceField& field) const { return field.denoise && source.volume; }
  /// What the field's curves are over.
  PotentialSource sourceFor(const scene::ForceField& field, Progress& progress) const {
    PotentialSource of = volumeSourceFor(field, progress);
    if (!field.byType.empty() && source.model.data) of.types = typesOfModel(progress);
    return of;
  }
  const Shared<LabelVolume>& typesOfModel(Progress& progress) const {
    std::lock_guard guard(typesLock);
    if (types) return types;
    progress.report(0.0, "looking where types are dense");
    isolated([&] { types = Shared<LabelVolume>(makeTypeGrid(source.model, source.frame, source.unit)); });
    return types;
  }
  const PotentialSource& volumeSourceFor(const scene::ForceField& field, Progress& progress) const {
    if (!isCalm(field) || (field.byValue.empty() && field.byGradient.empty())) return source;
    std::lock_guard guard(calmLock);
    if (calm) return *calm;
    progress.report(0.0, "taking noise out");
    isolated([&] {
      double noise = noiseOf(*source.volume, source.channel, source.timeStep);
      PotentialSource made = source;
      made.volume = Shared<Volume>(denoise(*source.volume, source.channel, source.timeStep, noise, progress));
      made.channel = made.timeStep = 0;
      calm = made;
    });
    return *calm;
  }
  /// The gradients where a field needs them.
  const Gradients* gradientsFor(const scene::ForceField& field, const PotentialSource& of, Progress& progress) const {
    if (field.byGradient.empty() || !of.volume) return nullptr;
    std::lock_guard guard(gradientLock);
    auto& known = gradients[isCalm(field) ? 1 : 0];
    if (!known) isolated([&] { known = computeGradients(*of.volume, of.channel, of.timeStep, progress); });
    return &*known;
  }
  /// The pieces that are too small to count; null where all count.
  std::shared_ptr<const SmallPieces> smallFor(const scene::ForceField& field, Progress& progress) const {
    if (!source.volume || field.byValue.empty() || field.leastPiece == 0 || field.leastPiece == 1) return nullptr;
    scene::ForceField part;
    part.byValue = field.byValue;
    part.denoise = field.denoise;
    part.leastPiece = field.leastPiece;
    const PotentialSource& of = volumeSourceFor(part, progress);
    std::lock_guard guard(piecesLock);
    auto found = std::find_if(pieces.begin(), pieces.end(), [&](const auto& known) { return known.field == part; });
    if (found != pieces.end()) {
      std::rotate(found, found + 1, pieces.end());
      return pieces.back().small;
    }
    progress.report(0.0, "looking for specks");
    KnownPieces made{part, nullptr};
    StrengthRows rows(of, nullptr, part);
    auto row = [&](int y, int z, float* out) { rows.fillOfVolume(0, of.volume->dims.x, y, z, out); };
    isolated([&] {
      made.small =
          std::make_shared<const SmallPieces>(findSmallPieces(of.volume->dims, part.leastPiece, row, progress));
    });
    if (pieces.size() >= kPiecesKept) pieces.erase(pieces.begin());
    pieces.push_back(std::move(made));
    return pieces.back().small;
  }
  StrengthRows rowsFor(const scene::ForceField& field, Progress& progress) const {
    PotentialSource of = sourceFor(field, progress);
    const Gradients* slopes = gradientsFor(field, of, progress);
    return StrengthRows(std::move(of), slopes, field, smallFor(field, progress));
  }
  void checkBox(VoxelBox box) const {
    if (glm::any(glm::lessThan(box.min, glm::ivec3(0))) || glm::any(glm::greaterThan(box.end, source.dims)) ||
        glm::any(glm::lessThan(box.end, box.min)))
      throw ArgumentError("the box of voxels leaves the volume");
  }
};

Potential::Potential(const scene::Scene& scene) : Potential(sourceOf(scene)) {}
Potential::Potential(PotentialSource source) : mData(std::make_unique<Data>()) { mData->source = std::move(source); }
Potential::~Potential() = default;
Potential::Potential(Potential&&) noexcept = default;
Potential& Potential::operator=(Potential&&) noexcept = default;

bool Potential::matches(const scene::Scene& scene) const {
  PotentialSource other = sourceOf(scene);
  const PotentialSource& own = mData->source;
  bool isSameModel = own.model.data == other.model.data &&
                     (!own.model.data || (own.model.copies == other.model.copies && own.frame == other.frame));
  return own.volume == other.volume && own.labels == other.labels && isSameModel && own.unit == other.unit &&
         own.timeStep == other.timeStep && own.channel == other.channel;
}

bool Potential::holdsModel() const { return membrane::holdsModel(mData->source); }

Shared<LabelVolume> Potential::types(Progress& progress) const {
  return mData->source.model.data ? mData->typesOfModel(progress) : Shared<LabelVolume>();
}
const PotentialSource& Potential::source() const { return mData->source; }
glm::ivec3 Potential::dims() const { return mData->source.dims; }
const Shared<LabelVolume>& Potential::labels() const { return mData->source.labels; }
const glm::dmat4& Potential::worldFromVoxel() const { return mData->source.worldFromVoxel; }

KernelGrid Potential::computeKernels(const scene::ForceField& field, Progress& progress) const {
  return std::move(computeLevels(field, field.level, field.level, progress).front());
}

std::vector<KernelGrid> Potential::computeLevels(const scene::ForceField& field, int finest, int coarsest,
                                                 Progress& progress) const {
  finest = std::clamp(finest, 0, kCoarsestLevel);
  coarsest = std::clamp(coarsest, finest, kCoarsestLevel);
  const PotentialSource& source = mData->source;
  StrengthRows rows = mData->rowsFor(field, progress);
  progress.report(0.0, "evaluating forces");
  glm::ivec3 to = dimsOfLevel(source.dims, finest);
  std::vector<float> means(nodeCount(to));
  parallelFor(0, to.y * to.z, [&](int row) {
    if (progress.isCancelled()) return;
    averageRow(rows, source.dims, finest, row % to.y, row / to.y, means.data() + std::size_t(row) * std::size_t(to.x));
  });
  progress.throwIfCancelled();
  std::vector<KernelGrid> levels;
  for (int level = finest; level <= coarsest; ++level) {
    std::vector<float> next = level < coarsest ? coarsen(means, source.dims, level) : std::vector<float>();
    levels.push_back(toKernels(std::move(means), source.dims, level, source.worldFromVoxel, field.threshold));
    means = std::move(next);
  }
  return levels;
}

std::vector<float> Potential::computeStrengths(const scene::ForceField& field, VoxelBox box, Progress& progress) const {
  mData->checkBox(box);
  StrengthRows rows = mData->rowsFor(field, progress);
  glm::ivec3 size = box.end - box.min;
  std::vector<float> strengths(nodeCount(size));
  forRows(rows, box, progress, [&](std::size_t first, const std::vector<float>& row) {
    std::copy(row.begin(), row.end(), &strengths[first]);
  });
  return strengths;
}

ProtectedVoxels Potential::computeProtected(const scene::ForceField& field, VoxelBox box, Progress& progress) const {
  mData->checkBox(box);
  StrengthRows rows = mData->rowsFor(field, progress);
  ProtectedVoxels voxels{box, std::vector<std::uint8_t>(nodeCount(box.end - box.min)), worldFromVoxel(), {}};
  forRows(rows, box, progress, [&](std::size_t first, const std::vector<float>& row) {
    for (std::size_t x = 0; x < row.size(); ++x) voxels.mask[first + x] = row[x] > 0.0f;
  });
  return voxels;
}

std::vector<std::uint8_t> Potential::computeWeights(const scene::ForceField& field, VoxelBox box, double strongest,
                                                    Progress& progress) const {
  mData->checkBox(box);
  StrengthRows rows = mData->rowsFor(field, progress);
  std::vector<std::uint8_t> weights(nodeCount(box.end - box.min));
  forRows(rows, box, progress, [&](std::size_t first, const std::vector<float>& row) {
    for (std::size_t x = 0; x < row.size(); ++x) weights[first + x] = weightOf(double(row[x]), strongest);
  });
  return weights;
}

LeftOut Potential::computeLeftOut(const scene::ForceField& field, Progress& progress) const {
  auto small = mData->smallFor(field, progress);
  if (!small) return {};
  return {small->least, small->pieces, small->voxels, small->protectedVoxels};
}

}  // namespace velum::membrane
