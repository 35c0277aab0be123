#include "core/FinestVoxels.h"

#include <gtest/gtest.h>

#include "RandomGrowing.h"
#include "Twins.h"
#include "growth/FirstDoubt.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"

namespace velum::growth {
namespace {

TEST(FinestVoxels, LabelsOnAnotherGridComeOntoTheFinest) {
  RandomGrowing random(7);
  Twins twins(random.volume(SampleType::UInt8, {100, 70, 66}), {32, 32, 32});
  const Volume& coarse = *twins.streamed;
  Shared<LabelVolume> given(makeLabels(
      coarse.dims, [&](glm::ivec3 v) { return v.x < 12  ? 0
                                              : v.y < 8 ? 2
                                                        : 5; }, coarse.worldFromVoxel));
  Shared<LabelVolume> labels = labelsFor(coarse, given);
  ASSERT_EQ(labels->dims(), twins.whole->dims);
  EXPECT_FALSE(labels->warnings.empty());
  for (glm::ivec3 v(0); v.z < labels->dims().z; ++v.z)
    for (v.y = 0; v.y < labels->dims().y; ++v.y)
      for (v.x = 0; v.x < labels->dims().x; ++v.x)
        ASSERT_EQ(labels->at(v), given->at(voxelAt(coarse, twins.world(v)))) << v.x << " " << v.y << " " << v.z;
  EXPECT_EQ(labelsFor(coarse, labels), labels) << "what lies on it stays";
}

TEST(FinestVoxels, WhatIsMostOfItsPlaneIsKnownByTheCoarseLevel) {
  auto volumeOf = [](int radius) {
    return makeVolume({120, 110, 100}, SampleType::UInt8, [&](glm::ivec3 v) {
      int x = v.x - 60, z = v.z - 50;
      return x * x + z * z < radius * radius ? 150.0 : v.y > 100 ? 0.0 : 20.0;
    });
  };
  for (int radius : {10, 60}) {
    Twins twins(volumeOf(radius), {32, 32, 32});
    scene::Growth step;
    step.structure = 1;
    step.seeds = {{60, 60, 50}};
    step.low = 100, step.high = 200;
    step.centre = {60, 60.5, 50};
    step.axis = {0, -1, 0};
    step.distance = firstSlabEnd(*twins.whole, step);
    EXPECT_NEAR(firstSlabEnd(*twins.streamed, step), step.distance, 1e-9);
    Progress progress;
    Grown streamed = Grower().grow(twins.streamed, labelsFor(*twins.streamed, {}), step, {}, progress);
    Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), step, {}, progress);
    twins.source->reads = 0;
    EXPECT_EQ(isMostOfItsPlane(*twins.streamed, *streamed.labels, step), radius == 60);
    EXPECT_EQ(isMostOfItsPlane(*twins.whole, *whole.labels, step), radius == 60);
    EXPECT_EQ(twins.source->reads, 0);
  }
}

TEST(FinestVoxels, AreThoseOfTheVolumeWhereverTheyLie) {
  RandomGrowing random(3);
  for (int i = 0; i < 10; ++i) {
    glm::ivec3 dims(random.whole(4, 60), random.whole(4, 40), random.whole(4, 40));
    Twins twins(random.volume(SampleType::Float32, dims, random.whole(1, 3)), {random.whole(1, 40), 7, 9});
    FinestVoxels streamed(*twins.streamed), whole(*twins.whole);
    EXPECT_TRUE(streamed.isStreamed());
    EXPECT_FALSE(whole.isStreamed());
    EXPECT_EQ(&whole.grid(), &*twins.whole);
    ASSERT_EQ(streamed.grid().dims, dims);
    int channel = random.whole(0, twins.whole->channels - 1);
    for (int k = 0; k < 50; ++k) {
      glm::ivec3 v = random.voxel(dims);
      ASSERT_EQ(streamed.value(v, channel), valueAt(*twins.whole, v, channel));
      ASSERT_EQ(whole.value(v, channel), valueAt(*twins.whole, v, channel));
    }
    glm::ivec3 first = random.voxel(dims) - 5;
    Volume a = streamed.read(first, glm::ivec3(12), -1, 0), b = whole.read(first, glm::ivec3(12), -1, 0);
    EXPECT_EQ(a.dims, b.dims);
    EXPECT_EQ(a.voxels, b.voxels);
    EXPECT_EQ(a.worldFromVoxel, b.worldFromVoxel);
  }
}

}  // namespace
}  // namespace velum::growth
