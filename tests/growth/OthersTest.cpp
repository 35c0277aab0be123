// A step that is told what it is not: where its border lies, and what leaves it as it is.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "RandomGrowing.h"
#include "core/Error.h"
#include "growth/GrowOverTime.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "growth/SmoothRegion.h"

namespace velum::growth {
namespace {

constexpr int kId = 7;

using IsIn = std::function<bool(glm::dvec3)>;

double noiseAt(glm::ivec3 v) { return 6.0 * (hashNoise(v, 3) + hashNoise(v, 4) - 1.0); }

/// 100 where something is, with noise; voxels of 1.
Shared<Volume> volumeOf(glm::ivec3 dims, const IsIn& isIn) {
  return Shared<Volume>(makeVolume(dims, SampleType::Int16,
                                   [&](glm::ivec3 v) { return (isIn(glm::dvec3(v)) ? 100.0 : 0.0) + noiseAt(v); }));
}

scene::Growth stepOf(glm::dvec3 seed, std::vector<glm::dvec3> others) {
  scene::Growth step;
  step.structure = kId;
  step.seeds = {seed};
  step.others = std::move(others);
  step.low = 60, step.high = 140;
  return step;
}

Shared<LabelVolume> grow(const Shared<Volume>& volume, const scene::Growth& step) {
  Progress progress;
  return Grower().grow(volume, labelsFor(*volume, {}), step, {}, progress).labels;
}

template <class Body>
void forVoxels(glm::ivec3 dims, const Body& body) {
  for (glm::ivec3 v(0); v.z < dims.z; ++v.z)
    for (v.y = 0; v.y < dims.y; ++v.y)
      for (v.x = 0; v.x < dims.x; ++v.x) body(v);
}

/// Voxels in which labels differ from a form.
std::size_t differences(const LabelVolume& labels, const IsIn& isIn) {
  std::size_t count = 0;
  forVoxels(labels.dims(), [&](glm::ivec3 v) { count += (labels.at(v) == kId) != isIn(glm::dvec3(v)); });
  return count;
}

bool areEqual(const LabelVolume& a, const LabelVolume& b) {
  return differences(a, [&](glm::dvec3 v) { return b.at(glm::ivec3(v)) == kId; }) == 0;
}

std::size_t countOf(const LabelVolume& labels) {
  return differences(labels, [](glm::dvec3) { return false; });
}

/// Two balls of one value whose middles lie 22 apart: they overlap in a neck of radius 4.8 at x = 31.
constexpr glm::dvec3 kBall{20, 24, 24}, kOtherBall{42, 24, 24};
constexpr double kBallRadius = 12.0, kNeck = 31.0;
bool isInBalls(glm::dvec3 p) {
  return glm::distance(p, kBall) < kBallRadius || glm::distance(p, kOtherBall) < kBallRadius;
}

TEST(Others, PartTwoBallsThatTouchAtTheirNeck) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  struct Click {
    glm::dvec3 place;
    bool isByNeck;
  };
  const Click inOne[] = {{kBall, false}, {{12, 20, 24}, false}, {{20, 33, 24}, false}, {{27, 22, 26}, true}};
  const Click inOther[] = {{kOtherBall, false}, {{51, 24, 28}, false}, {{42, 16, 20}, false}, {{35, 26, 22}, true}};
  std::size_t ball = countOf(*grow(volume, stepOf(kBall, {}))) / 2;
  for (const Click& seed : inOne)
    for (const Click& other : inOther) {
      auto labels = grow(volume, stepOf(seed.place, {other.place}));
      std::size_t wrong = differences(*labels, [](glm::dvec3 p) { return p.x <= kNeck && isInBalls(p); });
      // Who presses beside the neck on one side, and far from it on the other, moves the border by some voxels.
      double most = seed.isByNeck || other.isByNeck ? 0.25 : 0.08;
      EXPECT_LT(double(wrong), most * double(ball)) << seed.place.x << " " << other.place.x;
    }
  auto halves = grow(volume, stepOf(kBall, {kOtherBall}));
  EXPECT_LT(double(differences(*halves, [](glm::dvec3 p) { return p.x <= kNeck && isInBalls(p); })),
            0.02 * double(ball));
}

TEST(Others, PartATubeFromTheBlockThatItEndsIn) {
  constexpr double kMouth = 40.0, kRadius = 4.0;
  auto isTube = [](glm::dvec3 p) { return p.x < kMouth && p.x > 2 && std::hypot(p.y - 24, p.z - 24) < kRadius; };
  auto volume = volumeOf({76, 48, 48}, [&](glm::dvec3 p) {
    return isTube(p) || (p.x >= kMouth && p.x < 72 && p.y > 4 && p.y < 44 && p.z > 4 && p.z < 44);
  });
  for (double seed : {4.0, 20.0, 36.0})
    for (glm::dvec3 other : {glm::dvec3(56, 24, 24), glm::dvec3(44, 38, 12), glm::dvec3(69, 7, 40)}) {
      auto tube = grow(volume, stepOf({seed, 24, 24}, {other}));
      // What is wrong lies within half a width of the mouth.
      std::size_t far = 0;
      forVoxels(tube->dims(), [&](glm::ivec3 v) {
        bool isNearMouth = glm::distance(glm::dvec3(v), {kMouth, 24, 24}) < 2.0 * kRadius;
        far += !isNearMouth && (tube->at(v) == kId) != isTube(glm::dvec3(v));
      });
      EXPECT_EQ(far, 0u) << "seed " << seed << ", other " << other.x << " " << other.y;
      // And the other way round.
      auto block = grow(volume, stepOf(other, {{seed, 24, 24}}));
      std::size_t inTube = 0;
      forVoxels(block->dims(), [&](glm::ivec3 v) { inTube += v.x < kMouth - 2.0 * kRadius && block->at(v) == kId; });
      EXPECT_EQ(inTube, 0u);
    }
}

TEST(Others, PartWhatTouchesAllAlongWhereTheValuesChange) {
  // A slab of two values in one range, whose border is a wave.
  auto isDarker = [](glm::dvec3 p) { return p.x < 22.0 + 4.0 * std::sin(p.y / 6.0); };
  auto volume = Shared<Volume>(makeVolume({44, 40, 24}, SampleType::Int16, [&](glm::ivec3 v) {
    return (isDarker(glm::dvec3(v)) ? 85.0 : 115.0) + noiseAt(v);
  }));
  auto labels = grow(volume, stepOf({3, 6, 12}, {{41, 35, 4}}));
  EXPECT_LT(differences(*labels, isDarker), 40u * 24u) << "a voxel of the border";
}

TEST(Others, PartWhatIsAlikeEverywhereInTheMiddle) {
  auto volume = Shared<Volume>(makeVolume({61, 5, 5}, SampleType::UInt8, [](glm::ivec3) { return 100; }));
  auto labels = grow(volume, stepOf({10, 2, 2}, {{50, 2, 2}}));
  EXPECT_EQ(differences(*labels, [](glm::dvec3 p) { return p.x <= 30; }), 0u) << "what is as near to both is its own";
}

TEST(Others, ThatLieInNothingOfItChangeNothing) {
  auto volume = volumeOf({63, 48, 48}, [](glm::dvec3 p) { return isInBalls(p) || p.x > 58; });
  auto free = grow(volume, stepOf(kBall, {}));
  EXPECT_GT(countOf(*free), 5000u);
  for (glm::dvec3 other : {glm::dvec3(2, 2, 2), glm::dvec3(60, 10, 10), glm::dvec3(-50, 0, 0), glm::dvec3(1e15)})
    EXPECT_TRUE(areEqual(*grow(volume, stepOf(kBall, {other})), *free)) << other.x;
  // But a place of nothing beside one that says something.
  EXPECT_TRUE(
      areEqual(*grow(volume, stepOf(kBall, {{2, 2, 2}, kOtherBall})), *grow(volume, stepOf(kBall, {kOtherBall}))));
}

TEST(Others, OnItsOwnSeedGiveUpNothing) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  EXPECT_GT(countOf(*grow(volume, stepOf(kBall, {kBall}))), 0u);
}

/// However a hand has cut the way into pieces, and whatever else the grower has kept.
TEST(Others, GiveTheSameHoweverADragWasCut) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  auto before = labelsFor(*volume, {});
  Progress progress;
  Grower grower;
  scene::Growth step = stepOf(kBall, {kOtherBall});
  step.centre = {0, 12, 0}, step.axis = {0, 1, 0};
  for (double distance : {3.0, 11.5, 12.0, 19.0, 26.0, 9.0, 40.0}) {
    step.distance = distance;
    scene::Growth free = step;
    free.others.clear();
    grower.grow(volume, before, free, {}, progress);
    auto one = grower.grow(volume, before, step, {}, progress).labels;
    EXPECT_TRUE(areEqual(*one, *grow(volume, step))) << distance;
    bool reachesOthers = distance >= 12.0;
    EXPECT_EQ(areEqual(*one, *grow(volume, free)), !reachesOthers) << distance;
  }
}

TEST(Others, LeaveWhatTheStructureHadAndBeginThere) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  LabelVolume had = *labelsFor(*volume, {});
  had.write({44, 22, 22}, {4, 4, 4}, std::vector<std::uint16_t>(64, kId));
  Progress progress;
  Shared<LabelVolume> before(std::move(had));
  auto labels = Grower().grow(volume, before, stepOf(kBall, {{44, 16, 24}}), {}, progress).labels;
  EXPECT_EQ(labels->at({45, 23, 23}), kId);
  EXPECT_NE(labels->at({44, 16, 24}), kId);
}

TEST(Others, KeepToBarriersAndToWhatItGrowsWithin) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  scene::Growth step = stepOf(kBall, {kOtherBall});
  step.barriers = {{{{14, 0, 24}, {14, 48, 24}}, 2.0}};
  auto labels = grow(volume, step);
  EXPECT_EQ(labels->at({14, 24, 24}), 0);
  EXPECT_EQ(labels->at({24, 24, 24}), kId);
  Shared<LabelVolume> given(makeLabels(
      volume->dims, [](glm::ivec3 v) { return v.z < 24 ? 3 : 0; }, volume->worldFromVoxel));
  step.within = 3;
  step.seeds = {kBall - glm::dvec3(0, 0, 4)};
  step.others = {kOtherBall - glm::dvec3(0, 0, 4)};
  Progress progress;
  auto part = Grower().grow(volume, given, step, {}, progress).labels;
  EXPECT_GT(countOf(*part), 1000u);
  forVoxels(part->dims(), [&](glm::ivec3 v) {
    if (v.z >= 24) {
      ASSERT_EQ(part->at(v), 0);
    }
  });
}

TEST(Others, AreNotTakenByWhatSmoothsItsEnd) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  scene::Growth step = stepOf(kBall, {kOtherBall});
  step.closing = 8.0, step.fillHoles = true;
  Progress progress;
  Grown grown = Grower().grow(volume, labelsFor(*volume, {}), step, {}, progress);
  ASSERT_TRUE(grown.others);
  auto smooth = smoothRegion(volume, grown.labels, step, progress, grown.others).labels;
  std::size_t theirs = 0;
  forVoxels(smooth->dims(), [&](glm::ivec3 v) {
    if (grown.others->at(v) == 0) return;
    ++theirs;
    ASSERT_EQ(smooth->at(v), 0);
  });
  EXPECT_GT(theirs, 5000u);
}

TEST(Others, LeaveLabelsAsTheyAreWhereTheStepIsCancelled) {
  auto volume = volumeOf({63, 48, 48}, isInBalls);
  auto before = labelsFor(*volume, {});
  scene::Growth step = stepOf(kBall, {kOtherBall});
  int reports = 0;
  Progress counting([&](double, const std::string&) { ++reports; });
  Grower grower;
  auto right = grower.grow(volume, before, step, {}, counting).labels;
  ASSERT_GE(reports, 2);
  for (int stopAt = 1; stopAt <= reports; ++stopAt) {
    int count = 0;
    Progress* self = nullptr;
    Progress progress([&](double, const std::string&) {
      if (++count == stopAt) self->cancel();
    });
    self = &progress;
    EXPECT_THROW(grower.grow(volume, before, step, {}, progress), Cancelled) << stopAt;
    Progress calm;
    EXPECT_TRUE(areEqual(*grower.grow(volume, before, step, {}, calm).labels, *right));
  }
}

/// Two balls that touch wander together: neither seed holds.
TEST(Others, AreCarriedToOtherTimeSteps) {
  constexpr int kTimes = 5;
  constexpr glm::ivec3 kDims(63, 70, 32);
  auto inBall = [](glm::dvec3 p, double x, int t) {
    return glm::distance(p, glm::dvec3(x, 16.0 + 8.0 * t, 16.0)) < kBallRadius;
  };
  Volume all = makeVolume({kDims.x, kDims.y, kDims.z * kTimes}, SampleType::UInt8, [&](glm::ivec3 v) {
    glm::dvec3 p(v.x, v.y, v.z % kDims.z);
    int t = v.z / kDims.z;
    return inBall(p, kBall.x, t) || inBall(p, kOtherBall.x, t) ? 100 + noiseAt(v) : 10;
  });
  all.dims = kDims;
  all.timeSteps = kTimes;
  Shared<Volume> volume(std::move(all));
  scene::Growth step = stepOf({20, 16, 16}, {{42, 16, 16}});
  Progress progress;
  for (int t = 0; t < kTimes; ++t) {
    auto labels = growLabels(volume, {}, std::vector{step}, t, progress);
    auto isOwn = [&](glm::dvec3 p) { return inBall(p, kBall.x, t) && p.x <= kNeck; };
    EXPECT_LT(differences(*labels, isOwn), 300u) << "of 6900, at " << t;
    GrowOverTime known;
    for (int seen : {kTimes - 1, 1}) known.labelsAt(seen, 1, volume, {}, std::vector{step}, progress);
    EXPECT_TRUE(areEqual(*known.labelsAt(t, 1, volume, {}, std::vector{step}, progress), *labels));
  }
}

}  // namespace
}  // namespace velum::growth
