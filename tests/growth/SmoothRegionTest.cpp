#include "growth/SmoothRegion.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "RandomGrowing.h"
#include "growth/GrowDomain.h"
#include "growth/GrowRule.h"

namespace velum::growth {
namespace {

using Voxel = std::tuple<int, int, int>;

/// Closing and filling as they are defined, voxel by voxel.
class SmoothOracle {
 public:
  SmoothOracle(const Volume& volume, const LabelVolume& labels, const scene::Growth& step)
      : mVolume(volume), mLabels(labels), mStep(step) {}

  std::set<Voxel> smoothed() const {
    std::set<Voxel> region;
    each([&](glm::ivec3 v) {
      if (mLabels.at(v) == mStep.structure) region.insert(key(v));
    });
    if (mStep.closing > 0.0) join(region, closedOf(region));
    if (mStep.fillHoles) join(region, holesOf(region));
    return region;
  }

 private:
  static Voxel key(glm::ivec3 v) { return {v.x, v.y, v.z}; }
  template <class Body>
  void each(const Body& body) const {
    for (int z = 0; z < mVolume.dims.z; ++z)
      for (int y = 0; y < mVolume.dims.y; ++y)
        for (int x = 0; x < mVolume.dims.x; ++x) body(glm::ivec3(x, y, z));
  }
  glm::dvec3 world(glm::dvec3 v) const { return glm::dvec3(mVolume.worldFromVoxel * glm::dvec4(v, 1.0)); }
  bool isIn(glm::ivec3 v) const {
    if (mStep.axis == glm::dvec3(0.0)) return true;
    double depth = glm::dot(world(v) - mStep.centre, mStep.axis / glm::length(mStep.axis));
    return depth > 0.0 && depth <= mStep.distance;
  }
  void join(std::set<Voxel>& region, const std::set<Voxel>& more) const {
    for (auto [x, y, z] : more) {
      glm::ivec3 v(x, y, z);
      bool isBarred = std::any_of(mStep.barriers.begin(), mStep.barriers.end(),
                                  [&](const auto& barrier) { return holds(barrier, world(v)); });
      if (mLabels.at(v) == mStep.within && isIn(v) && !isBarred) region.insert(key(v));
    }
  }
  std::vector<glm::ivec3> ball() const {
    std::vector<glm::ivec3> steps;
    for (int z = -8; z <= 8; ++z)
      for (int y = -8; y <= 8; ++y)
        for (int x = -8; x <= 8; ++x)
          if (glm::length(glm::dmat3(mVolume.worldFromVoxel) * glm::dvec3(x, y, z)) <= mStep.closing)
            steps.push_back({x, y, z});
    return steps;
  }
  std::set<Voxel> closedOf(const std::set<Voxel>& region) const {
    auto steps = ball();
    std::set<Voxel> wide, closed;
    for (auto [x, y, z] : region)
      for (auto step : steps) wide.insert(key(glm::ivec3(x, y, z) + step));
    each([&](glm::ivec3 v) {
      if (std::all_of(steps.begin(), steps.end(), [&](auto step) { return wide.count(key(v + step)); }))
        closed.insert(key(v));
    });
    return closed;
  }
  std::set<Voxel> holesOf(const std::set<Voxel>& region) const {
    std::set<Voxel> open, outside;
    std::vector<glm::ivec3> queue;
    each([&](glm::ivec3 v) {
      if (!region.count(key(v)) && isIn(v)) open.insert(key(v));
    });
    auto reach = [&](glm::ivec3 v) {
      if (open.count(key(v)) && outside.insert(key(v)).second) queue.push_back(v);
    };
    each([&](glm::ivec3 v) {
      if (glm::any(glm::equal(v, glm::ivec3(0))) || glm::any(glm::equal(v, mVolume.dims - 1))) reach(v);
    });
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int axis = 0; axis < 3; ++axis)
        for (int side : {-1, 1}) {
          glm::ivec3 next = queue[i];
          next[axis] += side;
          reach(next);
        }
    for (const Voxel& v : outside) open.erase(v);
    return open;
  }

  const Volume& mVolume;
  const LabelVolume& mLabels;
  const scene::Growth& mStep;
};

std::set<Voxel> voxelsOf(const LabelVolume& labels, int structure) {
  std::set<Voxel> voxels;
  for (int z = 0; z < labels.dims().z; ++z)
    for (int y = 0; y < labels.dims().y; ++y)
      for (int x = 0; x < labels.dims().x; ++x)
        if (labels.at({x, y, z}) == structure) voxels.insert({x, y, z});
  return voxels;
}

scene::Growth stepOf(double closing, bool fillHoles) {
  scene::Growth step;
  step.structure = 1;
  step.closing = closing;
  step.fillHoles = fillHoles;
  return step;
}

TEST(SmoothRegion, IsWhatItsDefinitionSaysVoxelForVoxel) {
  std::size_t joined = 0;
  for (unsigned seed = 0; seed < 80; ++seed) {
    RandomGrowing random(seed);
    // Wider than a word, or as small as can be.
    glm::ivec3 dims(random.whole(1, 75), random.whole(1, 16), random.whole(1, 16));
    Shared<Volume> volume(random.volume(SampleType::UInt8, dims));
    auto noise = unsigned(random.whole(1, 1000));
    double share = random.number(0.05, 0.6);
    glm::ivec3 margin(random.whole(0, dims.x / 3), random.whole(0, dims.y / 3), random.whole(0, dims.z / 3));
    Shared<LabelVolume> labels(makeLabels(
        dims,
        [&](glm::ivec3 v) {
          double at = hashNoise(v / 2, noise);
          bool isAround = glm::any(glm::lessThan(glm::min(v, dims - 1 - v), margin));
          return isAround ? 0 : at < share ? 1 : at > 0.95 ? 2 : 0;
        },
        volume->worldFromVoxel));
    auto world = [&](glm::ivec3 v) { return glm::dvec3(volume->worldFromVoxel * glm::dvec4(v, 1.0)); };
    scene::Growth step = stepOf(random.whole(0, 2) ? random.number(0.3, 2.9) : 0.0, random.whole(0, 2) != 0);
    if (random.whole(0, 1)) {
      step.axis = random.direction();
      step.centre = world(random.voxel(dims)) + glm::dvec3(0.0123, 0.00711, 0.00537);
      step.distance = random.number(0, 15);
    }
    if (random.whole(0, 2) == 0) step.barriers = {{{world(random.voxel(dims)), world(random.voxel(dims))}, 1.3}};
    // What the step asks of values and gradients is for growing.
    if (random.whole(0, 1)) step.low = 100, step.high = 110, step.steepest = random.number(0.1, 5.0);
    Smoothed smoothed = smoothRegion(volume, labels, step, Progress());
    auto before = voxelsOf(*labels, 1), wanted = SmoothOracle(*volume, *labels, step).smoothed();
    ASSERT_EQ(voxelsOf(*smoothed.labels, 1), wanted) << "seed " << seed;
    ASSERT_EQ(smoothed.voxels, wanted.size() - before.size());
    ASSERT_EQ(voxelsOf(*smoothed.labels, 2), voxelsOf(*labels, 2)) << "others keep what they have";
    ASSERT_EQ(smoothed.labels == labels, smoothed.voxels == 0);
    joined += smoothed.voxels;
  }
  EXPECT_GT(joined, 2000u);
}

TEST(SmoothRegion, WhatIsClosedStaysAsItIs) {
  RandomGrowing random(3);
  Shared<Volume> volume(random.volume(SampleType::UInt8, {60, 30, 20}));
  Shared<LabelVolume> labels(makeLabels(
      volume->dims, [](glm::ivec3 v) { return hashNoise(v / 3, 5) < 0.3 ? 1 : 0; }, volume->worldFromVoxel));
  Smoothed once = smoothRegion(volume, labels, stepOf(2.0, false), Progress());
  EXPECT_GT(once.voxels, 100u);
  EXPECT_EQ(smoothRegion(volume, once.labels, stepOf(2.0, false), Progress()).voxels, 0u);
}

TEST(SmoothRegion, MarrowIsAHoleOfItsBoneHoweverFarThatIsPulled) {
  auto isBone = [](glm::ivec3 v) {
    double r = glm::length(glm::dvec2(v) - 15.5);
    return r < 9.0 && r > 5.0;
  };
  Shared<Volume> volume(makeVolume({32, 32, 40}, SampleType::UInt8, [&](glm::ivec3 v) { return isBone(v) ? 9 : 1; }));
  for (double distance : {4.0, 11.0}) {
    scene::Growth step = stepOf(0.0, true);
    step.axis = {0, 0, 1}, step.centre = {0, 0, 9.5}, step.distance = distance;
    Shared<LabelVolume> labels(makeLabels(
        volume->dims, [&](glm::ivec3 v) { return isBone(v) && v.z >= 10 && v.z < 10 + int(distance) ? 1 : 0; }));
    Smoothed smoothed = smoothRegion(volume, labels, step, Progress());
    for (int z = 8; z < 30; ++z)
      EXPECT_EQ(smoothed.labels->at({15, 15, z}), z >= 10 && z < 10 + int(distance) ? 1 : 0) << z;
    EXPECT_EQ(smoothed.labels->at({3, 3, 12}), 0) << "beside it";
  }
}

TEST(SmoothRegion, AWideClosingGoesOnlySoFarAlongTheFinestAxis) {
  // A hollow box, long along the axis with the finest voxels, and wider than any ball along the others: it is filled
  // where no ball fits into it.
  constexpr int kMost = int(kMostClosingVoxels);
  for (int axis = 0; axis < 3; ++axis)
    for (int hollow : {2 * kMost - 3, 2 * kMost + 3}) {
      glm::dvec3 spacing(2.5);
      spacing[axis] = 1.0;
      glm::ivec3 dims(kMost + 1);
      dims[axis] = hollow + 2;
      Shared<Volume> volume(makeVolume(
          dims, SampleType::UInt8, [](glm::ivec3) { return 1; }, centredFrame(dims, spacing)));
      Shared<LabelVolume> labels(makeLabels(
          dims,
          [&](glm::ivec3 v) {
            return glm::any(glm::equal(v, glm::ivec3(0))) || glm::any(glm::equal(v, dims - 1)) ? 1 : 0;
          },
          volume->worldFromVoxel));
      Smoothed smoothed = smoothRegion(volume, labels, stepOf(1e9, false), Progress());
      EXPECT_EQ(smoothed.labels->at(dims / 2), hollow < 2 * kMost ? 1 : 0) << "axis " << axis << ", " << hollow;
    }
}

}  // namespace
}  // namespace velum::growth
