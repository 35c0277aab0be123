// Membranes over volumes that are larger than memory: forces come from the finest level in the sheet's reach.
#include "GlFixture.h"
#include "PyramidSource.h"
#include "io/phantoms/Sample.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/MembraneMover.h"
#include "session/membrane/Membranes.h"

namespace velum::session {
namespace {

class StreamedMembranesGL : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    io::Sample sample = io::makeSample("vessels", 96, sProgress);
    mSource = std::make_shared<PyramidSource>(sample.volume, 3, glm::ivec3(32, 20, 24));
    mWhole = Shared<Volume>(std::move(sample.volume));
    mLabels = Shared<LabelVolume>(std::move(sample.labels));
  }
  /// A membrane over the streamed volume, or the same one in memory.
  /// @param size  of the frame, as shares of the window's
  scene::Scene sceneOf(bool isStreamed, glm::dvec3 axis, glm::dvec3 share = glm::dvec3(1.0)) {
    scene::Scene scene;
    scene.volume.data = mWhole;
    scene.camera.target = centreOf(*mWhole);
    scene.camera.eye = scene.camera.target + axis * 1000.0;
    scene.cuts = {makeCut(scene, scene::CutShape::Membrane)};
    scene.cuts[0].id = 1;
    scene.cuts[0].centre = centreOf(*mWhole);
    scene.cuts[0].size *= share;
    protectValues(*scene.cuts[0].membrane, 700, 4000);
    scene.cuts[0].membrane->field.leastPiece = 1;  // all count, wherever the box ends
    if (isStreamed) scene.volume.data = Shared<Volume>(streamedVolume(mSource, 2));
    return scene;
  }
  MembraneReport settled(scene::Scene& scene, bool limit = false) {
    return settleMembranes(scene, {true, limit}, sProgress).at(0);
  }

  std::shared_ptr<PyramidSource> mSource;
  Shared<Volume> mWhole;
  Shared<LabelVolume> mLabels;
  inline static Progress sProgress;
};

void expectSame(const MembraneReport& streamed, const MembraneReport& whole) {
  EXPECT_TRUE(streamed.atRest);
  EXPECT_EQ(streamed.voxels.level, 0);
  EXPECT_GT(whole.kept->cutAreaPlane, 100);
  EXPECT_EQ(streamed.kept->cutAreaPlane, whole.kept->cutAreaPlane);
  EXPECT_EQ(streamed.kept->cutAreaMembrane, whole.kept->cutAreaMembrane);
  EXPECT_EQ(streamed.kept->meanDistance, whole.kept->meanDistance);
}

TEST_F(StreamedMembranesGL, RestsWhereItRestsInMemory) {
  for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)})
    for (glm::dvec3 share : {glm::dvec3(1.0), glm::dvec3(0.5, 0.6, 0.8)}) {
      scene::Scene streamed = sceneOf(true, axis, share), whole = sceneOf(false, axis, share);
      MembraneReport a = settled(streamed, true), b = settled(whole, true);
      expectSame(a, b);
      EXPECT_EQ(streamed.cuts[0].membrane->shape, whole.cuts[0].membrane->shape);
      EXPECT_EQ(a.limit->figure.cutAreaMembrane, b.limit->figure.cutAreaMembrane);
    }
}

TEST_F(StreamedMembranesGL, StructuresAndOtherRulesProtectAsInMemory) {
  auto check = [&](auto change) {
    scene::Scene streamed = sceneOf(true, {0, 0, 1}, glm::dvec3(0.7)),
                 whole = sceneOf(false, {0, 0, 1}, glm::dvec3(0.7));
    for (scene::Scene* one : {&streamed, &whole}) {
      one->labels.data = mLabels;
      change(one->cuts[0].membrane->field);
    }
    expectSame(settled(streamed), settled(whole));
  };
  check([](scene::ForceField& field) {
    field.byValue.clear();
    field.byLabel = {{1, 400}, {2, 250}};
  });
  check([](scene::ForceField& field) { field.rule = scene::KernelRule::Paper; });
  check([](scene::ForceField& field) { field.level = 3; });
}

TEST_F(StreamedMembranesGL, KeepsMoreThanTheCoarseLevelWould) {
  scene::Scene streamed = sceneOf(true, {0, 0, 1}), coarse = streamed;
  Volume level = *streamed.volume.data;
  level.finer.reset();
  coarse.volume.data = Shared<Volume>(std::move(level));
  MembraneReport fine = settled(streamed);
  settleMembranes(coarse, {}, sProgress);
  scene::Scene whole = sceneOf(false, {0, 0, 1});
  auto byCoarse = measureCut(membrane::Potential(whole), whole.cuts[0], coarse.cuts[0].membrane->shape, sProgress);
  EXPECT_LT(double(fine.kept->cutAreaMembrane), 0.8 * double(byCoarse.cutAreaMembrane));
}

TEST_F(StreamedMembranesGL, ShowsTheCoarseSheetUntilFinerForcesAreThere) {
  scene::Scene streamed = sceneOf(true, {0, 0, 1}), rested = streamed;
  MembraneMover mover;
  mover.follow(streamed);
  mSource->reads = 0;
  auto first = mover.nextWork();
  ASSERT_TRUE(first);
  mover.endWork(first(sProgress));
  EXPECT_EQ(mSource->reads, 0) << "the first forces ask for no bricks";
  EXPECT_EQ(mover.status(1)->voxels.level, 2);
  EXPECT_TRUE(mover.isMoving());
  auto second = mover.nextWork();
  ASSERT_TRUE(second) << "finer ones are due at once, while the sheet moves";
  for (int i = 0; i < 5; ++i) mover.advance(1.0);
  mover.endWork(second(sProgress));
  EXPECT_GT(mSource->reads, 0);
  EXPECT_EQ(mover.status(1)->voxels.level, 0);
  for (int i = 0; i < 5000 && !mover.isSettled(); ++i) {
    if (auto work = mover.nextWork()) mover.endWork(work(sProgress));
    mover.advance(20.0);
  }
  ASSERT_TRUE(mover.isSettled());
  MembraneReport report = settled(rested);
  EXPECT_EQ(mover.status(1)->sheetPairs, report.kept->cutAreaMembrane);
  mover.releaseGpu();
}

TEST_F(StreamedMembranesGL, ADamagedBrickIsToldAndTheCoarseSheetHangs) {
  scene::Scene streamed = sceneOf(true, {0, 0, 1});
  mSource->damaged = true;
  EXPECT_THROW(settled(streamed), InputError);
  MembraneMover mover;
  mover.follow(streamed);
  auto first = mover.nextWork();
  mover.endWork(first(sProgress));
  auto second = mover.nextWork();
  try {
    mover.endWork(second(sProgress));
    FAIL() << "the brick is damaged";
  } catch (const InputError& error) {
    mover.endWork({}, error.what());
  }
  EXPECT_EQ(mover.status(1)->error, "brick is damaged");
  for (int i = 0; i < 5000 && mover.isMoving(); ++i) mover.advance(20.0);
  EXPECT_FALSE(mover.isMoving());
  EXPECT_EQ(mover.status(1)->voxels.level, 2);
  EXPECT_FALSE(mover.withShapes(streamed).cuts[0].membrane->shape.places.empty());
  mover.releaseGpu();
}

TEST_F(StreamedMembranesGL, ACancelIsHeardAtTheNextBrick) {
  scene::Scene streamed = sceneOf(true, {0, 0, 1});
  Progress progress;
  mSource->reads = 0;
  mSource->whenRead = [&] {
    if (mSource->reads > 5) progress.cancel();
  };
  EXPECT_THROW(settleMembranes(streamed, {true, false}, progress), Cancelled);
  EXPECT_LT(mSource->reads, 20);
  mSource->whenRead = {};
}

}  // namespace
}  // namespace velum::session
