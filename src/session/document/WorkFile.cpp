#include "session/document/WorkFile.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/BrickCache.h"
#include "core/Error.h"
#include "io/kinds/FileKind.h"
#include "scene/Presets.h"
#include "scene/Units.h"
#include "scene/json/Paths.h"
#include "scene/timeline/SceneAt.h"
#include "session/document/Open.h"

namespace velum::session {

namespace {

/// A line of a script that opens a source as it was opened. @param verb  open, add
std::string lineOf(const char* verb, const scene::Source& source, const std::string& options = {}) {
  std::string line = verb;
  if (!source.series.empty()) line += " series=" + source.series;
  scene::Scene plain, as;
  as.volume.source = source;
  for (const auto& [path, value] : scene::fieldChanges(plain, as)) {
    std::string name = path.substr(path.rfind("source.") + 7);
    if (name.starts_with("raw.") || name == "spacing" || name == "level") line += " " + name + "=" + value;
  }
  return line + options + " " + std::filesystem::absolute(source.path).lexically_normal().string();
}

/// What opens a scene that has come from no scene file, as lines of a script.
std::vector<std::string> openingOf(const scene::Scene& scene, bool isRecovered) {
  std::vector<std::string> lines;
  auto add = [&](const scene::Source& source, const char* options) {
    if (!source.path.empty()) lines.push_back(lineOf(lines.empty() ? "open" : "add", source, options));
  };
  add(scene.volume.source, "");
  add(scene.labels.source, lines.empty() ? "" : " asLabels=true");
  add(scene.model.source, "");
  for (const auto& surface : scene.surfaces) add(surface.source, "");
  if (scene.volume.data && scene.volume.source.path.empty()) lines.push_back("# the volume is in no file");
  scene::Scene fresh;
  if (!isRecovered) {
    // The rest is how data is first shown.
    fresh = scene;
    fresh.camera = {};
    fresh.sections = {};
    scene::placeSections(fresh);
  }
  for (const auto& [path, value] : scene::fieldChanges(fresh, scene))
    if (path.find("source.") == std::string::npos) lines.push_back("set " + path + " " + value);
  return lines;
}

/// True for other levels of the same data, or the same data in another file, such as a pyramid that was made of it.
bool isSameData(const Volume& before, const scene::Source& was, const Volume& now, const scene::Source& source) {
  bool isAlike = finestDims(now) == finestDims(before) && now.type == before.type && now.channels == before.channels &&
                 now.timeSteps == before.timeSteps && now.isColor == before.isColor;
  if (source.path == was.path) {
    scene::Source otherwise = was;
    otherwise.level = source.level;
    otherwise.fingerprint = source.fingerprint;
    return otherwise == source && now.type == before.type && now.channels == before.channels;
  }
  // Means of blocks have less range than the voxels have.
  double shared = std::min(now.range.y, before.range.y) - std::max(now.range.x, before.range.x);
  return isAlike && shared > 0.5 * std::max(now.range.y - now.range.x, before.range.y - before.range.x);
}

constexpr double kEven = 1e-9;  ///< Shares by which edges may grow differently and still be said to grow alike.

}  // namespace

// Reading.

Loaded read(const std::vector<scene::Source>& sources, Progress& progress, const DataPolicy& policy) {
  Loaded loaded;
  Opened opened = openAll(sources, progress, policy, &loaded.notes);
  loaded.scene = std::move(opened.scene);
  loaded.path = opened.path;
  loaded.isScene = io::holdsScene(io::kindOf(loaded.path));
  return loaded;
}

Loaded readPaths(const std::vector<std::string>& paths, Progress& progress, const DataPolicy& policy) {
  return read(sourcesOf(paths), progress, policy);
}

void rereadVolume(scene::Scene& scene, const scene::Source& source, Progress& progress) {
  if (!scene.volume.data) throw ArgumentError("there is no volume to read anew");
  Shared<Volume> before = scene.volume.given ? scene.volume.given : scene.volume.data;
  glm::dvec3 ratio = glm::all(glm::greaterThan(source.spacing, glm::dvec3(0))) ? source.spacing / finestSpacing(*before)
                                                                               : glm::dvec3(1.0);
  double factor = std::cbrt(ratio.x * ratio.y * ratio.z);
  bool isEven = glm::all(glm::lessThan(glm::abs(ratio / factor - 1.0), glm::dvec3(kEven)));
  if (!scene.labels.growths.empty() && (!isEven || !(source.raw == scene.volume.source.raw)))
    throw ArgumentError("structures were grown in this volume and would lie elsewhere; remove them first");
  scene::scaleLengths(scene, factor);
  scene::scaleKeys(scene, factor);
  bool sharesGrid = scene.labels.data && scene.labels.data->dims() == before->dims &&
                    scene.labels.data->worldFromVoxel() == before->worldFromVoxel;
  scene::Source was = std::exchange(scene.volume.source, source);
  scene.volume.data = scene.volume.given = {};
  if (sharesGrid && !scene.labels.source.path.empty()) {
    scene.labels.source.spacing = source.spacing;
    scene.labels.data = scene.labels.given = scene.labels.unsmoothed = {};
    scene.labels.smoothed.clear();
  }
  loadData(scene, {}, progress, {}, nullptr);
  const Volume& now = *scene.volume.data;
  if (now.dims == before->dims && now.type == before->type && now.range == before->range) return;
  if (isSameData(*before, was, now, source)) return scene::placeSections(scene);
  scene.volume.channel = scene.volume.timeStep = 0;
  scene.volume.channels.clear();
  scene::applyPreset(scene, scene::choosePreset(now));
  scene::completeChannels(scene.volume);
  scene::placeSections(scene);
}

Loaded readBeside(scene::Scene beside, const std::vector<std::string>& paths, Progress& progress,
                  const DataPolicy& policy) {
  Loaded loaded;
  loaded.scene = std::move(beside);
  addAll(loaded.scene, paths, progress, &loaded.notes, policy);
  return loaded;
}

Loaded readLabels(scene::Scene beside, const scene::Source& source, Progress& progress) {
  Loaded loaded;
  loaded.scene = std::move(beside);
  addLabels(loaded.scene, foundInStore(source), progress);
  return loaded;
}

Loaded readPhantom(const std::string& name, int voxels, const std::filesystem::path& folder, Progress& progress) {
  Loaded loaded;
  loaded.scene = openSample(name, voxels, folder, progress);
  return loaded;
}

Loaded readLost(const std::filesystem::path& folder, Progress& progress, const DataPolicy& policy) {
  Loaded loaded;
  loaded.lost = std::make_unique<WorkClaim>(folder);
  loaded.scene = loaded.lost->readScene();
  loadData(loaded.scene, {}, progress, policy, &loaded.notes);
  return loaded;
}

void readMissing(Loaded& loaded, Progress& progress, const DataPolicy& policy) {
  loadData(loaded.scene, {}, progress, policy, &loaded.notes);
  scene::placeSections(loaded.scene);
}

// What is open.

bool WorkFile::isCarried() const { return mName.ownVolume && mDocument.scene().volume.source.path != *mName.ownVolume; }

std::string WorkFile::path() const { return isCarried() ? mDocument.scene().volume.source.path : mName.path; }

std::string WorkFile::name() const { return std::filesystem::path(path()).filename().string(); }

void WorkFile::open(Loaded loaded, const std::string& path) {
  mName.ownVolume.reset();
  mName.path = path;
  // Recovered work that was never saved goes by the name of its data.
  const std::string& source = loaded.scene.volume.source.path;
  if (loaded.lost && !std::filesystem::path(path).is_absolute() && !source.empty()) mName.path = source;
  mName.scenePath =
      io::kindOf(mName.path) == io::FileKind::Scene ? std::filesystem::absolute(mName.path).string() : std::string();
  mName.isOpen = true;
  bool isSceneFile = io::holdsScene(io::kindOf(mName.path)) && !loaded.lost;
  std::vector<std::string> opening =
      isSceneFile
          ? std::vector<std::string>{"open " + std::filesystem::absolute(mName.path).lexically_normal().string()}
          : openingOf(loaded.scene, bool(loaded.lost));
  replace(std::move(loaded.scene), std::move(opening));
  if (!loaded.lost) return;
  // Only when it is safe in the new journal may the old one go; until then it is offered again should this one be lost.
  mDocument.markModified();
  mLost = std::move(loaded.lost);
  if (mJournal && mJournal->flush()) dropLost();
}

/// What was recovered is safe, or given up.
void WorkFile::dropLost() {
  try {
    if (mLost) mLost->remove();
  } catch (const InputError&) {
    // It is offered again.
  }
  mLost.reset();
}

void WorkFile::add(const Loaded& loaded) {
  mDocument.edit("Add data", [&](scene::Scene& now) {
    const scene::Scene& read = loaded.scene;
    bool hasOtherLabels = !now.labels.data || !(read.labels.source == now.labels.source);
    if (read.labels.data && hasOtherLabels) now.labels = read.labels;
    if (read.model.data && read.model.data != now.model.data) now.model = read.model;
    for (const scene::Surface& surface : read.surfaces) {
      auto isIt = [&](const scene::Surface& other) { return other.data == surface.data; };
      if (std::none_of(now.surfaces.begin(), now.surfaces.end(), isIt)) now.surfaces.push_back(surface);
    }
    if (!now.volume.data) now.volume = read.volume;
  });
}

void WorkFile::carry(scene::Scene scene, const std::string& command) {
  if (!mName.ownVolume) mName.ownVolume = mDocument.scene().volume.source.path;
  std::optional<double> playhead = mDocument.playhead();
  // Nothing of it is a key, and no track keeps what it was.
  mDocument.setPlayhead({});
  mDocument.edit(
      "Carry over to other data", [&](scene::Scene& now) { now = std::move(scene); }, false, command);
  mDocument.setPlayhead(playhead);
  describe();
}

void WorkFile::close() {
  mName = {};
  replace({});
}

void WorkFile::restore(Before before) {
  mLost.reset();  // recovered work is offered again
  mName = std::move(before.name);
  mDocument.restore(std::move(before.document));
  describe();
}

void WorkFile::save(const std::string& path) {
  saveScene(mDocument.scene(), path);
  mName.scenePath = mName.path = std::filesystem::absolute(path).string();
  if (mName.ownVolume) mName.ownVolume = mDocument.scene().volume.source.path;
  mDocument.markSaved();
  discardJournal();
  describe();
}

void WorkFile::replace(scene::Scene scene, std::vector<std::string> opening) {
  discardJournal();
  mIsReplacing = true;
  mDocument.replace(std::move(scene), std::move(opening));
  mIsReplacing = false;
  mJournaledChange = mDocument.changeCount();
  describe();
}

// The journal.

void WorkFile::protect(const std::filesystem::path& root, std::function<void(const std::string&)> onError) {
  mRecoveryRoot = root;
  mJournal = std::make_unique<Journal>(Journal::Options{root});
  mJournaledChange = mDocument.changeCount();
  mJournal->setErrorListener(std::move(onError));
}

void WorkFile::journalChange() {
  if (!mJournal || mIsReplacing || mDocument.changeCount() == mJournaledChange) return;
  mJournaledChange = mDocument.changeCount();
  if (mName.isOpen) mJournal->record(mDocument.scene(), mDocument.undoLabel());
}

void WorkFile::describe() {
  if (mJournal) mJournal->describe(name(), scenePath());
}

void WorkFile::flushJournal() {
  if (mJournal) mJournal->flush();
}

void WorkFile::discardJournal(bool flush) {
  dropLost();
  if (!mJournal) return;
  mJournal->discard();
  if (flush) mJournal->flush();
}

}  // namespace velum::session
