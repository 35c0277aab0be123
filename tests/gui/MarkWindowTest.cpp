// Marks are set by clicks in the picture and on sections, dragged, moved by keys, listed and styled.
#include <QClipboard>
#include <QComboBox>
#include <QLineEdit>
#include <QListWidget>
#include <QToolButton>

#include "Shots.h"
#include "ShownPictures.h"
#include "WindowFixture.h"
#include "gui/kit/Points.h"
#include "gui/mark/MarkTool.h"
#include "scene/PlateStyles.h"

namespace velum::gui {
namespace {

using scene::Mark, scene::MarkKind;

class MarkWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 860);
    openPhantom();
    drawSoon();
    ASSERT_TRUE(settle());
  }
  const std::vector<Mark>& marks() { return scene().lettering.marks; }
  session::Document& document() { return mWindow->document(); }
  std::size_t steps() { return document().undoLabels().size(); }
  void takeUp(const char* id) { mWindow->actions().find(id)->trigger(); }
  MarkTool* tool() { return qobject_cast<MarkTool*>(mWindow->toolbox().active()); }
  QListWidget& list() { return *child<QListWidget>("markList"); }
  void click(QWidget& view, QPoint place) { QTest::mouseClick(&view, Qt::LeftButton, {}, place); }
  void showSections() {
    mWindow->views().setLayout(scene::Layout::FourUp);
    ASSERT_TRUE(settle());
  }
  SectionView& axial() { return mWindow->views().section(scene::SectionKind::Axial); }
  QPoint middleOf(const QWidget& view) { return view.rect().center(); }
  /// Places of the picture where something is seen, apart from each other.
  std::vector<QPoint> seen(std::size_t count, const std::function<bool(const ViewPoint&)>& suits = {}) {
    std::vector<QPoint> places;
    for (int y = 60; y < viewport().height() - 20 && places.size() < count; y += 17)
      for (int x = 20; x < viewport().width() - 20 && places.size() < count; x += 17) {
        ViewPoint at(viewport(), scene(), QPointF(x, y));
        bool isApart = std::all_of(places.begin(), places.end(),
                                   [&](QPoint p) { return (p - QPoint(x, y)).manhattanLength() > 60; });
        if (at.pick() && isApart && (!suits || suits(at))) places.emplace_back(x, y);
      }
    EXPECT_EQ(places.size(), count);
    return places;
  }
  /// A distance on the axial section, from the middle to the right.
  void addDistance() {
    showSections();
    takeUp("mark.distance");
    click(axial(), middleOf(axial()));
    click(axial(), middleOf(axial()) + QPoint(60, 0));
    ASSERT_EQ(marks().size(), 1u);
    QTest::keyClick(&axial(), Qt::Key_Escape);
    ASSERT_FALSE(tool());
    ASSERT_TRUE(settle());
  }
  QPoint pixelOf(SectionView& view, glm::dvec3 place) { return toPoint(*view.space().pixelFromWorld(place)).toPoint(); }
};

TEST_F(MarkWindow, TwoClicksInThePictureMakeADistanceOnWhatIsSeen) {
  std::vector<QPoint> places = seen(2);
  std::vector<glm::dvec3> wanted;
  for (QPoint place : places) wanted.push_back(viewport().pickAt(place)->world);
  std::size_t before = steps();
  int pictures = shownPictures(viewport());
  takeUp("mark.distance");
  click(viewport(), places[0]);
  EXPECT_TRUE(marks().empty());
  ASSERT_TRUE(tool() && tool()->isSetting());
  QTest::mouseMove(&viewport(), places[1]);
  takeShot(*mWindow, "mark-preview");
  click(viewport(), places[1]);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].kind, MarkKind::Distance);
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(glm::distance(marks()[0].points[std::size_t(i)], wanted[std::size_t(i)]), 0, 1e-6);
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(document().undoLabel(), "Add distance");
  EXPECT_EQ(viewport().shownCount(), pictures) << "the picture below is the same";
  EXPECT_EQ(mWindow->selection().mark(), 1);
  takeShot(*mWindow, "mark-distance");
  document().undo();
  EXPECT_TRUE(marks().empty());
  EXPECT_EQ(mWindow->selection().mark(), 0);
  EXPECT_TRUE(tool()) << "it stays for the next one";
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(tool());
}

TEST_F(MarkWindow, NothingIsSetWhereNothingIsSeenAndNeverOnWhatACutRemoved) {
  takeUp("mark.distance");
  click(viewport(), {3, viewport().height() - 3});
  EXPECT_FALSE(tool()->isSetting());
  EXPECT_TRUE(tool()->hint().contains("Nothing is there"));
  takeUp("mark.distance");
  takeUp("cut.addPlane");
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  auto isFree = [&](const ViewPoint& at) { return !mWindow->toolbox().isInTheWay(at); };
  std::vector<QPoint> places = seen(2, isFree);
  takeUp("mark.distance");
  for (QPoint place : places) click(viewport(), place);
  ASSERT_EQ(marks().size(), 1u);
  const scene::Cut& cut = scene().cuts[0];
  for (const glm::dvec3& point : marks()[0].points)
    EXPECT_GE(glm::dot(cut.centre - point, glm::normalize(cut.axis)), -1e-3 * glm::length(cut.size));
}

TEST_F(MarkWindow, OnASectionPointsLieInItsPlaneAndTheTableSaysHowLong) {
  addDistance();
  auto plane = *axial().space().section();
  for (const glm::dvec3& point : marks()[0].points) EXPECT_NEAR(scene::heightOverSection(plane, point), 0.0, 1e-9);
  EXPECT_NEAR(glm::distance(marks()[0].points[0], marks()[0].points[1]), 60 * plane.lengthPerPixel, 1e-9);
  ASSERT_EQ(list().count(), 1);
  EXPECT_EQ(list().item(0)->text(), "Distance");
  takeShot(*mWindow, "mark-section");
}

TEST_F(MarkWindow, AWayEndsByADoubleClickOrEnterAndBackspaceTakesAPointBack) {
  showSections();
  QPoint middle = middleOf(axial());
  takeUp("mark.path");
  click(axial(), middle);
  click(axial(), middle + QPoint(40, 0));
  click(axial(), middle + QPoint(40, 40));
  QTest::keyClick(&axial(), Qt::Key_Backspace);
  click(axial(), middle + QPoint(0, 40));
  QTest::mouseDClick(&axial(), Qt::LeftButton, {}, middle + QPoint(0, 40));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].points.size(), 3u);
  takeUp("mark.area");
  for (QPoint way : {QPoint(-50, -50), QPoint(-10, -50), QPoint(-10, -20), QPoint(-50, -20)})
    click(axial(), middle + way);
  axial().setFocus();
  QTest::keyClick(&axial(), Qt::Key_Return);
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_EQ(marks()[1].kind, MarkKind::Area);
  EXPECT_EQ(marks()[1].points.size(), 4u);
  takeUp("mark.angle");
  for (QPoint way : {QPoint(80, -50), QPoint(60, -20), QPoint(90, -10)}) click(axial(), middle + way);
  ASSERT_EQ(marks().size(), 3u);
  EXPECT_EQ(marks()[2].kind, MarkKind::Angle);
}

TEST_F(MarkWindow, ADoubleClickInThePictureEndsAWayAndLeavesTheView) {
  std::vector<QPoint> places = seen(3);
  takeUp("mark.path");
  for (QPoint place : places) click(viewport(), place);
  QTest::mouseDClick(&viewport(), Qt::LeftButton, {}, places[2]);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].points.size(), 3u);
  EXPECT_EQ(scene().sections.layout, scene::Layout::Volume);
}

TEST_F(MarkWindow, APointThatIsDraggedIsOneStep) {
  addDistance();
  glm::dvec3 before = marks()[0].points[1], other = marks()[0].points[0];
  QPoint at = pixelOf(axial(), before);
  std::size_t were = steps();
  drag(axial(), at, at + QPoint(20, 30));
  EXPECT_EQ(steps(), were + 1);
  EXPECT_EQ(document().undoLabel(), "Move point of mark");
  auto plane = *axial().space().section();
  glm::dvec3 wanted = before + 20 * plane.lengthPerPixel * plane.right - 30 * plane.lengthPerPixel * plane.up;
  EXPECT_NEAR(glm::distance(marks()[0].points[1], wanted), 0.0, 1e-6);
  EXPECT_EQ(marks()[0].points[0], other);
  document().undo();
  EXPECT_EQ(marks()[0].points[1], before);
}

TEST_F(MarkWindow, WordsAreDraggedToo) {
  addDistance();
  auto wordsOf = [&] {
    QTest::qWait(50);  // until they are painted
    const session::PlacedWords& words = mWindow->models().lettering().words(axial())[0];
    return toPoint(0.5 * (words.low + words.high)).toPoint();
  };
  QPoint words = wordsOf();
  drag(axial(), words, words + QPoint(15, 45));
  EXPECT_EQ(document().undoLabel(), "Move words of mark");
  ASSERT_TRUE(marks()[0].wordsAt);
  QPoint now = wordsOf();
  EXPECT_LE((now - words - QPoint(15, 45)).manhattanLength(), 2);
}

TEST_F(MarkWindow, KeysGoFromPointToPointAndMoveThem) {
  addDistance();
  axial().setFocus();
  glm::dvec3 first = marks()[0].points[0], second = marks()[0].points[1];
  glm::dvec3 crosshair = scene().sections.crosshair;
  auto plane = *axial().space().section();
  std::size_t were = steps();
  QTest::keyClick(&axial(), Qt::Key_Tab);
  QTest::keyClick(&axial(), Qt::Key_Right);
  QTest::keyClick(&axial(), Qt::Key_Right);
  EXPECT_NEAR(glm::distance(marks()[0].points[0], first + 2.0 * plane.lengthPerPixel * plane.right), 0.0, 1e-6);
  EXPECT_EQ(steps(), were + 1) << "moves of one point are one step";
  QTest::keyClick(&axial(), Qt::Key_Tab);
  QTest::keyClick(&axial(), Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR(glm::distance(marks()[0].points[1], second + 10.0 * plane.lengthPerPixel * plane.up), 0.0, 1e-6);
  EXPECT_EQ(steps(), were + 2);
  EXPECT_EQ(scene().sections.crosshair, crosshair);
  QTest::keyClick(&axial(), Qt::Key_Escape);
  QTest::keyClick(&axial(), Qt::Key_Right);
  EXPECT_NE(scene().sections.crosshair, crosshair) << "without a point arrows do what they do elsewhere";
  QTest::keyClick(&axial(), Qt::Key_Delete);
  EXPECT_TRUE(marks().empty());
  document().undo();
  EXPECT_EQ(marks().size(), 1u);
}

TEST_F(MarkWindow, ALabelAsksForItsWordsAtOnce) {
  showSections();
  takeUp("mark.label");
  click(axial(), middleOf(axial()));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_FALSE(tool());
  EXPECT_TRUE(list().isVisible());
  auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_TRUE(editor);
  QTest::keyClicks(editor, "The isthmus");
  QTest::keyClick(editor, Qt::Key_Return);
  EXPECT_TRUE(QTest::qWaitFor([&] { return marks()[0].text == "The isthmus"; }, kPatience)) << marks()[0].text;
  takeShot(*mWindow, "mark-label");
}

TEST_F(MarkWindow, TheListShowsHidesCopiesAndRemoves) {
  addDistance();
  ASSERT_TRUE(mWindow->tabs().showPage("Marks"));
  list().setCurrentRow(0);
  list().setFocus();
  QTest::keyClick(&list(), Qt::Key_Space);
  EXPECT_FALSE(marks()[0].visible);
  EXPECT_EQ(document().undoLabel(), "Hide distance");
  QTest::keySequence(&list(), QKeySequence::Copy);
  EXPECT_TRUE(QApplication::clipboard()->text().startsWith("Distance\t"))
      << QApplication::clipboard()->text().toStdString();
  child<QPushButton>("markDuplicate")->click();
  ASSERT_EQ(marks().size(), 2u);
  child<QCheckBox>("markOwnColor")->click();
  EXPECT_TRUE(marks()[0].color);
  QTest::keyClick(&list(), Qt::Key_Delete);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].id, 2);
  EXPECT_EQ(mWindow->selection().mark(), 0);
}

TEST_F(MarkWindow, AStyleIsChosenAndAPageFromThoseOfJournals) {
  ASSERT_TRUE(mWindow->tabs().showPage("Marks"));
  auto* style = child<QComboBox>("letteringStyle");
  EXPECT_EQ(style->currentText(), "Screen");
  EXPECT_TRUE(child<NumberRow>("textSize")->isVisible());
  style->setCurrentIndex(1);
  emit style->activated(1);
  EXPECT_EQ(scene::plateStyleName(scene().lettering), "journal");
  EXPECT_FALSE(child<NumberRow>("textSize")->isVisible());
  EXPECT_TRUE(child<NumberRow>("textPoints")->isVisible());
  child<QCheckBox>("bold")->click();
  EXPECT_EQ(style->currentIndex(), -1) << "of nobody's table";
  takeShot(*mWindow, "mark-page");
}

TEST_F(MarkWindow, NamesAreOfTheStructureThatIsClicked) {
  mWindow->openLabels(path("phantom_labels.seg.nrrd"));
  ASSERT_TRUE(waitForJob());
  ASSERT_TRUE(settle());
  std::vector<QPoint> places = seen(1, [](const ViewPoint& at) { return at.structure() != 0; });
  int structure = viewport().pickAt(places[0])->structure;
  takeUp("mark.name");
  click(viewport(), places[0]);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].kind, MarkKind::Name);
  EXPECT_EQ(marks()[0].structure, structure);
  EXPECT_EQ(marks()[0].points.size(), 1u);
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  QMenu menu;
  mWindow->structures().fillMenu(menu, {structure});
  for (QAction* action : menu.actions())
    if (action->text() == "Name this") action->trigger();
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_EQ(marks()[1].structure, structure);
  EXPECT_TRUE(marks()[1].points.empty()) << "where it is seen best";
}

}  // namespace
}  // namespace velum::gui
