// A morning's work in the window, with the hand's events: a DICOM folder opened, looked at, made clear, cut, a
// structure spared, taken back, saved, opened again and saved as a picture. With VELUM_SHOTS each step's window is
// kept.
#include <gtest/gtest.h>

#include <QDir>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>
#include <cmath>

#include "DicomSeries.h"
#include "RunBatch.h"
#include "Shots.h"
#include "TempFolder.h"
#include "gui/look/TransferCanvas.h"
#include "gui/structure/StructureCommands.h"
#include "gui/window/MainWindow.h"
#include "io/labels/WriteLabels.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/WriteVolume.h"
#include "patience.h"
#include "session/look/TransferTool.h"

namespace velum::gui {
namespace {

bool wantsPictures() { return qEnvironmentVariableIsSet("VELUM_SHOTS") || qEnvironmentVariableIsSet("VELUM_GUIDE"); }

class AsUsed : public testing::Test {
 protected:
  void SetUp() override {
    Progress progress;
    io::Sample sample = io::makeSample("torso", wantsPictures() ? 256 : 48, progress);
    ASSERT_TRUE(writeDicomSeries(sample.volume, mFolder / "ct"));
    io::writeLabels(sample.labels, mFolder / "organs.seg.nrrd", progress);
    mWindow = makeWindow();
  }
  std::unique_ptr<MainWindow> makeWindow() {
    auto window = std::make_unique<MainWindow>();
    window->views().setLayout(scene::Layout::FourUp);  // whatever was used last
    window->resize(1440, 900);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(window.get()));
    return window;
  }
  QString path(const char* name) { return QString::fromStdString((mFolder / name).string()); }
  const scene::Scene& scene() { return mWindow->document().scene(); }
  template <class T>
  T* child(const char* name) {
    return mWindow->findChild<T*>(name);
  }
  bool waitForJob(MainWindow& window) {
    return QTest::qWaitFor([&] { return !window.isBusy(); }, kPatience);
  }
  /// The step is done: keeps a picture of it where they are wanted. @param guideName  as the guide shows it
  void shot(const char* name, const char* guideName = nullptr) {
    if (!wantsPictures()) return;
    QTest::qWait(300);
    EXPECT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
    takeShot(*mWindow, name);
    if (QString guide = qEnvironmentVariable("VELUM_GUIDE"); !guide.isEmpty() && guideName)
      mWindow->grab().save(guide + "/" + guideName + ".jpg", "jpg", 82);
  }
  void showTab(const char* name) { ASSERT_TRUE(mWindow->tabs().showPage(name)) << name; }
  void drag(QWidget& widget, QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&widget, button, {}, from);
    for (int i = 1; i <= 5; ++i) QTest::mouseMove(&widget, from + (to - from) * i / 5);
    QTest::mouseRelease(&widget, button, {}, to);
  }

  void openAndLook() {
    mWindow->openPaths({path("ct")});
    ASSERT_TRUE(waitForJob(*mWindow));
    ASSERT_TRUE(scene().volume.data);
    EXPECT_EQ(scene().volume.data->modality, Modality::CT);
    EXPECT_EQ(scene().volume.data->unit, "HU");
    EXPECT_EQ(scene().sections.layout, scene::Layout::FourUp);
    shot("used-1-open");
    auto& axial = mWindow->views().section(scene::SectionKind::Axial);
    glm::dvec3 before = scene().sections.crosshair;
    QTest::mouseClick(&axial, Qt::LeftButton, {}, {axial.width() / 3, axial.height() / 2});
    EXPECT_NE(scene().sections.crosshair, before);
    drag(mWindow->viewport(), {200, 200}, {260, 180});
  }
  void editCurve() {
    showTab("Look");
    auto* canvas = child<TransferCanvas>("transferCanvas");
    ASSERT_TRUE(canvas);
    auto before = scene().volume.transfer;
    const auto& point = before.opacities[1];
    ASSERT_TRUE(QTest::qWaitFor([&] { return canvas->view().high > canvas->view().low + 2; }, kPatience));
    auto frame = canvas->frame();
    QPoint from(int(std::lround(session::xOf(frame, point.value))),
                int(std::lround(session::yOf(frame, point.opacity))));
    drag(*canvas, from, from + QPoint(-6, 14));
    EXPECT_NE(scene().volume.transfer, before);
    EXPECT_EQ(mWindow->document().undoLabel(), "Move opacity point");
    shot("used-2-curve", "curve");
  }
  void cutAndSpare() {
    showTab("Cuts");
    QTest::mouseClick(child<QPushButton>("addPlane"), Qt::LeftButton);
    ASSERT_EQ(scene().cuts.size(), 1u);
    shot("used-3-cut");
    mWindow->openPaths({path("organs.seg.nrrd")}, true);
    ASSERT_TRUE(waitForJob(*mWindow));
    ASSERT_FALSE(scene().labels.structures.empty());
    showTab("Structures");
    int id = scene().labels.structures.back().id;
    mWindow->selection().setStructure(id);
    mWindow->viewport().setFocus();
    QTest::keyClick(mWindow.get(), Qt::Key_K);
    EXPECT_EQ(scene().cuts[0].spares, std::vector<scene::Spare>{{id}});
    shot("used-4-spared", "spared");
  }
  TempFolder mFolder;
  std::unique_ptr<MainWindow> mWindow;
};

TEST_F(AsUsed, OpenLookCurveCutSpareUndoSaveReopenExport) {
  openAndLook();
  editCurve();
  cutAndSpare();
  if (HasFatalFailure()) return;
  scene::Scene made = scene();

  // Taken back to the beginning and done again, by keys.
  while (mWindow->document().canUndo()) QTest::keyClick(mWindow.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().cuts.empty());
  EXPECT_FALSE(scene().labels.data);
  while (mWindow->document().canRedo()) QTest::keyClick(mWindow.get(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(scene(), made);

  // Saved, and opened in another window.
  mWindow->saveSceneTo(path("work.json"));
  EXPECT_FALSE(mWindow->isWindowModified());
  auto other = makeWindow();
  other->openPaths({path("work.json")});
  ASSERT_TRUE(waitForJob(*other));
  EXPECT_EQ(other->document().scene().cuts, made.cuts);
  EXPECT_EQ(other->document().scene().volume.transfer, made.volume.transfer);
  EXPECT_EQ(other->document().scene().camera, made.camera);
  EXPECT_EQ(other->document().scene().sections, made.sections);
  EXPECT_EQ(other->document().scene().labels.structures, made.labels.structures);

  // The picture from the window and the one without it are the same file.
  other->exports().savePictureTo(path("window.png"), {{160, 120}, 1, false, false}, other->document().scene());
  ASSERT_TRUE(waitForJob(*other));
  runBatch({"render", path("work.json"), "-o", path("batch.png"), "--size", "160x120", "--samples", "1"});
  QFile window(path("window.png")), headless(path("batch.png"));
  ASSERT_TRUE(window.open(QIODevice::ReadOnly) && headless.open(QIODevice::ReadOnly));
  EXPECT_EQ(window.readAll(), headless.readAll());
}

TEST_F(AsUsed, BonesWithACutTakeOneClickAfterOpening) {
  // Open, the folder, its button: three clicks. The look is chosen by the data; the fourth is this one.
  mWindow->openPaths({path("ct")});
  ASSERT_TRUE(waitForJob(*mWindow));
  EXPECT_EQ(scene().volume.transfer.preset, "ct-bone");
  mWindow->actions().find("cut.addPlane")->trigger();
  EXPECT_EQ(scene().cuts.size(), 1u);
  EXPECT_TRUE(QTest::qWaitFor([&] { return mWindow->views().isCurrent(); }, kPatience));
}

}  // namespace
}  // namespace velum::gui
