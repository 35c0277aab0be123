// A structure that has leaked is told what it is not: by a click, by a stroke, from the box that says why it is held.
#include <QLabel>

#include "PullFixture.h"
#include "gui/view/SectionView.h"

namespace velum::gui {

namespace {

constexpr int kNotThisEdge = 64;
constexpr double kPlane = 40.0, kFar = 36.0;

/// A bar along y that opens into a block at y < 16, and a bar of its own beside it.
int pullNotThisBarAndBlock(int x, int y, int z) {
  bool isBar = std::abs(x - 32) < 4 && std::abs(z - 32) < 4;
  bool isBlock = y < 16 && x > 2 && x < 62 && z > 2 && z < 62;
  bool isAlone = std::abs(x - 12) < 3 && std::abs(z - 12) < 3 && y > 20;
  return isBlock || isBar ? 150 : isAlone ? 100 : 20;
}

constexpr auto kNotThis = Qt::ControlModifier | Qt::ShiftModifier;

}  // namespace

class PullNotThis : public PullFixture {
 protected:
  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    writeVoxels(*sFolder / "not.nrrd", kNotThisEdge, pullNotThisBarAndBlock);
  }
  void SetUp() override {
    PullFixture::SetUp();
    openCut(path("not.nrrd"), kOnBar);
    pull(pixelOf(kOnBar), kOnBar, cut(), kFar);
    ASSERT_TRUE(settle());
    ASSERT_EQ(scene().labels.growths.size(), 1u);
    mStructure = scene().labels.growths[0].structure;
    ASSERT_TRUE(leakText().isVisible());
  }
  QLabel& leakText() { return *child<QLabel>("leakText"); }
  /// All of the block comes along.
  void flood() {
    clickButton("leakGoOn");
    ASSERT_GT(inBlock(), 59u * 59 * 7);
  }
  std::size_t inBlock() {
    return voxelsOf(mStructure, [](glm::dvec3 p) { return p.y < 12; });
  }
  std::size_t inBar() {
    return voxelsOf(mStructure, [](glm::dvec3 p) { return p.y > 18; });
  }
  /// The block is given up but for what lies at its mouth, and the bar stays.
  void expectBarAlone() {
    EXPECT_LT(inBlock(), 200u);
    EXPECT_GT(inBar(), 49u * 19);
    EXPECT_FALSE(leakText().isVisible());
    EXPECT_TRUE(session::isGrown(scene()));
    EXPECT_NEAR(session::extrusionOf(cut(), mStructure), kFar, 1.0);
  }
  /// Where the block is seen, well inside.
  std::vector<Seen> seenBlock() {
    std::vector<Seen> seen = look();
    std::erase_if(seen, [&](const Seen& one) {
      glm::dvec3 place = one.pick.world;
      return one.pick.structure != mStructure || place.y > 13 || glm::distance(place, {32, 10, 32}) < 14;
    });
    return seen;
  }

  static constexpr glm::dvec3 kOnBar{32, kPlane, 32}, kAlone{12, kPlane, 12};
  int mStructure = 0;
};

TEST_F(PullNotThis, AClickOnWhatItHasLeakedIntoTakesThatAwayInOneStep) {
  flood();
  EXPECT_TRUE(tool()->hint().contains("Ctrl and Shift"));
  takeShot(*mWindow, "not-this-before");
  auto labels = scene().labels.data;
  scene::Camera camera = scene().camera;
  auto seen = seenBlock();
  ASSERT_GT(seen.size(), 5u);
  QTest::mouseClick(&viewport(), Qt::LeftButton, kNotThis, seen[seen.size() / 2].pixel);
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "not-this");
  EXPECT_EQ(scene().camera, camera);
  ASSERT_EQ(scene().labels.growths.size(), 1u);
  EXPECT_EQ(scene().labels.growths[0].others.size(), 1u);
  expectBarAlone();
  EXPECT_TRUE(child<QLabel>("growText")->text().contains("not of it"));
  EXPECT_EQ(document().undoLabel(), "Not this: Region 1");
  document().undo();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(scene().labels.data == labels);
  EXPECT_TRUE(scene().labels.growths[0].others.empty());
}

TEST_F(PullNotThis, AStrokeSaysSoOfAllThatLiesUnderIt) {
  flood();
  auto seen = seenBlock();
  ASSERT_GT(seen.size(), 5u);
  auto byX = [](const Seen& a, const Seen& b) { return a.pixel.x() < b.pixel.x(); };
  auto [from, to] = std::minmax_element(seen.begin(), seen.end(), byX);
  drag(from->pixel, to->pixel, Qt::LeftButton, kNotThis);
  ASSERT_TRUE(settle());
  ASSERT_EQ(scene().labels.growths.size(), 1u);
  EXPECT_GT(scene().labels.growths[0].others.size(), 3u);
  expectBarAlone();
  std::size_t steps = scene().labels.growths[0].others.size();
  document().undo();
  EXPECT_TRUE(scene().labels.growths[0].others.empty()) << "all " << steps << " at once";
}

TEST_F(PullNotThis, TheBoxThatHoldsItAsksForAClickOnASection) {
  mWindow->views().setLayout(scene::Layout::FourUp);
  ASSERT_TRUE(settle());
  clickButton("leakNotThis");
  EXPECT_TRUE(tool());
  EXPECT_TRUE(tool()->hint().contains("not of it")) << tool()->hint().toStdString();
  takeShot(*mWindow, "not-this-asked");
  SectionView& view = mWindow->views().section(scene::SectionKind::Axial);
  document().view([](scene::Scene& s) { s.sections.crosshair = {32, 20, 32}; });
  ASSERT_TRUE(settle());
  glm::dvec2 p = scene::sectionPixelFromWorld(view.plane(), {20, 8, 32});
  QTest::mouseClick(&view, Qt::LeftButton, {}, {int(std::lround(p.x)), int(std::lround(p.y))});
  ASSERT_TRUE(settle());
  takeShot(*mWindow, "not-this-section");
  EXPECT_EQ(scene().labels.growths[0].others.size(), 1u);
  expectBarAlone();
  EXPECT_FALSE(tool()->hint().contains("Click on what is not")) << "once";
}

TEST_F(PullNotThis, EscTakesTheQuestionBackAndLeavesTheTool) {
  clickButton("leakNotThis");
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_TRUE(tool());
  EXPECT_FALSE(tool()->hint().contains("Click on what is not"));
  EXPECT_TRUE(leakText().isVisible());
}

TEST_F(PullNotThis, OnWhatItDoesNotReachNothingChangesAndItIsSaid) {
  scene::Scene before = scene();
  std::string step = document().undoLabel();
  document().edit("Narrow", [&](scene::Scene& s) {
    session::changeGrowth(s, mStructure, [](scene::Growth& growth) { growth.low = 120.0; });
  });
  ASSERT_TRUE(settle());
  before = scene(), step = document().undoLabel();
  QTest::mouseClick(&viewport(), Qt::LeftButton, kNotThis, pixelOf(kAlone));
  ASSERT_TRUE(settle());
  EXPECT_EQ(scene(), before);
  EXPECT_EQ(document().undoLabel(), step);
  EXPECT_NE(mWindow->messages().text().toStdString().find("gives up nothing"), std::string::npos);
}

}  // namespace velum::gui
