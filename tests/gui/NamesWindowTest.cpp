// Names of what is seen in the window, values that take their time, and what is saved of them.
#include <QListWidget>

#include "Shots.h"
#include "WindowFixture.h"
#include "gui/kit/Points.h"
#include "gui/rows/EyeList.h"
#include "scene/Mark.h"
#include "session/command/Command.h"

namespace velum::gui {
namespace {

using scene::Mark, scene::MarkKind;

class NamesWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1300, 860);
    mWindow->openPaths({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    ASSERT_TRUE(waitForJob());
    drawSoon();
    ASSERT_TRUE(settle());
  }
  std::vector<session::PlacedWords> words() {
    QTest::qWait(50);  // until they are painted
    auto all = mWindow->models().lettering().words(viewport());
    return {all.begin(), all.end()};
  }
  const std::vector<Mark>& marks() { return scene().lettering.marks; }
  std::string valueOf(int row) { return child<EyeList>("markList")->valueAt(row).toStdString(); }
};

TEST_F(NamesWindow, StandBesideThePictureAndBecomeMarksWhereAHandDragsThem) {
  EXPECT_TRUE(words().empty());
  mWindow->actions().find("mark.names")->trigger();
  ASSERT_TRUE(settle());
  std::vector<session::PlacedWords> names = words();
  ASSERT_EQ(names.size(), 2u) << "upper and lower sphere";
  takeShot(*mWindow, "names");
  QPoint from = toPoint(0.5 * (names[0].low + names[0].high)).toPoint();
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&viewport(), from + QPoint(4, 6));
  QTest::mouseMove(&viewport(), from + QPoint(-20, 60));
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, from + QPoint(-20, 60));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].kind, MarkKind::Name);
  EXPECT_EQ(marks()[0].structure, names[0].structure);
  EXPECT_TRUE(marks()[0].wordsAt);
  drawSoon();
  ASSERT_TRUE(settle());
  std::vector<session::PlacedWords> after = words();
  ASSERT_EQ(after.size(), 2u) << "each has one name still";
  auto own = std::ranges::find(after, marks()[0].id, &session::PlacedWords::mark);
  ASSERT_NE(own, after.end());
  glm::dvec2 moved = 0.5 * (own->low + own->high) - 0.5 * (names[0].low + names[0].high);
  EXPECT_NEAR(glm::distance(moved, glm::dvec2(-20, 60)), 0.0, 12.0);
  EXPECT_EQ(mWindow->document().undoLabel(), "Move words of mark");
  mWindow->document().undo();
  EXPECT_TRUE(marks().empty()) << "one step";
}

TEST_F(NamesWindow, LetteringStaysWhereHandlesArePutAway) {
  mWindow->actions().find("mark.names")->trigger();
  ASSERT_TRUE(settle());
  mWindow->toolbox().setHandlesShown(false);
  EXPECT_EQ(words().size(), 2u);
  mWindow->actions().find("mark.names")->trigger();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(words().empty());
}

TEST_F(NamesWindow, ACircleThatIsDrawnOnASectionIsFlatAndOneInThePictureIsABall) {
  mWindow->views().setLayout(scene::Layout::FourUp);
  ASSERT_TRUE(settle());
  SectionView& axial = mWindow->views().section(scene::SectionKind::Axial);
  mWindow->actions().find("mark.circle")->trigger();
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center());
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() + QPoint(40, 0));
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center() + QPoint(-30, -30));
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, viewport().rect().center() + QPoint(-50, -30));
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_NEAR(std::abs(glm::dot(marks()[0].normal, glm::dvec3(0, 0, 1))), 1.0, 1e-9);
  EXPECT_EQ(marks()[1].normal, glm::dvec3(0.0));
}

TEST_F(NamesWindow, ValuesThatTakeTheirTimeComeIntoTheListAndIntoTheTable) {
  mWindow->jobs().run(session::parseCall("mark.add circle 0,0,0;6,0,0"));
  ASSERT_TRUE(settle());
  ASSERT_TRUE(QTest::qWaitFor([&] { return valueOf(0).starts_with("mean"); }, 20000)) << valueOf(0);
  for (const char* name : {"table.csv", "table.json"}) {
    mWindow->marks().saveTableTo(path(name));
    ASSERT_TRUE(waitForJob());
    QByteArray table = bytesOf(path(name));
    EXPECT_TRUE(table.contains("circle")) << name;
    EXPECT_TRUE(table.contains("upper sphere")) << "structures, too";
  }
}

}  // namespace
}  // namespace velum::gui
