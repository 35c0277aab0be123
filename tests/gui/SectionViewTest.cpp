#include <QImage>

#include <QSignalSpy>

#include "WindowFixture.h"
#include "session/section/SectionTool.h"

namespace velum::gui {

using scene::Layout;
using scene::SectionKind;

/// A window with the phantom in four views.
class Sections : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 700);
    openPhantom();
    views().setLayout(Layout::FourUp);
    QTest::qWait(20);
  }
  ViewGrid& views() { return mWindow->views(); }
  SectionView& section(SectionKind kind) { return views().section(kind); }
  const scene::Sections& sections() { return scene().sections; }
  QPoint placeOf(SectionKind kind, glm::dvec3 world) {
    glm::dvec2 p = scene::sectionPixelFromWorld(section(kind).plane(), world);
    return {int(std::lround(p.x)), int(std::lround(p.y))};
  }
  void wheel(SectionView& view, QPointF place, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent event(place, view.mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton, keys,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
  }
};

TEST_F(Sections, ADragMovesTheCrosshairInTheOthersToo) {
  SectionView& axial = section(SectionKind::Axial);
  glm::dvec3 before = sections().crosshair;
  int painted = section(SectionKind::Sagittal).paintCount();
  QPoint to = placeOf(SectionKind::Axial, before + glm::dvec3(6, -4, 0));
  drag(axial, placeOf(SectionKind::Axial, before), to);
  EXPECT_EQ(placeOf(SectionKind::Axial, sections().crosshair), to);
  EXPECT_EQ(sections().crosshair.z, before.z);
  QTest::qWait(50);
  EXPECT_GT(section(SectionKind::Sagittal).paintCount(), painted);
  EXPECT_EQ(mWindow->document().undoLabel(), "Move view");
  EXPECT_FALSE(mWindow->document().isModified());
}

TEST_F(Sections, MovingTheCrosshairLeavesThe3dPictureAlone) {
  ASSERT_TRUE(settle());
  double ms = viewport().stats().frameMs;
  drag(section(SectionKind::Coronal), {60, 60}, {90, 80});
  drag(section(SectionKind::Coronal), {60, 60}, {90, 80}, Qt::RightButton);  // its grey window
  QTest::qWait(300);
  EXPECT_TRUE(viewport().isConverged());
  EXPECT_EQ(viewport().stats().frameMs, ms);
}

TEST_F(Sections, TheWheelScrollsWholePlanesAndZoomsAboutThePointer) {
  SectionView& sagittal = section(SectionKind::Sagittal);
  auto before = scene::sectionIndex(scene(), SectionKind::Sagittal);
  wheel(sagittal, {100, 100}, 1);
  // Forward is away from the viewer, who stands on the patient's left.
  EXPECT_EQ(scene::sectionIndex(scene(), SectionKind::Sagittal)->index, before->index - 1);
  glm::dvec2 pointer(120, 80);
  glm::dvec3 held = scene::worldFromSectionPixel(sagittal.plane(), pointer);
  wheel(sagittal, {pointer.x, pointer.y}, 3, Qt::ControlModifier);
  EXPECT_LT(glm::length(scene::sectionPixelFromWorld(sagittal.plane(), held) - pointer), 1e-6);
  EXPECT_GT(sections().sagittal.height, 0);
  QTest::keyClick(&sagittal, Qt::Key_F);
  EXPECT_EQ(sections().sagittal.height, 0);
}

TEST_F(Sections, RightDragSetsTheWindowInOneUndoStep) {
  glm::dvec2 before = scene::effectiveWindow(scene().volume);
  drag(section(SectionKind::Axial), {60, 60}, {110, 40}, Qt::RightButton);
  glm::dvec2 after = scene::effectiveWindow(scene().volume);
  EXPECT_GT(after.y, before.y);
  EXPECT_LT(after.x, before.x);
  EXPECT_EQ(mWindow->document().undoLabel(), "Change window");
  mWindow->document().undo();
  EXPECT_EQ(scene::effectiveWindow(scene().volume), before);
  EXPECT_NE(mWindow->document().undoLabel(), "Change window");
}

TEST_F(Sections, MiddleDragPansAndAKnobTurnsTheOthers) {
  SectionView& coronal = section(SectionKind::Coronal);
  drag(coronal, {60, 60}, {75, 52}, Qt::MiddleButton);
  EXPECT_NE(sections().coronal.pan, glm::dvec2(0));
  QTest::keyClick(&coronal, Qt::Key_R);
  EXPECT_EQ(sections().coronal, scene::Sections().coronal);
  QTest::mouseMove(&coronal, QPoint(30, 30));
  auto lines = session::crosshairLines(scene(), SectionKind::Coronal, coronal.plane());
  ASSERT_TRUE(lines.at(0).hasKnobs);
  glm::dvec2 knob = lines[0].knobs[1];
  drag(coronal, QPoint(int(knob.x), int(knob.y)), QPoint(int(knob.x), int(knob.y) - 40));
  EXPECT_TRUE(scene::isOblique(sections(), SectionKind::Axial));
  EXPECT_TRUE(scene::isOblique(sections(), SectionKind::Sagittal));
  EXPECT_FALSE(scene::isOblique(sections(), SectionKind::Coronal));
  mWindow->actions().find("sections.reset")->trigger();
  EXPECT_FALSE(scene::isOblique(sections(), SectionKind::Axial));
}

TEST_F(Sections, KeysMoveAndScroll) {
  SectionView& axial = section(SectionKind::Axial);
  axial.setFocus();
  glm::dvec3 before = sections().crosshair;
  double mm = scene::sectionStep(scene());
  QTest::keyClick(&axial, Qt::Key_Right);
  QTest::keyClick(&axial, Qt::Key_Up);
  EXPECT_LT(glm::length(sections().crosshair - before - glm::dvec3(mm, -mm, 0)), 1e-9);
  auto index = scene::sectionIndex(scene(), SectionKind::Axial)->index;
  QTest::keyClick(&axial, Qt::Key_PageUp);  // away: up the body
  EXPECT_EQ(scene::sectionIndex(scene(), SectionKind::Axial)->index, index + 1);
  QTest::keyClick(&axial, Qt::Key_Home);
  EXPECT_EQ(sections().crosshair, before);
  scene::Camera camera = scene().camera;
  QTest::keyClick(&axial, Qt::Key_R);  // its own, not the 3D view's
  EXPECT_EQ(scene().camera, camera);
}

TEST_F(Sections, DoubleClickFillsTheWindowAndBackAndLeavesTheCrosshair) {
  glm::dvec3 before = sections().crosshair;
  for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    QTest::mouseClick(&section(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_NE(sections().crosshair, before);
    QTest::mouseDClick(&section(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_EQ(sections().layout, Layout::Section);
    EXPECT_EQ(section(kind).size(), views().size());
    EXPECT_FALSE(viewport().isVisible());
    EXPECT_EQ(sections().crosshair, before);
    QTest::mouseDClick(&section(kind), Qt::LeftButton, {}, {30, 60});
    EXPECT_EQ(sections().layout, Layout::FourUp);
  }
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_EQ(viewport().size(), views().size());
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_TRUE(section(SectionKind::Axial).isVisible());
  EXPECT_TRUE(settle());
}

TEST_F(Sections, ASecondDoubleClickGoesBackToTheLayoutThatWasThere) {
  QTest::keyClick(mWindow.get(), Qt::Key_F4);
  ASSERT_EQ(sections().layout, Layout::VolumeAndSection);
  ASSERT_TRUE(settle());
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_EQ(sections().layout, Layout::Volume);
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, {30, 60});
  EXPECT_EQ(sections().layout, Layout::VolumeAndSection);
}

TEST_F(Sections, LayoutsKeepTheOne3dViewAndAreRemembered) {
  Viewport* view = &viewport();
  for (auto [key, layout] : {std::pair{Qt::Key_F3, Layout::Volume},
                             {Qt::Key_F4, Layout::VolumeAndSection},
                             {Qt::Key_F5, Layout::Section},
                             {Qt::Key_F2, Layout::FourUp}}) {
    QTest::keyClick(mWindow.get(), key);
    EXPECT_EQ(sections().layout, layout);
    EXPECT_EQ(&viewport(), view);
    EXPECT_EQ(viewport().isVisible(), layout != Layout::Section);
    EXPECT_EQ(ViewGrid::layoutFor(scene()), layout);
  }
  EXPECT_TRUE(settle());
}

TEST_F(Sections, GapsCanBeDragged) {
  int before = section(SectionKind::Axial).width();
  QPoint gap(section(SectionKind::Axial).geometry().right() + 2, 40);
  drag(views(), gap, gap + QPoint(60, 0));
  EXPECT_NEAR(section(SectionKind::Axial).width(), before + 60, 4);
  EXPECT_EQ(section(SectionKind::Coronal).width(), section(SectionKind::Axial).width());
}

TEST_F(Sections, ThePointerSaysValueAndStructure) {
  mWindow->openPaths({path("phantom_labels.seg.nrrd")}, true);
  ASSERT_TRUE(waitForJob());
  QSignalSpy spy(&section(SectionKind::Coronal), &SectionView::pointedAt);
  // Onto a structure, wherever the phantom has one.
  const LabelVolume& labels = *scene().labels.data;
  glm::dvec3 world(0.0);
  glm::ivec3 dims = labels.dims();
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
    if (glm::ivec3 v(i % dims.x, i / dims.x % dims.y, i / dims.x / dims.y); labels.at(v))
      world = glm::dvec3(labels.worldFromVoxel() * glm::dvec4(v, 1));
  mWindow->document().view([&](scene::Scene& s) { scene::moveCrosshair(s, world); });
  SectionView& coronal = section(SectionKind::Coronal);
  QPointF place = placeOf(SectionKind::Coronal, world);
  spy.clear();
  QMouseEvent move(QEvent::MouseMove, place, coronal.mapToGlobal(place), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&coronal, &move);
  ASSERT_EQ(spy.size(), 1);
  auto pick = spy[0][0].value<render::Pick>();
  EXPECT_NE(pick.structure, 0);
  EXPECT_LT(glm::length(pick.world - world), 1.0);
}

TEST_F(Sections, CtrlClickIn3dMovesTheCrosshairThere) {
  ASSERT_TRUE(settle());
  QPoint place(viewport().width() / 2, viewport().height() / 2);
  auto pick = viewport().pickAt(place);
  ASSERT_TRUE(pick && pick->hit);
  QTest::mouseClick(&viewport(), Qt::LeftButton, Qt::ControlModifier, place);
  EXPECT_LT(glm::length(sections().crosshair - pick->world), 1e-6);
}

TEST_F(Sections, TheWindowShowsWhatTheBatchDraws) {
  SectionView& axial = section(SectionKind::Axial);
  mWindow->document().view([](scene::Scene& s) { s.sections.showCrosshair = false; });
  QTest::qWait(300);
  ASSERT_TRUE(axial.isComplete());
  QImage shown = axial.grab().toImage();
  render::SectionImage drawn = render::drawSection(scene(), SectionKind::Axial, {axial.width(), axial.height()});
  // Between the words at the sides.
  int differing = 0;
  for (int y = axial.height() / 4; y < axial.height() * 3 / 4; ++y)
    for (int x = axial.width() / 4; x < axial.width() * 3 / 4; ++x)
      differing += (shown.pixel(x, y) & 0xffffff) != (drawn.pixels[std::size_t(y * axial.width() + x)] & 0xffffff);
  EXPECT_EQ(differing, 0);
}

TEST_F(Sections, EveryLayoutSettlesInASmallWindow) {
  mWindow->resize(640, 420);
  for (auto [layout, sections] : {std::pair(Layout::Section, 1), {Layout::VolumeAndSection, 1}, {Layout::FourUp, 3}}) {
    views().setLayout(layout);
    EXPECT_TRUE(settle());
    int visible = 0;
    for (auto kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal})
      if (section(kind).isVisible()) {
        EXPECT_TRUE(views().rect().contains(section(kind).geometry()));
        EXPECT_GT(section(kind).width() * section(kind).height(), 5000);
        ++visible;
      }
    EXPECT_EQ(visible, sections) << enumName(layout);
  }
}

}  // namespace velum::gui
