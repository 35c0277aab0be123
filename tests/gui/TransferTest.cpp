// The look of a scene by hand: curve, colours, presets, channels, files and "show this", with real events.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <fstream>

#include "Shots.h"
#include "TempFolder.h"
#include "gui/look/ChannelList.h"
#include "gui/look/LookCommands.h"
#include "gui/look/LookPanel.h"
#include "gui/look/TransferCanvas.h"
#include "gui/window/MainWindow.h"
#include "io/volumes/WriteVolume.h"
#include "makeVolume.h"
#include "patience.h"
#include "scene/Presets.h"
#include "session/look/TransferTool.h"

namespace velum::gui {
namespace {

class Transfer : public testing::Test {
 protected:
  void SetUp() override {
    mWindow = std::make_unique<MainWindow>();
    mWindow->resize(760, 700);
    mWindow->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
    mWindow->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(mWindow.get()));
  }
  void TearDown() override { mWindow.reset(); }
  QString path(const char* name) { return QString::fromStdString((mFolder / name).string()); }

  /// A ball of 300 in air, like a CT; no file is read.
  void openBall() {
    glm::ivec3 dims(32);
    Volume v = makeVolume(
        dims, SampleType::Int16,
        [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 15.5) < 11 ? 300.0 + p.x % 3 : -1000.0; },
        centredFrame(dims));
    v.unit = "HU";
    v.modality = Modality::CT;
    openVolume("ball.nrrd", v);
    mWindow->document().edit("Prepare", [](scene::Scene& scene) {
      drawPlainly(scene);
      scene.volume.transfer.opacities = {{0, 0}, {200, 0.5}, {280, 1}};
      scene.volume.transfer.colors = {{-200, {1, 0, 0}}, {250, {0, 0, 1}}};
    });
  }
  /// What these tests look at needs no fine picture.
  static void drawPlainly(scene::Scene& scene) {
    scene.rayCast.samplesPerPixel = 1;
    scene.lighting.shaded = false;
  }
  void openVolume(const char* name, const Volume& v) {
    Progress progress;
    io::writeVolume(v, mFolder / name, progress);
    mWindow->openPaths({path(name)});
    ASSERT_TRUE(QTest::qWaitFor([&] { return !mWindow->isBusy(); }, kPatience));
    ASSERT_TRUE(scene().volume.data);
    ASSERT_TRUE(QTest::qWaitFor([&] { return canvas().view().high > canvas().view().low + 2; }, kPatience));
  }
  const scene::Scene& scene() { return mWindow->document().scene(); }
  const scene::TransferFunction& transfer() { return scene::currentTransfer(scene().volume); }
  std::string undoLabel() { return mWindow->document().undoLabel(); }
  TransferCanvas& canvas() { return *child<TransferCanvas>("transferCanvas"); }
  template <class T>
  T* child(const QString& name) {
    return mWindow->findChild<T*>(name);
  }
  QPoint placeOf(double value, double opacity) {
    auto frame = canvas().frame();
    return {int(std::lround(session::xOf(frame, value))), int(std::lround(session::yOf(frame, opacity)))};
  }
  void drag(QPoint from, QPoint to, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&canvas(), Qt::LeftButton, keys, from);
    for (int i = 1; i <= 4; ++i) QTest::mouseMove(&canvas(), from + (to - from) * i / 4);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, keys, to);
  }
  double pixelValue() { return (canvas().view().high - canvas().view().low) / canvas().frame().size.x; }

  TempFolder mFolder;
  std::unique_ptr<MainWindow> mWindow;
};

TEST_F(Transfer, APointMovesInOneUndoStep) {
  openBall();
  auto before = transfer();
  drag(placeOf(200, 0.5), placeOf(150, 0.2));
  EXPECT_NEAR(transfer().opacities[1].value, 150, 2 * pixelValue());
  EXPECT_NEAR(transfer().opacities[1].opacity, 0.2, 0.02);
  EXPECT_EQ(undoLabel(), "Move opacity point");
  drag(placeOf(150, 0.2), placeOf(100, 0.2));
  QTest::qWait(20);
  takeShot(*mWindow, "transfer");
  mWindow->document().undo();
  EXPECT_NEAR(transfer().opacities[1].value, 150, 2 * pixelValue());
  mWindow->document().undo();
  EXPECT_EQ(transfer(), before);
  EXPECT_EQ(undoLabel(), "Prepare");
}

TEST_F(Transfer, AClickOnTheLineAddsAPointThatChangesNothingAndDelRemovesIt) {
  openBall();
  QPoint place = placeOf(100, scene::opacityAt(transfer().opacities, 100));
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, place);
  ASSERT_EQ(transfer().opacities.size(), 4u);
  EXPECT_NEAR(transfer().opacities[1].opacity, 0.25, 0.03);
  EXPECT_EQ(canvas().selection().index, 1);
  // Del is the cut's key in the window, and the point's here.
  QTest::keyClick(&canvas(), Qt::Key_Delete);
  EXPECT_EQ(transfer().opacities.size(), 3u);
  EXPECT_EQ(undoLabel(), "Remove opacity point");
  QTest::mouseClick(&canvas(), Qt::RightButton, {}, placeOf(200, 0.5));
  EXPECT_EQ(transfer().opacities.size(), 2u);
  QTest::mouseClick(&canvas(), Qt::RightButton, {}, placeOf(0, 0));
  QTest::mouseClick(&canvas(), Qt::RightButton, {}, placeOf(280, 1));
  EXPECT_EQ(transfer().opacities.size(), 1u);  // the last one stays
}

TEST_F(Transfer, ADragBetweenPointsMovesAllOrScalesAll) {
  openBall();
  auto before = transfer();
  QPoint line = placeOf(100, scene::opacityAt(transfer().opacities, 100));
  drag(line, line + QPoint(30, 2));
  EXPECT_EQ(undoLabel(), "Shift transfer function");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(transfer().opacities[i].value - before.opacities[i].value, 30 * pixelValue(), pixelValue());
  EXPECT_NEAR(transfer().colors[0].value - before.colors[0].value, 30 * pixelValue(), pixelValue());
  mWindow->document().undo();
  drag(line, line + QPoint(1, 25));
  EXPECT_EQ(undoLabel(), "Scale opacity");
  EXPECT_LT(transfer().opacities[1].opacity, 0.4);
  EXPECT_EQ(transfer().opacities[1].value, 200);
  mWindow->document().undo();
  drag(QPoint(40, 20), QPoint(80, 20), Qt::AltModifier);
  EXPECT_EQ(undoLabel(), "Stretch transfer function");
  EXPECT_GT(transfer().opacities[2].value - transfer().opacities[0].value, 300);
  EXPECT_NEAR(transfer().opacities[2].value + transfer().opacities[0].value, 280, 1e-6);
}

TEST_F(Transfer, ArrowsAndNumbersMoveTheSelectedPoint) {
  openBall();
  QTest::mouseClick(&canvas(), Qt::LeftButton, {}, placeOf(200, 0.5));
  QTest::keyClick(&canvas(), Qt::Key_Up);
  EXPECT_NEAR(transfer().opacities[1].opacity, 0.51, 1e-9);
  QTest::keyClick(&canvas(), Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(transfer().opacities[1].value, 200 + 10 * pixelValue(), 1e-6);
  QTest::keyClick(&canvas(), Qt::Key_PageUp);
  EXPECT_EQ(canvas().selection().index, 0);
  auto* value = child<QDoubleSpinBox>("pointValue");
  EXPECT_TRUE(value->isVisible());
  EXPECT_TRUE(value->suffix().contains("HU"));
  // Nothing is cut off at the panel's edge.
  QTest::qWait(20);
  auto* panel = mWindow->findChild<QWidget*>("sidePanel");
  QPushButton* remove = child<QPushButton>("removePoint");
  EXPECT_LT(remove->mapTo(panel, QPoint(remove->width(), 0)).x(), panel->width());
  value->setValue(-37.5);
  EXPECT_NEAR(transfer().opacities[0].value, -37.5, 0.01);
  child<QDoubleSpinBox>("pointOpacity")->setValue(0.25);
  EXPECT_NEAR(transfer().opacities[0].opacity, 0.0025, 1e-9);
}

TEST_F(Transfer, ColoursAreAddedMovedAndRemovedInTheBar) {
  openBall();
  QPoint place(int(session::xOf(canvas().frame(), 0)), int(canvas().barRect().center().y()));
  glm::dvec3 there = scene::colorAt(transfer().colors, 0);
  drag(place, place + QPoint(20, 0));
  ASSERT_EQ(transfer().colors.size(), 3u);
  EXPECT_EQ(undoLabel(), "Add colour");
  EXPECT_NEAR(transfer().colors[1].value, 20 * pixelValue(), 2 * pixelValue());
  EXPECT_LT(glm::length(glm::dvec3(transfer().colors[1].color) - there), 0.02);
  canvas().colorSelected({0, 1, 0});
  EXPECT_EQ(transfer().colors[1].color, glm::vec3(0, 1, 0));
  QTest::mouseClick(&canvas(), Qt::RightButton, {}, place + QPoint(20, 6));
  EXPECT_EQ(transfer().colors.size(), 2u);
}

TEST_F(Transfer, TheAxisZoomsPansAndComesBack) {
  openBall();
  auto start = canvas().view();
  QPointF middle(canvas().width() / 2.0, 60);
  QWheelEvent wheel(middle, canvas().mapToGlobal(middle), {}, {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                    false);
  QApplication::sendEvent(&canvas(), &wheel);
  auto near = canvas().view();
  EXPECT_LT(near.high - near.low, 0.7 * (start.high - start.low));
  QTest::mousePress(&canvas(), Qt::MiddleButton, {}, {150, 60});
  QTest::mouseMove(&canvas(), {120, 60});
  QTest::mouseRelease(&canvas(), Qt::MiddleButton, {}, {120, 60});
  EXPECT_GT(canvas().view().low, near.low);
  QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, canvas().axisRect().center().toPoint());
  EXPECT_EQ(canvas().view().low, scene().volume.data->range.x);
  EXPECT_EQ(canvas().view().high, scene().volume.data->range.y);
  EXPECT_EQ(undoLabel(), "Prepare");  // looking is no edit
}

TEST_F(Transfer, TheGradientCurveBeginsWithoutChange) {
  openBall();
  auto* uses = child<QCheckBox>("usesGradients");
  auto* gradients = child<TransferCanvas>("gradientCanvas");
  EXPECT_FALSE(gradients->isVisible());
  uses->click();
  ASSERT_GE(transfer().gradientOpacities.size(), 2u);
  for (const auto& point : transfer().gradientOpacities) EXPECT_EQ(point.opacity, 1.0);
  EXPECT_TRUE(gradients->isVisible());
  auto frame = gradients->frame();
  QPoint first(int(session::xOf(frame, 0)), int(session::yOf(frame, 1)));
  QTest::mousePress(gradients, Qt::LeftButton, {}, first);
  QTest::mouseMove(gradients, first + QPoint(0, 40));
  QTest::mouseRelease(gradients, Qt::LeftButton, {}, first + QPoint(0, 40));
  EXPECT_LT(transfer().gradientOpacities[0].opacity, 0.5);
  EXPECT_EQ(undoLabel(), "Move gradient point");
  QTest::qWait(20);
  takeShot(*mWindow, "gradient");
  uses->click();
  EXPECT_TRUE(transfer().gradientOpacities.empty());
}

TEST_F(Transfer, PresetsShowTheData) {
  openBall();
  auto* look = mWindow->findChild<LookPanel*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled() && look->isComplete(); }, kPatience));
  auto* presets = child<QListWidget>("preset");
  ASSERT_GE(presets->count(), 6);
  for (int i = 0; i < presets->count(); ++i) {
    EXPECT_FALSE(presets->item(i)->data(Qt::UserRole + 1).value<QPixmap>().isNull()) << i;
    EXPECT_TRUE(presets->item(i)->data(Qt::UserRole).toString().startsWith("ct-")) << i;
  }
  QTest::mouseClick(presets->viewport(), Qt::LeftButton, {}, presets->visualItemRect(presets->item(1)).center());
  EXPECT_EQ(transfer().preset, "ct-skin");
  EXPECT_EQ(undoLabel(), "Choose preset");
  takeShot(*mWindow, "presets");
}

TEST_F(Transfer, SmoothIsOneClickAndOneUndoStep) {
  openBall();
  auto* smooth = child<QCheckBox>("smooth");
  ASSERT_TRUE(smooth && smooth->isEnabled());
  EXPECT_FALSE(smooth->isChecked());
  smooth->click();
  EXPECT_TRUE(scene().volume.smooth);
  EXPECT_EQ(undoLabel(), "Change smoothing");
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  mWindow->document().undo();
  EXPECT_FALSE(scene().volume.smooth);
  EXPECT_FALSE(smooth->isChecked());
}

TEST_F(Transfer, AClickOnTissueShowsIt) {
  openBall();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  Viewport& view = mWindow->viewport();
  QPoint middle(view.width() / 2, view.height() / 2);
  QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
  EXPECT_EQ(undoLabel(), "Prepare");  // the tool is not taken up
  QTest::keyClick(mWindow.get(), Qt::Key_T);
  EXPECT_TRUE(mWindow->look().isShowing());
  QTest::mouseClick(&view, Qt::LeftButton, {}, middle);
  EXPECT_EQ(undoLabel(), "Show this tissue");
  EXPECT_GT(scene::opacityAt(transfer().opacities, 301), 0.5);
  EXPECT_LT(scene::opacityAt(transfer().opacities, 200), 0.1);
  EXPECT_TRUE(mWindow->messages().text().contains("around 30")) << mWindow->messages().text().toStdString();
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->isSettled(); }, kPatience));
  QTest::mouseClick(&view, Qt::LeftButton, Qt::ControlModifier, middle);
  EXPECT_EQ(undoLabel(), "Hide this tissue");
  EXPECT_LT(scene::opacityAt(transfer().opacities, 301), 1e-6);
  QTest::keyClick(mWindow.get(), Qt::Key_T);
  EXPECT_FALSE(mWindow->look().isShowing());
}

TEST_F(Transfer, LooksAreWrittenAndDroppedBack) {
  openBall();
  auto ours = transfer();
  mWindow->look().exportTo(path("a.velum-transfer.json"));
  mWindow->look().exportTo(path("a.vp"));
  mWindow->document().edit("Change", [](scene::Scene& scene) { scene.volume.transfer.opacities = {{5, 0.5}}; });
  QMimeData mime;
  mime.setUrls({QUrl::fromLocalFile(path("a.velum-transfer.json"))});
  QDragEnterEvent enter({50, 50}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(mWindow.get(), &enter);
  QDropEvent drop({50, 50}, Qt::CopyAction, &mime, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(mWindow.get(), &drop);
  EXPECT_EQ(transfer(), ours);
  EXPECT_EQ(undoLabel(), "Import look");
  mWindow->openPaths({path("a.vp")});
  ASSERT_EQ(transfer().opacities.size(), ours.opacities.size());
  EXPECT_NEAR(transfer().opacities[1].opacity, ours.opacities[1].opacity, 1e-5);
  std::ofstream(path("bad.vp").toStdString()) << "1\n2\n";
  auto before = transfer();
  mWindow->look().importFrom(path("bad.vp"));
  EXPECT_TRUE(mWindow->messages().text().contains("bad.vp"));
  EXPECT_EQ(transfer(), before);
}

TEST_F(Transfer, ChannelsAreShownColouredAndEditedOneByOne) {
  glm::ivec3 dims(28);
  Volume wide = makeVolume({dims.x * 2, dims.y, dims.z}, SampleType::UInt16, [](glm::ivec3 p) {
    glm::dvec3 at(p.x / 2, p.y, p.z);
    return glm::length(at - glm::dvec3(p.x % 2 ? 18 : 10, 14, 14)) < 7 ? 900.0 + p.y : 20.0 + p.z % 5;
  });
  wide.dims = dims;
  wide.channels = 2;
  wide.worldFromVoxel = centredFrame(dims);
  openVolume("two.nrrd", wide);
  ASSERT_TRUE(scene::mixesChannels(scene().volume));
  mWindow->document().edit("Prepare", [](scene::Scene& scene) { drawPlainly(scene); });
  auto* list = mWindow->findChild<ChannelList*>();
  EXPECT_TRUE(list->isVisible());
  auto first = scene().volume.channels[0].transfer;
  QTest::mouseClick(child<QPushButton>("channelName1"), Qt::LeftButton);
  EXPECT_EQ(scene().volume.channel, 1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return mWindow->findChild<LookPanel*>()->isComplete() && mWindow->isSettled(); },
                              kPatience));
  takeShot(*mWindow, "channels");
  const auto& points = transfer().opacities;
  QPoint last = placeOf(points.back().value, points.back().opacity);
  drag(last, last + QPoint(-8, 12));
  EXPECT_EQ(scene().volume.channels[0].transfer, first);
  EXPECT_EQ(undoLabel(), "Move opacity point");
  auto* eye = child<ChannelEye>("channelEye0");
  QTest::mouseClick(eye, Qt::LeftButton);
  EXPECT_FALSE(scene().volume.channels[0].visible);
  QTest::mouseClick(eye, Qt::LeftButton, Qt::AltModifier);  // alone
  EXPECT_TRUE(scene().volume.channels[0].visible);
  EXPECT_FALSE(scene().volume.channels[1].visible);
  QTest::mouseClick(eye, Qt::LeftButton, Qt::AltModifier);  // all again
  EXPECT_TRUE(scene().volume.channels[1].visible);
}

}  // namespace
}  // namespace velum::gui
