// Pins and kernels in the real window: set, dragged, selected, removed, undone.
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QToolButton>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Theme.h"
#include "gui/membrane/SheetGrips.h"

namespace velum::gui {

class SheetHandsWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(860, 820);
  }
  void addMembrane(scene::Layout layout = scene::Layout::Volume) {
    openPhantom();
    mWindow->views().setLayout(layout);
    drawSoon();
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene().cuts.size(), 1u);
    ASSERT_TRUE(settle());
  }
  session::Document& document() { return mWindow->document(); }
  const scene::Membrane& membrane() { return *scene().cuts[0].membrane; }
  void press(const char* action) { mWindow->actions().find(action)->trigger(); }
  QPoint pixelOf(glm::dvec3 world) {
    auto pixel = scene::pixelFromWorld(scene().camera, size(), world).value();
    return {int(std::lround(pixel.x)), int(std::lround(pixel.y))};
  }
  /// How far the sheet passes from a pin, mm.
  double offPin(const scene::Pin& pin) {
    auto sheet = viewport().membranes().index(scene().cuts[0].id);
    glm::dvec3 normal(scene::worldFromCut(scene().cuts[0])[2]);
    auto point = session::sheetOnRay(scene().cuts[0], *sheet, {pin.place + normal * 1000.0, -normal});
    return point ? glm::length(point->place - pin.place) : 1e30;
  }
};

TEST_F(SheetHandsWindow, APinIsSetDraggedUndoneAndRemoved) {
  addMembrane();
  press("membrane.pin");
  EXPECT_TRUE(child<QPushButton>("pinTool")->isChecked());
  QPoint middle(viewport().width() / 2 + 40, viewport().height() / 2 - 60);
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, middle);
  ASSERT_EQ(membrane().pins.size(), 1u);
  EXPECT_EQ(document().undoLabel(), "Add pin");
  EXPECT_FALSE(child<QPushButton>("pinTool")->isChecked());
  ASSERT_TRUE(settle());
  double millionth = 1e-6 * scene().cuts[0].size.x;
  EXPECT_LT(offPin(membrane().pins[0]), 10 * millionth);  // floats
  viewport().lookFrom(scene::StandardView::Oblique);
  ASSERT_TRUE(settle());
  scene::Membrane before = membrane();
  QPoint pin = pixelOf(before.pins[0].place);
  drag(pin, pin + QPoint(0, -30), Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_EQ(document().undoLabel(), "Move pin");
  glm::dvec3 way = membrane().pins[0].place - before.pins[0].place, normal(scene::worldFromCut(scene().cuts[0])[2]);
  EXPECT_GT(glm::length(way), 1.0);
  EXPECT_LT(glm::length(glm::cross(way, normal)), 1e-6) << "with Shift along the normal";
  EXPECT_LT(pixelOf(membrane().pins[0].place).y(), pin.y() - 2) << "upwards, as the hand goes";
  ASSERT_TRUE(settle());
  EXPECT_LT(offPin(membrane().pins[0]), 10 * millionth);
  document().undo();
  EXPECT_EQ(membrane(), before) << "one step for the whole drag";
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, pin);
  QTest::keyClick(&viewport(), Qt::Key_Delete);
  EXPECT_TRUE(membrane().pins.empty());
  EXPECT_EQ(scene().cuts.size(), 1u) << "the cut has the same key";
  EXPECT_EQ(document().undoLabel(), "Remove pin");
  ASSERT_TRUE(settle());
}

TEST_F(SheetHandsWindow, PinsAndForcesAreSetWithoutAMouse) {
  addMembrane();
  viewport().setFocus();
  press("membrane.pin");
  auto key = [&](Qt::Key which, Qt::KeyboardModifiers keys = {}) { QTest::keyClick(&viewport(), which, keys); };
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Up, Qt::ShiftModifier);
  takeShot(*mWindow, "key-pointer");
  key(Qt::Key_Return);
  ASSERT_EQ(membrane().pins.size(), 1u);
  QPoint middle(viewport().width() / 2 + 24, viewport().height() / 2 - 24);
  EXPECT_LT(glm::length(glm::dvec2(pixelOf(membrane().pins[0].place).x() - middle.x(),
                                   pixelOf(membrane().pins[0].place).y() - middle.y())),
            3.0);
  // A force: Space at its middle, arrows to its rim, Space.
  press("membrane.push");
  key(Qt::Key_Left, Qt::ShiftModifier);
  key(Qt::Key_Space);
  ASSERT_EQ(membrane().field.kernels.size(), 1u);
  double before = membrane().field.kernels[0].radius;
  for (int i = 0; i < 4; ++i) key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Space);
  EXPECT_NE(membrane().field.kernels[0].radius, before);
  EXPECT_FALSE(mWindow->toolbox().active()) << "laid down, as after a drag by mouse";
  document().undo();
  EXPECT_TRUE(membrane().field.kernels.empty()) << "one step";
  // Without a tool the arrows are the view's own.
  key(Qt::Key_Right);
  EXPECT_EQ(document().scene().cuts.size(), 1u);
}

TEST_F(SheetHandsWindow, AKernelIsDraggedOnASectionAndEditedInTheList) {
  addMembrane(scene::Layout::FourUp);
  SectionView& view = mWindow->views().section(scene::SectionKind::Axial);
  press("membrane.push");
  QPoint from(view.width() / 2 + 20, view.height() / 2 + 15), to = from + QPoint(30, 10);
  drag(view, from, to);
  ASSERT_EQ(membrane().field.kernels.size(), 1u);
  EXPECT_EQ(document().undoLabel(), "Push sheet");
  auto kernel = membrane().field.kernels[0];
  scene::SectionPlane plane = view.plane();
  EXPECT_LT(glm::length(kernel.centre - scene::worldFromSectionPixel(plane, {from.x(), from.y()})), 1e-9);
  EXPECT_NEAR(kernel.radius, std::hypot(30, 10) * plane.lengthPerPixel, 1e-9);
  EXPECT_GT(kernel.strength, 0.0);
  // Its rim sets the radius; Esc has laid the tool down already.
  drag(view, to, to + QPoint(15, 5));
  EXPECT_EQ(document().undoLabel(), "Resize force");
  EXPECT_NEAR(membrane().field.kernels[0].radius, std::hypot(45, 15) * plane.lengthPerPixel, 1e-6);
  document().undo();
  EXPECT_EQ(membrane().field.kernels[0], kernel);
  drag(view, from, from + QPoint(-25, 0));
  EXPECT_EQ(document().undoLabel(), "Move force");
  // In the list.
  QDoubleSpinBox* strength = nullptr;
  for (auto* spin : mWindow->findChildren<QDoubleSpinBox*>())
    if (spin->accessibleName().startsWith("Strength, ") && spin->isVisibleTo(mWindow.get())) strength = spin;
  ASSERT_TRUE(strength);
  strength->setValue(-800);
  EXPECT_EQ(membrane().field.kernels[0].strength, -800.0);
  auto* away = child<QToolButton>("removeHand");
  ASSERT_TRUE(away);
  away->click();
  EXPECT_TRUE(membrane().field.kernels.empty());
  EXPECT_EQ(document().undoLabel(), "Remove force");
  ASSERT_TRUE(settle());
}

TEST_F(SheetHandsWindow, EscLaysTheToolDownAndWithoutAMembraneItSaysWhatIsMissing) {
  addMembrane();
  press("membrane.pull");
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(child<QPushButton>("pullTool")->isChecked());
  document().undo();
  press("membrane.pin");
  EXPECT_TRUE(mWindow->messages().text().contains("membrane"));
}

TEST_F(SheetHandsWindow, AllOfItIsSeenInBothThemes) {
  mWindow->resize(1500, 980);
  addMembrane(scene::Layout::FourUp);
  viewport().lookFrom(scene::StandardView::Oblique);
  document().edit("Put hands on", [](scene::Scene& scene) {
    scene::Cut& cut = scene.cuts[0];
    glm::dmat4 world = scene::worldFromCut(cut);
    auto at = [&](double x, double y, double z) {
      return glm::dvec3(world * glm::dvec4(glm::dvec3(x, y, z) * cut.size, 1.0));
    };
    double r = 0.11 * cut.size.x;
    cut.membrane->pins = {{{0.75, 0.5}, at(0.25, 0.0, 0.35)}, {{0.5, 0.8}, at(0.0, 0.3, -0.2)}};
    cut.membrane->field.kernels = {{at(-0.3, -0.3, 0.05), r, 500}, {at(-0.2, 0.3, -0.25), 1.2 * r, -800}};
    cut.membrane->look = scene::SheetLook::Grid;
    cut.size.x *= 0.85;
    cut.size.y *= 0.85;
  });
  ASSERT_TRUE(settle());
  std::vector<QImage> themes;
  for (auto kind : {ThemeKind::Dark, ThemeKind::Light}) {
    applyTheme(*qApp, kind);
    QTest::qWait(300);
    ASSERT_TRUE(settle());
    takeShot(*mWindow, kind == ThemeKind::Dark ? "hands-dark" : "hands-light");
    themes.push_back(mWindow->grab().toImage());
  }
  EXPECT_NE(themes[0], themes[1]);
  applyTheme(*qApp, ThemeKind::Dark);
  ASSERT_TRUE(settle());
  // Each of them on the picture and on the sections: without one it is another picture.
  auto seen = [&] {
    EXPECT_TRUE(settle());
    return mWindow->views().grab().toImage();
  };
  QImage all = seen();
  for (bool ofPins : {true, false}) {
    document().edit("Take one off", [&](scene::Scene& scene) {
      auto& membrane = *scene.cuts[0].membrane;
      ofPins ? membrane.pins.pop_back() : membrane.field.kernels.pop_back();
    });
    QImage fewer = seen();
    EXPECT_NE(all, fewer);
    all = fewer;
  }
}

}  // namespace velum::gui
