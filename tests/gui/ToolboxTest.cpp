// Who has the pointer: at most one tool, whichever was taken up last; its buttons and commands say so; a click does
// what the tool does and nothing else.
#include <QAbstractButton>

#include "WindowFixture.h"

namespace velum::gui {

namespace {

/// A tool by its switches: a button of the panel, a command of the menus, or both.
struct Row {
  const char *button, *action;
  const char* step;        ///< the name of the undo step that it makes
  std::size_t clicks = 1;  ///< after which it does
  /// What of the scene it changes.
  void (*copyChanged)(const scene::Scene& from, scene::Scene& to) = [](const scene::Scene& from, scene::Scene& to) {
    to.cuts = from.cuts;
  };
};

void copyMarks(const scene::Scene& from, scene::Scene& to) { to.lettering.marks = from.lettering.marks; }
void copyTransfer(const scene::Scene& from, scene::Scene& to) { to.volume.transfer = from.volume.transfer; }

constexpr Row kTools[] = {{"protectThis", nullptr, "Protect from sheet"},
                          {"letThrough", nullptr, "Let sheet through"},
                          {"pinTool", "membrane.pin", "Add pin"},
                          {"pushTool", "membrane.push", "Push sheet"},
                          {"pullTool", "membrane.pull", "Pull sheet"},
                          {"sketchKeep", nullptr, "Sketch what to protect"},
                          {"sketchAvoid", nullptr, "Sketch what to let through"},
                          {nullptr, "cut.threePoints", "Plane through three points", 3},
                          {nullptr, "look.showThis", "Show this tissue", 1, copyTransfer},
                          {"mark.distanceTool", "mark.distance", "Add distance", 2, copyMarks}};

}  // namespace

class ToolWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 860);
    openPhantom();
    drawSoon();
    mWindow->actions().find("cut.addMembrane")->trigger();
    ASSERT_TRUE(waitForJob());
    // What tools say takes room from the views: from the beginning, so that places stay where they are.
    mWindow->messages().showNote("Ready");
    ASSERT_TRUE(settle());
  }
  session::Document& document() { return mWindow->document(); }
  void press(const Row& row, bool byAction) {
    if (row.action && (byAction || !row.button))
      mWindow->actions().find(row.action)->trigger();
    else
      child<QAbstractButton>(row.button)->click();
  }
  /// Exactly this tool's switches are on; null: none is.
  void expectOnly(const Row* active, const std::string& when) {
    EXPECT_EQ(mWindow->toolbox().active() != nullptr, active != nullptr) << when;
    for (const Row& row : kTools) {
      if (row.button) {
        EXPECT_EQ(child<QAbstractButton>(row.button)->isChecked(), &row == active) << row.button << ", " << when;
      }
      if (row.action) {
        EXPECT_EQ(mWindow->actions().find(row.action)->isChecked(), &row == active) << row.action << ", " << when;
      }
    }
  }
  static std::string nameOf(const Row& row) { return row.button ? row.button : row.action; }

  /// Something for each tool to change.
  void prepare(const Row& row) {
    bool clears = std::string(row.step) != "Let sheet through";
    glm::dvec2 range = scene().volume.data->range;
    document().edit("Prepare", [&](scene::Scene& scene) {
      scene::ForceField& field = scene.cuts[0].membrane->field;
      field = {};
      if (!clears) field.byValue = {{range.x, 400}, {range.y, 400}};
      scene.volume.transfer.opacities = {{0, 0.3}, {range.y, 0.6}};
    });
    ASSERT_TRUE(settle());
  }
  /// Clicks until the tool has what it wants; its step is then the only change.
  void expectOneStep(const Row& row, QWidget& view, const std::vector<QPoint>& places) {
    prepare(row);
    auto steps = document().undoLabels().size();
    scene::Scene before = scene();
    int structure = mWindow->selection().structure();
    press(row, false);
    for (std::size_t i = 0; i < row.clicks; ++i) QTest::mouseClick(&view, Qt::LeftButton, {}, places.at(i));
    EXPECT_EQ(document().undoLabels().size(), steps + 1) << nameOf(row);
    EXPECT_EQ(document().undoLabel(), row.step) << nameOf(row);
    EXPECT_EQ(mWindow->selection().structure(), structure) << nameOf(row);
    scene::Scene rest = scene();
    row.copyChanged(before, rest);
    EXPECT_NE(rest, scene()) << nameOf(row) << " changed nothing";
    EXPECT_EQ(rest, before) << nameOf(row) << " changed what is none of its business";
    document().undo();
    EXPECT_EQ(scene(), before) << nameOf(row);
    QTest::keyClick(&view, Qt::Key_Escape);
    EXPECT_EQ(mWindow->toolbox().active(), nullptr) << nameOf(row);
  }
};

TEST_F(ToolWindow, TakingOneUpLaysEveryOtherDown) {
  for (const Row& first : kTools)
    for (const Row& second : kTools) {
      if (&first == &second) continue;
      std::string when = nameOf(first) + " then " + nameOf(second);
      press(first, false);
      expectOnly(&first, when);
      press(second, true);
      expectOnly(&second, when);
      press(second, false);
      expectOnly(nullptr, when + " twice");
    }
}

TEST_F(ToolWindow, EscapeLaysAnyDown) {
  for (const Row& row : kTools) {
    press(row, true);
    expectOnly(&row, nameOf(row));
    QTest::keyClick(&viewport(), Qt::Key_Escape);
    expectOnly(nullptr, nameOf(row) + " after Esc");
  }
}

TEST_F(ToolWindow, AClickOnASectionIsOneStepAndNothingElse) {
  mWindow->views().setLayout(scene::Layout::FourUp);
  ASSERT_TRUE(settle());
  // The sagittal section crosses the sheet: along its line there is place for a pin.
  SectionView& view = mWindow->views().section(scene::SectionKind::Sagittal);
  const scene::Cut& cut = scene().cuts[0];
  auto sheet = viewport().membranes().index(cut.id);
  std::vector<QPoint> places;
  for (int y = view.height() / 4; y < 3 * view.height() / 4 && places.size() < 3; y += 4)
    for (int x = view.width() / 4; x < 3 * view.width() / 4 && places.size() < 3; x += 4)
      if (session::sheetAt(cut, *sheet, view.space(), {x, y}, 4.0) && view.pickAt(QPointF(x, y))->hit &&
          (places.empty() || (QPoint(x, y) - places.back()).manhattanLength() > 25))
        places.emplace_back(x, y);
  ASSERT_EQ(places.size(), 3u);
  places[1] += QPoint(12, 7);  // three on a line are no plane
  for (const Row& row : kTools) expectOneStep(row, view, places);
}

TEST_F(ToolWindow, AClickInThePictureIsOneStepAndNothingElse) {
  prepare(kTools[0]);
  std::vector<QPoint> places;
  const scene::Cut& cut = scene().cuts[0];
  auto sheet = viewport().membranes().index(cut.id);
  for (int y = viewport().height() / 4; y < viewport().height() && places.size() < 3; y += 9)
    for (int x = viewport().width() / 4; x < viewport().width() && places.size() < 3; x += 9) {
      ViewPoint at(viewport(), scene(), QPointF(x, y));
      bool isFree =
          at.pick() && !mWindow->toolbox().isInTheWay(at) && session::sheetAt(cut, *sheet, at.space(), at.pixel(), 4.0);
      bool isNear = !places.empty() && (QPoint(x, y) - places.back()).manhattanLength() < 40;
      // Three on a line are no plane.
      bool isAside = places.size() < 2 || std::abs(x - places[1].x()) + 40 < std::abs(y - places[1].y()) * 2;
      if (isFree && !isNear && isAside) places.emplace_back(x, y);
    }
  ASSERT_EQ(places.size(), 3u);
  for (const Row& row : kTools) expectOneStep(row, viewport(), places);
}

TEST_F(ToolWindow, PinsAndHandlesAreTakenWhateverToolIsActiveInThePicture) {
  auto gizmo = session::makeCutGizmo(scene(), scene().cuts[0], size());
  ASSERT_FALSE(gizmo.grips.empty());
  for (const char* button : {"protectThis", "sketchKeep"}) {
    viewport().lookFrom(scene::StandardView::Oblique);
    ASSERT_TRUE(settle());
    gizmo = session::makeCutGizmo(scene(), scene().cuts[0], size());
    auto tip = scene::pixelFromWorld(scene().camera, size(), gizmo.arrowTip);
    ASSERT_TRUE(tip);
    scene::Cut before = scene().cuts[0];
    child<QAbstractButton>(button)->click();
    QPoint from(int(tip->x), int(tip->y));
    drag(from, from + QPoint(0, -14));
    EXPECT_EQ(document().undoLabel(), "Move cut") << button;
    document().undo();
    EXPECT_EQ(scene().cuts[0], before);
    QTest::keyClick(&viewport(), Qt::Key_Escape);
  }
}

}  // namespace velum::gui
