#include "session/document/StructureShapes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/SmoothLabels.h"
#include "scene/Scene.h"
#include "scene/Units.h"

namespace velum::session {

namespace {

/// What the source holds.
const Shared<LabelVolume>& labelsOfFile(const scene::LabelLayer& labels) {
  if (labels.unsmoothed) return labels.unsmoothed;
  bool isGrown = !labels.growths.empty() || !labels.grown.empty();
  return isGrown ? labels.given : labels.data;
}

std::vector<ShapeSmoothing> wantedSmoothing(const scene::LabelLayer& labels) {
  std::vector<ShapeSmoothing> wanted;
  for (const auto& structure : labels.structures)
    if (structure.smoothing > 0.0 && isOfFile(labels, structure.id))
      wanted.push_back({std::uint16_t(structure.id), structure.smoothing});
  return wanted;
}

}  // namespace

bool shapesFit(const scene::Scene& scene) {
  return !labelsOfFile(scene.labels) || wantedSmoothing(scene.labels) == scene.labels.smoothed;
}

void settleShapes(scene::Scene& scene, Progress& progress) {
  if (shapesFit(scene)) return;
  auto& labels = scene.labels;
  Shared<LabelVolume> file = labelsOfFile(labels);
  std::vector<ShapeSmoothing> wanted = wantedSmoothing(labels);
  labels.given = wanted.empty() ? file : Shared<LabelVolume>(smoothLabels(*file, wanted, progress));
  labels.unsmoothed = wanted.empty() ? Shared<LabelVolume>() : file;
  labels.smoothed = std::move(wanted);
  labels.data = labels.given;
  labels.grown.clear();
}

bool takeShapes(scene::Scene& now, const scene::LabelLayer& before, const scene::LabelLayer& settled) {
  auto& labels = now.labels;
  if (!(labelsOfFile(labels) == labelsOfFile(before)) || labels.smoothed != before.smoothed) return false;
  for (auto& structure : labels.structures)
    for (const auto& other : settled.structures)
      if (structure.id == other.id) structure.smoothing = other.smoothing;
  if (settled.smoothed == before.smoothed) return true;
  labels.given = labels.data = settled.given;
  labels.unsmoothed = settled.unsmoothed;
  labels.smoothed = settled.smoothed;
  labels.grown.clear();
  return true;
}

bool isOfFile(const scene::LabelLayer& labels, int id) {
  const Shared<LabelVolume>& file = labelsOfFile(labels);
  return file && !labels.source.path.empty() &&
         std::any_of(file->table.begin(), file->table.end(), [id](const LabelInfo& info) { return info.id == id; });
}

std::string sayBlocks(const scene::Scene& scene) {
  const auto& smoothed = scene.labels.smoothed;
  if (smoothed.empty()) return {};
  double widest = 0.0;
  for (const ShapeSmoothing& one : smoothed) widest = std::max(widest, one.deviation);
  std::string who = fmt::format("{} structures", smoothed.size());
  for (const auto& structure : scene.labels.structures)
    if (smoothed.size() == 1 && structure.id == smoothed[0].id) who = structure.name;
  return fmt::format(
      "{}: made of blocks, as of a coarser grid; shapes are smoothed by {:.3g} {} (smoothing 0: as in the file)", who,
      widest, symbolOf(scene.unit));
}

double widestSmoothing(const scene::Scene& scene) {
  if (!scene.labels.data) return 0.0;
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, glm::length(glm::dvec3(scene.labels.data->worldFromVoxel()[axis])));
  return kWidestSmoothing * longest;
}

}  // namespace velum::session
