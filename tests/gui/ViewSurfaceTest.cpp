// The 3D view where the window system has no OpenGL: a context beside it draws, and the picture is copied.
#include "Shots.h"
#include "WindowFixture.h"
#include "gpu/Loss.h"

namespace velum::gui {
namespace {

class BesideTheWindow : public Window {
 protected:
  void SetUp() override {
    mBefore = qgetenv("VELUM_CONTEXT");
    qputenv("VELUM_CONTEXT", "osmesa");
    Window::SetUp();
  }
  void TearDown() override {
    gpu::simulateLoss(0);
    Window::TearDown();
    mBefore.isEmpty() ? qunsetenv("VELUM_CONTEXT") : qputenv("VELUM_CONTEXT", mBefore);
  }
  QByteArray mBefore;
};

int worstDifference(const QImage& a, const QImage& b) {
  EXPECT_EQ(a.size(), b.size());
  int worst = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      QColor one = a.pixelColor(x, y), other = b.pixelColor(x, y);
      for (int step : {one.red() - other.red(), one.green() - other.green(), one.blue() - other.blue()})
        worst = std::max(worst, std::abs(step));
    }
  return worst;
}

TEST_F(BesideTheWindow, TheSameIsSeen) {
  openPhantom();
  ASSERT_TRUE(settle());
  EXPECT_FALSE(viewport().surface().widget().inherits("QOpenGLWidget"));
  QImage picture = viewport().picture();
  mBefore.isEmpty() ? qunsetenv("VELUM_CONTEXT") : qputenv("VELUM_CONTEXT", mBefore);
  mWindow = std::make_unique<MainWindow>();
  mWindow->resize(760, 520);
  mWindow->views().setLayout(scene::Layout::Volume);
  mWindow->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(mWindow.get()));
  openPhantom();
  ASSERT_TRUE(settle());
  EXPECT_LE(worstDifference(picture, viewport().picture()), 2);
}

TEST_F(BesideTheWindow, AnotherSizeIsDrawnAnew) {
  openPhantom();
  ASSERT_TRUE(settle());
  QSize before = viewport().picture().size();
  mWindow->resize(640, 420);
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().picture().size() != before; }, kPatience));
  ASSERT_TRUE(settle());
  EXPECT_EQ(viewport().picture().size(), viewport().size() * viewport().devicePixelRatioF());
  takeShot(*mWindow, "beside-the-window");
}

TEST_F(BesideTheWindow, WhatWasHiddenMeanwhileHasTheNewSize) {
  openPhantom();
  ASSERT_TRUE(settle());
  viewport().hide();
  mWindow->resize(620, 500);
  viewport().setVisible(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().picture().size() == viewport().size(); }, kPatience));
  EXPECT_TRUE(settle());
}

TEST_F(BesideTheWindow, TheMouseTurnsIt) {
  openPhantom();
  ASSERT_TRUE(settle());
  QImage before = viewport().picture();
  scene::Camera camera = scene().camera;
  drag({60, 60}, {160, 90});
  EXPECT_NE(scene().camera.eye, camera.eye);
  ASSERT_TRUE(settle());
  EXPECT_NE(viewport().picture(), before);
}

/// Whoever asks makes it again at once: no window has to.
TEST_F(BesideTheWindow, AContextThatIsLostIsMadeAgain) {
  openPhantom();
  ASSERT_TRUE(settle());
  QImage before = viewport().picture();
  auto pick = viewport().pickAt({100, 100});
  gpu::simulateLoss(1);
  auto again = viewport().pickAt({100, 100});
  ASSERT_TRUE(pick && again);
  EXPECT_EQ(again->hit, pick->hit);
  for (int question : {1, 2, 5}) {
    viewport().lookFrom(scene::StandardView::Right);
    ASSERT_TRUE(settle());
    gpu::simulateLoss(question);
    viewport().lookFrom(scene::StandardView::Anterior);
    ASSERT_TRUE(settle());
    EXPECT_EQ(viewport().picture(), before) << question;
  }
}

}  // namespace
}  // namespace velum::gui
