// What is about to flow into something else is held and said, with every way on that there is; Esc stops what grows.
#include <QDoubleSpinBox>
#include <QLabel>
#include <map>

#include "PullFixture.h"
#include "patience.h"
#include "session/extrusion/Pull.h"

namespace velum::gui {

namespace {

constexpr int kLeakEdge = 64, kMazeEdge = 320;

/// A bar along y that opens into a block at y < 16, which is a little brighter.
int barAndBlock(int x, int y, int z) {
  bool isBar = std::abs(x - 32) < 4 && std::abs(z - 32) < 4;
  bool isBlock = y < 16 && x > 2 && x < 62 && z > 2 && z < 62;
  return isBlock ? 170 : isBar ? 150 : 20;
}

/// In every plane across y one winding way, which takes as many steps to go as it has voxels.
int maze(int x, int, int z) {
  bool isTurn = x % 4 == 1 ? z == 0 : x % 4 == 3 && z == kMazeEdge - 1;
  return x % 2 == 0 || isTurn ? 150 : 20;
}

}  // namespace

class PullLeak : public PullFixture {
 protected:
  static constexpr double kPlane = 40.0, kBlock = 15.5, kFar = 36.0;

  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    writeVoxels(*sFolder / "leak.nrrd", kLeakEdge, barAndBlock);
    writeVoxels(*sFolder / "maze.nrrd", kMazeEdge, maze);
  }

  /// The bar is pulled out beyond where it becomes the block.
  void pullTheBar() {
    glm::dvec3 place(32, kPlane, 32);
    openCut(path("leak.nrrd"), place);
    pull(pixelOf(place), place, cut(), kFar);
    ASSERT_TRUE(settle());
    ASSERT_EQ(scene().labels.growths.size(), 1u);
    mStructure = scene().labels.growths[0].structure;
  }
  bool isWarned() { return child<QLabel>("leakText")->isVisible(); }
  void type(const char* name, const QString& number) {
    auto* spin = child<QDoubleSpinBox>(name);
    ASSERT_TRUE(spin && spin->isVisible());
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, number);
    QTest::keyClick(spin, Qt::Key_Return);
    ASSERT_TRUE(settle());
  }
  std::size_t voxelsInBlock() {
    return voxelsOf(mStructure, [](glm::dvec3 p) { return p.y < kBlock; });
  }
  /// How far it has grown out of the face.
  double deepest() {
    double deep = 0.0;
    voxelsOf(mStructure, [&](glm::dvec3 p) { return deep = std::max(deep, kPlane - p.y), true; });
    return deep;
  }
  void expectWholeBarAlone() {
    EXPECT_FALSE(isWarned());
    EXPECT_EQ(voxelsInBlock(), 0u);
    EXPECT_GT(deepest(), kPlane - kBlock - 2.0) << "as far as it is pulled, or there is some of it";
    EXPECT_NEAR(session::extrusionOf(cut(), mStructure), kFar, 1.0);
    EXPECT_TRUE(session::isGrown(scene()));
  }

  int mStructure = 0;
};

TEST_F(PullLeak, IsSaidBeforeThePictureIsFloodedAndMayStayAsFarAsHere) {
  pullTheBar();
  ASSERT_TRUE(isWarned());
  takeShot(*mWindow, "pull-leak");
  QString text = child<QLabel>("leakText")->text();
  EXPECT_TRUE(text.contains("Region 1")) << text.toStdString();
  EXPECT_TRUE(text.contains("mm")) << text.toStdString();
  EXPECT_EQ(voxelsInBlock(), 0u);
  std::size_t held = voxelsOf(mStructure);
  EXPECT_GT(held, 49u * 15) << "what there is of the bar stays";
  clickButton("leakHere");
  EXPECT_FALSE(isWarned());
  EXPECT_EQ(voxelsOf(mStructure), held);
  EXPECT_NEAR(session::extrusionOf(cut(), mStructure), kFar, 1.0);
}

TEST_F(PullLeak, FieldsKeepTheirPlacesWhenItIsSaid) {
  glm::dvec3 place(32, kPlane, 32);
  openCut(path("leak.nrrd"), place);
  pull(pixelOf(place), place, cut(), 6.0);
  ASSERT_TRUE(settle());
  ASSERT_FALSE(isWarned());
  std::map<QString, QPoint> before;
  for (const char* name : {"pulledDistance", "growLow", "growHigh", "growSteepest", "putBack", "extrusionList"})
    before[name] = child<QWidget>(name)->mapTo(mWindow.get(), QPoint());
  glm::dvec3 out = place + 6.0 * session::pullDirection(cut(), place);
  pull(pixelOf(out), out, cut(), kFar - 6.0);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(isWarned());
  for (const auto& [name, where] : before)
    EXPECT_EQ(mWindow->findChild<QWidget*>(name)->mapTo(mWindow.get(), QPoint()), where) << name.toStdString();
}

TEST_F(PullLeak, WhatIsMostOfThePlaneIsHeldFirst) {
  openCut(path("maze.nrrd"), glm::dvec3(kMazeEdge / 2));
  std::vector<Seen> face = look();
  std::erase_if(face, [&](const Seen& seen) { return !isOnFace(seen, cut()); });
  ASSERT_FALSE(face.empty());
  pull(face[face.size() / 2].pixel, face[face.size() / 2].pick.world, cut(), 10.0);
  ASSERT_TRUE(settle());
  ASSERT_TRUE(isWarned());
  EXPECT_TRUE(child<QLabel>("leakText")->text().contains("most of what there is"));
  int structure = scene().labels.growths[0].structure;
  EXPECT_LT(voxelsOf(structure), 4u * kMazeEdge * kMazeEdge) << "a slab at the most";
  clickButton("leakGoOn");
  EXPECT_FALSE(isWarned());
  EXPECT_GT(voxelsOf(structure), 8u * kMazeEdge * kMazeEdge / 2);
}

TEST_F(PullLeak, MayGoOn) {
  pullTheBar();
  ASSERT_TRUE(isWarned());
  clickButton("leakGoOn");
  EXPECT_FALSE(isWarned());
  EXPECT_GT(voxelsInBlock(), 59u * 59 * 10);
}

TEST_F(PullLeak, IsHealedByANarrowerRange) {
  pullTheBar();
  ASSERT_TRUE(isWarned());
  type("growHigh", "160");
  EXPECT_EQ(scene().labels.growths[0].high, 160.0);
  expectWholeBarAlone();
}

TEST_F(PullLeak, IsHealedByAStopAtEdges) {
  pullTheBar();
  ASSERT_TRUE(isWarned());
  type("growSteepest", "8");
  EXPECT_EQ(scene().labels.growths[0].steepest, 8.0);
  expectWholeBarAlone();
}

TEST_F(PullLeak, IsHealedByABarrierThatIsDrawnAcrossIt) {
  pullTheBar();
  ASSERT_TRUE(isWarned());
  clickButton("barrierTool");
  // Across the bar before the place where it is held, wide enough for all of it.
  constexpr double kDepth = 16.0;
  std::vector<Seen> across = look(3);
  std::erase_if(across, [&](const Seen& seen) {
    return seen.pick.structure != mStructure || std::abs(kPlane - seen.pick.world.y - kDepth) > 1.0 ||
           seen.pick.normal.z < 0.7;
  });
  ASSERT_GE(across.size(), 3u);
  auto byX = [](const Seen& a, const Seen& b) { return a.pick.world.x < b.pick.world.x; };
  auto [from, to] = std::minmax_element(across.begin(), across.end(), byX);
  turnWheel(5);
  QTest::keyClick(&viewport(), Qt::Key_G);  // the cut's handles lie over it
  drag(from->pixel, to->pixel);
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-barrier");
  const auto& step = scene().labels.growths[0];
  ASSERT_EQ(step.barriers.size(), 1u);
  EXPECT_GT(step.barriers[0].radius, 5.0);
  EXPECT_FALSE(isWarned());
  EXPECT_EQ(voxelsInBlock(), 0u);
  EXPECT_LT(deepest(), kDepth) << "nothing grows through it";
  EXPECT_GT(deepest(), kDepth - 2.5 * step.barriers[0].radius) << "nor is what lies before it lost";
  EXPECT_TRUE(session::isGrown(scene()));
  document().undo();
  ASSERT_TRUE(settle());
  EXPECT_GT(deepest(), kDepth);
}

TEST_F(PullLeak, EscStopsWhatGrowsAndLeavesWhatThereIsWhileTheWindowAnswers) {
  // Deep enough that it grows for many pictures, however slow the machine draws them.
  openCut(path("maze.nrrd"), {kMazeEdge / 2, kMazeEdge - 4, kMazeEdge / 2});
  constexpr double kDeep = kMazeEdge - 10;
  std::vector<Seen> face = look();
  std::erase_if(face, [&](const Seen& seen) { return !isOnFace(seen, cut()); });
  ASSERT_FALSE(face.empty());
  const Seen& place = face[face.size() / 2];
  pull(place.pixel, place.pick.world, cut(), kDeep);
  // The ways are all that there is.
  ASSERT_TRUE(QTest::qWaitFor([&] { return isWarned(); }, kPatience));
  QTest::mouseClick(child<QPushButton>("leakGoOn"), Qt::LeftButton);
  ASSERT_EQ(scene().labels.growths.size(), 1u);
  int structure = scene().labels.growths[0].structure;
  auto isUnderWay = [&] { return growth().isGrowing() && !scene().labels.grown.empty(); };
  ASSERT_TRUE(QTest::qWaitFor([&] { return isUnderWay() && voxelsOf(structure) > 0; }, kPatience))
      << "the front is seen";
  // The camera turns, and the front goes on meanwhile.
  scene::Camera start = scene().camera;
  int shown = viewport().shownCount();
  drag({8, 8}, {14, 8}, Qt::MiddleButton);
  EXPECT_NE(scene().camera, start);
  ASSERT_TRUE(QTest::qWaitFor([&] { return viewport().shownCount() > shown; }, kPatience));
  ASSERT_TRUE(growth().isGrowing()) << "the picture did not wait for its end";
  std::size_t before = voxelsOf(structure);
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(growth().isGrowing());
  EXPECT_TRUE(tool()) << "the tool stays";
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "pull-stopped");
  EXPECT_TRUE(session::isGrown(scene()));
  std::size_t stopped = voxelsOf(structure);
  EXPECT_GE(stopped, before);
  EXPECT_LT(scene().labels.growths.back().distance, kDeep - 5.0);
  EXPECT_NEAR(session::extrusionOf(cut(), structure), kDeep, 2.0);
  EXPECT_EQ(document().undoLabel(), "Stop growing");
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(tool()) << "when nothing grows it lays the tool down";
}

}  // namespace velum::gui
