#pragma once
#include <QMainWindow>
#include <QStackedWidget>
#include <QTabWidget>
#include <filesystem>
#include <functional>
#include <memory>

#include "ActionTable.h"
#include "Bars.h"
#include "Job.h"
#include "Viewport.h"
#include "velum/session/Document.h"
#include "velum/session/Picture.h"

namespace velum::gui {

class CutPanel;
class LookCommands;
class HelpWindow;
class LookPanel;
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
  void savePictureTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene);
  void saveSceneTo(const QString& path);
  /// Stops the load or the picture that is running; what is open stays.
  void cancelJob();

  session::Document& document() { return mDocument; }
  Viewport& viewport() { return *mViewport; }
  LookCommands& look() { return *mLookCommands; }
  MessageBar& messages() { return *mMessages; }
  ActionTable& actions() { return *mActions; }
  bool isBusy() const { return mJob != nullptr; }
  /// Nothing is running, and what is shown is complete.
  bool isSettled() const { return !isBusy() && (mPages->currentIndex() == 0 || mViewport->isConverged()); }

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
  void buildTimeActions(QMenu* menu);
  void buildHelpActions(QMenu* menu);
  void addTab(QWidget* panel, const QString& title, const QString& tip);
  void buildStatus();
  void startJob(const QString& what, Job::Work work, std::function<void()> whenDone);
  void startLoad(const QString& what, std::function<void(scene::Scene&, Progress&)> read, bool add,
                 const QString& path);
  void takeScene(scene::Scene scene, bool add, const QString& path);
  void documentChanged();
  void showData();
  void showPick(const render::Pick& pick);
  void askOpen(bool add);
  void askOpenFolder();
  void askSavePicture();
  void askSaveScene(bool asNew);
  void showAbout();
  void showHelp();
  void showPreferences();
  void findCommand();
  QString pictureFolder() const;

  session::Document mDocument;
  ActionTable* mActions = nullptr;
  Viewport* mViewport = nullptr;
  QStackedWidget* mPages = nullptr;
  MessageBar* mMessages = nullptr;
  ProgressStrip* mProgress = nullptr;
  LookPanel* mLook = nullptr;
  CutPanel* mCuts = nullptr;
  LookCommands* mLookCommands = nullptr;
  TimeBar* mTime = nullptr;
  HelpWindow* mHelp = nullptr;
  QWidget* mSide = nullptr;
  QTabWidget* mTabs = nullptr;
  QLabel *mDataLabel = nullptr, *mPickLabel = nullptr, *mReductionLabel = nullptr, *mRefineLabel = nullptr,
         *mDriverLabel = nullptr;
  QAction *mUndo = nullptr, *mRedo = nullptr, *mCancel = nullptr, *mProjection = nullptr;
  QString mPath;       ///< What is open: file, folder or scene.
  QString mScenePath;  ///< Where the scene is saved; empty: not yet.
  std::unique_ptr<Job> mJob;
};

}  // namespace velum::gui
