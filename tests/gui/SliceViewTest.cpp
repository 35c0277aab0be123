#include <QImage>

#include <QSignalSpy>

#include "WindowFixture.h"
#include "velum/session/section/SliceTool.h"

namespace velum::gui {

using scene::Layout;
using scene::SliceKind;

/// A window with the phantom in four views.
class Slices : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 700);
    openPhantom();
    views().setLayout(Layout::FourUp);
    QTest::qWait(20);
  }
  ViewGrid& views() { return mWindow->views(); }
  SliceView& slice(SliceKind kind) { return views().slice(kind); }
  const scene::Slices& slices() { return scene().slices; }
  QPoint placeOf(SliceKind kind, glm::dvec3 worldMm) {
    glm::dvec2 p = scene::slicePixelFromWorld(slice(kind).frame(), worldMm);
    return {int(std::lround(p.x)), int(std::lround(p.y))};
  }
  void wheel(SliceView& view, QPointF place, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(place, view.mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }
};

TEST_F(Slices, ADragMovesTheCrosshairInTheOthersToo) {
  SliceView& axial = slice(SliceKind::Axial);
  glm::dvec3 before = slices().crosshairMm;
  int painted = slice(SliceKind::Sagittal).paintCount();
  QPoint to = placeOf(SliceKind::Axial, before + glm::dvec3(6, -4, 0));
  drag(axial, placeOf(SliceKind::Axial, before), to);
  EXPECT_EQ(placeOf(SliceKind::Axial, slices().crosshairMm), to);
  EXPECT_EQ(slices().crosshairMm.z, before.z);
  QTest::qWait(50);
  EXPECT_GT(slice(SliceKind::Sagittal).paintCount(), painted);
  EXPECT_EQ(mWindow->document().undoLabel(), "Move view");
  EXPECT_FALSE(mWindow->document().isModified());
}

TEST_F(Slices, MovingTheCrosshairLeavesThe3dPictureAlone) {
  ASSERT_TRUE(settle());
  double ms = viewport().stats().frameMs;
  drag(slice(SliceKind::Coronal), {60, 60}, {90, 80});
  drag(slice(SliceKind::Coronal), {60, 60}, {90, 80}, Qt::RightButton);  // its grey window
  QTest::qWait(300);
  EXPECT_TRUE(viewport().isConverged());
  EXPECT_EQ(viewport().stats().frameMs, ms);
}

TEST_F(Slices, TheWheelScrollsWholePlanesAndZoomsAboutThePointer) {
  SliceView& sagittal = slice(SliceKind::Sagittal);
  auto before = scene::sliceIndex(scene(), SliceKind::Sagittal);
  wheel(sagittal, {100, 100}, 1);
  // Forward is away from the viewer, who stands on the patient's left.
  EXPECT_EQ(scene::sliceIndex(scene(), SliceKind::Sagittal)->index, before->index - 1);
  glm::dvec2 pointer(120, 80);
  glm::dvec3 held = scene::worldFromSlicePixel(sagittal.frame(), pointer);
  wheel(sagittal, {pointer.x, pointer.y}, 3, Qt::ControlModifier);
  EXPECT_LT(glm::length(scene::slicePixelFromWorld(sagittal.frame(), held) - pointer), 1e-6);
  EXPECT_GT(slices().sagittal.heightMm, 0);
  QTest::keyClick(&sagittal, Qt::Key_F);
  EXPECT_EQ(slices().sagittal.heightMm, 0);
}

TEST_F(Slices, RightDragSetsTheWindowInOneUndoStep) {
  glm::dvec2 before = scene::effectiveWindow(scene().volume);
  drag(slice(SliceKind::Axial), {60, 60}, {110, 40}, Qt::RightButton);
  glm::dvec2 after = scene::effectiveWindow(scene().volume);
  EXPECT_GT(after.y, before.y);
  EXPECT_LT(after.x, before.x);
  EXPECT_EQ(mWindow->document().undoLabel(), "Change window");
  mWindow->document().undo();
  EXPECT_EQ(scene::effectiveWindow(scene().volume), before);
  EXPECT_NE(mWindow->document().undoLabel(), "Change window");
}

TEST_F(Slices, MiddleDragPansAndAKnobTurnsTheOthers) {
  SliceView& coronal = slice(SliceKind::Coronal);
  drag(coronal, {60, 60}, {75, 52}, Qt::MiddleButton);
  EXPECT_NE(slices().coronal.panMm, glm::dvec2(0));
  QTest::keyClick(&coronal, Qt::Key_R);
  EXPECT_EQ(slices().coronal, scene::Slices().coronal);
  QTest::mouseMove(&coronal, QPoint(30, 30));
  auto lines = session::crosshairLines(scene(), SliceKind::Coronal, coronal.frame());
  ASSERT_TRUE(lines.at(0).hasKnobs);
  glm::dvec2 knob = lines[0].knobs[1];
  drag(coronal, QPoint(int(knob.x), int(knob.y)), QPoint(int(knob.x), int(knob.y) - 40));
  EXPECT_TRUE(scene::isOblique(slices(), SliceKind::Axial));
  EXPECT_TRUE(scene::isOblique(slices(), SliceKind::Sagittal));
  EXPECT_FALSE(scene::isOblique(slices(), SliceKind::Coronal));
  mWindow->actions().find("slices.reset")->trigger();
  EXPECT_FALSE(scene::isOblique(slices(), SliceKind::Axial));
}

TEST_F(Slices, KeysMoveAndScroll) {
  SliceView& axial = slice(SliceKind::Axial);
  axial.setFocus();
  glm::dvec3 before = slices().crosshairMm;
  double mm = scene::sliceStepMm(scene());
  QTest::keyClick(&axial, Qt::Key_Right);
  QTest::keyClick(&axial, Qt::Key_Up);
  EXPECT_LT(glm::length(slices().crosshairMm - before - glm::dvec3(mm, -mm, 0)), 1e-9);
  auto index = scene::sliceIndex(scene(), SliceKind::Axial)->index;
  QTest::keyClick(&axial, Qt::Key_PageUp);  // away: up the body
  EXPECT_EQ(scene::sliceIndex(scene(), SliceKind::Axial)->index, index + 1);
  QTest::keyClick(&axial, Qt::Key_Home);
  EXPECT_EQ(slices().crosshairMm, before);
  scene::Camera camera = scene().camera;
  QTest::keyClick(&axial, Qt::Key_R);  // its own, not the 3D view's
  EXPECT_EQ(scene().camera, camera);
}

TEST_F(Slices, DoubleClickFillsTheWindowAndBackAndLeavesTheCrosshair) {
  glm::dvec3 before = slices().crosshairMm;
  for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal}) {
    QTest::mouseClick(&slice(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_NE(slices().crosshairMm, before);
    QTest::mouseDClick(&slice(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_EQ(slices().layout, Layout::Slice);
    EXPECT_EQ(slice(kind).size(), views().size());
    EXPECT_FALSE(viewport().isVisible());
    EXPECT_EQ(slices().crosshairMm, before);
    QTest::mouseDClick(&slice(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_EQ(slices().layout, Layout::FourUp);
  }
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_EQ(viewport().size(), views().size());
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_TRUE(slice(SliceKind::Axial).isVisible());
  EXPECT_TRUE(settle());
}

TEST_F(Slices, LayoutsKeepTheOne3dViewAndAreRemembered) {
  Viewport* view = &viewport();
  for (auto [key, layout] : {std::pair{Qt::Key_F3, Layout::Volume},
                             {Qt::Key_F4, Layout::VolumeAndSlice},
                             {Qt::Key_F5, Layout::Slice},
                             {Qt::Key_F2, Layout::FourUp}}) {
    QTest::keyClick(mWindow.get(), key);
    EXPECT_EQ(slices().layout, layout);
    EXPECT_EQ(&viewport(), view);
    EXPECT_EQ(viewport().isVisible(), layout != Layout::Slice);
    EXPECT_EQ(ViewGrid::layoutFor(scene()), layout);
  }
  EXPECT_TRUE(settle());
}

TEST_F(Slices, GapsCanBeDragged) {
  int before = slice(SliceKind::Axial).width();
  QPoint gap(slice(SliceKind::Axial).geometry().right() + 2, 40);
  drag(views(), gap, gap + QPoint(60, 0));
  EXPECT_NEAR(slice(SliceKind::Axial).width(), before + 60, 4);
  EXPECT_EQ(slice(SliceKind::Coronal).width(), slice(SliceKind::Axial).width());
}

TEST_F(Slices, ThePointerSaysValueAndStructure) {
  mWindow->openPaths({path("phantom_labels.seg.nrrd")}, true);
  ASSERT_TRUE(waitForJob());
  QSignalSpy spy(&slice(SliceKind::Coronal), &SliceView::pointedAt);
  // Onto a structure, wherever the phantom has one.
  const LabelVolume& labels = *scene().labels.data;
  glm::dvec3 world(0.0);
  glm::ivec3 dims = labels.dims();
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
    if (glm::ivec3 v(i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y); labels.at(v))
      world = glm::dvec3(labels.worldFromVoxel() * glm::dvec4(v, 1));
  mWindow->document().view([&](scene::Scene& s) { scene::moveCrosshair(s, world); });
  SliceView& coronal = slice(SliceKind::Coronal);
  QPointF place = placeOf(SliceKind::Coronal, world);
  spy.clear();
  QMouseEvent move(QEvent::MouseMove, place, coronal.mapToGlobal(place), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&coronal, &move);
  ASSERT_EQ(spy.size(), 1);
  auto pick = spy[0][0].value<render::Pick>();
  EXPECT_NE(pick.structure, 0);
  EXPECT_LT(glm::length(pick.worldMm - world), 1.0);
}

TEST_F(Slices, CtrlClickIn3dMovesTheCrosshairThere) {
  ASSERT_TRUE(settle());
  QPoint place(viewport().width() / 2, viewport().height() / 2);
  auto pick = viewport().pickAt(place);
  ASSERT_TRUE(pick && pick->hit);
  QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ControlModifier, place);
  EXPECT_LT(glm::length(slices().crosshairMm - pick->worldMm), 1e-6);
}

TEST_F(Slices, TheWindowShowsWhatTheBatchDraws) {
  SliceView& axial = slice(SliceKind::Axial);
  mWindow->document().view([](scene::Scene& s) { s.slices.showCrosshair = false; });
  QTest::qWait(300);
  ASSERT_TRUE(axial.isComplete());
  QImage shown = axial.grab().toImage();
  render::SliceImage drawn = render::drawSlice(scene(), SliceKind::Axial, {axial.width(), axial.height()});
  // Between the words at the sides.
  int differing = 0;
  for (int y = axial.height() / 4; y < axial.height() * 3 / 4; ++y)
    for (int x = axial.width() / 4; x < axial.width() * 3 / 4; ++x)
      differing += (shown.pixel(x, y) & 0xffffff) != (drawn.pixels[std::size_t(y * axial.width() + x)] & 0xffffff);
  EXPECT_EQ(differing, 0);
}

TEST_F(Slices, EveryLayoutSettlesInASmallWindow) {
  mWindow->resize(640, 420);
  for (auto layout : {Layout::Slice, Layout::VolumeAndSlice, Layout::FourUp}) {
    views().setLayout(layout);
    EXPECT_TRUE(settle());
    for (auto kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
      if (slice(kind).isVisible()) {
        EXPECT_TRUE(views().rect().contains(slice(kind).geometry()));
      }
  }
}

}  // namespace velum::gui
