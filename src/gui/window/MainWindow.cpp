#include "MainWindow.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMimeData>
#include <QScrollArea>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTabBar>
#include <QVBoxLayout>
#include <cmath>

#include "RecentFiles.h"
#include "RecoveryBar.h"
#include "cut/CutPanel.h"
#include "kit/Courtesy.h"
#include "kit/KeyboardFocus.h"
#include "kit/Widgets.h"
#include "look/LookCommands.h"
#include "look/LookPanel.h"
#include "membrane/ProtectTool.h"
#include "membrane/SheetTool.h"
#include "membrane/SketchTool.h"
#include "structure/StructurePanel.h"
#include "velum/session/document/Open.h"
#include "velum/session/look/Look.h"
#include "view/TimeBar.h"

namespace velum::gui {

namespace {

constexpr int kPanelWidth = 348;

QString pathName(const QString& path) { return QFileInfo(path).fileName(); }

/// Millimetres with the digits that matter.
QString shortNumber(double value) { return QString::number(value, 'g', 4); }

}  // namespace

MainWindow::MainWindow() : mActions(new ActionTable(this)) {
  giveWayToTheWindow();
  setAcceptDrops(true);
  buildCentre();
  buildPanel();
  buildStatus();
  buildActions();
  new KeyboardFocus(*this, [this] { return mPages->currentIndex() == 1 ? &mViews->keyboardView() : nullptr; });
  mDocument.setListener([this] { documentChanged(); });
  documentChanged();
  if (!mActions->warning().isEmpty()) mMessages->showNote(mActions->warning());
  resize(1440, 900);
}

MainWindow::~MainWindow() {
  mDocument.setListener({});
  mScan.reset();
  delete mSide;  // a field that is being edited hands its text over as it goes: while there is a document
  mJob.reset();  // cancels and waits
}

void MainWindow::buildCentre() {
  auto* centre = new QWidget(this);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  mRecovery = new RecoveryBar(centre);
  mMessages = new MessageBar(centre);
  mPages = new QStackedWidget(centre);
  mProgress = new ProgressStrip(centre);
  mTime = new TimeBar(mDocument, centre);
  auto* empty = new EmptyState(mPages);
  mSelection = new Selection(this);
  mViews = new ViewGrid(mDocument, *mSelection, mPages);
  mViewport = &mViews->viewport();
  mPages->addWidget(empty);
  mPages->addWidget(mViews);
  layout->addWidget(mRecovery);
  layout->addWidget(mMessages);
  layout->addWidget(mPages, 1);
  layout->addWidget(mTime);
  layout->addWidget(mProgress);
  setCentralWidget(centre);
  connect(empty, &EmptyState::openFiles, this, [this] { askOpen(false); });
  connect(empty, &EmptyState::openFolder, this, &MainWindow::askOpenFolder);
  connect(empty, &EmptyState::makePhantom, this, [this] { openPhantom("torso", 0); });
  mRecent = empty->recent();
  connect(mRecent, &RecentRow::chosen, this, [this](const QString& path) { openAsked({path}); });
  connect(mProgress, &ProgressStrip::cancelled, this, &MainWindow::cancelJob);
  connect(mTime, &TimeBar::askReady, this, [this](bool& ready) { ready = mViews->isCurrent(); });
  connect(mViewport, &Viewport::failed, mMessages, &MessageBar::showError);
}

void MainWindow::buildPanel() {
  mDock = new QDockWidget(this);
  mDock->setObjectName("sideDock");
  mDock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  mDock->setTitleBarWidget(new QWidget(mDock));
  mSide = new QWidget(mDock);
  mSide->setObjectName("sidePanel");
  mSide->setFixedWidth(kPanelWidth);
  auto* outer = new QVBoxLayout(mSide);
  outer->setContentsMargins(0, 0, 0, 0);
  mTabs = new QTabWidget(mSide);
  mTabs->setObjectName("sideTabs");
  mTabs->setDocumentMode(true);
  mTabs->tabBar()->setExpanding(true);
  outer->addWidget(mTabs);
  mLook = new LookPanel(mDocument, mTabs);
  mCuts = new CutPanel(mDocument, *mSelection, mTabs);
  addTab(mLook, tr("Look"), tr("Preset, rendering, light and background"));
  buildStructures();
  addTab(mCuts, tr("Cuts"), tr("What is cut away"));
  buildMembrane();
  mDock->setWidget(mSide);
  addDockWidget(Qt::RightDockWidgetArea, mDock);
  connect(mSelection, &Selection::cutChanged, mViewport, &Viewport::selectCut);
  connect(mViewport, &Viewport::refined, mLook, [this](double, const QString& stage) {
    if (stage.isEmpty()) mLook->viewIsComplete();
  });
  connect(mViews, &ViewGrid::pointedAt, mLook, [this](const render::Pick& pick) { mLook->setProbe(pick.value); });
  connect(mViews, &ViewGrid::pointedAtNothing, mLook, &LookPanel::clearProbe);
}

/// What the panel of a membrane says to the views, and they to it.
void MainWindow::buildMembrane() {
  mProtect = new ProtectTool(mDocument, *mViews, *mSelection, *mMessages, this);
  MembraneForm& form = mCuts->membraneForm();
  auto tell = [this, &form] {
    int cut = mSelection->cut();
    if (cut != 0) form.showStatus(mViewport->membranes().status(cut), mViewport->membranes().isPlaying());
  };
  connect(mViewport, &Viewport::sheetsTold, &form, tell);
  connect(mSelection, &Selection::cutChanged, &form, tell);
  connect(mSelection, &Selection::cutChanged, mProtect, &ProtectTool::stop);
  connect(&form, &MembraneForm::playAsked, mViewport, &Viewport::playMembranes);
  connect(&form, &MembraneForm::stepAsked, mViewport, &Viewport::stepMembranes);
  connect(&form, &MembraneForm::flatAsked, mViewport, [this] { mViewport->resetMembrane(mSelection->cut()); });
  connect(&form, &MembraneForm::protectAsked, mProtect,
          [this](bool on, bool letThrough) { on ? mProtect->start(letThrough) : mProtect->stop(); });
  connect(mProtect, &ProtectTool::ended, &form, &MembraneForm::pointingEnded);
  buildSketch();
  buildHands();
}

/// A page of the side panel, which scrolls where the window is low.
void MainWindow::addTab(QWidget* panel, const QString& title, const QString& tip) {
  auto* scroll = new QScrollArea(mTabs);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);  // it scrolls to what has the keyboard
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* contents = new QWidget(scroll);
  contents->setObjectName("sideContents");
  auto* layout = new QVBoxLayout(contents);
  layout->setContentsMargins(16, 14, 16, 14);
  layout->setSpacing(14);
  layout->addWidget(panel);
  // A panel with a list takes all of the height.
  if (panel->sizePolicy().verticalPolicy() != QSizePolicy::Expanding) layout->addStretch(1);
  scroll->setWidget(contents);
  tabInLayoutOrder(panel);
  mTabs->setTabToolTip(mTabs->addTab(scroll, title), tip);
}

void MainWindow::buildStatus() {
  statusBar()->setSizeGripEnabled(false);
  mDataLabel = new QLabel(tr("Nothing is open"), this);
  mReductionLabel = new QLabel(this);
  mReductionLabel->setProperty("role", "alarm");
  mPickLabel = new QLabel(this);
  mRefineLabel = new QLabel(this);
  mDriverLabel = new QLabel(this);
  mRefineLabel->setToolTip(tr("How far the picture is refined"));
  mPickLabel->setToolTip(tr("Under the pointer: value, position in patient coordinates (L, P, S), structure"));
  statusBar()->addWidget(mDataLabel);
  statusBar()->addWidget(mReductionLabel);
  statusBar()->addPermanentWidget(mPickLabel);
  statusBar()->addPermanentWidget(mRefineLabel);
  statusBar()->addPermanentWidget(mDriverLabel);
  connect(mViews, &ViewGrid::pointedAt, this, &MainWindow::showPick);
  connect(mViews, &ViewGrid::pointedAtNothing, mPickLabel, &QLabel::clear);
  connect(mViewport, &Viewport::refined, this, [this](double fraction, const QString& stage) {
    if (stage.isEmpty() && mWantsPicture) rememberPicture();
    mRefineLabel->setText(stage.isEmpty() ? tr("Complete")
                          : fraction > 0  ? QString("%1 %2 %").arg(stage).arg(int(100 * fraction))
                                          : stage);
    render::Stats stats = mViewport->stats();
    QString driver = QString::fromStdString(stats.renderer);
    mDriverLabel->setText(driver.section(" (", 0, 0).section('/', 0, 0));
    mDriverLabel->setToolTip(tr("Drawn by %1").arg(driver));
    QString reduction = QString::fromStdString(stats.reduction);
    mReductionLabel->setText(reduction.isEmpty() ? QString() : tr("Reduced"));
    mReductionLabel->setToolTip(reduction);
  });
}

// Jobs.

void MainWindow::startJob(const QString& what, Job::Work work, std::function<void()> whenDone) {
  if (mJob) return mMessages->showNote(tr("Still busy: wait, or cancel what is running first."));
  mMessages->hide();
  mLastError.clear();
  mJob = std::make_unique<Job>(std::move(work), nullptr);
  mProgress->begin(what);
  mCancel->setEnabled(true);
  connect(mJob.get(), &Job::progressed, mProgress, &ProgressStrip::setProgress);
  connect(mJob.get(), &Job::finished, this, [this, whenDone = std::move(whenDone)](bool done, const QString& error) {
    mProgress->hide();
    mCancel->setEnabled(false);
    mJob.release()->deleteLater();
    mLastError = error;
    if (!error.isEmpty()) mMessages->showError(error);
    if (done) whenDone();
    emit jobEnded();
  });
  mJob->start();
}

void MainWindow::cancelJob() {
  if (!mJob) return;
  mJob->cancel();
  mProgress->setProgress(0.0, tr("stopping"));
}

void MainWindow::startLoad(const QString& what, std::function<void(Loaded&, Progress&)> read, bool add,
                           const QString& path) {
  auto loaded = std::make_shared<Loaded>();
  if (add) loaded->scene = mDocument.scene();
  startJob(
      what, [loaded, read = std::move(read)](Progress& progress) { read(*loaded, progress); },
      [this, loaded, add, path] { finishLoad(loaded, add, path); });
}

void MainWindow::openPaths(const QStringList& paths, bool add) {
  if (paths.isEmpty()) return;
  if (paths.size() == 1 && session::isLookFile(paths.first().toStdString()))
    return mLookCommands->importFrom(paths.first());
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(QFileInfo(path).absoluteFilePath().toStdString());
  bool beside = add && mPages->currentIndex() == 1;
  auto read = [names, beside, policy = dataPolicy()](Loaded& loaded, Progress& progress) {
    if (!beside) {
      loaded.scene = session::openAll(names, progress, policy, &loaded.notes);
      loaded.isScene = session::readSceneText(names.front()).has_value();
      return;
    }
    for (const auto& name : names) {
      scene::Source source;
      source.path = name;
      session::add(loaded.scene, source, progress);
    }
  };
  startLoad(tr("Opening %1").arg(pathName(paths.first())), read, beside, paths.first());
}

void MainWindow::openPhantom(const QString& name, int voxels) {
  std::filesystem::path folder(QStandardPaths::writableLocation(QStandardPaths::CacheLocation).toStdString());
  auto read = [name = name.toStdString(), voxels, folder](Loaded& loaded, Progress& progress) {
    loaded.scene = session::openSample(name, voxels, folder / "phantoms", progress);
  };
  startLoad(tr("Making a phantom"), read, false, name);
}

void MainWindow::showScene(scene::Scene scene, const QString& name) {
  Loaded loaded;
  loaded.scene = std::move(scene);
  takeScene(loaded, false, name);
}

void MainWindow::takeScene(Loaded& loaded, bool add, QString path) {
  scene::Scene& scene = loaded.scene;
  // Recovered work that was never saved goes by the name of its data.
  if (loaded.lost && !QFileInfo(path).isAbsolute() && !scene.volume.source.path.empty())
    path = QString::fromStdString(scene.volume.source.path);
  if (add) {
    // The look may have been changed while the file was read: take over only what was added.
    mDocument.edit("Add data", [&](scene::Scene& now) {
      now.labels = scene.labels;
      now.surfaces = scene.surfaces;
      if (!now.volume.data) now.volume = scene.volume;
    });
    return;
  }
  QString suffix = QFileInfo(path).suffix().toLower();
  mPath = path;
  mScenePath = suffix == "json" ? QFileInfo(path).absoluteFilePath() : QString();
  if (scene.volume.data)
    for (const auto& line : scene.volume.data->warnings) loaded.notes.push_back(line);
  mPages->setCurrentIndex(1);
  mDock->show();
  layout()->activate();  // so that the views have the size that they will have
  if (!loaded.isScene && !loaded.lost) {
    scene.slices.layout = ViewGrid::layoutFor(scene);
    mViews->place(scene.slices);  // so that the camera fits the view as it will be
    scene.camera = mViewport->frame(scene, scene::defaultView(scene));
  }
  replaceScene(std::move(scene), path);
  if (loaded.lost) adoptLostWork(*loaded.lost);
  mViewport->setFocus();
  QStringList notes;
  for (const auto& note : loaded.notes) notes << QString::fromStdString(note);
  if (!notes.isEmpty()) mMessages->showNote(tr("%1: %2").arg(pathName(path), notes.join("; ")));
}

void MainWindow::savePictureTo(const QString& path, const session::PictureOptions& options, const scene::Scene& scene) {
  startJob(
      tr("Drawing %1").arg(pathName(path)),
      [scene, options, path = path.toStdString()](Progress& progress) {
        session::renderPictureFile(scene, options, path, progress);
      },
      [this, path] { mMessages->showNote(tr("Saved %1").arg(path)); });
}

void MainWindow::saveSceneTo(const QString& path) {
  try {
    session::saveScene(mDocument.scene(), path.toStdString());
    mScenePath = mPath = QFileInfo(path).absoluteFilePath();
    mLastError.clear();
    mDocument.markSaved();
    discardWork();
    describeWork();
    rememberFile(mPath);
    rememberPicture();
  } catch (const Error& error) {
    mLastError = QString::fromUtf8(error.what());
    mMessages->showError(mLastError);
  }
}

// What is shown.

void MainWindow::documentChanged() {
  journalChange();
  mViews->refresh();
  if (mLayouts) mLayouts->actions()[int(mDocument.scene().slices.layout)]->setChecked(true);
  mLook->refresh();
  mTime->refresh();
  mCuts->refresh();
  mSheetTool->refresh();
  mSketch->refresh();
  mStructures->refresh();
  bool open = mPages->currentIndex() == 1;
  mDock->setVisible(open);
  mActions->setSceneOpen(open);
  auto name = [](const QString& verb, const std::string& label) {
    return label.empty() ? verb : QString("%1 \"%2\"").arg(verb, QString::fromStdString(label));
  };
  if (mUndo) {
    mUndo->setEnabled(mDocument.canUndo());
    mUndo->setText(name(tr("&Undo"), mDocument.undoLabel()));
    mRedo->setEnabled(mDocument.canRedo());
    mRedo->setText(name(tr("&Redo"), mDocument.redoLabel()));
    mProjection->setChecked(mDocument.scene().camera.projection == scene::Projection::Orthographic);
  }
  setWindowTitle(mPath.isEmpty() ? "Velum" : QString("%1[*] - Velum").arg(pathName(mPath)));
  setWindowModified(mDocument.isModified() && !mPath.isEmpty());
  showData();
}

void MainWindow::showData() {
  const auto& scene = mDocument.scene();
  if (const auto& v = scene.volume.data) {
    glm::dvec3 mm = spacingMm(*v);
    QString times = QString::fromUtf8(" \u00d7 ");
    QString unit = v->unit.empty() ? QString() : " " + QString::fromStdString(v->unit);
    auto type = enumName(v->type);
    QStringList dims, spacing;
    for (int i = 0; i < 3; ++i) {
      dims << QString::number(v->dims[i]);
      spacing << shortNumber(mm[i]);
    }
    QString text = dims.join(times) + "    ";
    text += v->isSpacingKnown ? spacing.join(times) + " mm" : tr("spacing unknown");
    text += QString("    %1    %2 to %3%4")
                .arg(QString::fromUtf8(type.data(), int(type.size())), shortNumber(v->range.x), shortNumber(v->range.y),
                     unit);
    mDataLabel->setText(text);
    mDataLabel->setToolTip(
        tr("Voxels, spacing, sample type and range of values of %1").arg(QString::fromStdString(v->name)));
  } else if (scene.labels.data) {
    mDataLabel->setText(tr("%n structure(s)", nullptr, int(scene.labels.structures.size())));
  } else {
    mDataLabel->setText(scene.surfaces.empty() ? tr("Nothing is open")
                                               : tr("%n surface(s)", nullptr, int(scene.surfaces.size())));
  }
}

void MainWindow::showPick(const render::Pick& pick) {
  const auto& scene = mDocument.scene();
  QString text;
  QStringList values;
  for (double value : render::probe(scene, pick.worldMm).values) values << shortNumber(value);
  if (const auto& v = scene.volume.data; v && !values.isEmpty())
    text = QString("%1 %2    ").arg(values.join(", "), QString::fromStdString(v->unit));
  // Letters only where the file says how the patient lay.
  bool letters = !scene.volume.data || scene.volume.data->isOrientationKnown;
  static constexpr const char* kPlus[] = {"L", "P", "S"};
  static constexpr const char* kMinus[] = {"R", "A", "I"};
  for (int i = 0; i < 3; ++i) {
    double mm = pick.worldMm[i];
    text += letters ? QString("%1 %2  ").arg(mm < 0 ? kMinus[i] : kPlus[i]).arg(std::abs(mm), 0, 'f', 1)
                    : QString("%1  ").arg(mm, 0, 'f', 1);
  }
  text += "mm";
  for (const auto& structure : scene.labels.structures)
    if (structure.id == pick.structure) text += "    " + QString::fromStdString(structure.name);
  mPickLabel->setText(text);
}

// Events.

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) return event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  event->acceptProposedAction();
  openAsked(paths, event->modifiers() & Qt::ControlModifier);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayLeaveScene()) return event->ignore();
  rememberPicture();
  discardWork();
  if (mJob) {
    mJob->disconnect(this);
    mJob.reset();  // cancels and waits
    mProgress->hide();
  }
  event->accept();
}

}  // namespace velum::gui
