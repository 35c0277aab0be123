#include "session/document/Document.h"

#include <utility>

#include "scene/json/Paths.h"

namespace velum::session {

namespace {
constexpr const char* kMoveView = "Move view";
}

void Document::edit(const std::string& label, const Change& change, bool merge, const std::string& command) {
  scene::Scene next = mScene;
  change(next);  // may throw: nothing has changed yet
  scene::completeItems(next);
  if (next == mScene) return;
  bool joins = merge && mMerging && canUndo() && mUndo.back().label == label;
  bool isBack = joins && mUndo.back().scene == next;
  if (!joins) push({label, std::move(mScene), mEdit, false, {}});
  mUndo.back().command = command;
  mScene = std::move(next);
  mRedo.clear();
  mMerging = merge && !isBack;
  mEdit = isBack ? mUndo.back().edit : ++mLastEdit;
  if (isBack) mUndo.pop_back();  // a drag that comes back to where it began leaves no step
  changed();
}

void Document::view(const Change& change) {
  scene::Scene next = mScene;
  change(next);
  if (next == mScene) return;
  if (canUndo() && mUndo.back().isView) {
    if (mUndo.back().scene == next) mUndo.pop_back();  // back where it was
  } else {
    push({kMoveView, std::move(mScene), mEdit, true, {}});
  }
  mScene = std::move(next);
  moveRedoView(change);
  mMerging = false;
  changed();
}

void Document::complete(const Change& change) {
  scene::Scene next = mScene;
  change(next);
  scene::completeItems(next);
  if (next == mScene) return;
  mScene = std::move(next);
  changed();
}

/// Takes the view along to what can be redone, up to the next step that is a view itself.
void Document::moveRedoView(const Change& change) {
  while (canRedo() && mRedo.back().isView) mRedo.pop_back();  // this one is in its place
  for (auto step = mRedo.rbegin(); step != mRedo.rend() && !step->isView; ++step) change(step->scene);
}

void Document::push(Step step) {
  mUndo.push_back(std::move(step));
  if (mUndo.size() <= kMaxSteps) return;
  auto lines = linesOf(mUndo[0], mUndo[1].scene);
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
  return place + 1 < mUndo.size() ? mUndo[place + 1].scene : mScene;
}

std::vector<std::string> Document::commandLines() const {
  std::vector<std::string> all = mForgotten;
  for (std::size_t i = 0; i < mUndo.size(); ++i) {
    auto lines = linesOf(mUndo[i], sceneAfter(i));
    all.insert(all.end(), lines.begin(), lines.end());
  }
  return all;
}

std::vector<std::string> Document::lastCommandLines() const {
  return canUndo() ? linesOf(mUndo.back(), mScene) : std::vector<std::string>();
}

void Document::step(std::vector<Step>& from, std::vector<Step>& to) {
  if (from.empty()) return;
  Step step = std::move(from.back());
  from.pop_back();
  to.push_back({step.label, std::exchange(mScene, std::move(step.scene)), std::exchange(mEdit, step.edit), step.isView,
                step.command});
  mMerging = false;
  changed();
}

void Document::undo() { step(mUndo, mRedo); }
void Document::redo() { step(mRedo, mUndo); }

std::vector<std::string> Document::labelsOf(const std::vector<Step>& steps) {
  std::vector<std::string> labels;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step) labels.push_back(step->label);
  return labels;
}

void Document::replace(scene::Scene scene, std::vector<std::string> opening) {
  mScene = std::move(scene);
  mForgotten = std::move(opening);
  scene::completeItems(mScene);
  mUndo.clear();
  mRedo.clear();
  mMerging = false;
  mSavedEdit = mEdit = ++mLastEdit;
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
