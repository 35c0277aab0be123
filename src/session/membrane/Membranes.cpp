#include "session/membrane/Membranes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <type_traits>

#include "core/Assert.h"
#include "core/Error.h"
#include "membrane/forces/CoarseVoxels.h"
#include "membrane/forces/Fate.h"
#include "membrane/sheet/SheetIndex.h"
#include "render/kept/KeptVoxels.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/Rest.h"
#include "session/membrane/MembraneMover.h"

namespace velum::session {

namespace {

bool isLive(const scene::Cut& cut) { return cut.enabled && scene::isMembrane(cut); }

/// What becomes of all that is protected is counted by voxels, in larger data by blocks, so many along an edge at most.
constexpr int kFateAlongEdge = 256;

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
  out.finer.reset();
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

membrane::KeptWhole measureCut(const membrane::Potential& potential, const scene::Cut& cut,
                               const scene::SheetShape& shape, Progress& progress) {
  return membrane::measureKeptWhole(protectedVoxels(potential, cut, progress), cut, sideOf(cut, shape),
                                    membrane::meanDistance(shape), progress);
}

membrane::KeptWhole measureMembrane(membrane::ForceMaker& maker, const scene::Cut& cut, const scene::SheetShape& shape,
                                    Progress& progress) {
  membrane::KeptWhole figures = measureCut(maker.potentialFor(cut, progress), cut, shape, progress);
  // Where it is worse than flat the flat sheet is taken.
  bool isFlat = membrane::isWorseThanFlat(figures, cut);
  figures.fate = membrane::measureFate(
      membrane::coarseVoxels(maker.potential(), cut.membrane->field, kFateAlongEdge, progress).grid, cut,
      isFlat ? membrane::sideOfPlane() : sideOf(cut, shape), progress);
  return figures;
}

std::vector<Advice> adviceFor(const membrane::KeptWhole& figures, const membrane::Potential& potential,
                              const scene::Scene& scene, const scene::Cut& cut, Progress& progress) {
  return wantsAdvice(figures, cut) ? adviseMembrane(potential, scene, cut, progress) : std::vector<Advice>();
}

membrane::KeptWholeLimit limitOf(const membrane::Potential& potential, const scene::Cut& cut, Progress& progress) {
  return membrane::computeLimit(protectedVoxels(potential, cut, progress), cut, progress);
}

std::vector<MembraneReport> settleMembranes(scene::Scene& scene, MembraneQuestions questions, Progress& progress) {
  if (!hasMembranes(scene)) return {};
  scene::completeItems(scene);  // a mover knows them by their ids
  MembraneMover mover(MembraneMover::Purpose::Rest);
  mover.setMeasures(questions.kept || questions.limit);
  mover.follow(scene);
  bringToRest(
      mover, [&] { mover.complete(scene); }, progress);
  scene = mover.withShapes(std::move(scene));
  std::vector<MembraneReport> reports = mover.reports();
  if (questions.limit && scene.volume.data)
    for (MembraneReport& report : reports) report.limit = mover.limit(report.cut, progress);
  return reports;
}

}  // namespace velum::session
