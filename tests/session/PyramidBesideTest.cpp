#include <gtest/gtest.h>

#include <fstream>

#include "PyramidSource.h"
#include "TempFolder.h"
#include "core/Memory.h"
#include "io/phantoms/Sample.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/WriteVolume.h"
#include "session/document/Open.h"
#include "session/document/PyramidBeside.h"
#include "session/document/WorkFile.h"

namespace velum::session {
namespace {

/// A file of voxels that counts as large.
class BesideFile : public testing::Test {
 protected:
  void SetUp() override {
    io::Sample sample = io::makeSample("torso", 160, mProgress);
    io::writeVolume(sample.volume, mFolder / "scan.nii", mProgress);
    mSource.path = (mFolder / "scan.nii").string();
    setMemoryBudget({.wholeBytes = 100e3});
  }
  void TearDown() override { setMemoryBudget({}); }
  std::filesystem::path store() const { return mFolder / "scan.ome.zarr"; }

  TempFolder mFolder;
  Progress mProgress;
  scene::Source mSource;
};

TEST_F(BesideFile, IsOfferedForWhatIsLargeAndHasOneLevel) {
  auto plan = pyramidBeside(mSource);
  ASSERT_TRUE(plan);
  EXPECT_EQ(plan->path, store());
  EXPECT_GT(plan->diskBytes, plan->sampleBytes);
  EXPECT_GT(plan->freeBytes, 0.0);
  EXPECT_TRUE(plan->obstacle.empty()) << plan->obstacle;
  EXPECT_FALSE(plan->isBegun || plan->isThere);
  setMemoryBudget({});
  EXPECT_FALSE(pyramidBeside(mSource)) << "it is read in a moment";
  EXPECT_TRUE(pyramidBeside(mSource, true)) << "who asks gets one";
  EXPECT_FALSE(isTooLarge(mSource));
}

TEST_F(BesideFile, WhatIsInTheWayIsSaidBefore) {
  std::filesystem::create_directory(store());
  std::ofstream(store() / "notes.txt") << "mine";
  auto plan = pyramidBeside(mSource);
  ASSERT_TRUE(plan);
  EXPECT_NE(plan->obstacle.find("is there already"), std::string::npos) << plan->obstacle;
}

TEST_F(BesideFile, AWriterThatWasStoppedGoesOn) {
  Progress stopped([&](double fraction, const std::string&) {
    if (fraction > 0.3) stopped.cancel();
  });
  EXPECT_THROW(makePyramidBeside(mSource, store(), stopped), Cancelled);
  EXPECT_TRUE(pyramidBeside(mSource)->isBegun);
  EXPECT_THROW(readPaths({store().string()}, mProgress, {}), InputError) << "it is not whole";
  makePyramidBeside(mSource, store(), mProgress);
  auto plan = pyramidBeside(mSource);
  EXPECT_TRUE(plan->isThere);
  EXPECT_FALSE(plan->isBegun);
}

TEST_F(BesideFile, TheSceneGoesOnWithThePyramidAsItWas) {
  Loaded loaded = read({mSource}, mProgress, {});
  scene::Scene scene = loaded.scene;
  scene.volume.transfer.opacities = {{100.0, 0.0}, {200.0, 0.7}};
  makePyramidBeside(mSource, store(), mProgress);
  scene::Scene after = scene;
  rereadVolume(after, withPyramid(scene.volume.source, store()), mProgress);
  ASSERT_TRUE(after.volume.data->finer) << "it is streamed";
  EXPECT_EQ(finestDims(*after.volume.data), scene.volume.data->dims);
  EXPECT_EQ(after.volume.transfer, scene.volume.transfer) << "it is the same data: the look stays";
  EXPECT_NEAR(finestSpacing(*after.volume.data).x, spacingOf(*scene.volume.data).x, 1e-9);
  // Another level of it, too; and a voxel size that is given is that of the finest.
  scene::Source source = after.volume.source;
  source.level = 0;
  rereadVolume(after, source, mProgress);
  EXPECT_FALSE(after.volume.data->finer);
  EXPECT_EQ(after.volume.transfer, scene.volume.transfer);
  source.level = scene::kFittingLevel;
  source.spacing = glm::dvec3(3.0);
  rereadVolume(after, source, mProgress);
  ASSERT_TRUE(after.volume.data->finer);
  EXPECT_NEAR(finestSpacing(*after.volume.data).x, 3.0, 1e-9);
  EXPECT_GT(spacingOf(*after.volume.data).x, 5.9) << "of the coarse level";
}

TEST_F(BesideFile, TheLevelOfThePolicyIsTakenWhereThereIsOne) {
  makePyramidBeside(mSource, store(), mProgress);
  auto lines = levelLines(withPyramid(mSource, store()));
  ASSERT_GE(lines.size(), 2u);
  EXPECT_NE(lines.front().find("MiB"), std::string::npos) << lines.front();
  DataPolicy policy;
  policy.level = 1;
  Loaded coarse = readPaths({store().string()}, mProgress, policy);
  EXPECT_EQ(coarse.scene.volume.source.level, 1);
  EXPECT_FALSE(coarse.scene.volume.data->finer);
  policy.level = 40;
  EXPECT_EQ(readPaths({store().string()}, mProgress, policy).scene.volume.source.level, int(lines.size()) - 1);
  EXPECT_EQ(readPaths({mSource.path}, mProgress, policy).scene.volume.source.level, -1) << "it has no levels";
}

TEST(BrickBudget, TakesEffectAtOnce) {
  Progress progress;
  auto source = std::make_shared<PyramidSource>(io::makeSample("two-spheres", 64, progress).volume, 2, glm::ivec3(16));
  BrickCache cache(source, 1u << 28);
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) cache.brick({0, {x, y, 0}});
  std::size_t all = cache.bytes();
  cache.setMostBytes(all / 4);
  EXPECT_LE(cache.bytes(), all / 4);
  EXPECT_GT(cache.bytes(), 0u);
  EXPECT_TRUE(cache.find({0, {3, 3, 0}})) << "the last one used stays";
  EXPECT_FALSE(cache.find({0, {0, 0, 0}}));
}

}  // namespace
}  // namespace velum::session
