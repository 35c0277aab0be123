#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "velum/scene/Scene.h"

namespace velum::session {

/// A scene with its undo history: the only place where a scene changes. Old scenes are kept whole; voxels and models
/// are shared between them, so a step costs little. One thread.
class Document {
 public:
  using Change = std::function<void(scene::Scene&)>;

  /// Undo steps that are kept; the oldest is forgotten.
  static constexpr std::size_t kMaxSteps = 200;

  const scene::Scene& scene() const { return mScene; }

  /// Changes the scene as one undo step. A change that throws, or that leaves the scene equal, adds nothing.
  /// @param label  what was done, for the Edit menu: "Move cut"
  /// @param merge  joins the step before where that has the same label and merges, too (a drag, a slider), until
  ///               endMerge() or another edit comes between
  void edit(const std::string& label, const Change& change, bool merge = false);
  /// The next merging edit begins a step of its own: a drag is over.
  void endMerge() { mMerging = false; }

  /// Changes the scene without an undo step (the camera). It holds for the whole history: undo does not take it back.
  /// @param change  must set the same whatever else the scene holds
  void amend(const Change& change);

  /// One step back or forth; nothing when there is none.
  void undo();
  void redo();
  bool canUndo() const { return !mUndo.empty(); }
  bool canRedo() const { return !mRedo.empty(); }
  /// What undo() would take back, redo() would do again; empty when there is nothing.
  std::string undoLabel() const { return canUndo() ? mUndo.back().label : std::string(); }
  std::string redoLabel() const { return canRedo() ? mRedo.back().label : std::string(); }

  /// Takes another scene and forgets the history: a file was opened.
  void replace(scene::Scene scene);

  /// True when edits have been made since replace() or markSaved(); the camera does not count.
  bool isModified() const { return mModified; }
  void markSaved();

  /// Called after every change, from the thread that made it.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }

 private:
  /// The scene on the other side of a step.
  struct Step {
    std::string label;
    scene::Scene scene;
  };
  void step(std::vector<Step>& from, std::vector<Step>& to);
  void notify() const {
    if (mListener) mListener();
  }

  scene::Scene mScene;
  std::vector<Step> mUndo, mRedo;
  bool mMerging = false;
  bool mModified = false;
  std::function<void()> mListener;
};

}  // namespace velum::session
