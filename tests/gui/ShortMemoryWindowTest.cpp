// A card without memory: the window says so, lives on, and draws again when there is memory.
#include "Shots.h"
#include "WindowFixture.h"
#include "gpu/Allocation.h"
#include "gui/kit/Messages.h"
#include "gui/look/LookPanel.h"
#include "gui/view/PreparingVeil.h"
#include "gui/view/Viewport.h"

namespace velum::gui {
namespace {

using gpu::AllocationFault;
using Which = AllocationFault::Which;

class ShortMemory : public Window {
 protected:
  QString said() { return mWindow->messages().isVisible() ? mWindow->messages().text() : QString(); }
  void expectSaid() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return said().contains("memory"); }, 20'000)) << said().toStdString();
    EXPECT_TRUE(said().contains("close other programs")) << said().toStdString();
    EXPECT_FALSE(said().contains('\n'));
  }
  void turn(double by) {
    mWindow->document().view([by](scene::Scene& scene) { scene.camera.eye.x += by; });
  }
  void openSettled() {
    openPhantom();
    drawSoon();
    ASSERT_TRUE(settle());
  }
  void addCut() {
    mWindow->document().edit("Add cut", [](scene::Scene& scene) {
      scene::Cut plane;
      plane.axis = {0, -1, 0};
      plane.centre = scene.camera.target;
      scene::addCut(scene, plane);
    });
  }
};

TEST_F(ShortMemory, WhereASceneIsOpenedItIsSaidAndDrawnAtTheNextChange) {
  {
    AllocationFault fault(Which::NthOn, 1);
    mWindow->openPaths({path("phantom.nrrd")});
    expectSaid();
    EXPECT_FALSE(viewport().isCurrent());
    takeShot(*mWindow, "short-memory-open");
    EXPECT_FALSE(fault.failed().empty());
  }
  mWindow->messages().hide();
  turn(1.0);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(viewport().isCurrent());
  EXPECT_EQ(said(), "");
}

TEST_F(ShortMemory, WhereItIsCutItIsSaidAndDrawnAtTheNextChange) {
  openSettled();
  {
    AllocationFault fault(Which::NthOn, 1);
    addCut();
    expectSaid();
    EXPECT_FALSE(viewport().pickAt({100, 100}).has_value()) << "what stands there is another picture";
    EXPECT_EQ(child<PreparingVeil>("preparingVeil")->kind(), PreparingVeil::Kind::Dim);
    takeShot(*mWindow, "short-memory-cut");
  }
  mWindow->messages().hide();
  turn(1.0);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(viewport().isCurrent());
  EXPECT_EQ(said(), "");
}

/// Each in turn, as the picture of a cut is made: whichever fails, the cut is drawn or it is said.
TEST_F(ShortMemory, OneThatFailsIsMadeUpForBySomethingThatGoes) {
  openSettled();
  for (std::size_t n : {1, 2, 4, 8, 12, 16, 24, 32}) {
    {
      AllocationFault fault(Which::Nth, n);
      n % 2 ? addCut() : turn(1.0);
      ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().isConverged() || !said().isEmpty(); }, 20'000)) << n;
    }
    turn(0.5);
    ASSERT_TRUE(settle());
    EXPECT_TRUE(viewport().isCurrent()) << n;
    mWindow->messages().hide();
  }
}

TEST_F(ShortMemory, ASheetThatCannotMoveMovesLater) {
  openSettled();
  {
    AllocationFault fault(Which::NthOn, 1);
    mWindow->actions().find("cut.addMembrane")->trigger();
    expectSaid();
  }
  mWindow->messages().hide();
  turn(1.0);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(viewport().isCurrent());
  EXPECT_EQ(said(), "");
}

TEST_F(ShortMemory, SmallPicturesSayWhyThereAreNone) {
  auto* words = mWindow->findChild<LookPanel*>()->findChild<QLabel*>("noSmallPictures");
  ASSERT_TRUE(words);
  {
    // The view's own picture has the memory that it needs.
    AllocationFault fault(Which::Larger, 100, AllocationFault::Threads::All);
    openPhantom();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !words->isHidden(); }, 30'000));
    EXPECT_TRUE(words->text().contains("memory")) << words->text().toStdString();
  }
  mWindow->messages().hide();
  turn(1.0);
  ASSERT_TRUE(settle());
  EXPECT_TRUE(QTest::qWaitFor([&] { return words->isHidden(); }, 30'000)) << words->text().toStdString();
}

}  // namespace
}  // namespace velum::gui
