#include "growth/Grower.h"

#include <gtest/gtest.h>

#include "GrowOracle.h"
#include "RandomGrowing.h"
#include "core/Error.h"
#include "growth/GrowOverTime.h"
#include "growth/LabelsFor.h"

namespace velum::growth {
namespace {

scene::Growth stepOf(int structure, std::vector<glm::dvec3> seeds, double low, double high) {
  scene::Growth step;
  step.structure = structure;
  step.seeds = std::move(seeds);
  step.low = low, step.high = high;
  return step;
}

scene::Growth randomStep(RandomGrowing& random, const Volume& volume) {
  auto world = [&](glm::ivec3 v) { return glm::dvec3(volume.worldFromVoxel * glm::dvec4(v, 1.0)); };
  const double lows[] = {30, 50, 60};
  double low = lows[random.whole(0, 2)];
  scene::Growth step = stepOf(random.whole(4, 6), {}, low, low + 25.0);
  for (int i = random.whole(0, 2); i > 0; --i) step.seeds.push_back(world(random.voxel(volume.dims)));
  step.within = random.whole(0, 5) == 0 ? random.whole(1, 6) : 0;
  step.centre = world(random.voxel(volume.dims)) + glm::dvec3(0.0123, 0.00711, 0.00537);
  step.axis = random.whole(0, 6) == 0 ? glm::dvec3(0.0) : random.direction();
  step.distance = random.whole(0, 5) == 0 ? scene::Growth::kEndless : random.number(0, 25);
  return step;
}

bool areEqual(const LabelVolume& a, const LabelVolume& b) {
  std::vector<std::uint16_t> of[2];
  for (auto& ids : of) ids.resize(std::size_t(a.dims().x) * std::size_t(a.dims().y) * std::size_t(a.dims().z));
  a.read({0, 0, 0}, a.dims(), of[0]);
  b.read({0, 0, 0}, b.dims(), of[1]);
  return of[0] == of[1];
}

/// A step by its definition.
LabelVolume byDefinition(const Volume& volume, const LabelVolume& before, const scene::Growth& step) {
  GrowOracle oracle(volume, before, step.structure, ruleOf(step));
  std::vector<glm::ivec3> seeds;
  for (auto seed : step.seeds) seeds.push_back(voxelAt(volume, seed));
  oracle.step(seeds, step.centre, step.axis, step.distance);
  return makeLabels(
      volume.dims, [&](glm::ivec3 v) { return oracle.has(v) ? step.structure : int(before.at(v)); },
      volume.worldFromVoxel);
}

TEST(Grower, AStepDependsOnNothingButLabelsAndStep) {
  std::size_t all = 0;
  for (unsigned seed = 0; seed < 25; ++seed) {
    RandomGrowing random(seed);
    Shared<Volume> volume(random.volume(SampleType::Int16, random.dims()));
    Shared<LabelVolume> labels(random.labels(*volume)), earlier = labels;
    Grower kept;
    Progress progress;
    for (int i = 0; i < 12; ++i) {
      // Structures by turns, compete for the same voxels; and now and then somebody undoes.
      scene::Growth step = randomStep(random, *volume);
      if (random.whole(0, 4) == 0) labels = earlier;
      LabelVolume wanted = byDefinition(*volume, *labels, step);
      Grown grown = kept.grow(volume, labels, step, {}, progress);
      ASSERT_TRUE(areEqual(*grown.labels, wanted)) << "seed " << seed << ", step " << i;
      // What it says it has changed.
      std::size_t changed = 0;
      glm::ivec3 first = volume->dims, end(0);
      for (int z = 0; z < volume->dims.z; ++z)
        for (int y = 0; y < volume->dims.y; ++y)
          for (int x = 0; x < volume->dims.x; ++x) {
            glm::ivec3 v(x, y, z);
            if (wanted.at(v) == labels->at(v)) continue;
            ++changed;
            first = glm::min(first, v), end = glm::max(end, v + 1);
          }
      ASSERT_EQ(grown.voxels, changed);
      ASSERT_EQ(grown.box, changed > 0 ? (VoxelBox{first, end}) : VoxelBox{});
      ASSERT_EQ(grown.labels == labels, changed == 0);
      if (random.whole(0, 2) == 0) earlier = labels;
      labels = grown.labels;
      all += changed;
    }
  }
  EXPECT_GT(all, 100000u);
}

TEST(Grower, WhoComesFirstHasTheVoxelsThatTwoWant) {
  Shared<Volume> volume(makeVolume({70, 8, 8}, SampleType::UInt8, [](glm::ivec3) { return 9; }));
  auto left = stepOf(1, {{0, 4, 4}}, 5, 10), right = stepOf(2, {{69, 4, 4}}, 5, 10);
  left.axis = {1, 0, 0}, left.centre = {-0.5, 0, 0}, left.distance = 40;
  right.axis = {-1, 0, 0}, right.centre = {69.5, 0, 0}, right.distance = 40;
  Progress progress;
  auto oneWay = growLabels(volume, {}, std::vector{left, right}, 0, progress);
  auto otherWay = growLabels(volume, {}, std::vector{right, left}, 0, progress);
  EXPECT_EQ(oneWay->at({35, 4, 4}), 1);
  EXPECT_EQ(otherWay->at({35, 4, 4}), 2);
  EXPECT_EQ(oneWay->at({40, 4, 4}), 2);
  EXPECT_EQ(otherWay->at({29, 4, 4}), 1);
}

TEST(Grower, OnlyBricksThatItTouchesAreNew) {
  Shared<Volume> volume(makeVolume({128, 128, 128}, SampleType::UInt8, [](glm::ivec3 v) { return v.x < 20 ? 9 : 0; }));
  auto step = stepOf(3, {{4, 4, 4}}, 5, 10);
  step.axis = {0, 0, 1}, step.centre = {0, 0, -0.5}, step.distance = 10;
  Progress progress;
  auto before = labelsFor(*volume, {});
  Grown grown = Grower().grow(volume, before, step, {}, progress);
  EXPECT_EQ(grown.voxels, 20u * 128 * 10);
  EXPECT_EQ(grown.box, (VoxelBox{{0, 0, 0}, {20, 128, 10}}));
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        EXPECT_EQ(before->brickId({x, y, z}) == grown.labels->brickId({x, y, z}), x > 0 || z > 0);
  ASSERT_EQ(grown.labels->table.size(), 1u);
  EXPECT_EQ(grown.labels->table[0].id, 3);
}

TEST(Grower, LabelsOfAnotherGridAreBroughtOntoTheVolumes) {
  glm::dmat4 frame = centredFrame({40, 40, 40});
  Shared<Volume> volume(makeVolume(
      {40, 40, 40}, SampleType::UInt8, [](glm::ivec3) { return 9; }, frame));
  Shared<LabelVolume> coarse(makeLabels(
      {20, 20, 20}, [](glm::ivec3 v) { return v.x < 10 ? 5 : 0; }, centredFrame({20, 20, 20}, glm::dvec3(2.0))));
  Progress progress;
  auto labels = growLabels(volume, coarse, std::vector{stepOf(6, {{5, 5, 5}}, 1, 10)}, 0, progress);
  EXPECT_EQ(labels->dims(), volume->dims);
  EXPECT_EQ(labels->at({19, 3, 3}), 5);
  EXPECT_EQ(labels->at({20, 3, 3}), 6);
  ASSERT_EQ(labels->warnings.size(), 1u);
  EXPECT_NE(labels->warnings[0].find("nearest voxel"), std::string::npos);
  EXPECT_EQ(labelsFor(*volume, labels), labels) << "on the grid they stay what they are";
}

TEST(Grower, CancelledItHasChangedNothing) {
  RandomGrowing random(9);
  Shared<Volume> volume(random.volume(SampleType::Int16, {90, 90, 90}));
  auto before = labelsFor(*volume, {});
  auto step = stepOf(1, {{20.0, 10.0, -3.0}}, 0, 100);
  step.axis = {0.1, 0.2, 1}, step.centre = {20.0, 10.0, -30.0};
  Grower grower;
  bool isCancelled = false;
  Progress* running = nullptr;
  Progress stopping([&](double fraction, const std::string&) {
    if (fraction > 0.1) running->cancel();
  });
  running = &stopping;
  try {
    grower.grow(volume, before, step, {}, stopping);
  } catch (const Cancelled&) {
    isCancelled = true;
  }
  EXPECT_TRUE(isCancelled);
  EXPECT_TRUE(before->idsInUse().empty());
  Progress progress;
  Grown grown = grower.grow(volume, before, step, {}, progress);
  EXPECT_TRUE(areEqual(*grown.labels, byDefinition(*volume, *before, step)));
}

TEST(Grower, RefusesLabelsThatCannotBe) {
  Shared<Volume> volume(makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3) { return 1; }));
  Progress progress;
  EXPECT_THROW(growLabels(volume, {}, std::vector{stepOf(0, {}, 0, 1)}, 0, progress), ArgumentError);
  EXPECT_THROW(growLabels(volume, {}, std::vector{stepOf(65536, {}, 0, 1)}, 0, progress), ArgumentError);
}

}  // namespace
}  // namespace velum::growth
