#include "velum/session/Document.h"

#include <utility>

namespace velum::session {

void Document::edit(const std::string& label, const Change& change, bool merge) {
  scene::Scene next = mScene;
  change(next);  // may throw: nothing has changed yet
  if (next == mScene) return;
  bool joins = merge && mMerging && canUndo() && mUndo.back().label == label;
  if (!joins) mUndo.push_back({label, std::move(mScene)});
  if (mUndo.size() > kMaxSteps) mUndo.erase(mUndo.begin());
  mScene = std::move(next);
  mRedo.clear();
  mMerging = merge;
  mModified = true;
  notify();
}

void Document::amend(const Change& change) {
  scene::Scene next = mScene;
  change(next);
  if (next == mScene) return;
  mScene = std::move(next);
  for (auto* steps : {&mUndo, &mRedo})
    for (auto& step : *steps) change(step.scene);
  notify();
}

void Document::step(std::vector<Step>& from, std::vector<Step>& to) {
  if (from.empty()) return;
  Step step = std::move(from.back());
  from.pop_back();
  to.push_back({step.label, std::exchange(mScene, std::move(step.scene))});
  mMerging = false;
  mModified = true;
  notify();
}

void Document::undo() { step(mUndo, mRedo); }
void Document::redo() { step(mRedo, mUndo); }

void Document::replace(scene::Scene scene) {
  mScene = std::move(scene);
  mUndo.clear();
  mRedo.clear();
  mMerging = mModified = false;
  notify();
}

void Document::markSaved() {
  mModified = false;
  notify();
}

}  // namespace velum::session
