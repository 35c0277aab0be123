#include "session/document/Document.h"

#include <utility>

#include "scene/Navigate.h"
#include "scene/json/Paths.h"
#include "scene/timeline/SceneAt.h"
#include "scene/timeline/Tracks.h"

namespace velum::session {

namespace {
constexpr const char* kMoveView = "Move view";
constexpr const char* kRecordView = "Key view";
}  // namespace

/// The scene that is shown, changed. @throw what the change throws
scene::Scene Document::changedBy(const Change& change) const {
  scene::Scene next = shown();
  change(next);
  scene::completeItems(next);
  return next;
}

/// What of a scene that is to be shown goes into the scene that is saved: all but what tracks say, which becomes keys
/// where changes are recorded.
scene::Scene Document::kept(const scene::Scene& next, bool records) const {
  scene::Scene out = next;
  if (!mShown) return out;
  double orbit = glm::radians(scene::orbitAt(mScene, *mPlayhead));
  auto unturned = [&](scene::Scene scene) {
    if (orbit != 0.0) scene.camera = scene::turntable(scene.camera, -orbit);
    return scene;
  };
  out.camera = next.camera == mShown->camera ? mScene.camera : unturned(next).camera;
  if (next.timeline.orbitDeg == 0.0) out.timeline.orbitDeg = mScene.timeline.orbitDeg;
  if (records) {
    scene::Timeline recorded = scene::recorded(unturned(*mShown), unturned(next), *mPlayhead);
    out.timeline.tracks = std::move(recorded.tracks);
  }
  scene::keepTracked(out, mScene);
  return out;
}

/// Takes over a scene that was changed, and what is seen of it; where its film has changed, that is asked anew.
void Document::take(scene::Scene next, scene::Scene seen) {
  bool isFilmSame = next.timeline == mScene.timeline;
  mScene = std::move(next);
  if (!mPlayhead) return;
  if (isFilmSame)
    mShown = std::move(seen);
  else
    mShown = scene::sceneAt(mScene, *mPlayhead);
}

void Document::setPlayhead(std::optional<double> seconds) {
  if (!seconds && !mPlayhead) return;
  mPlayhead = seconds;
  mShown.reset();
  if (seconds) mShown = scene::sceneAt(mScene, *seconds);
  mMerging = false;
  notify();
}

void Document::setRecording(bool recording) {
  if (recording == mRecording) return;
  mRecording = recording;
  notify();
}

void Document::edit(const std::string& label, const Change& change, bool merge, const std::string& command) {
  scene::Scene seen = changedBy(change);  // may throw: nothing has changed yet
  if (seen == shown()) return;
  scene::Scene next = kept(seen, isRecording());
  if (next == mScene) {  // of a field that a track sets
    mShown = std::move(seen);
    return notify();
  }
  bool joins = merge && mMerging && canUndo() && mUndo.back()->label == label;
  bool isBack = joins && mUndo.back()->scene == next;
  Step step = joins ? *mUndo.back() : Step{label, mScene, mEdit, false, {}};
  step.command = isRecording() ? std::string() : command;
  if (joins) mUndo.pop_back();
  push(std::move(step));
  take(std::move(next), std::move(seen));
  mRedo.clear();
  mMerging = merge && !isBack;
  mEdit = isBack ? mUndo.back()->edit : ++mLastEdit;
  if (isBack) mUndo.pop_back();  // a drag that comes back to where it began leaves no step
  changed();
}

void Document::view(const Change& change) {
  if (isRecording()) return edit(kRecordView, change, true);
  scene::Scene seen = changedBy(change);
  if (seen == shown()) return;
  scene::Scene next = kept(seen, isRecording());
  if (next == mScene) {
    mShown = std::move(seen);
    return notify();
  }
  if (canUndo() && mUndo.back()->isView) {
    if (mUndo.back()->scene == next) mUndo.pop_back();  // back where it was
  } else {
    push({kMoveView, mScene, mEdit, true, {}});
  }
  take(std::move(next), std::move(seen));
  moveRedoView(change);
  mMerging = false;
  changed();
}

void Document::complete(const Change& change) {
  scene::Scene seen = changedBy(change);
  if (seen == shown()) return;
  scene::Scene next = kept(seen, false);
  if (mShown) {
    scene::keepRests(next, mScene);
    mShown = std::move(seen);
  }
  if (next == mScene) return notify();
  mScene = std::move(next);
  changed();
}

/// Takes the view along to what can be redone, up to the next step that is a view itself.
void Document::moveRedoView(const Change& change) {
  while (canRedo() && mRedo.back()->isView) mRedo.pop_back();  // this one is in its place
  for (auto step = mRedo.rbegin(); step != mRedo.rend() && !(*step)->isView; ++step) {
    Step moved = **step;
    change(moved.scene);
    if (mShown) scene::keepTracked(moved.scene, (*step)->scene);
    *step = std::move(moved);
  }
}

void Document::push(Step step) {
  mUndo.push_back(std::move(step));
  if (mUndo.size() <= kMaxSteps) return;
  auto lines = linesOf(*mUndo[0], mUndo[1]->scene);
  mForgotten.insert(mForgotten.end(), lines.begin(), lines.end());
  mUndo.erase(mUndo.begin());
}

std::vector<std::string> Document::linesOf(const Step& step, const scene::Scene& after) {
  if (!step.command.empty()) return {step.command};
  std::vector<std::string> lines{"# " + step.label};
  for (const auto& change : scene::fieldChanges(step.scene, after))
    lines.push_back("set " + change.path + " " + change.value);
  return lines;
}

const scene::Scene& Document::sceneAfter(std::size_t place) const {
  return place + 1 < mUndo.size() ? mUndo[place + 1]->scene : mScene;
}

std::vector<std::string> Document::commandLines() const {
  std::vector<std::string> all = mForgotten;
  for (std::size_t i = 0; i < mUndo.size(); ++i) {
    auto lines = linesOf(*mUndo[i], sceneAfter(i));
    all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

std::vector<std::string> Document::lastCommandLines() const {
  return canUndo() ? linesOf(*mUndo.back(), mScene) : std::vector<std::string>();
}

void Document::step(Steps& from, Steps& to) {
  if (from.empty()) return;
  Step step = *from.back();
  from.pop_back();
  std::swap(mScene, step.scene);
  std::swap(mEdit, step.edit);
  to.emplace_back(std::move(step));
  if (mShown) mShown = scene::sceneAt(mScene, *mPlayhead);
  mMerging = false;
  changed();
}

void Document::undo() { step(mUndo, mRedo); }
void Document::redo() { step(mRedo, mUndo); }

std::vector<std::string> Document::labelsOf(const Steps& steps) {
  std::vector<std::string> labels;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) labels.push_back((*step)->label);
  return labels;
}

void Document::replace(scene::Scene scene, std::vector<std::string> opening) {
  mScene = std::move(scene);
  mForgotten = std::move(opening);
  scene::completeItems(mScene);
  mPlayhead.reset();
  mShown.reset();
  mUndo.clear();
  mRedo.clear();
  mMerging = false;
  mSavedEdit = mEdit = ++mLastEdit;
  changed();
}

void Document::restore(Document before) {
  before.mListener = std::move(mListener);
  before.mChangeCount = mChangeCount;
  *this = std::move(before);
  changed();
}

void Document::markSaved() {
  mSavedEdit = mEdit;
  mMerging = false;  // what comes is a step of its own: undo must be able to come back to what was saved
  notify();
}

void Document::markModified() {
  mSavedEdit = 0;
  mEdit = ++mLastEdit;
  changed();
}

void Document::changed() {
  ++mChangeCount;
  notify();
}

}  // namespace velum::session
