#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/Shared.h"
#include "scene/Scene.h"

namespace velum::session {

/// A scene with its undo history: the only place where a scene changes. Old scenes are kept whole; voxels and models
/// are shared between them, so a step costs little. One thread.
class Document {
 public:
  using Change = std::function<void(scene::Scene&)>;

  /// How many undo steps are kept; beyond that the oldest is forgotten.
  static constexpr std::size_t kMaxSteps = 200;

  /// The scene: what is saved, undone and journaled.
  const scene::Scene& scene() const { return mScene; }
  /// The scene as it is seen: at the playhead where there is one, else scene() itself. Changes are made to it.
  const scene::Scene& shown() const { return mShown ? *mShown : mScene; }

  /// Where in its film the scene is seen, seconds; nothing: the scene itself is seen. Moving the playhead shows the
  /// scene of another time (scene::sceneAt()) and changes nothing else: it is no step and no change of scene().
  void setPlayhead(std::optional<double> seconds);
  std::optional<double> playhead() const { return mPlayhead; }
  /// Recording: whatever is changed at the playhead becomes a key there, see scene::recorded(). Otherwise a change of a
  /// field that a track sets is seen until the playhead moves, and is then lost; all else goes into the scene.
  void setRecording(bool recording);
  bool isRecording() const { return mRecording && mPlayhead; }

  /// Changes the scene that is shown as one undo step. A change that throws, or that leaves the scene equal, adds no
  /// step.
  /// @param label  what was done, for the Edit menu: "Move cut"
  /// @param merge  joins the step before where that has the same label and merges, too (a drag, a slider), until
  /// endMerge() or another edit comes between; an edit that comes back to where the step began takes the step away
  /// @param command  line of a script that does the same as the step, that is, all joined edits together; empty: the
  /// fields that have changed say it
  void edit(const std::string& label, const Change& change, bool merge = false, const std::string& command = {});
  /// The next merging edit begins a step of its own: a drag is over.
  void endMerge() { mMerging = false; }

  /// Changes the view: camera, layout, crosshair, a section's place. Consecutive changes, however many drags, are one
  /// step named "Move view"; a view that comes back to where it was leaves no step. What was undone can still be
  /// redone, and is then seen from the new view. A change of the view does not count as a modification.
  /// @param change  must set the same whatever else the scene holds: it is also applied to scenes that can be redone
  void view(const Change& change);

  /// Writes down what follows from the scene by itself, such as where a sheet has come to rest, as part of the step
  /// that led there. What was undone can still be redone, a drag goes on, and the change does not count as a
  /// modification.
  void complete(const Change& change);

  /// One step back or forth; does nothing when there is no such step.
  void undo();
  void redo();
  bool canUndo() const { return !mUndo.empty(); }
  bool canRedo() const { return !mRedo.empty(); }
  /// The label of the step that undo() would take back, or redo() would do again; empty when there is none.
  std::string undoLabel() const { return canUndo() ? mUndo.back()->label : std::string(); }
  std::string redoLabel() const { return canRedo() ? mRedo.back()->label : std::string(); }
  /// The labels of all steps that can be undone or redone, the nearest first.
  std::vector<std::string> undoLabels() const { return labelsOf(mUndo); }
  std::vector<std::string> redoLabels() const { return labelsOf(mRedo); }

  /// Takes another scene and forgets the history: a file was opened. @param opening  lines of a script that open the
  /// same
  void replace(scene::Scene scene, std::vector<std::string> opening = {});

  /// Puts everything but the listener back as it was when a copy of this document was made: work that was stopped has
  /// not been done. A copy shares its history's steps, and costs little.
  void restore(Document before);

  /// All that was done since replace(), with the opening, as lines of a script: run again they lead to the same scene,
  /// sheets and growth at rest. For a step without a command there is a line `set FIELD VALUE` for each field, after a
  /// line with the step's name.
  std::vector<std::string> commandLines() const;
  /// The lines of the last step alone; empty when there is none.
  std::vector<std::string> lastCommandLines() const;

  /// True when the scene is not the one of replace() or markSaved(); undoing back to that scene makes this false again.
  /// The view does not count.
  bool isModified() const { return mEdit != mSavedEdit; }
  void markSaved();
  /// Says that the open work is saved nowhere: it was recovered.
  void markModified();
  /// A number that changes with every change of the scene.
  std::uint64_t changeCount() const { return mChangeCount; }

  /// Called after every change, from the thread that made it.
  void setListener(std::function<void()> listener) { mListener = std::move(listener); }

 private:
  /// A step, with the scene on its other side: before it in the undo history, after it among what can be redone.
  struct Step {
    std::string label;
    scene::Scene scene;
    std::uint64_t edit = 0;  ///< names the state of what counts as modified, for isModified()
    bool isView = false;
    std::string command;  ///< as of edit()
  };
  using Steps = std::vector<Shared<Step>>;
  scene::Scene changedBy(const Change& change) const;
  scene::Scene kept(const scene::Scene& next, bool records) const;
  void take(scene::Scene next, scene::Scene seen);
  static std::vector<std::string> labelsOf(const Steps& steps);
  void push(Step step);
  /// The lines of a script that do a step. @param after  the scene to which the step led
  static std::vector<std::string> linesOf(const Step& step, const scene::Scene& after);
  const scene::Scene& sceneAfter(std::size_t place) const;
  void step(Steps& from, Steps& to);
  void moveRedoView(const Change& change);
  void changed();
  void notify() const {
    if (mListener) mListener();
  }

  scene::Scene mScene;
  std::optional<double> mPlayhead;
  bool mRecording = false;
  std::optional<scene::Scene> mShown;  ///< where there is a playhead
  Steps mUndo, mRedo;
  std::vector<std::string> mForgotten;  ///< lines of the opening, and of steps that cannot be undone any more
  std::uint64_t mEdit = 0, mSavedEdit = 0, mLastEdit = 0, mChangeCount = 0;
  bool mMerging = false;
  std::function<void()> mListener;
};

}  // namespace velum::session
