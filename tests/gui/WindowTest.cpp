// Drives the real window with real events, under a display.
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QSurfaceFormat>
#include <fstream>

#include "RunBatch.h"
#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Theme.h"
#include "patience.h"

namespace velum::gui {

namespace {

void onMessage(QtMsgType type, const QMessageLogContext&, const QString& text) {
  if (type != QtDebugMsg && type != QtInfoMsg) warnings() << text;
}

}  // namespace

TEST_F(Window, IsDrawnByTheDriverThatWasAskedFor) {
  const char* wanted = std::getenv("VELUM_TEST_DRIVER");
  if (!wanted) GTEST_SKIP() << "whichever the machine has";
  openPhantom();
  ASSERT_TRUE(viewport().surface().context());
  std::string renderer = viewport().surface().context()->limits().renderer;
  EXPECT_EQ(renderer.rfind(wanted, 0), 0u) << renderer;
}

TEST_F(Window, RefinesUntilCompleteAndThenRests) {
  openPhantom();
  ASSERT_TRUE(settle());
  EXPECT_EQ(viewport().stats().samples, scene().rayCast.samplesPerPixel);
  double ms = viewport().stats().frameMs;
  QTest::qWait(200);
  EXPECT_EQ(viewport().stats().frameMs, ms);
  EXPECT_TRUE(mWindow->windowTitle().contains("phantom"));
}

TEST_F(Window, WhatIsPickedProjectsBackToItsPixel) {
  openPhantom();
  ASSERT_TRUE(settle());
  int hits = 0;
  for (QPointF place : {QPointF(0.5, 0.5), QPointF(0.4, 0.5), QPointF(0.6, 0.5), QPointF(0.5, 0.4)}) {
    QPointF pixel(place.x() * size().x, place.y() * size().y);
    auto pick = viewport().pickAt(pixel);
    ASSERT_TRUE(pick);
    if (!pick->hit) continue;
    ++hits;
    auto back = scene::pixelFromWorld(scene().camera, size(), pick->world);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->x, pixel.x(), 1.5);
    EXPECT_NEAR(back->y, pixel.y(), 1.5);
  }
  EXPECT_GT(hits, 0);
}

TEST_F(Window, MouseTurnsMovesAndNears) {
  openPhantom();
  scene::Camera start = scene().camera;
  drag({200, 200}, {280, 220});
  scene::Camera turned = scene().camera;
  EXPECT_NE(turned.eye, start.eye);
  EXPECT_EQ(turned.target, start.target);
  drag({200, 200}, {240, 200}, Qt::MiddleButton);
  EXPECT_NE(scene().camera.target, start.target);
  double distance = glm::length(scene().camera.eye - scene().camera.target);
  drag({200, 200}, {200, 160}, Qt::RightButton);
  EXPECT_LT(glm::length(scene().camera.eye - scene().camera.target), distance);
  EXPECT_EQ(mWindow->document().undoLabels(), std::vector<std::string>{"Move view"});
  EXPECT_FALSE(mWindow->document().isModified());
  viewport().setFocus();
  QTest::keyClick(&viewport(), Qt::Key_R);
  EXPECT_EQ(scene().camera.target, start.target);
  QTest::keyClick(&viewport(), Qt::Key_5);
  EXPECT_EQ(scene().camera.projection, scene::Projection::Orthographic);
  EXPECT_TRUE(settle());
}

TEST_F(Window, GizmoMovesTheCutAlongItsNormalInOneStep) {
  openPhantom();
  viewport().lookFrom(scene::StandardView::Oblique);
  QTest::mouseClick(child<QPushButton>("addPlane"), Qt::LeftButton);
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(mWindow->selection().cut(), scene().cuts[0].id);
  viewport().lookFrom(scene::StandardView::Left);  // so that the arrow lies across the view
  scene::Cut before = scene().cuts[0];
  auto gizmo = session::makeCutGizmo(scene(), before, size());
  auto tip = scene::pixelFromWorld(scene().camera, size(), gizmo.arrowTip);
  auto foot = scene::pixelFromWorld(scene().camera, size(), gizmo.centre);
  ASSERT_TRUE(tip && foot);
  glm::dvec2 to = *tip + (*tip - *foot) * 0.4;
  drag(QPoint(int(tip->x), int(tip->y)), QPoint(int(to.x), int(to.y)));
  glm::dvec3 moved = scene().cuts[0].centre - before.centre;
  EXPECT_GT(glm::dot(moved, gizmo.normal), 1.0);
  EXPECT_LT(glm::length(glm::cross(moved, gizmo.normal)), 1e-6);
  EXPECT_EQ(mWindow->document().undoLabel(), "Move cut");
  QTest::keyClick(mWindow.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().cuts[0], before);
  EXPECT_EQ(mWindow->document().undoLabels(), (std::vector<std::string>{"Move view", "Add cut", "Move view"}));
  mWindow->document().undo();
  mWindow->document().undo();
  EXPECT_TRUE(scene().cuts.empty());
  EXPECT_EQ(mWindow->selection().cut(), 0);
}

TEST_F(Window, KnobTiltsTheCut) {
  openPhantom();
  mWindow->document().edit("Add cut", [](scene::Scene& s) { scene::addCut(s, session::cutFacingCamera(s)); });
  scene::Cut before = scene().cuts[0];
  auto gizmo = session::makeCutGizmo(scene(), before, size());
  auto knob = scene::pixelFromWorld(scene().camera, size(), handlePlace(gizmo, session::CutHandle::KnobRight));
  ASSERT_TRUE(knob);
  drag(QPoint(int(knob->x), int(knob->y)), QPoint(int(knob->x) - 30, int(knob->y)));
  EXPECT_LT(glm::dot(scene().cuts[0].axis, before.axis), 0.99);
  EXPECT_EQ(mWindow->document().undoLabel(), "Tilt cut");
}

TEST_F(Window, PresetIsOneUndoStep) {
  openPhantom();
  auto* presets = child<QListWidget>("preset");
  std::string before = scene().volume.transfer.preset;
  child<QPushButton>("morePresets")->click();
  QListWidgetItem* skin = nullptr;
  for (int i = 0; i < presets->count(); ++i)
    if (presets->item(i)->data(Qt::UserRole).toString() == "ct-skin") skin = presets->item(i);
  ASSERT_TRUE(skin);
  presets->setCurrentItem(skin);
  QTest::keyClick(presets, Qt::Key_Return);
  EXPECT_EQ(scene().volume.transfer.preset, "ct-skin");
  mWindow->document().undo();
  EXPECT_EQ(scene().volume.transfer.preset, before);
  EXPECT_EQ(presets->currentItem()->data(Qt::UserRole).toString().toStdString(), before);
}

TEST_F(Window, SavedPictureEqualsTheHeadlessOne) {
  openPhantom();
  mWindow->document().edit("Add cut", [](scene::Scene& s) { scene::addCut(s, session::cutFacingCamera(s)); });
  drag({200, 200}, {260, 180});
  mWindow->saveSceneTo(path("scene.json"));
  mWindow->exports().savePictureTo(path("window.png"), {{160, 120}, 2, false, false}, scene());
  ASSERT_TRUE(waitForJob());
  runBatch({"render", path("scene.json"), "-o", path("batch.png"), "--size", "160x120", "--samples", "2"});
  ASSERT_FALSE(bytesOf(path("window.png")).isEmpty());
  EXPECT_EQ(bytesOf(path("window.png")), bytesOf(path("batch.png")));
  // The picture opens as its scene.
  scene::Scene before = scene();
  mWindow->openPaths({path("window.png")});
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(scene().cuts, before.cuts);
  EXPECT_EQ(scene().camera, before.camera);
}

TEST_F(Window, BadFileIsNamedInTheMessageBar) {
  std::ofstream(path("bad.nrrd").toStdString()) << "NRRD0004\nthis is no header\n";
  mWindow->openPaths({path("bad.nrrd")});
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(mWindow->messages().isVisible());
  EXPECT_TRUE(mWindow->messages().text().contains("bad.nrrd")) << mWindow->messages().text().toStdString();
  EXPECT_FALSE(scene().volume.data);
}

TEST_F(Window, CutsThatLeaveNothingSayItAndTakeItBack) {
  openPhantom();
  drawSoon();
  mWindow->actions().find("cut.addPlane")->trigger();
  auto moveTo = [&](double y) {
    mWindow->document().edit("Move cut", [y](scene::Scene& scene) {
      scene.cuts[0].axis = {0, -1, 0};
      scene.cuts[0].centre = {0, y, 0};
    });
  };
  auto isSaid = [&] { return mWindow->messages().isVisible() && mWindow->messages().text().contains("leave nothing"); };
  moveTo(1000);
  EXPECT_TRUE(QTest::qWaitFor(isSaid, kPatience));
  takeShot(*mWindow, "nothing-left");
  moveTo(0);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !isSaid(); }, kPatience));
  mWindow->document().undo();
  EXPECT_TRUE(QTest::qWaitFor(isSaid, kPatience));
}

TEST_F(Window, LoadCanBeCancelledAndWhatWasOpenStays) {
  openPhantom();
  scene::Scene before = scene();
  mWindow->openPhantom("torso", 256);
  EXPECT_TRUE(mWindow->isBusy());
  QTest::qWait(150);
  QTest::keyClick(mWindow.get(), Qt::Key_Escape);
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(scene(), before);
  EXPECT_FALSE(mWindow->messages().isVisible());
}

TEST_F(Window, DroppedFilesOpenWithTheVolumeFirst) {
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(path("phantom_labels.seg.nrrd")), QUrl::fromLocalFile(path("phantom.nrrd"))});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(mWindow.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({50, 50}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(mWindow.get(), &drop);
  ASSERT_TRUE(waitForJob());
  EXPECT_TRUE(scene().volume.data);
  EXPECT_TRUE(scene().labels.data);
}

TEST_F(Window, ClosesWhileLoading) {
  mWindow->openPhantom("torso", 256);
  QTest::qWait(50);
  mWindow->close();
  EXPECT_FALSE(mWindow->isBusy());
  mWindow.reset();
}

}  // namespace velum::gui

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  velum::TempFolder runtime;
  qputenv("XDG_RUNTIME_DIR", runtime.path().c_str());
  QFile::setPermissions(QString::fromStdString(runtime.path()), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  for (const char* name : {"XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"})
    qputenv(name, (runtime / name).c_str());
  QStandardPaths::setTestModeEnabled(true);
  QSurfaceFormat format;
  format.setVersion(4, 5);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setOption(QSurfaceFormat::DebugContext);  // the driver says all that it has to say
  QSurfaceFormat::setDefaultFormat(format);
  qInstallMessageHandler(velum::gui::onMessage);
  QApplication application(argc, argv);
  QApplication::setApplicationName("velum");
  velum::gui::applyTheme(application);
  return RUN_ALL_TESTS();
}
