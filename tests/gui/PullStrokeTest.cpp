// A stroke with Ctrl gives a structure that was pulled out more places to grow from.
#include "PullFixture.h"
#include "gui/extrusion/SeedStroke.h"

namespace velum::gui {

namespace {

constexpr int kStrokeEdge = 64;
constexpr double kStrokePlane = 40.0, kStrokeOut = 14.0;
constexpr int kBars[] = {14, 32, 50}, kValues[] = {150, 150, 230};

bool isBar(int i, double x, double z) { return std::abs(x - kBars[i]) < 5 && std::abs(z - 32) < 5; }

/// Three bars along y that touch nowhere, the third of other values.
int bars(int x, int, int z) {
  for (int i = 0; i < 3; ++i)
    if (isBar(i, x, z)) return kValues[i];
  return 20;
}

}  // namespace

class PullStroke : public PullFixture {
 protected:
  static void SetUpTestSuite() {
    Window::SetUpTestSuite();
    writeVoxels(*sFolder / "bars.nrrd", kStrokeEdge, bars);
  }
  /// With a plane across the bars, seen obliquely; the first one is pulled out.
  void pullTheFirst() {
    open({path("bars.nrrd")});
    document().edit("Look", [&](scene::Scene& s) {
      s.volume.transfer.opacities = {{60, 0}, {80, 1}, {255, 1}};
      scene::Cut cut;
      cut.axis = {0, -1, 0};
      cut.centre = onBar(1);
      scene::addCut(s, cut);
      s.camera = scene::frameCamera(s, scene::StandardView::Oblique, 1.0);
    });
    takeUp();
    pull(pixelOf(onBar(0)), onBar(0), cut(), kStrokeOut);
    ASSERT_TRUE(settle());
    ASSERT_EQ(scene().labels.growths.size(), 1u);
    mStructure = scene().labels.growths[0].structure;
    ASSERT_GT(onlyBar(0), 81u * 12);
    ASSERT_EQ(onlyBar(1), 0u);
    document().edit("Narrow", [&](scene::Scene& s) {
      session::changeGrowth(s, mStructure, [](scene::Growth& step) { step.high = 180.0; });
    });
    ASSERT_TRUE(settle());
  }
  static glm::dvec3 onBar(int i) { return {kBars[i], kStrokePlane, 32}; }
  void strokeFromTo(glm::dvec3 from, glm::dvec3 to) {
    drag(pixelOf(from), pixelOf(to), Qt::LeftButton, Qt::ControlModifier);
    ASSERT_TRUE(settle());
  }
  /// Voxels of the structure in a bar.
  std::size_t onlyBar(int i) {
    return voxelsOf(mStructure, [i](glm::dvec3 p) { return isBar(i, p.x, p.z); });
  }
  std::string said() { return mWindow->messages().text().toStdString(); }
  /// The stroke is heard, but changes nothing.
  void expectNothingAdded(glm::dvec3 from, glm::dvec3 to, const char* said) {
    scene::Scene before = scene();
    std::string step = document().undoLabel();
    mWindow->messages().showNote("-");
    strokeFromTo(from, to);
    EXPECT_TRUE(mWindow->messages().isVisible());
    EXPECT_NE(this->said().find(said), std::string::npos) << this->said();
    EXPECT_EQ(scene(), before);
    EXPECT_EQ(document().undoLabel(), step);
  }

  int mStructure = 0;
};

TEST_F(PullStroke, AddsWhatIsJoinedToItAsFarAsTheStructureIsPulledInOneStep) {
  pullTheFirst();
  std::size_t first = onlyBar(0);
  auto labels = scene().labels.data;
  scene::Camera camera = scene().camera;
  EXPECT_TRUE(tool()->hint().contains("Ctrl"));
  // From the one that is there already over the gap to the other one.
  strokeFromTo(onBar(0) + glm::dvec3(3, 0, 0), onBar(1) - glm::dvec3(2, 0, 0));
  takeShot(*mWindow, "pull-stroke");
  EXPECT_EQ(scene().camera, camera) << "nothing turns";
  EXPECT_EQ(onlyBar(0), first);
  EXPECT_NEAR(double(onlyBar(1)), double(first), 0.15 * double(first)) << "as far, not all of it";
  EXPECT_EQ(voxelsOf(mStructure), onlyBar(0) + onlyBar(1));
  auto out = session::extrusionsOf(scene());
  ASSERT_EQ(out.size(), 1u) << "it is one structure";
  auto pick = viewport().pickAt(pixelOf(onBar(1) + 0.5 * kStrokeOut * session::pullDirection(cut(), onBar(1))));
  ASSERT_TRUE(pick && pick->hit);
  EXPECT_EQ(pick->structure, mStructure) << "and is seen";
  EXPECT_GT(session::depthInCut(cut(), pick->world), 0.5);
  EXPECT_EQ(document().undoLabel(), "Add to Region 1");
  document().undo();
  ASSERT_TRUE(settle());
  EXPECT_TRUE(scene().labels.data == labels);
}

TEST_F(PullStroke, OfOtherValuesAddsNothingAndSaysSo) {
  pullTheFirst();
  expectNothingAdded(onBar(2) - glm::dvec3(3, 0, 0), onBar(2) + glm::dvec3(3, 0, 0), "Region 1");
  EXPECT_NE(said().find("180"), std::string::npos) << said();
}

TEST_F(PullStroke, WithoutAStructureThatWasGrownSaysWhatToDo) {
  pullTheFirst();
  mWindow->selection().setStructure(0);
  EXPECT_FALSE(tool()->hint().contains("stroke"));
  expectNothingAdded(onBar(1), onBar(1) + glm::dvec3(2, 0, 0), "select");
  document().edit("Row", [](scene::Scene& s) { s.labels.structures.push_back({.id = 40, .name = "given"}); });
  mWindow->selection().setStructure(40);
  expectNothingAdded(onBar(1), onBar(1) + glm::dvec3(2, 0, 0), "given has labels of its own");
}

TEST_F(PullStroke, BesideWhatCanBePulledTheViewRolls) {
  pullTheFirst();
  std::size_t steps = scene().labels.growths.size();
  glm::dvec3 up = scene().camera.up;
  drag({5, 5}, {60, 8}, Qt::LeftButton, Qt::ControlModifier);
  EXPECT_NE(scene().camera.up, up);
  EXPECT_EQ(scene().labels.growths.size(), steps);
}

TEST(SeedStroke, LeadsThroughNothingThatNobodyHasDrawnOn) {
  Volume volume;
  volume.dims = {20, 4, 4};
  glm::dvec3 from(2, 1, 1), to(9, 1, 1);
  SeedStroke one;
  one.goOn(from, {0, 1});
  one.goOn(to, {0, 1});
  EXPECT_EQ(one.places(volume).size(), 8u) << "a hand that is quick";
  SeedStroke lifted;
  lifted.goOn(from, {0, 1});
  lifted.lift();
  lifted.goOn(to, {0, 1});
  EXPECT_EQ(lifted.places(volume), (std::vector{from, to}));
  for (SeedStroke::Ground other : {SeedStroke::Ground{5, 1}, {0, 2}}) {
    SeedStroke stroke;
    stroke.goOn(from, {0, 1});
    stroke.goOn(to, other);
    EXPECT_EQ(stroke.places(volume), (std::vector{from, to})) << "onto another structure, out of another plane";
  }
}

}  // namespace velum::gui
