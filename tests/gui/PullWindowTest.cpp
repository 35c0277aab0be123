// Structures are pulled out of cuts with the pointer, in the real window.
#include <QLabel>
#include <QListWidget>
#include <QPushButton>

#include "Shots.h"
#include "WindowFixture.h"
#include "velum/session/extrusion/Extrusion.h"
#include "velum/session/growth/Growths.h"

namespace velum::gui {

class PullWindow : public Window {
 protected:
  void SetUp() override {
    Window::SetUp();
    mWindow->resize(1100, 800);
  }
  session::Document& document() { return mWindow->document(); }
  void open(bool withLabels) {
    openPhantom();
    if (withLabels) {
      mWindow->openPaths({path("phantom_labels.seg.nrrd")}, true);
      ASSERT_TRUE(waitForJob());
    }
    drawSoon();
    document().edit("Add cut", [](scene::Scene& s) {
      scene::Bounds bounds = scene::computeBounds(s);
      scene::Cut cut;
      cut.centre = (bounds.min + bounds.max) * 0.5;
      cut.axis = {0, -1, 0};
      scene::addCut(s, cut);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 4.0 / 3.0);
    });
    ASSERT_TRUE(settle());
  }
  void takeUp() {
    mWindow->actions().find("extrusion.pull")->trigger();
    ASSERT_TRUE(mWindow->toolbox().active());
    ASSERT_TRUE(settle());
  }
  const scene::Cut& cut(int i = 0) { return scene().cuts[std::size_t(i)]; }
  QPoint pixelOf(glm::dvec3 world) {
    auto pixel = scene::pixelFromWorld(scene().camera, size(), world);
    return pixel ? QPoint(int(std::lround(pixel->x)), int(std::lround(pixel->y))) : QPoint();
  }
  /// A place on the face of the first cut, so far from its middle.
  glm::dvec3 onFace(double right, double up) { return cut().centre + glm::dvec3(right, 0, up); }
  /// The place where something is hit that can be pulled, along a line on the face.
  std::optional<glm::dvec3> bright() {
    for (double r = 0; r < 16; r += 0.5)
      for (double sign : {1.0, -1.0}) {
        auto pick = viewport().pickAt(pixelOf(onFace(sign * r, 0)));
        bool isNear = pick && pick->hit && glm::distance(pick->world, onFace(sign * r, 0)) < 2.0;
        bool isMeant = isNear && (scene().labels.data ? pick->structure > 0 : pick->value > 0.5 * scene().volume.data->range.y);
        if (isMeant) return onFace(sign * r, 0);
      }
    return std::nullopt;
  }
};

TEST_F(PullWindow, OneClickAndOneDragPullWhatHasNoLabelOutOfTheCut) {
  open(false);
  takeUp();
  auto place = bright();
  ASSERT_TRUE(place);
  double wanted = 6.0;
  std::string before = document().undoLabel();
  drag(pixelOf(*place), pixelOf(*place + wanted * session::pullDirection(cut(), *place)));
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-one");
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u);
  EXPECT_NEAR(out[0].distance, wanted, 1.5 * scene::lengthPerPixel(scene().camera, size(), *place))
      << "a length on the projected normal is a length";
  EXPECT_TRUE(session::isGrown(scene()));
  ASSERT_TRUE(scene().labels.data);
  EXPECT_EQ(scene().labels.structures.size(), 1u);
  // What stands there now is seen before the face.
  glm::dvec3 tip = *place + 0.5 * wanted * session::pullDirection(cut(), *place);
  auto pick = viewport().pickAt(pixelOf(tip));
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

TEST_F(PullWindow, ADragBesideWhatCanBePulledTurnsTheCamera) {
  open(false);
  takeUp();
  scene::Camera before = scene().camera;
  drag({5, 5}, {60, 40});
  EXPECT_NE(scene().camera, before);
  EXPECT_TRUE(session::extrusionsOf(scene()).empty());
}

TEST_F(PullWindow, LabelledStructuresArePulledTogetherWithShiftAndPutBack) {
  open(true);
  takeUp();
  auto place = bright();
  ASSERT_TRUE(place);
  glm::dvec3 out = session::pullDirection(cut(), *place);
  drag(pixelOf(*place), pixelOf(*place + 5.0 * out));
  ASSERT_TRUE(settle());
  auto first = session::extrusionsOf(scene());
  ASSERT_EQ(first.size(), 1u);
  EXPECT_GT(first[0].structure, 0);
  EXPECT_TRUE(scene().labels.growths.empty()) << "what has a label is not grown";
  auto* list = child<QListWidget>("extrusionList");
  ASSERT_TRUE(list);
  EXPECT_EQ(list->count(), 1);
  child<QPushButton>("putAllBack")->click();
  EXPECT_TRUE(session::extrusionsOf(scene()).empty());
  document().undo();
  EXPECT_EQ(session::extrusionsOf(scene()), first);
}

// The second press comes out of the same plane here: to be found out whether the test or the tool is wrong.
TEST_F(PullWindow, DISABLED_SpaceSaysOutOfWhichOfTwoPlanesItIsPulled) {
  open(true);
  takeUp();
  auto place = bright();
  ASSERT_TRUE(place);
  mWindow->actions().find("extrusion.secondPlane")->trigger();
  ASSERT_EQ(scene().cuts.size(), 2u);
  EXPECT_TRUE(scene().cuts[1].joined);
  int structure = scene().labels.data->at(glm::ivec3(
      glm::round(glm::dvec3(glm::inverse(scene().labels.data->worldFromVoxel()) * glm::dvec4(*place, 1.0)))));
  document().edit("Pull", [&](scene::Scene& s) {
    for (auto& one : s.cuts) session::setExtrusion(one, structure, 9.0);
  });
  ASSERT_TRUE(settle());
  // A place that both hold.
  std::optional<QPoint> both;
  for (int y = 20; y < viewport().height() && !both; y += 12)
    for (int x = 20; x < viewport().width() && !both; x += 12) {
      auto pick = viewport().pickAt(QPointF(x, y));
      if (pick && pick->hit && session::cutsUnder(scene(), pick->world, pick->structure, 0.1).size() == 2 &&
          pick->structure == structure)
        both = QPoint(x, y);
    }
  ASSERT_TRUE(both);
  takeShot(*mWindow, "pull-wedge");
  QTest::mouseMove(&viewport(), *both);
  auto selected = [&] { return child<QListWidget>("extrusionList")->currentRow(); };
  drag(*both, *both);
  int first = selected();
  QTest::mouseMove(&viewport(), *both + QPoint(1, 0));
  QTest::keyClick(&viewport(), Qt::Key_Space);
  drag(*both, *both);
  EXPECT_NE(selected(), first);
}

TEST_F(PullWindow, WithoutACutTheToolMakesOne) {
  openPhantom();
  drawSoon();
  mWindow->actions().find("extrusion.pull")->trigger();
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_EQ(cut().shape, scene::CutShape::Plane);
}

}  // namespace velum::gui
