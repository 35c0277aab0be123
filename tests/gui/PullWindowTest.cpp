// Structures are pulled out of cuts with the pointer, in the real window.
#include <QLineEdit>

#include "PullFixture.h"
#include "gui/kit/Messages.h"
#include "gui/kit/Widgets.h"
#include "patience.h"
#include "scene/Scene.h"
#include "session/extrusion/PulledEnd.h"

namespace velum::gui {

class PullWindow : public PullFixture {
 protected:
  /// Beside the small phantom one that is fine enough for what lies between the spheres to part them by values.
  static void SetUpTestSuite() {
    PullFixture::SetUpTestSuite();
    Progress progress;
    io::writeVolume(io::makeSample("two-spheres", 64, progress).volume, *sFolder / "apart.nrrd", progress);
  }
  /// Two spheres, and a plane through the middles of both.
  void openCut(bool withLabels) {
    if (withLabels)
      open({path("phantom.nrrd"), path("phantom_labels.seg.nrrd")});
    else
      open({path("apart.nrrd")});
    document().edit("Add cut", [](scene::Scene& s) {
      scene::Cut cut;
      cut.axis = {0, -1, 0};
      scene::addCut(s, cut);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 4.0 / 3.0);
    });
    takeUp();
  }
  /// The middle of the upper sphere's cut.
  static constexpr glm::dvec3 kPlace{-29, 0, 14};
};

TEST_F(PullWindow, OneClickAndOneDragPullWhatHasNoLabelOutOfTheCut) {
  openCut(false);
  double wanted = 6.0;
  std::string before = document().undoLabel();
  pull(pixelOf(kPlace), kPlace, cut(), wanted);
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-one");
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u);
  EXPECT_NEAR(out[0].distance, wanted, 1.5 * scene::lengthPerPixel(scene().camera, size(), kPlace))
      << "a length on the projected normal is a length";
  EXPECT_TRUE(session::isGrown(scene()));
  ASSERT_TRUE(scene().labels.data);
  EXPECT_EQ(scene().labels.structures.size(), 1u);
  // What stands there now is seen before the face.
  auto pick = viewport().pickAt(pixelOf(kPlace + 0.5 * wanted * session::pullDirection(cut(), kPlace)));
  ASSERT_TRUE(pick && pick->hit);
  EXPECT_EQ(pick->structure, out[0].structure);
  EXPECT_GT(session::depthInCut(cut(), pick->world), 0.5);
  EXPECT_EQ(document().undoLabel(), "Pull out Region 1");
  document().undo();
  EXPECT_EQ(document().undoLabel(), before) << "one step";
  ASSERT_TRUE(settle());
  EXPECT_TRUE(session::extrusionsOf(scene()).empty());
  EXPECT_TRUE(scene().labels.structures.empty());
  EXPECT_FALSE(scene().labels.data);
}

TEST_F(PullWindow, ADragOnTheEmptyGroundTurnsTheCamera) {
  openCut(false);
  scene::Camera before = scene().camera;
  drag({5, 5}, {60, 40});
  EXPECT_NE(scene().camera, before);
  EXPECT_TRUE(session::extrusionsOf(scene()).empty());
}

TEST_F(PullWindow, ADragBesideTheFaceSaysSoAndDoesNotTurnTheCamera) {
  openCut(false);
  std::vector<Seen> seen = look();
  std::erase_if(seen,
                [&](const Seen& one) { return std::abs(session::depthInCut(cut(), one.pick.world)) < 2.0 * slack(); });
  ASSERT_FALSE(seen.empty()) << "a sphere's side";
  // The edge of the face: the last place to the left on which there is nothing.
  QPoint beside = pixelOf(kPlace);
  while (viewport().pickAt(beside) && viewport().pickAt(beside)->hit) beside -= QPoint(1, 0);
  beside -= QPoint(12, 0);
  ASSERT_FALSE(viewport().pickAt(beside)->hit);
  scene::Camera before = scene().camera;
  for (QPoint place : {seen.front().pixel, seen.back().pixel, beside}) {
    mWindow->findChild<MessageBar*>()->hide();
    drag(place, place + QPoint(30, 20));
    EXPECT_EQ(scene().camera, before);
    EXPECT_TRUE(session::extrusionsOf(scene()).empty());
    EXPECT_TRUE(mWindow->findChild<MessageBar*>()->isVisible()) << "it says why";
  }
}

TEST_F(PullWindow, ThePlaneIsMovedByAltOrCtrlAndTheWheelAndByBrackets) {
  openCut(false);
  mWindow->selection().setCut(cut().id);
  double step = scene::sectionStep(scene());
  glm::dvec3 begin = cut().centre;
  auto moved = [&] { return glm::dot(cut().centre - begin, session::pullDirection(cut(), begin)) / step; };
  turnWheel(1);
  EXPECT_NEAR(moved(), 1.0, 1e-9);
  turnWheel(2, Qt::ControlModifier);
  EXPECT_NEAR(moved(), 3.0, 1e-9);
  scene::Camera camera = scene().camera;
  QTest::keyClick(&viewport(), Qt::Key_BracketLeft);
  EXPECT_NEAR(moved(), 2.0, 1e-9);
  QTest::keyClick(&viewport(), Qt::Key_BracketRight);
  EXPECT_NEAR(moved(), 3.0, 1e-9);
  EXPECT_EQ(scene().camera, camera) << "nor does the wheel come nearer";
}

TEST_F(PullWindow, ARowIsNamedAndColouredOnThePage) {
  openCut(false);
  pull(pixelOf(kPlace), kPlace, cut(), 6.0);
  ASSERT_TRUE(settle());
  auto* name = child<QLineEdit>("pulledName");
  ASSERT_TRUE(name && name->isVisible());
  EXPECT_EQ(name->text(), "Region 1");
  name->setFocus();
  name->selectAll();
  QTest::keyClicks(name, "upper ball");
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_EQ(scene().labels.structures[0].name, "upper ball");
  EXPECT_TRUE(child<QListWidget>("extrusionList")->item(0)->text().startsWith("upper ball"));
  EXPECT_EQ(document().undoLabel(), "Rename Region 1");
  emit child<ColorButton>("pulledColor")->picked({0.2f, 0.6f, 0.9f});
  EXPECT_EQ(scene().labels.structures[0].color, glm::vec3(0.2f, 0.6f, 0.9f));
  EXPECT_EQ(scene().labels.structures[0].tint, 1.0) << "it is seen";
  document().undo();
  document().undo();
  EXPECT_EQ(scene().labels.structures[0].name, "Region 1");
  EXPECT_EQ(name->text(), "Region 1");
}

TEST_F(PullWindow, NothingStandsOutFartherThanItGoes) {
  openCut(true);
  pull(pixelOf(kPlace), kPlace, cut(), 200.0);
  ASSERT_TRUE(settle());
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u);
  double end = session::pulledEnd(scene(), cut(), out[0].structure);
  EXPECT_GT(end, 5.0);
  EXPECT_LT(end, 60.0) << "of a ball";
  EXPECT_EQ(out[0].distance, end);
  EXPECT_EQ(child<NumberRow>("pulledDistance")->spin()->maximum(), child<NumberRow>("pulledDistance")->value());
}

TEST_F(PullWindow, WhatIsFoundOnTheWayEndsWhereItEnds) {
  openCut(false);
  QPoint from = pixelOf(kPlace), to = from + pixelOf(kPlace + 200.0 * session::pullDirection(cut(), kPlace)) - from;
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) {
    QPointF place(from + (to - from) * i / 5);
    QMouseEvent move(QEvent::MouseMove, place, viewport().mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&viewport(), &move);
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return session::isGrown(scene()); }, kPatience));
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
  ASSERT_TRUE(settle());
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out[0].distance, session::pulledEnd(scene(), cut(), out[0].structure));
  EXPECT_LT(out[0].distance, 60.0);
}

TEST_F(PullWindow, LabelledStructuresArePulledTogetherWithShiftAndPutBack) {
  openCut(true);
  glm::dvec3 other(29, 0, -14);
  pull(pixelOf(kPlace), kPlace, cut(), 5.0);
  ASSERT_TRUE(settle());
  auto first = session::extrusionsOf(scene());
  ASSERT_EQ(first.size(), 1u);
  EXPECT_GT(first[0].structure, 0);
  EXPECT_TRUE(scene().labels.growths.empty()) << "what has a label is not grown";
  QPoint from = pixelOf(other), to = pixelOf(other + 5.0 * session::pullDirection(cut(), other));
  drag(from, to, Qt::LeftButton, Qt::ShiftModifier);
  auto both = session::extrusionsOf(scene());
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0].distance, 10.0, 2.0) << "comes along";
  EXPECT_NEAR(both[1].distance, 5.0, 1.0);
  auto* list = child<QListWidget>("extrusionList");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->count(), 2);
  EXPECT_EQ(list->selectedItems().size(), 1) << "what was pressed on, which Put back means";
  child<QPushButton>("putAllBack")->click();
  EXPECT_TRUE(session::extrusionsOf(scene()).empty());
  document().undo();
  EXPECT_EQ(session::extrusionsOf(scene()), both);
}

TEST_F(PullWindow, SpaceSaysOutOfWhichOfTwoPlanesItIsPulled) {
  openCut(true);
  document().edit("Wedge", [](scene::Scene& s) {
    scene::Cut across;
    across.axis = {-1, 0, 0};
    across.centre = kPlace;
    across.joined = true;
    scene::addCut(s, across);
    for (auto& one : s.cuts) session::setExtrusion(one, 1, 20.0);
  });
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-wedge");
  auto isShared = [&](const Seen& seen) {
    return session::cutsUnder(scene(), seen.pick.world, seen.pick.structure, 0.1).size() == 2;
  };
  std::vector<Seen> shared = look();
  std::erase_if(shared, [&](const Seen& seen) { return !isShared(seen); });
  ASSERT_GE(shared.size(), 9u);
  // The distances say out of which it was pulled.
  auto distances = [&] { return std::pair(session::extrusionOf(cut(0), 1), session::extrusionOf(cut(1), 1)); };
  for (const Seen& seen : {shared.front(), shared[shared.size() / 2], shared.back()}) {
    SCOPED_TRACE(testing::Message() << seen.pixel.x() << " " << seen.pixel.y());
    auto pullsSecond = [&] {
      auto before = distances();
      drag(seen.pixel, seen.pixel + QPoint(9, 17));
      auto after = distances();
      document().undo();
      EXPECT_EQ(distances(), before);
      EXPECT_NE(before.first == after.first, before.second == after.second) << "one of the two";
      EXPECT_TRUE(settle());
      return before.first == after.first;
    };
    hover(seen.pixel);
    bool wasSecond = pullsSecond();
    hover(seen.pixel + QPoint(1, 0));
    QTest::keyClick(&viewport(), Qt::Key_Space);
    EXPECT_EQ(mWindow->selection().cut(), cut(wasSecond ? 0 : 1).id) << "the list says it";
    EXPECT_NE(pullsSecond(), wasSecond);
    EXPECT_NE(pullsSecond(), wasSecond) << "as long as the pointer stays there";
    hover(seen.pixel);
    QTest::keyClick(&viewport(), Qt::Key_Space);
    EXPECT_EQ(pullsSecond(), wasSecond) << "and back";
    hover({3, 3});
  }
}

TEST_F(PullWindow, WithoutACutTheToolMakesOne) {
  open({path("phantom.nrrd")});
  press("U");
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(cut().shape, scene::CutShape::Plane);
  EXPECT_EQ(cut().name, "Plane 1");
}

}  // namespace velum::gui
