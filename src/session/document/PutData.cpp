#include "session/document/PutData.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/Log.h"
#include "scene/FirstLook.h"
#include "scene/Presets.h"
#include "scene/VisibleFrame.h"
#include "session/document/LabelPlace.h"
#include "session/document/Sources.h"
#include "session/document/StructureShapes.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

/// Of data that is in no file its own.
const std::string& nameOf(const scene::Source& source, const std::string& own) {
  return source.path.empty() ? own : source.path;
}

/// A scan that would hide solid structures is hardly there.
void recede(scene::Scene& scene) {
  auto& labels = scene.labels;
  bool hasSolids = std::any_of(labels.structures.begin(), labels.structures.end(),
                               [](const auto& structure) { return structure.showAs == scene::ShowAs::Solid; });
  if (scene.volume.data && hasSolids && labels.unlabelled == 1.0) labels.unlabelled = scene::kReceded;
}

}  // namespace

void warnAll(const std::string& path, const std::vector<std::string>& warnings) {
  for (const auto& warning : warnings) log::warning(fmt::format("{}: {}", path, warning));
}

void adoptUnit(scene::Scene& scene, LengthUnit unit) {
  if (!scene::hasData(scene) && scene.cuts.empty()) scene.unit = unit;
}

void putVolume(scene::Scene& scene, Volume volume) {
  scene.volume.source.fingerprint = fingerprintOf(scene.volume.source.path);
  warnAll(nameOf(scene.volume.source, volume.name), volume.warnings);
  setLengthUnit(volume, scene.unit);
  scene.volume.data = Shared<Volume>(std::move(volume));
}

void putLabels(scene::Scene& scene, LabelVolume labels, Progress& progress) {
  scene.labels.source.fingerprint = fingerprintOf(scene.labels.source.path);
  warnAll(nameOf(scene.labels.source, labels.name), labels.warnings);
  labels.setLengthUnit(scene.unit);
  scene.labels.data = scene.labels.given = Shared<LabelVolume>(std::move(labels));
  scene.labels.grown.clear();
  scene.labels.unsmoothed = {};
  scene.labels.smoothed.clear();
  scene::completeStructures(scene.labels);
  settleShapes(scene, progress);
  if (std::string line = misplacedLabels(scene); !line.empty())
    warnAll(nameOf(scene.labels.source, scene.labels.data->name), {line});
}

void placeLabels(scene::Scene& scene, Progress& progress) {
  const auto& labels = scene.labels.data;
  if (!labels || scene.labels.source.path.empty() || !scene.labels.growths.empty()) return;
  io::LabelGrid scan = io::gridOf(*scene.volume.data);
  if (labels->dims() != scan.dims || labels->worldFromVoxel() == scan.worldFromVoxel) return;
  if (std::error_code error; !fs::exists(scene.labels.source.path, error)) return;
  putLabels(scene, readLabelsOf(scene, progress), progress);
}

namespace {

/// What follows where a volume has come in.
void firstSeen(scene::Scene& scene, Progress& progress) {
  const Volume& volume = *scene.volume.data;
  if (!(volume.range.x < volume.range.y))
    warnAll(nameOf(scene.volume.source, volume.name), {"every voxel has the same value; there is nothing to see"});
  scene::applyFirstLook(scene);
  scene::completeChannels(scene.volume);
  placeLabels(scene, progress);
  recede(scene);
}

}  // namespace

void takeVolume(scene::Scene& scene, const scene::Source& source, Volume volume, Progress& progress) {
  scene.volume.source = source;
  adoptUnit(scene, volume.lengthUnit);
  putVolume(scene, std::move(volume));
  firstSeen(scene, progress);
}

scene::Scene sceneOf(const Shared<Volume>& volume, Progress& progress) {
  scene::Scene scene;
  scene.unit = volume->lengthUnit;
  scene.volume.data = volume;
  firstSeen(scene, progress);
  seeAll(scene);
  return scene;
}

void takeLabels(scene::Scene& scene, const scene::Source& source, LabelVolume labels, Progress& progress) {
  scene.labels = {};
  scene.labels.source = source;
  adoptUnit(scene, labels.lengthUnit());
  putLabels(scene, std::move(labels), progress);
  scene::applyFirstLook(scene.labels);
  recede(scene);
  settleShapes(scene, progress);
  std::string line = sayBlocks(scene);
  if (line.empty()) return;
  warnAll(nameOf(source, scene.labels.data->name), {line});
  LabelVolume said = *scene.labels.data;
  said.warnings.push_back(line);  // for whoever tells what was opened
  scene.labels.data = scene.labels.given = Shared<LabelVolume>(std::move(said));
}

void seeAll(scene::Scene& scene) {
  scene.camera = scene::firstCamera(scene, 4.0 / 3.0);
  scene::placeSections(scene);
}

}  // namespace velum::session
