// While a hand pulls, the picture stands; what is found is shown over it, and the label follows the pointer.
#include <QElapsedTimer>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "DragSection.h"
#include "PullFixture.h"
#include "makeVolume.h"
#include "patience.h"

namespace velum::gui {

namespace {

constexpr int kEdge = 64, kLarge = 256;

/// A ball with noise.
template <int kSize>
int ball(int x, int y, int z) {
  double away = glm::distance(glm::dvec3(x, y, z), glm::dvec3(0.5 * (kSize - 1)));
  return int((away < 0.27 * kSize ? 150.0 : 20.0) + 24.0 * (hashNoise({x, y, z}) - 0.5));
}

/// Keeps a core busy while it lives.
class BusyCore {
 public:
  BusyCore()
      : mThread([this] {
          double x = 1.0;
          while (!mEnds) x = std::sin(x) + 1.0;
          mSink = x;
        }) {}
  ~BusyCore() {
    mEnds = true;
    mThread.join();
  }

 private:
  std::atomic<bool> mEnds{false};
  std::atomic<double> mSink{0.0};
  std::thread mThread;
};

}  // namespace

class PullFollow : public PullFixture {
 protected:
  void openBall(const char* file, int edge) {
    open({path(file)});
    document().edit("Look", [&](scene::Scene& s) {
      s.volume.transfer.opacities = {{60, 0}, {80, 1}, {255, 1}};
      scene::Cut cut;
      cut.axis = {0, -1, 0};
      cut.centre = glm::dvec3(0.5 * (edge - 1));
      scene::addCut(s, cut);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.2);
    });
    takeUp();
    mPlace = cut().centre;
  }
  QPoint placeAt(double distance) { return pixelOf(mPlace + distance * session::pullDirection(cut(), mPlace)); }
  void moveTo(QPoint pixel) {
    QPointF place(pixel);
    QMouseEvent move(QEvent::MouseMove, place, viewport().mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&viewport(), &move);
  }
  glm::dvec3 mPlace{0.0};
};

TEST_F(PullFollow, WhatIsFoundShowsOverThePictureThatStands) {
  writeVoxels(*sFolder / "ball.nrrd", kEdge, ball<kEdge>);
  openBall("ball.nrrd", kEdge);
  ASSERT_TRUE(settle());
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, placeAt(0.0));
  int drawn = 0, shown = -1;
  for (double distance : {3.0, 6.0, 9.0, 13.0}) {
    moveTo(placeAt(distance));
    EXPECT_NEAR(session::extrusionOf(cut(), 1), distance, 0.5);
    EXPECT_TRUE(tool()->tag().contains("Region 1")) << "the label waits for nothing";
    ASSERT_TRUE(QTest::qWaitFor([&] { return tool()->preview().drawnCount() > drawn && session::isGrown(scene()); },
                                kPatience));
    // Until the picture of what was found last is there.
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const QImage& image = tool()->preview().image();
          return !image.isNull() && qAlpha(image.pixel(placeAt(0.7 * distance))) == 255;
        },
        kPatience));
    drawn = tool()->preview().drawnCount();
    // The press itself may finish a picture.
    if (shown < 0) shown = viewport().shownCount();
  }
  EXPECT_EQ(viewport().shownCount(), shown) << "the rest is not drawn anew";
  takeShot(*mWindow, "pull-follow");
  // A hand that rests changes nothing.
  QTest::qWait(500);
  EXPECT_EQ(viewport().shownCount(), shown);
  QImage over = tool()->preview().image();
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, placeAt(13.0));
  EXPECT_EQ(tool()->preview().image(), over) << "it stays until there is a picture";
  ASSERT_TRUE(settle());
  EXPECT_GT(viewport().shownCount(), shown);
  EXPECT_TRUE(tool()->preview().image().isNull());
  takeShot(*mWindow, "pull-follow-end");
  // What was shown is what stands now.
  int same = 0, all = 0;
  for (const Seen& seen : look(8)) {
    if (seen.pick.structure != 1 || depthOf(seen.pick.world) < 2.0) continue;
    ++all, same += qAlpha(over.pixel(seen.pixel)) == 255;
  }
  EXPECT_GT(all, 50);
  EXPECT_GT(same, 0.97 * all);
}

/// Figures for docs/PERFORMANCE.md: how soon the label follows, and how many answers come in a second.
TEST_F(PullFollow, AnswersWhileEveryCoreIsBusy) {
  writeVoxels(*sFolder / "large.nrrd", kLarge, ball<kLarge>);
  openBall("large.nrrd", kLarge);
  BusyCore one, other;
  PaintCount paints(viewport());
  QElapsedTimer press;
  press.start();
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, placeAt(0.0));
  double pressMs = double(press.nsecsElapsed()) * 1e-6;
  int shown = -1, moves = 0;
  double worstMs = 0.0, sumMs = 0.0;
  QElapsedTimer all;
  all.start();
  constexpr double kSeconds = 4.0;
  while (all.elapsed() < 1000.0 * kSeconds) {
    double distance = 60.0 * double(all.elapsed()) / (1000.0 * kSeconds);
    QElapsedTimer move;
    move.start();
    int before = paints.count;
    moveTo(placeAt(distance));
    while (paints.count == before && move.elapsed() < 5000)
      QApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
    double ms = double(move.nsecsElapsed()) * 1e-6;
    worstMs = std::max(worstMs, ms), sumMs += ms, ++moves;
    if (shown < 0 && tool()->preview().drawnCount() > 0) shown = viewport().shownCount();
    QTest::qWait(8);
  }
  int answers = tool()->preview().drawnCount();
  std::printf("press %.0f ms; label %.1f ms, at most %.1f, of %d moves; %.1f answers a second; %lld voxels grown\n",
              pressMs, sumMs / moves, worstMs, moves, answers / kSeconds,
              static_cast<long long>(growth().status().voxels));
  EXPECT_EQ(viewport().shownCount(), shown) << "nothing is drawn anew";
  EXPECT_GT(answers, 0);
  EXPECT_GT(moves, 10);
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, placeAt(60.0));
  mWindow->toolbox().stop();
}

}  // namespace velum::gui
