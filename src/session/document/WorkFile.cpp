#include "velum/session/document/WorkFile.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "velum/core/Error.h"
#include "velum/session/document/Open.h"

namespace velum::session {

namespace {

bool isSceneFile(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".json";
}

}  // namespace

// Reading.

Loaded readPaths(const std::vector<std::string>& paths, Progress& progress, const DataPolicy& policy) {
  Loaded loaded;
  Opened opened = openAll(paths, progress, policy, &loaded.notes);
  loaded.scene = std::move(opened.scene);
  loaded.path = opened.path;
  loaded.isScene = readSceneText(loaded.path).has_value();
  return loaded;
}

Loaded readBeside(scene::Scene beside, const std::vector<std::string>& paths, Progress& progress) {
  Loaded loaded;
  loaded.scene = std::move(beside);
  addAll(loaded.scene, paths, progress, &loaded.notes);
  return loaded;
}

Loaded readLabels(scene::Scene beside, const std::string& path, Progress& progress) {
  Loaded loaded;
  loaded.scene = std::move(beside);
  scene::Source source;
  source.path = path;
  addLabels(loaded.scene, source, progress);
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

std::string WorkFile::name() const { return std::filesystem::path(mPath).filename().string(); }

void WorkFile::open(Loaded loaded, const std::string& path) {
  mPath = path;
  // Recovered work that was never saved goes by the name of its data.
  const std::string& source = loaded.scene.volume.source.path;
  if (loaded.lost && !std::filesystem::path(path).is_absolute() && !source.empty()) mPath = source;
  mScenePath = isSceneFile(mPath) ? std::filesystem::absolute(mPath).string() : std::string();
  mIsOpen = true;
  replace(std::move(loaded.scene));
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
    now.labels = loaded.scene.labels;
    now.surfaces = loaded.scene.surfaces;
    now.model = loaded.scene.model;
    if (!now.volume.data) now.volume = loaded.scene.volume;
  });
}

void WorkFile::close() {
  mPath.clear();
  mScenePath.clear();
  mIsOpen = false;
  replace({});
}

void WorkFile::save(const std::string& path) {
  saveScene(mDocument.scene(), path);
  mScenePath = mPath = std::filesystem::absolute(path).string();
  mDocument.markSaved();
  discardJournal();
  describe();
}

void WorkFile::replace(scene::Scene scene) {
  discardJournal();
  mIsReplacing = true;
  mDocument.replace(std::move(scene));
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
  if (mIsOpen) mJournal->record(mDocument.scene(), mDocument.undoLabel());
}

void WorkFile::describe() {
  if (mJournal) mJournal->describe(name(), mScenePath);
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
