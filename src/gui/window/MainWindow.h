#pragma once
#include <QActionGroup>
#include <QMainWindow>
#include <QStackedWidget>
#include <QTabWidget>
#include <filesystem>
#include <functional>
#include <memory>

#include "kit/ActionTable.h"
#include "kit/Bars.h"
#include "kit/Job.h"
#include "kit/Selection.h"
#include "velum/session/document/Document.h"
#include "velum/session/document/Journal.h"
#include "velum/session/document/Recovery.h"
#include "velum/session/document/Sources.h"
#include "velum/session/picture/Picture.h"
#include "view/ViewGrid.h"

namespace velum::gui {

class CutPanel;
class LookCommands;
class HelpWindow;
class LookPanel;
class ProtectTool;
class SheetTool;
class RecentRow;
class RecoveryBar;
class SketchTool;
class StructureCommands;
class StructurePanel;
class ThreePointTool;
class TimeBar;

/// The window: the 3D view, the side panel, the bars, and the actions. Everything it does to the scene goes through the
/// document; everything long goes through a job.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  MainWindow();
  ~MainWindow() override;

  /// Reads files or folders in the background. @param add  beside what is open, instead of in its place
  void openPaths(const QStringList& paths, bool add = false);
  void openPhantom(const QString& name, int voxels);
  /// Shows a scene whose data is in memory. @param name  what it is called
  void showScene(scene::Scene scene, const QString& name);
  void savePictureTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene);
  void saveSceneTo(const QString& path);
  /// The sheet of the selected membrane, or of the first, as it rests; the volume without what the cuts take away.
  void exportSheetTo(const QString& path);
  void exportClippedTo(const QString& path);
  /// Stops the load or the picture that is running; what is open stays.
  void cancelJob();
  /// Back to the empty window.
  void newScene();

  /// Journals every change from now on, in a folder under this one. @param offers  what dead sessions left there, too
  void protectWork(const std::filesystem::path& root, bool offers = true);
  /// Opens the work that is offered, as modified. False when nothing is offered.
  bool restoreWork();
  /// A script runs: nothing is asked. Unsaved changes are given up; data that is missing is an error.
  void setUnattended(bool unattended) { mUnattended = unattended; }
  /// Leaves without asking, whatever is unsaved.
  void leave(int exitCode);

  session::Document& document() { return mDocument; }
  ViewGrid& views() { return *mViews; }
  Viewport& viewport() { return mViews->viewport(); }
  LookCommands& look() { return *mLookCommands; }
  MessageBar& messages() { return *mMessages; }
  ActionTable& actions() { return *mActions; }
  Selection& selection() { return *mSelection; }
  SketchTool& sketch() { return *mSketch; }
  StructureCommands& structures() { return *mStructureCommands; }
  ThreePointTool& threePoints() { return *mThreePoints; }
  /// Reads a file as labels of what is open, whatever it looks like.
  void openLabels(const QString& path);
  bool isBusy() const { return mJob != nullptr; }
  /// What went wrong in the last job or while saving; empty when nothing did.
  QString lastError() const { return mLastError; }
  /// Dead sessions' work is still being looked for.
  bool isLookingForWork() const { return mScan != nullptr; }
  /// Nothing is running, and what is shown is complete.
  bool isSettled() const { return !isBusy() && (mPages->currentIndex() == 0 || mViews->isComplete()); }

 signals:
  /// A job has ended, was cancelled or has failed.
  void jobEnded();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void closeEvent(QCloseEvent* event) override;

 private:
  void buildCentre();
  void buildPanel();
  void buildActions();
  void buildFileActions(QMenu* menu, QToolBar* bar);
  void buildEditActions(QMenu* menu, QToolBar* bar);
  void buildViewActions(QMenu* menu, QToolBar* bar);
  void buildCutActions(QMenu* menu, QToolBar* bar);
  void buildStructures();
  void buildMembrane();
  void buildSketch();
  void buildHands();
  void buildExportActions(QMenu* menu);
  void buildStructureActions(QMenu* menu);
  void buildLayoutActions(QMenu* menu, QToolBar* bar);
  void buildTimeActions(QMenu* menu);
  void buildHelpActions(QMenu* menu);
  void addTab(QWidget* panel, const QString& title, const QString& tip);
  void buildStatus();
  void startJob(const QString& what, Job::Work work, std::function<void()> whenDone);
  /// What a load gives.
  struct Loaded {
    scene::Scene scene;
    bool isScene = false;                      ///< camera and layout are its own
    std::vector<std::string> notes;            ///< for the user
    std::unique_ptr<session::WorkClaim> lost;  ///< recovered work, until it is journaled anew
  };
  void startLoad(const QString& what, std::function<void(Loaded&, Progress&)> read, bool add, const QString& path);
  void finishLoad(std::shared_ptr<Loaded> loaded, bool add, const QString& path);
  bool locateMissing(Loaded& loaded);
  void takeScene(Loaded& loaded, bool add, QString path);
  void replaceScene(scene::Scene scene, const QString& path);
  session::DataPolicy dataPolicy() const;
  // The document: what is asked, journaled, remembered (MainWindowDocument.cpp).
  bool mayLeaveScene();
  void openAsked(const QStringList& paths, bool add = false);
  void journalChange();
  void describeWork();
  void discardWork();
  void rememberFile(const QString& path);
  void rememberPicture();
  void buildDocumentActions(QMenu* file);
  void buildHistory(QMenu* edit);
  void lookForWork();
  void askDiscardWork();
  void adoptLostWork(session::WorkClaim& lost);
  void documentChanged();
  void showData();
  void showPick(const render::Pick& pick);
  void askOpen(bool add);
  void askOpenFolder();
  void askOpenLabels();
  void askSavePicture();
  void askSaveScene(bool asNew);
  void askExportSheet();
  void askExportClipped();
  int membraneToExport() const;
  std::function<scene::Scene(Progress&)> sceneAtRest() const;
  void showAbout();
  void showHelp();
  void showPreferences();
  void findCommand();
  QString pictureFolder() const;

  session::Document mDocument;
  ActionTable* mActions = nullptr;
  ViewGrid* mViews = nullptr;
  Viewport* mViewport = nullptr;  ///< Of the views.
  QActionGroup* mLayouts = nullptr;
  QStackedWidget* mPages = nullptr;
  MessageBar* mMessages = nullptr;
  ProgressStrip* mProgress = nullptr;
  LookPanel* mLook = nullptr;
  CutPanel* mCuts = nullptr;
  ProtectTool* mProtect = nullptr;
  SheetTool* mSheetTool = nullptr;
  SketchTool* mSketch = nullptr;
  Selection* mSelection = nullptr;
  StructureCommands* mStructureCommands = nullptr;
  StructurePanel* mStructures = nullptr;
  ThreePointTool* mThreePoints = nullptr;
  LookCommands* mLookCommands = nullptr;
  TimeBar* mTime = nullptr;
  HelpWindow* mHelp = nullptr;
  QDockWidget* mDock = nullptr;  ///< Holds the side panel; away while nothing is open.
  QWidget* mSide = nullptr;
  QTabWidget* mTabs = nullptr;
  QLabel *mDataLabel = nullptr, *mPickLabel = nullptr, *mReductionLabel = nullptr, *mRefineLabel = nullptr,
         *mDriverLabel = nullptr;
  QAction *mUndo = nullptr, *mRedo = nullptr, *mCancel = nullptr, *mProjection = nullptr;
  QString mPath;       ///< What is open: file, folder or scene.
  QString mScenePath;  ///< Where the scene is saved; empty: not yet.
  QString mLastError;
  RecoveryBar* mRecovery = nullptr;
  RecentRow* mRecent = nullptr;
  bool mUnattended = false;
  bool mIsReplacing = false;           ///< Another scene is coming in: that is no change to journal.
  bool mWantsPicture = false;          ///< The recent file that is open has no picture of this session yet.
  std::uint64_t mJournaledChange = 0;  ///< The document's change that the journal heard of last.
  std::filesystem::path mRecoveryRoot;
  std::unique_ptr<session::Journal> mJournal;
  std::unique_ptr<Job> mScan;  ///< Looks for dead sessions' work.
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
