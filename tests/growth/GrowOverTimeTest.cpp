#include "growth/GrowOverTime.h"

#include <gtest/gtest.h>

#include <random>

#include "GrowOracle.h"
#include "RandomGrowing.h"
#include "core/Error.h"
#include "growth/LabelsFor.h"

namespace velum::growth {
namespace {

constexpr int kSteps = 9;

/// @param valueOf  of a voxel at a time step
template <class ValueOf>
Shared<Volume> overTime(glm::ivec3 dims, int steps, const ValueOf& valueOf) {
  Volume volume = makeVolume({dims.x, dims.y, dims.z * steps}, SampleType::UInt8,
                             [&](glm::ivec3 v) { return valueOf(glm::ivec3(v.x, v.y, v.z % dims.z), v.z / dims.z); });
  volume.dims = dims;
  volume.timeSteps = steps;
  return Shared<Volume>(std::move(volume));
}

glm::dvec3 middleAt(int t) { return {10.0 + 4.0 * t, 12.0, 11.0}; }
bool isInBall(glm::ivec3 v, int t) { return glm::distance(glm::dvec3(v), middleAt(t)) < 6.3; }
/// One of the same values that stands still.
bool isInOther(glm::ivec3 v) { return glm::distance(glm::dvec3(v), {30.0, 30.0, 11.0}) < 5.0; }

Shared<Volume> movingBall() {
  return overTime({56, 40, 24}, kSteps, [](glm::ivec3 v, int t) { return isInBall(v, t) || isInOther(v) ? 90 : 20; });
}

scene::Growth stepOf(int structure, glm::dvec3 seed, int timeStep) {
  scene::Growth step;
  step.structure = structure;
  step.seeds = {seed};
  step.low = 80, step.high = 100;
  step.timeStep = timeStep;
  return step;
}

template <class IsIn>
std::size_t differences(const LabelVolume& labels, int structure, const IsIn& isIn) {
  std::size_t wrong = 0;
  for (int z = 0; z < labels.dims().z; ++z)
    for (int y = 0; y < labels.dims().y; ++y)
      for (int x = 0; x < labels.dims().x; ++x)
        wrong += (labels.at({x, y, z}) == structure) != isIn(glm::ivec3(x, y, z));
  return wrong;
}

bool areEqual(const LabelVolume& a, const LabelVolume& b) {
  for (int z = 0; z < a.dims().z; ++z)
    for (int y = 0; y < a.dims().y; ++y)
      for (int x = 0; x < a.dims().x; ++x)
        if (a.at({x, y, z}) != b.at({x, y, z})) return false;
  return a.dims() == b.dims();
}

TEST(GrowOverTime, FollowsWhatMovesAwayFromItsSeedsFromAndToAnyStep) {
  auto volume = movingBall();
  Progress progress;
  for (int home = 0; home < kSteps; home += 4) {
    std::vector steps{stepOf(7, middleAt(home), home)};
    for (int t = 0; t < kSteps; ++t) {
      auto labels = growLabels(volume, {}, steps, t, progress);
      EXPECT_EQ(differences(*labels, 7, [&](glm::ivec3 v) { return isInBall(v, t); }), 0u) << home << " to " << t;
    }
  }
}

TEST(GrowOverTime, WhatIsShownInBetweenChangesNothing) {
  // Blobs that drift; two structures that compete, and steps of several times.
  auto volume = overTime({48, 30, 20}, 6, [](glm::ivec3 v, int t) {
    glm::dvec3 p = glm::dvec3(v) * 0.31 + 0.4 * t;
    return 60.0 + 20.0 * (std::sin(p.x) + std::sin(p.y + 0.4 * t) * std::sin(p.z)) + 8.0 * hashNoise(v, unsigned(t));
  });
  std::mt19937 random(5);
  std::vector<scene::Growth> steps;
  for (int i = 0; i < 5; ++i) {
    scene::Growth step = stepOf(1 + i % 3, glm::dvec3(random() % 48, random() % 30, random() % 20), int(random() % 6));
    step.low = 45, step.high = 75;
    step.axis = {0, 0, 1}, step.centre = {0, 0, 3.5}, step.distance = 3.0 + 4.0 * i;
    steps.push_back(step);
  }
  Progress progress;
  GrowOverTime known;
  std::size_t filled = 0;
  for (int i = 0; i < 40; ++i) {
    if (i % 10 == 9) steps[random() % steps.size()].distance += 1.0;
    auto count = std::size_t(random() % 5) + 1;
    int t = int(random() % 6);
    auto labels = known.labelsAt(t, count, volume, {}, steps, progress);
    ASSERT_TRUE(areEqual(*labels, *growLabels(volume, {}, std::span(steps).first(count), t, progress))) << i;
    filled += labels->idsInUse().size();
  }
  EXPECT_GT(filled, 40u);
}

TEST(GrowOverTime, SeedsThatHoldAreSeedsThereElseWhatOverlaps) {
  auto volume = movingBall();
  Progress progress;
  // One still in the ball at the next step, one that it has left.
  for (double aside : {4.0, -4.0}) {
    scene::Growth step = stepOf(7, middleAt(0) + glm::dvec3(aside, 0, 0), 0);
    auto before = growLabels(volume, {}, std::vector{step}, 0, progress);
    auto after = growLabels(volume, {}, std::vector{step}, 1, progress);
    auto ground = labelsFor(*volume, {});
    GrowRule rule = ruleOf(step);
    rule.timeStep = 1;
    GrowOracle oracle(*volume, *ground, 7, rule);
    std::vector<glm::ivec3> seeds;
    if (aside > 0)
      seeds = {voxelAt(*volume, step.seeds[0])};
    else
      oracle.each([&](glm::ivec3 v) {
        if (before->at(v) == 7 && isInBall(v, 1)) seeds.push_back(v);
      });
    oracle.step(seeds, step.centre, step.axis, step.distance);
    EXPECT_GT(oracle.count(), 500u);
    EXPECT_EQ(differences(*after, 7, [&](glm::ivec3 v) { return oracle.has(v); }), 0u);
  }
}

TEST(GrowOverTime, WhatIsGoneForAStepComesBackWhereItsSeedsAre) {
  auto volume = overTime({30, 20, 20}, 4, [](glm::ivec3 v, int t) {
    return t != 1 && glm::distance(glm::dvec3(v), {12, 10, 10}) < 5 ? 90 : 20;
  });
  Progress progress;
  std::vector steps{stepOf(3, {12, 10, 10}, 0)};
  auto isIn = [&](glm::ivec3 v) { return glm::distance(glm::dvec3(v), {12, 10, 10}) < 5; };
  EXPECT_TRUE(growLabels(volume, {}, steps, 1, progress)->idsInUse().empty());
  EXPECT_EQ(differences(*growLabels(volume, {}, steps, 3, progress), 3, isIn), 0u);
}

TEST(GrowOverTime, StepsOfTimesThatAreNotThereAreRefused) {
  auto volume = movingBall();
  Progress progress;
  EXPECT_THROW(growLabels(volume, {}, std::vector{stepOf(1, {1, 1, 1}, kSteps)}, 0, progress), ArgumentError);
  EXPECT_THROW(growLabels(volume, {}, std::vector{stepOf(1, {1, 1, 1}, -1)}, 0, progress), ArgumentError);
}

}  // namespace
}  // namespace velum::growth
