// What grows through bricks that are read as the front comes is what grows in memory.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "RandomGrowing.h"
#include "Twins.h"
#include "core/LabelCover.h"
#include "growth/GrowOverTime.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "growth/RegionGrow.h"
#include "growth/SmoothRegion.h"

namespace velum::growth {
namespace {

constexpr int kVessel = 3;

constexpr glm::ivec3 kVesselDims(320, 200, 200), kVesselBrick(64, 12, 12);

glm::dvec3 vesselAt(double t) {
  double turn = 6.0 * 2.0 * 3.14159265 * t;
  return {10.0 + 300.0 * t, 100.0 + 80.0 * std::cos(turn), 100.0 + 80.0 * std::sin(turn)};
}

/// A tube that winds around the long axis, 6 voxels wide, and noise.
Volume vessel() {
  std::vector<std::uint8_t> isIn(std::size_t(kVesselDims.x) * std::size_t(kVesselDims.y) * std::size_t(kVesselDims.z));
  auto at = [&](glm::ivec3 v) -> auto& {
    return isIn[(std::size_t(v.z) * std::size_t(kVesselDims.y) + std::size_t(v.y)) * std::size_t(kVesselDims.x) +
                std::size_t(v.x)];
  };
  for (int i = 0; i <= 4000; ++i) {
    glm::ivec3 middle(vesselAt(i / 4000.0));
    for (glm::ivec3 off(-3); off.z <= 3; ++off.z)
      for (off.y = -3; off.y <= 3; ++off.y)
        for (off.x = -3; off.x <= 3; ++off.x)
          if (glm::dot(glm::dvec3(off), glm::dvec3(off)) <= 9.0) at(middle + off) = 1;
  }
  return makeVolume(kVesselDims, SampleType::UInt16,
                    [&](glm::ivec3 v) { return (at(v) ? 1000.0 : 100.0) + std::floor(90.0 * hashNoise(v, 5)); });
}

const Twins& vesselTwins() {
  static const Twins twins(vessel(), kVesselBrick);
  return twins;
}

scene::Growth vesselStep() {
  scene::Growth step;
  step.structure = kVessel;
  step.seeds = {glm::dvec3(glm::ivec3(vesselAt(0.0)))};
  step.low = 900.0, step.high = 2000.0;
  return step;
}

/// The bricks in which a structure has voxels, or voxels beside them.
std::size_t bricksMet(const LabelVolume& labels, int structure, glm::ivec3 brick) {
  std::set<std::array<int, 3>> met;
  glm::ivec3 dims = labels.dims();
  for (glm::ivec3 v(0); v.z < dims.z; ++v.z)
    for (v.y = 0; v.y < dims.y; ++v.y)
      for (v.x = 0; v.x < dims.x; ++v.x) {
        if (labels.at(v) != structure) continue;
        for (int side = 0; side < 7; ++side) {
          glm::ivec3 beside = v;
          if (side > 0) beside[(side - 1) / 2] += side % 2 ? 1 : -1;
          if (!glm::all(glm::lessThan(glm::uvec3(beside), glm::uvec3(dims)))) continue;
          beside /= brick;
          met.insert({beside.x, beside.y, beside.z});
        }
      }
  return met.size();
}

TEST(StreamedGrowth, AVesselThroughHundredsOfBricksIsThatInMemory) {
  const Twins& twins = vesselTwins();
  Progress progress;
  twins.source->reads = 0;
  Grown streamed = Grower().grow(twins.streamed, labelsFor(*twins.streamed, {}), vesselStep(), {}, progress);
  int reads = twins.source->reads;
  Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), vesselStep(), {}, progress);
  EXPECT_EQ(streamed.labels->dims(), kVesselDims) << "on the finest grid";
  EXPECT_GT(whole.voxels, 50000u);
  EXPECT_EQ(streamed.voxels, whole.voxels);
  EXPECT_EQ(streamed.box, whole.box);
  EXPECT_EQ(idsOf(*streamed.labels), idsOf(*whole.labels));
  std::size_t met = bricksMet(*whole.labels, kVessel, kVesselBrick);
  EXPECT_GE(met, 200u);
  EXPECT_LT(met, 600u) << "of 1445";
  EXPECT_EQ(std::size_t(reads), met) << "each brick that the front met was read once, and no other";
}

TEST(StreamedGrowth, BricksBehindTheDistanceAreNotRead) {
  Twins twins(vessel(), kVesselBrick);
  Progress progress;
  scene::Growth step = vesselStep();
  step.axis = {1, 0, 0};
  step.centre = {5, 0, 0};
  step.distance = 55.0;  // a turn
  Grown streamed =
      Grower().grow(twins.streamed, labelsFor(*twins.streamed, {}), step, {.guard = true, .begun = {}}, progress);
  std::size_t met = bricksMet(*streamed.labels, kVessel, kVesselBrick);
  EXPECT_GT(streamed.voxels, 5000u);
  EXPECT_LE(std::size_t(twins.source->reads), met);
  Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), step, {.guard = true, .begun = {}}, progress);
  EXPECT_EQ(idsOf(*streamed.labels), idsOf(*whole.labels));
}

TEST(StreamedGrowth, FewBricksInMemoryAreEnough) {
  Twins twins(vessel(), kVesselBrick, 5 * 64 * 12 * 12 * 2);
  Progress progress;
  Grown streamed = Grower().grow(twins.streamed, labelsFor(*twins.streamed, {}), vesselStep(), {}, progress);
  Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), vesselStep(), {}, progress);
  EXPECT_EQ(idsOf(*streamed.labels), idsOf(*whole.labels));
  EXPECT_LE(twins.streamed->finer->bricks->bytes(), twins.streamed->finer->bricks->mostBytes());
}

TEST(StreamedGrowth, StoppedInTheMiddleItGoesOnToTheSameEnd) {
  Twins twins(vessel(), kVesselBrick);
  Shared<LabelVolume> labels = labelsFor(*twins.streamed, {});
  RegionGrow region(twins.streamed, labels, 0, ruleOf(vesselStep()));
  region.addSeed(voxelAt(*twins.whole, vesselStep().seeds[0]));
  Progress stopped, goesOn;
  twins.source->whenRead = [&] {
    if (twins.source->reads > 60) stopped.cancel();
  };
  EXPECT_THROW(region.grow(GrowDomain(), stopped), Cancelled);
  EXPECT_LT(twins.source->reads, 70) << "a cancel is heard at the next brick";
  std::size_t soFar = region.voxelCount();
  region.grow(GrowDomain(), goesOn);
  Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), vesselStep(), {}, goesOn);
  EXPECT_GT(soFar, 1000u);
  EXPECT_LT(soFar, whole.voxels);
  EXPECT_EQ(region.voxelCount(), whole.voxels);
}

TEST(StreamedGrowth, ADamagedBrickIsToldInWords) {
  Twins twins(vessel(), kVesselBrick);
  Shared<LabelVolume> labels = labelsFor(*twins.streamed, {});
  Progress progress;
  Grower grower;
  twins.source->whenRead = [&] { twins.source->damaged = twins.source->reads > 100; };
  EXPECT_THROW(grower.grow(twins.streamed, labels, vesselStep(), {}, progress), InputError);
  EXPECT_EQ(labels->idsInUse().size(), 0u);
  twins.source->whenRead = {};
  twins.source->damaged = false;
  Grown mended = grower.grow(twins.streamed, labels, vesselStep(), {}, progress);
  Grown whole = Grower().grow(twins.whole, labelsFor(*twins.whole, {}), vesselStep(), {}, progress);
  EXPECT_EQ(idsOf(*mended.labels), idsOf(*whole.labels));
}

/// Any step: with all that a step may have.
scene::Growth anyStep(RandomGrowing& random, const Twins& twins) {
  auto place = [&] { return twins.world(random.voxel(twins.whole->dims)); };
  const double lows[] = {30, 45, 55};
  scene::Growth step;
  step.structure = random.whole(4, 5);
  step.low = lows[random.whole(0, 2)], step.high = step.low + 30.0;
  for (int i = random.whole(1, 3); i > 0; --i) step.seeds.push_back(place());
  step.channel = random.whole(0, twins.whole->channels - 1);
  step.within = random.whole(0, 4) == 0 ? random.whole(1, 3) : 0;
  step.centre = place() + glm::dvec3(0.0123, 0.00711, 0.00537);
  step.axis = random.whole(0, 2) == 0 ? glm::dvec3(0.0) : random.direction();
  step.distance = random.whole(0, 3) == 0 ? scene::Growth::kEndless : random.number(0, 40);
  if (random.whole(0, 2) == 0) step.steepest = random.number(4, 25);
  if (random.whole(0, 2) == 0) step.barriers.push_back({{place(), place()}, random.number(0.5, 3.0)});
  if (random.whole(0, 2) == 0) step.closing = random.number(0.5, 3.0);
  step.fillHoles = random.whole(0, 1);
  for (int i = random.whole(0, 3) == 0 ? 2 : 0; i > 0; --i) step.others.push_back(place());
  return step;
}

TEST(StreamedGrowth, WhateverAStepHasItGivesTheVoxelsInMemory) {
  const SampleType types[] = {SampleType::UInt8, SampleType::Int16, SampleType::UInt16, SampleType::Float32};
  std::size_t all = 0, smoothed = 0, divided = 0, leaks = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomGrowing random(seed + 100);
    glm::ivec3 dims = random.dims();
    glm::ivec3 brick(random.whole(1, 150), random.whole(1, 40), random.whole(1, 40));
    std::size_t cacheBytes = random.whole(0, 1) ? 1u << 28 : 20000u;
    Twins twins(random.volume(types[seed % 4], dims, random.whole(1, 2)), brick, cacheBytes);
    Shared<LabelVolume> streamed(random.labels(*twins.whole)), whole = streamed;
    Grower ofStreamed, ofWhole;
    Progress progress;
    for (int i = 0; i < 6; ++i) {
      scene::Growth step = anyStep(random, twins);
      GrowOptions options{.guard = step.others.empty() && random.whole(0, 1) == 1, .begun = {}};
      Grown a = ofStreamed.grow(twins.streamed, streamed, step, options, progress);
      Grown b = ofWhole.grow(twins.whole, whole, step, options, progress);
      ASSERT_EQ(a.voxels, b.voxels) << "seed " << seed << ", step " << i;
      ASSERT_EQ(a.distance, b.distance) << "seed " << seed << ", step " << i;
      ASSERT_EQ(bool(a.leak), bool(b.leak));
      Smoothed aSmooth = smoothRegion(twins.streamed, a.labels, step, progress, a.others);
      Smoothed bSmooth = smoothRegion(twins.whole, b.labels, step, progress, b.others);
      streamed = aSmooth.labels, whole = bSmooth.labels;
      ASSERT_EQ(idsOf(*streamed), idsOf(*whole)) << "seed " << seed << ", step " << i;
      all += a.voxels, smoothed += aSmooth.voxels, divided += bool(a.others), leaks += bool(a.leak);
    }
  }
  EXPECT_GT(all, 100000u);
  EXPECT_GT(smoothed, 1000u);
  EXPECT_GT(divided, 5u);
  EXPECT_GT(leaks, 1u);
}

TEST(StreamedGrowth, BordersLieWhereTheValuesEnd) {
  Twins twins(vessel(), kVesselBrick);
  Progress progress;
  Shared<LabelVolume> labels =
      Grower().grow(twins.whole, labelsFor(*twins.whole, {}), vesselStep(), {}, progress).labels;
  auto coverOf = [&](const Shared<Volume>& volume) {
    return LabelCover(labels, {{kVessel, 0, volume, 0, 0, 900.0, 2000.0, 400.0}});
  };
  LabelCover streamed = coverOf(twins.streamed), whole = coverOf(twins.whole), byMask(labels);
  std::size_t differs = 0;
  glm::ivec3 grid = labels->brickGrid();
  for (glm::ivec3 at(0); at.z < grid.z; ++at.z)
    for (at.y = 0; at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        LabelCover::Brick brick = streamed.brick(at);
        ASSERT_EQ(brick, whole.brick(at));
        differs += brick != byMask.brick(at);
      }
  EXPECT_GT(differs, 20u);
  Twins damaged(vessel(), kVesselBrick);
  damaged.source->damaged = true;
  EXPECT_EQ(coverOf(damaged.streamed).brick({0, 3, 5}), byMask.brick({0, 3, 5})) << "what cannot be read has none";
}

}  // namespace
}  // namespace velum::growth
