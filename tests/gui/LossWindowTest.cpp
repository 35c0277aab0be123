// The driver loses the 3D view's context while something goes on: the view gets another one, and all goes on.
#include <QSignalSpy>

#include "TimelineFixture.h"
#include "gpu/Loss.h"
#include "session/cut/CutGizmo.h"

namespace velum::gui {

class LossWindow : public Timelines {
 protected:
  void SetUp() override {
    Timelines::SetUp();
    if (!viewport().surface().widget().inherits("QOpenGLWidget"))
      GTEST_SKIP() << "no context of the window's; see BesideTheWindow";
  }
  void TearDown() override {
    gpu::simulateLoss(0);
    Timelines::TearDown();
  }
  QImage picture() { return viewport().picture(); }
  /// Waits for the loss that was asked for, and for the picture that follows.
  void expectRecovery(const QSignalSpy& heard) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.isEmpty(); }, kPatience)) << "nothing was lost";
    EXPECT_TRUE(mWindow->messages().isVisible());
    EXPECT_EQ(mWindow->messages().text(), "The graphics driver was reset; the picture has been drawn anew.");
    ASSERT_TRUE(settle());
  }
  void addCut(const char* command) {
    trigger(command);
    ASSERT_TRUE(waitForJob());
    ASSERT_EQ(scene().cuts.size(), 1u);
  }
  scene::SheetShape shape() { return viewport().membranes().withShapes(scene()).cuts[0].membrane->shape; }
};

TEST_F(LossWindow, AtRestItIsSeenWhenThePointerAsksAndNothingElseIsLost) {
  document().edit("Add cut", [](scene::Scene& s) { s.cuts.emplace_back(); });
  ASSERT_TRUE(settle());
  QImage before = picture();
  scene::Scene saved = scene();
  auto context = [this] {
    EXPECT_TRUE(viewport().surface().bind());
    return gpu::contextNumber();
  };
  unsigned number = context();
  QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
  gpu::simulateLoss(1);
  EXPECT_FALSE(viewport().pickAt({100, 100}));
  expectRecovery(heard);
  EXPECT_EQ(heard.size(), 1);
  EXPECT_NE(context(), number);
  EXPECT_EQ(picture(), before);
  EXPECT_EQ(scene(), saved);
  EXPECT_EQ(document().undoLabel(), "Add cut");
  EXPECT_TRUE(viewport().pickAt({100, 100}));
  takeShot(*mWindow, "loss-recovered");
}

TEST_F(LossWindow, WhileThePictureIsRefinedItBeginsAnew) {
  ASSERT_TRUE(settle());
  viewport().lookFrom(scene::StandardView::Left);
  ASSERT_TRUE(settle());
  QImage before = picture();
  for (int question : {1, 2, 5}) {
    viewport().lookFrom(scene::StandardView::Right);
    ASSERT_TRUE(settle());
    QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
    gpu::simulateLoss(question);
    viewport().lookFrom(scene::StandardView::Left);
    expectRecovery(heard);
    EXPECT_EQ(picture(), before) << question;
  }
}

TEST_F(LossWindow, WhileACutIsDraggedTheHandGoesOn) {
  addCut("cut.addPlane");
  viewport().lookFrom(scene::StandardView::Oblique);
  ASSERT_TRUE(settle());
  auto gizmo = session::makeCutGizmo(scene(), scene().cuts[0], size());
  auto tip = scene::pixelFromWorld(scene().camera, size(), gizmo.arrowTip);
  auto foot = scene::pixelFromWorld(scene().camera, size(), gizmo.centre);
  ASSERT_TRUE(tip && foot);
  QPointF from(std::round(tip->x), std::round(tip->y));
  glm::dvec2 along = glm::normalize(*tip - *foot) * 6.0;
  auto dragged = [&](bool loses) {
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, from.toPoint());
    for (int i = 1; i <= 6; ++i) {
      if (loses && i == 3) gpu::simulateLoss(1);
      QPointF place = (from + QPointF(along.x, along.y) * i).toPoint();
      QMouseEvent move(QEvent::MouseMove, place, viewport().mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(&viewport(), &move);
      QTest::qWait(60);
    }
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, (from + QPointF(along.x, along.y) * 6).toPoint());
    EXPECT_TRUE(settle());
    return std::pair(scene(), picture());
  };
  auto undisturbed = dragged(false);
  EXPECT_EQ(document().undoLabel(), "Move cut");
  document().undo();
  ASSERT_TRUE(settle());
  QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
  auto disturbed = dragged(true);
  expectRecovery(heard);
  EXPECT_EQ(disturbed, undisturbed);
  EXPECT_EQ(document().undoLabel(), "Move cut");
}

TEST_F(LossWindow, WhileAMembraneRelaxesItGoesOnAndRestsWhereItWould) {
  addCut("cut.addMembrane");
  ASSERT_TRUE(settle());
  scene::SheetShape rest = shape();
  QImage before = picture();
  scene::Scene saved = scene();
  int tried = 0;
  for (int question : {1, 3, 8, 20}) {
    viewport().resetMembrane(scene().cuts[0].id);
    QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
    gpu::simulateLoss(question);
    ASSERT_TRUE(settle());
    gpu::simulateLoss(0);
    tried += int(heard.size());
    EXPECT_EQ(shape(), rest) << question;
    EXPECT_EQ(picture(), before) << question;
    EXPECT_EQ(scene(), saved) << question;
  }
  EXPECT_GE(tried, 2);
}

TEST_F(LossWindow, APausedMembraneStaysWhereItIs) {
  addCut("cut.addMembrane");
  ASSERT_TRUE(settle());
  scene::SheetShape rest = shape();
  viewport().playMembranes(false);
  viewport().resetMembrane(scene().cuts[0].id);
  for (int i = 0; i < 12; ++i) viewport().stepMembranes();  // until it is seen
  ASSERT_TRUE(settle());
  scene::SheetShape hanging = shape();
  EXPECT_FALSE(hanging.places.empty());
  QImage before = picture();
  QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
  gpu::simulateLoss(1);
  viewport().update();
  expectRecovery(heard);
  EXPECT_EQ(shape(), hanging);
  EXPECT_EQ(picture(), before);
  // And rests where it would.
  viewport().playMembranes(true);
  ASSERT_TRUE(settle());
  EXPECT_EQ(shape(), rest);
}

TEST_F(LossWindow, WhileAFilmPlaysItPlaysOn) {
  makeFilm();
  document().setPlayhead(1.0);
  ASSERT_TRUE(settle());
  QImage before = picture();
  scene::Scene saved = scene();
  QSignalSpy heard(&viewport(), &Viewport::drawnAnew);
  mWindow->timeline().setPlaying(true);
  QTest::qWait(300);
  gpu::simulateLoss(1);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !heard.isEmpty(); }, kPatience));
  double lostAt = *document().playhead();
  EXPECT_TRUE(mWindow->timeline().isPlaying());
  ASSERT_TRUE(QTest::qWaitFor([&] { return *document().playhead() > lostAt + 0.3; }, kPatience));
  int shown = viewport().shownCount();
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().shownCount() > shown + 3; }, kPatience));
  mWindow->timeline().setPlaying(false);
  document().setPlayhead(1.0);
  ASSERT_TRUE(settle());
  EXPECT_EQ(picture(), before);
  EXPECT_EQ(scene(), saved);
}

TEST_F(LossWindow, ADriverThatIsResetAgainAndAgainIsSaidAndTheWorkStays) {
  document().edit("Add cut", [](scene::Scene& s) { s.cuts.emplace_back(); });
  ASSERT_TRUE(settle());
  gpu::simulateLoss(1, 1000);
  viewport().update();
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return mWindow->messages().text().contains("whenever it draws this"); }, kPatience));
  gpu::simulateLoss(0);
  EXPECT_EQ(document().undoLabel(), "Add cut");
  mWindow->saveSceneTo(path("saved.json"));
  EXPECT_TRUE(mWindow->lastError().isEmpty());
}

}  // namespace velum::gui
