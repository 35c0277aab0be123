// The cube in the corner of the 3D view.
#include "gui/view/ViewCube.h"

#include <QSet>

#include "ModelFixture.h"
#include "Shots.h"
#include "patience.h"

namespace velum::gui {
namespace {

class Cube : public ModelWindow {
 protected:
  ViewCube& cube() { return *child<ViewCube>("viewCube"); }
  glm::dvec3 towardsEye() { return glm::normalize(scene().camera.eye - scene().camera.target); }
  /// A place of the widget where a side is seen; nothing where it is not.
  std::optional<QPoint> placeOf(glm::ivec3 side) {
    for (int y = 0; y < cube().height(); ++y)
      for (int x = 0; x < cube().width(); ++x)
        if (cube().partAt(QPointF(x, y)) == side && cube().partAt(QPointF(x + 1, y + 1)) == side) return QPoint(x, y);
    return std::nullopt;
  }
  void lookAlong(glm::dvec3 side) {
    mWindow->document().view([side](scene::Scene& s) { s.camera.eye = s.camera.target + 400.0 * side; });
  }
};

TEST_F(Cube, AClickOnEachFaceEdgeAndCornerLooksFromThere) {
  openPhantom();
  drawSoon();
  mWindow->resize(900, 640);
  QTest::qWait(20);
  int clicked = 0;
  for (int x : {-1, 0, 1})
    for (int y : {-1, 0, 1})
      for (int z : {-1, 0, 1}) {
        glm::ivec3 side(x, y, z);
        if (side == glm::ivec3(0)) continue;
        glm::dvec3 wanted = glm::normalize(glm::dvec3(side));
        // From somewhere beside it, where it is seen.
        lookAlong(glm::normalize(wanted + glm::dvec3(0.21, -0.17, 0.13)));
        glm::dvec3 target = scene().camera.target;
        auto place = placeOf(side);
        ASSERT_TRUE(place) << x << " " << y << " " << z;
        QTest::mouseClick(&cube(), Qt::LeftButton, {}, *place);
        EXPECT_TRUE(QTest::qWaitFor([&] { return glm::length(towardsEye() - wanted) < 1e-6; }, kPatience))
            << x << y << z;
        EXPECT_EQ(scene().camera.target, target);
        ++clicked;
      }
  EXPECT_EQ(clicked, 26);
  EXPECT_FALSE(mWindow->document().isModified());
}

TEST_F(Cube, SaysTheSidesOfAPatientAndOfAModel) {
  openPhantom();
  EXPECT_EQ(cube().nameOf({0, -1, 0}), "anterior");
  EXPECT_EQ(cube().nameOf({1, 1, -1}), "posterior, left, inferior");
  takeShot(*mWindow, "cube");
  openModel();
  EXPECT_EQ(cube().nameOf({0, -1, 1}), "front, top");
  takeShot(*mWindow, "cube-model");
}

TEST_F(Cube, TurnsWithADragAndLeavesWhatIsBesideItToTheView) {
  openPhantom();
  glm::dvec3 before = towardsEye();
  QPoint middle = cube().rect().center();
  drag(cube(), middle, middle + QPoint(30, 0));
  glm::dvec3 turned = towardsEye();
  EXPECT_GT(glm::length(turned - before), 0.1);
  EXPECT_FALSE(cube().partAt({2, 2}));
  drag(cube(), {2, 2}, {2, 40});
  EXPECT_NE(towardsEye(), turned) << "beside the cube a drag is the view's";
}

TEST_F(Cube, StandsInACornerAndCanBePutAway) {
  openPhantom();
  mWindow->resize(1024, 700);
  QTest::qWait(30);
  ASSERT_TRUE(cube().isVisible());
  EXPECT_FALSE(cube().geometry().contains(viewport().rect().center()));
  EXPECT_TRUE(viewport().rect().contains(cube().geometry()));
  mWindow->actions().find("view.cube")->trigger();
  EXPECT_FALSE(cube().isVisible());
  MainWindow second;
  EXPECT_FALSE(second.actions().find("view.cube")->isChecked()) << "it is remembered";
  mWindow->actions().find("view.cube")->trigger();
  EXPECT_TRUE(cube().isVisible());
}

}  // namespace
}  // namespace velum::gui
