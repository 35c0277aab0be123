#pragma once
#include <QMainWindow>
#include <filesystem>
#include <vector>

#include "gui/cut/CutRoom.h"
#include "gui/look/LookRoom.h"
#include "gui/mark/MarkRoom.h"
#include "gui/model/ModelRoom.h"
#include "gui/structure/StructureRoom.h"
#include "gui/timeline/TimelineRoom.h"
#include "gui/window/FileCommands.h"
#include "gui/window/LostWork.h"
#include "gui/window/PyramidCommands.h"
#include "gui/window/WindowFrame.h"

namespace velum::gui {

class FilmCommands;

/// The window: a session, its views, and the rooms that bring everything else. The window makes the rooms and tells
/// them of every change; what can be done is in the rooms.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow();
  ~MainWindow() override;

  // What command line, scripts and tests do; see the rooms.
  void openPaths(const QStringList& paths, bool add = false) { mLoads->openPaths(paths, add); }
  void openPhantom(const QString& name, int voxels) { mLoads->openPhantom(name, voxels); }
  void openLabels(const QString& path) { mLoads->openLabels(path); }
  /// Shows a scene whose data is in memory. @param name  of the scene
  void showScene(scene::Scene scene, const QString& name);
  void saveSceneTo(const QString& path) { mFiles->saveSceneTo(path); }
  void newScene() { mFiles->newScene(); }
  ExportCommands& exports() { return *mExports; }
  FilmCommands& films() { return *mFilms; }
  /// Stops the load or the picture that is running; what is open stays.
  void cancelJob() { mJobs.cancel(); }
  /// Journals every change from now on, in a folder under this one. @param offers  true: also offers the work that dead
  /// sessions left there
  void protectWork(const std::filesystem::path& root, bool offers = true);
  /// Opens the work that is offered, as a modified scene. @return false when nothing is offered
  bool restoreWork() { return mLost->restore(); }
  /// A script runs: nothing is asked. Unsaved changes are given up; data that is missing is an error.
  void setUnattended(bool unattended) { mLoads->setUnattended(unattended); }
  /// Leaves without asking, whatever is unsaved.
  void leave(int exitCode);
  /// To be called when the system makes the program end: nothing is asked, running work is stopped, and unsaved edits
  /// are offered at the next start.
  void abandon();

  session::Session& session() { return mSession; }
  session::Document& document() { return mSession.document(); }
  ViewGrid& views() { return *mViews; }
  Viewport& viewport() { return mViews->viewport(); }
  MessageBar& messages() { return *mFrame.messages; }
  SideTabs& tabs() { return *mFrame.tabs; }
  ActionTable& actions() { return mActions; }
  Selection& selection() { return mSelection; }
  JobRunner& jobs() { return mJobs; }
  const WindowParts& parts() const { return mParts; }
  Toolbox& toolbox() { return mToolbox; }
  LookCommands& look() { return mLook->commands(); }
  StructureCommands& structures() { return mStructures->commands(); }
  /// Takes up preferences that have changed.
  void takePreferences();
  PyramidCommands& pyramids() { return *mPyramids; }
  AreaMeter& areas() { return mStructures->areas(); }
  ModelRoom& models() { return *mModels; }
  MarkRoom& marks() { return *mMarks; }
  TimelineRoom& timeline() { return *mTimeline; }
  Sketch& sketch() { return mCuts->membranes().sketch(); }

  bool isBusy() const { return mJobs.isBusy(); }
  /// What went wrong in the last job or while saving; empty when nothing did.
  QString lastError() const { return mJobs.lastError(); }
  /// True while the window still looks for the work of dead sessions.
  bool isLookingForWork() const { return mLost->isLooking(); }
  /// Nothing is running, and what is shown is complete.
  bool isSettled() const { return !isBusy() && (!mSession.file().isOpen() || mViews->isComplete()); }

 signals:
  /// A job has ended, was cancelled or has failed.
  void jobEnded();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildRooms();
  void connectRooms();
  void refresh();
  void collect();
  void showViews(bool open);
  void openSecondWindow();

  session::Session mSession;
  Player mPlayer;
  WindowFrame mFrame;
  Selection mSelection;
  ActionTable mActions;
  Toolbox mToolbox;
  ViewGrid* mViews;
  JobRunner mJobs;
  WindowParts mParts;
  // The rooms, which are told of every change in this order.
  std::vector<Room*> mRooms;
  FileLoads* mLoads = nullptr;
  LostWork* mLost = nullptr;
  ExportCommands* mExports = nullptr;
  FilmCommands* mFilms = nullptr;
  CarryCommands* mCarries = nullptr;
  FileCommands* mFiles = nullptr;
  PyramidCommands* mPyramids = nullptr;
  LookRoom* mLook = nullptr;
  StructureRoom* mStructures = nullptr;
  ModelRoom* mModels = nullptr;
  MarkRoom* mMarks = nullptr;
  CutRoom* mCuts = nullptr;
  TimelineRoom* mTimeline = nullptr;
};

}  // namespace velum::gui
