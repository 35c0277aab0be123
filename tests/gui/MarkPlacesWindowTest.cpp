// Marks that follow, are shown at one time step, or point at what is hidden; names in sections and beside the cube.
#include <QComboBox>
#include <QListWidget>
#include <QMenu>
#include <QToolButton>

#include <fmt/format.h>

#include "ModelFixture.h"
#include "Shots.h"
#include "gui/kit/Points.h"
#include "gui/mark/MarkMenu.h"
#include "gui/view/ViewCube.h"
#include "makeVolume.h"
#include "session/measure/Follow.h"
#include "session/model/ModelEdit.h"

namespace velum::gui {
namespace {

using scene::Mark, scene::MarkKind;

class MarkPlaces : public ModelWindow {
 protected:
  const std::vector<Mark>& marks() { return scene().lettering.marks; }
  session::Document& document() { return mWindow->document(); }
  void run(const std::string& line) { session::edit(document(), session::parseCall(line)); }
  QListWidget& markList() { return *child<QListWidget>("markList"); }
  std::span<const session::PlacedWords> words(ToolView& view) { return mWindow->models().lettering().words(view); }
  void openStructures() {
    mWindow->resize(1100, 760);
    openPhantom();
    mWindow->openLabels(path("phantom_labels.seg.nrrd"));
    ASSERT_TRUE(waitForJob());
    drawSoon();
    ASSERT_TRUE(settle());
  }
};

TEST_F(MarkPlaces, AClickNearAMoleculesMiddleTakesTheMiddleAndFollows) {
  openModel();
  ASSERT_TRUE(settle());
  mWindow->actions().find("mark.distance")->trigger();
  std::vector<int> wanted;
  for (std::uint32_t i = 0; i < 400 && wanted.size() < 2; ++i) {
    auto place = session::instancePlace(scene(), i);
    auto pixel = place ? viewport().space().pixelFromWorld(place->middle) : std::nullopt;
    if (!pixel) continue;
    auto pick = viewport().pickAt(toPoint(*pixel));
    if (!pick || !pick->hit || pick->type < 0 || pick->modelInstance != i) continue;
    wanted.push_back(int(i));
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, toPoint(*pixel).toPoint());
  }
  ASSERT_EQ(wanted.size(), 2u);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].pointInstances, wanted);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(marks()[0].points[i], session::instancePlace(scene(), std::uint32_t(wanted[i]))->middle);
  takeShot(*mWindow, "mark-follows");
  mWindow->actions().find("mark.distance")->trigger();
  ModelMaker other{.types = 5, .instances = 400, .moleculeRadius = 20.0f};
  other.seed = 9;
  session::editByHand(document(), "Another model",
                      [&](scene::Scene& scene) { scene.model.data = Shared<Model>(other.make()); });
  ASSERT_TRUE(settle());
  Mark now = session::followed(scene(), marks()[0]);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(now.points[i], session::instancePlace(scene(), std::uint32_t(wanted[i]))->middle);
}

TEST_F(MarkPlaces, TheMenuLetsGoOfWhatFollowsAndBindsWhatDoesNot) {
  openModel();
  ASSERT_TRUE(settle());
  run("mark.add distance pointInstances=3,7");
  MarkMenu marksMenu(document(), mWindow->jobs(), nullptr);
  auto choose = [&](const char* text) {
    QMenu menu;
    marksMenu.fill(menu, 1);
    for (QAction* action : menu.actions())
      if (action->text() == text) return action->trigger(), true;
    return false;
  };
  EXPECT_FALSE(choose("Follow what is there"));
  EXPECT_TRUE(choose("Let go"));
  EXPECT_FALSE(session::isFollowing(marks()[0]));
  EXPECT_TRUE(choose("Follow what is there"));
  ASSERT_TRUE(waitForJob());
  EXPECT_EQ(marks()[0].pointInstances.size(), 2u);
  document().undo();
  session::editByHand(document(), "Drag", [](scene::Scene& scene) {
    Mark& mark = scene.lettering.marks[0];
    mark.pointInstances = {-1, -1};
    mark.pointStructures = {0};
  });
  EXPECT_FALSE(choose("Let go")) << "it follows nothing";
}

TEST_F(MarkPlaces, ATimeStepIsChosenOnThePageAndUndone) {
  mWindow->resize(1100, 760);
  scene::Scene series;
  Volume volume = makeVolume({12, 12, 12}, SampleType::UInt8, [](glm::ivec3 v) { return 20 * v.x; });
  scene::addMark(series.lettering.marks, {.kind = MarkKind::Distance, .points = {{1, 1, 1}, {8, 8, 8}}});
  series.volume.data = Shared<Volume>(std::move(volume));
  mWindow->showScene(series, "series");
  ASSERT_TRUE(settle());
  ASSERT_TRUE(mWindow->tabs().showPage("Marks"));
  markList().setCurrentRow(0);
  auto* shownAt = child<QComboBox>("markShownAt");
  EXPECT_FALSE(shownAt->isVisible()) << "there is one time step";
  run("set lettering.marks[#1].timeStep 3");
  EXPECT_TRUE(shownAt->isVisible());
  EXPECT_EQ(shownAt->currentText(), "Time step 4");
  shownAt->setCurrentIndex(1);
  emit shownAt->activated(1);
  EXPECT_EQ(marks()[0].timeStep, 0);
  EXPECT_EQ(document().undoLabel(), "Change time step of mark");
  shownAt->setCurrentIndex(0);
  emit shownAt->activated(0);
  EXPECT_EQ(marks()[0].timeStep, -1);
  document().undo();
  EXPECT_EQ(marks()[0].timeStep, 0);
  EXPECT_EQ(shownAt->currentText(), "This time step (1)");
}

TEST_F(MarkPlaces, ALabelWhosePlaceIsHiddenIsDimInTheList) {
  openStructures();
  ASSERT_TRUE(mWindow->tabs().showPage("Marks"));
  glm::dvec3 target = scene().camera.target, towards = glm::normalize(scene().camera.eye - target);
  auto label = [&](glm::dvec3 at, const char* words) {
    run(fmt::format("mark.add label {},{},{} {}", at.x, at.y, at.z, words));
  };
  auto pick = viewport().pickAt({viewport().width() * 0.3, viewport().height() * 0.4});
  ASSERT_TRUE(pick && pick->hit);
  label(pick->world, "seen");
  label(pick->world - 40.0 * towards, "behind");
  ASSERT_TRUE(settle());
  QTest::qWait(50);
  std::vector<int> drawn;
  for (const session::PlacedWords& one : words(viewport())) drawn.push_back(one.mark);
  EXPECT_EQ(drawn, std::vector<int>{1});
  EXPECT_TRUE(markList().item(0)->toolTip().isEmpty());
  EXPECT_TRUE(markList().item(1)->toolTip().startsWith("Hidden here"));
  takeShot(*mWindow, "mark-hidden");
  run("mark.show 2 false");
  EXPECT_TRUE(markList().item(1)->toolTip().isEmpty()) << "it is put away, which the eye says";
}

TEST_F(MarkPlaces, NamesKeepAwayFromTheCube) {
  openStructures();
  run("set lettering.names true");
  run("set lettering.textSize 60");
  ASSERT_TRUE(settle());
  QTest::qWait(50);
  ViewCube* cube = child<ViewCube>("viewCube");
  ASSERT_TRUE(cube->isVisible());
  QRectF taken(cube->geometry());
  ASSERT_FALSE(words(viewport()).empty());
  for (const session::PlacedWords& one : words(viewport()))
    EXPECT_FALSE(taken.intersects(QRectF(toPoint(one.low), toPoint(one.high)))) << one.structure;
  takeShot(*mWindow, "names-cube");
}

TEST_F(MarkPlaces, SectionViewsNameWhatTheyCut) {
  openStructures();
  mWindow->views().setLayout(scene::Layout::FourUp);
  run("set lettering.names true");
  ASSERT_TRUE(settle());
  QTest::qWait(100);
  SectionView& axial = mWindow->views().section(scene::SectionKind::Axial);
  auto shown = axial.shownSection();
  ASSERT_TRUE(shown);
  ASSERT_FALSE(words(axial).empty());
  for (const session::PlacedWords& one : words(axial)) {
    glm::ivec2 at(one.at * axial.devicePixelRatioF());
    EXPECT_EQ(shown->image.structures[std::size_t(at.y * shown->image.size.x + at.x)], one.structure);
  }
  takeShot(*mWindow, "names-sections");
  run("set lettering.names false");
  ASSERT_TRUE(settle());
  QTest::qWait(100);
  EXPECT_TRUE(words(axial).empty());
}

TEST_F(MarkPlaces, ThePageFitsItsPanel) {
  openStructures();
  run("mark.add label 0,0,0 \"A label with very many words that nobody could read in one line\"");
  run("mark.add distance 0,0,0;30,40,0");
  mWindow->selection().setMark(1);
  ASSERT_TRUE(mWindow->tabs().showPage("Marks"));
  ASSERT_TRUE(settle());
  for (const char* name : {"markRemove", "markList", "markOwnColor", "letteringStyle", "named"}) {
    auto* widget = child<QWidget>(name);
    QWidget* page = widget->parentWidget();
    while (page && !page->inherits("QScrollArea")) page = page->parentWidget();
    ASSERT_TRUE(page) << name;
    int right = widget->mapTo(page, QPoint(widget->width(), 0)).x();
    EXPECT_LE(right, page->width()) << name;
  }
  takeShot(*mWindow, "mark-page-1100");
}

}  // namespace
}  // namespace velum::gui
