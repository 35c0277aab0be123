#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/Scene.h"

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
  ///               endMerge() or another edit comes between; one that comes back to where the step began takes it away
  /// @param command  line of a script that does the same, and, where edits join, what all of them do; empty: the fields
  ///                 that have changed say it
  void edit(const std::string& label, const Change& change, bool merge = false, const std::string& command = {});
  /// The next merging edit begins a step of its own: a drag is over.
  void endMerge() { mMerging = false; }

  /// Changes the view: camera, layout, crosshair, a section's place. Consecutive changes, however many drags, are one
  /// step named "Move view"; a view that comes back to where it was leaves none. What was undone can still be redone,
  /// and is then seen from the new view. It does not count as a modification.
  /// @param change  must set the same whatever else the scene holds
  void view(const Change& change);

  /// Writes down what follows from the scene by itself, such as where a sheet has come to rest: part of the step that
  /// led to it. What was undone can still be redone, a drag goes on, and it does not count as a modification.
  void complete(const Change& change);

  /// One step back or forth; nothing when there is none.
  void undo();
  void redo();
  bool canUndo() const { return !mUndo.empty(); }
  bool canRedo() const { return !mRedo.empty(); }
  /// What undo() would take back, redo() would do again; empty when there is nothing.
  std::string undoLabel() const { return canUndo() ? mUndo.back().label : std::string(); }
  std::string redoLabel() const { return canRedo() ? mRedo.back().label : std::string(); }
  /// All of them, the nearest first.
  std::vector<std::string> undoLabels() const { return labelsOf(mUndo); }
  std::vector<std::string> redoLabels() const { return labelsOf(mRedo); }

  /// Takes another scene and forgets the history: a file was opened.
  /// @param opening  lines of a script that do the same
  void replace(scene::Scene scene, std::vector<std::string> opening = {});

  /// All that was done since, as lines of a script: run again they lead to the same scene, sheets and growth at rest.
  /// Of steps without a command there is a line `set FIELD VALUE` for each field, after one with the step's name.
  std::vector<std::string> commandLines() const;
  /// The same of the last step alone; empty when there is none.
  std::vector<std::string> lastCommandLines() const;

  /// True when the scene is not the one of replace() or markSaved(); undoing to that one makes it false again. The view
  /// does not count.
  bool isModified() const { return mEdit != mSavedEdit; }
  void markSaved();
  /// What is open is work that is saved nowhere: it was recovered.
  void markModified();
  /// Another number after every change of the scene.
  std::uint64_t changeCount() const { return mChangeCount; }

  /// Called after every change, from the thread that made it.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }

 private:
  /// The scene on the other side of a step.
  struct Step {
    std::string label;
    scene::Scene scene;
    std::uint64_t edit = 0;  ///< names the state of what counts as modified
    bool isView = false;
    std::string command;  ///< as of edit()
  };
  static std::vector<std::string> labelsOf(const std::vector<Step>& steps);
  void push(Step step);
  /// The lines of a step. @param after  the scene that it led to
  static std::vector<std::string> linesOf(const Step& step, const scene::Scene& after);
  const scene::Scene& sceneAfter(std::size_t place) const;
  void step(std::vector<Step>& from, std::vector<Step>& to);
  void moveRedoView(const Change& change);
  void changed();
  void notify() const {
    if (mListener) mListener();
  }

  scene::Scene mScene;
  std::vector<Step> mUndo, mRedo;
  std::vector<std::string> mForgotten;  ///< Lines of the opening, and of steps that cannot be undone any more.
  std::uint64_t mEdit = 0, mSavedEdit = 0, mLastEdit = 0, mChangeCount = 0;
  bool mMerging = false;
  std::function<void()> mListener;
};

}  // namespace velum::session
