#include "session/membrane/Membranes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>

#include "core/Assert.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "membrane/forces/CoarseVoxels.h"
#include "membrane/forces/Fate.h"
#include "membrane/forces/Limit.h"
#include "membrane/sheet/SheetIndex.h"
#include "membrane/sheet/Simulation.h"
#include "render/kept/KeptVoxels.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

bool isLive(const scene::Cut& cut) { return cut.enabled && scene::isMembrane(cut); }

constexpr double kShareToWatch = 0.6;
/// What becomes of all that is protected is counted by voxels, in larger data by blocks, so many along an edge at most.
constexpr int kFateAlongEdge = 256;
constexpr int kStepsAtOnce = 10;  ///< between two looks at the speed

membrane::ProtectedVoxels protectedVoxels(const membrane::Potential& potential, const scene::Cut& cut,
                                          Progress& progress) {
  return potential.computeProtected(cut.membrane->field, membrane::voxelsInReach(potential, cut), progress);
}

membrane::SideOfPoints sideOf(const scene::Cut& cut, const scene::SheetShape& shape) {
  auto index = std::make_shared<const membrane::SheetIndex>(membrane::makeSheetIndex(shape, glm::ivec2(2), cut.size));
  return [index](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = membrane::isAbove(*index, local[i]) ? 1 : 0;
  };
}

/// What measureMembrane() finds out, without what becomes of what lies far from the sheet.
membrane::KeptWhole measurePairs(const membrane::Potential& potential, const scene::Cut& cut,
                                 const scene::SheetShape& shape, Progress& progress) {
  return membrane::measureKeptWhole(protectedVoxels(potential, cut, progress), cut, sideOf(cut, shape),
                                    membrane::meanDistance(shape), progress);
}

MembraneReport settle(membrane::ForceMaker& maker, int timeStep, scene::Cut& cut, Progress& progress) {
  MembraneReport report;
  report.name = cut.name;
  auto start = Clock::now();
  auto& membrane = *cut.membrane;
  bool isActive = membrane.repositioning == scene::Repositioning::Active && membrane.shape.particles.x > 1;
  scene::SheetShape first;
  if (isActive) {
    first = membrane::carryOver(membrane.shape, cut);
    first = membrane::fitShape(first, first.particles, cut.size);
  }
  bool isSided = membrane.field.rule == scene::KernelRule::Sided;
  membrane::CurrentSheet current;
  if (isActive && isSided) current = {membrane::heightOf(first), membrane.shape.timeStep};
  membrane::Forces forces = maker.compute(cut, current, progress);
  report.kernels = forces.kernels;
  report.kernelsMs = forces.kernelsMs;
  report.leastCutMs = forces.leastCutMs;
  double leastShare = forces.corridor.leastShare;
  membrane::Simulation simulation;
  simulation.begin(cut, std::move(forces), first);
  auto stepping = Clock::now();
  while (simulation.advance(kStepsAtOnce)) progress.report(0.5, "membrane");
  report.steps = simulation.steps();
  report.stepMs = msSince(stepping) / std::max(1, report.steps);
  report.atRest = simulation.isAtRest();
  membrane.shape = simulation.shape();
  if (membrane.repositioning == scene::Repositioning::Active) membrane::anchor(membrane.shape, cut, timeStep);
  // Only where so much must be cut can the sheet cut more than its plane.
  if (leastShare > kShareToWatch) {
    membrane::KeptWhole kept = measurePairs(maker.potential(), cut, membrane.shape, progress);
    if (membrane::isWorseThanFlat(kept, cut)) membrane.shape = membrane::flatShape(cut, membrane.shape.particles);
  }
  report.particles = membrane.shape.particles;
  report.totalMs = msSince(start);
  return report;
}

}  // namespace

Mesh sheetMesh(const scene::Cut& cut) {
  membrane::SheetIndex index = membrane::makeSheetIndex(cut.membrane->shape, cut.membrane->cloth.particles, cut.size);
  glm::dmat4 worldFromLocal = scene::worldFromCut(cut);
  glm::ivec2 n = index.particles;
  Mesh mesh;
  mesh.name = cut.name.empty() ? "membrane" : cut.name;
  std::size_t count = std::size_t(n.x) * std::size_t(n.y);
  for (std::size_t i = 0; i < count; ++i) {
    mesh.positions.emplace_back(worldFromLocal * glm::dvec4(glm::dvec3(index.rows[i]), 1.0));
    mesh.normals.emplace_back(worldFromLocal * glm::dvec4(glm::dvec3(index.rows[count + i]), 0.0));
  }
  for (int y = 0; y + 1 < n.y; ++y)
    for (int x = 0; x + 1 < n.x; ++x) {
      auto a = std::uint32_t(y * n.x + x), b = a + 1, d = a + std::uint32_t(n.x), c = d + 1;
      for (std::uint32_t corner : {a, b, c, a, c, d}) mesh.indices.push_back(corner);
    }
  return mesh;
}

Volume clippedVolume(const scene::Scene& scene, Progress& progress) {
  if (!scene.volume.data) throw ArgumentError("there is no volume to clip");
  const Volume& volume = *scene.volume.data;
  Volume out = volume;
  out.timeSteps = 1;
  std::size_t bytes = timeStepBytes(volume), sample = sampleSize(volume.type) * std::size_t(volume.channels);
  auto first = std::ptrdiff_t(bytes * std::size_t(scene::shownTimeStep(scene.volume)));
  out.voxels.assign(volume.voxels.begin() + first, volume.voxels.begin() + first + std::ptrdiff_t(bytes));
  std::vector<std::uint8_t> kept = render::keptVoxels(scene, volume.dims, volume.worldFromVoxel, progress);
  // A voxel with the smallest value, as raw bytes: colours become black.
  double raw = volume.isColor ? 0.0 : (volume.range.x - volume.offset) / volume.scale;
  std::vector<std::byte> empty(sample);
  visitSamples(out, [&]<class T>(const T*) {
    for (int c = 0; c < out.channels; ++c) {
      T value = T(std::is_integral_v<T> ? std::round(raw) : raw);
      std::memcpy(empty.data() + std::size_t(c) * sizeof(T), &value, sizeof(T));
    }
  });
  VELUM_ASSERT(kept.size() * sample == out.voxels.size(), "each voxel is kept or not");
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (!kept[i]) std::memcpy(out.voxels.data() + i * sample, empty.data(), sample);
  computeRange(out);
  return out;
}

bool hasMembranes(const scene::Scene& scene) { return std::any_of(scene.cuts.begin(), scene.cuts.end(), isLive); }

membrane::KeptWhole measureMembrane(const membrane::Potential& potential, const scene::Cut& cut,
                                    const scene::SheetShape& shape, Progress& progress) {
  membrane::KeptWhole figures = measurePairs(potential, cut, shape, progress);
  // Where it is worse than flat the flat sheet is taken.
  bool isFlat = membrane::isWorseThanFlat(figures, cut);
  figures.fate =
      membrane::measureFate(membrane::coarseVoxels(potential, cut.membrane->field, kFateAlongEdge, progress).grid, cut,
                            isFlat ? membrane::sideOfPlane() : sideOf(cut, shape), progress);
  return figures;
}

std::vector<Advice> adviceFor(const membrane::KeptWhole& figures, const membrane::Potential& potential,
                              const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  return wantsAdvice(figures, cut) ? adviseMembrane(potential, scene, cut, progress) : std::vector<Advice>();
}

std::vector<MembraneReport> settleMembranes(scene::Scene& scene, MembraneQuestions questions, Progress& progress) {
  std::vector<MembraneReport> reports;
  if (!hasMembranes(scene)) return reports;
  membrane::ForceMaker maker(scene);
  for (auto& cut : scene.cuts) {
    if (!isLive(cut)) continue;
    MembraneReport report = settle(maker, scene.volume.timeStep, cut, progress);
    report.cut = cut.id;
    if (maker.potential().dims().x > 0) {
      if (questions.kept || questions.limit)
        report.kept = measureMembrane(maker.potential(), cut, cut.membrane->shape, progress);
      if (report.kept) report.advice = adviceFor(*report.kept, maker.potential(), scene, cut, progress);
      if (report.kept) report.leftOut = maker.potential().computeLeftOut(cut.membrane->field, progress);
      if (questions.limit)
        report.limit = membrane::computeLimit(protectedVoxels(maker.potential(), cut, progress), cut, progress);
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

scene::Scene SheetsOverTime::settle(const scene::Scene& step, Progress& progress) {
  scene::Scene wanted = step;
  wanted.camera = {};  // has no say in how sheets lie
  if (mWanted == wanted) return withShapes(step);
  mWanted = wanted;
  scene::Scene settled = withShapes(step);
  settleMembranes(settled, {}, progress);
  mShapes.clear();
  for (const auto& cut : settled.cuts)
    if (cut.membrane) mShapes[cut.id] = cut.membrane->shape;
  return settled;
}

scene::Scene SheetsOverTime::withShapes(scene::Scene step) const {
  for (auto& cut : step.cuts)
    if (auto known = mShapes.find(cut.id); known != mShapes.end()) cut.membrane->shape = known->second;
  return step;
}

}  // namespace velum::session
