// All but the type of the row under the pointer is darkened: in the picture that is seen, and in no other.
#include "ModelFixture.h"
#include "Shots.h"

namespace velum::gui {
namespace {

class Highlight : public ModelWindow {
 protected:
  TypeHighlight& highlight() { return mWindow->models().highlight(); }
  int pixelsOf(std::int32_t type) {
    auto types = viewport().idsOfPixels().types;
    return int(std::count(types.begin(), types.end(), type));
  }
  void pointAt(int type) {
    QPoint place = list().cellOfType(type, ModelTree::Name).center();
    QMouseEvent move(QEvent::MouseMove, place, list().viewport()->mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(list().viewport(), &move);
  }
  void turn() {
    mWindow->document().view([](scene::Scene& scene) {
      glm::dvec3 arm = scene.camera.eye - scene.camera.target;
      scene.camera.eye = scene.camera.target + glm::dvec3(arm.y, -arm.x, arm.z);
    });
  }
};

TEST_F(Highlight, GoesWhileTheCameraMovesAndComesBackOverTheNewPicture) {
  openModel();
  ASSERT_TRUE(settle());
  pointAt(2);
  int before = pixelsOf(2);
  ASSERT_GT(before, 0);
  ASSERT_TRUE(highlight().isSeen());
  EXPECT_EQ(highlight().pixels(), before);
  turn();
  EXPECT_FALSE(highlight().isSeen()) << "it was of the picture before";
  ASSERT_TRUE(settle());
  EXPECT_TRUE(highlight().isSeen());
  EXPECT_GT(pixelsOf(2), 0);
  EXPECT_EQ(highlight().pixels(), pixelsOf(2));
  takeShot(*mWindow, "highlight-turned");
}

TEST_F(Highlight, OfARowThatIsComeToMeanwhileWaitsForThePicture) {
  openModel();
  ASSERT_TRUE(settle());
  turn();
  pointAt(1);
  EXPECT_FALSE(highlight().isSeen());
  ASSERT_TRUE(settle());
  EXPECT_EQ(highlight().pixels(), pixelsOf(1));
  emit list().hovered({});
  EXPECT_FALSE(highlight().isSeen());
  turn();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(highlight().isSeen()) << "the pointer has left the rows";
}

TEST_F(Highlight, GoesWhileABarIsDragged) {
  openModel();
  ASSERT_TRUE(settle());
  pointAt(2);
  ASSERT_TRUE(highlight().isSeen());
  int row = int(list().tree().indexOfType(2, 0).internalId());
  CountBar bar = list().barOf(row);
  auto placeAt = [&](double share) {
    return QPointF(bar.box.left() + share * bar.box.width(), bar.box.center().y()).toPoint();
  };
  auto* area = list().viewport();
  QTest::mousePress(area, Qt::LeftButton, {}, placeAt(1.0));
  QMouseEvent move(QEvent::MouseMove, placeAt(0.3), area->mapToGlobal(placeAt(0.3)), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(area, &move);
  ASSERT_EQ(scene().cuts.size(), 1u);
  EXPECT_FALSE(highlight().isSeen()) << "what is drawn is no longer what was darkened";
  QTest::mouseRelease(area, Qt::LeftButton, {}, placeAt(0.3));
  ASSERT_TRUE(settle());
  EXPECT_TRUE(highlight().isSeen());
  EXPECT_EQ(highlight().pixels(), pixelsOf(2));
}

}  // namespace
}  // namespace velum::gui
