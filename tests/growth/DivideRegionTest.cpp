// Whose a voxel is between two kinds of seeds, against plain definitions.
#include "growth/DivideRegion.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <queue>

#include "RandomGrowing.h"
#include "core/Error.h"
#include "growth/LabelsFor.h"
#include "growth/Thickness.h"

namespace velum::growth {
namespace {

constexpr std::uint64_t kFar = std::numeric_limits<std::uint64_t>::max();

/// Of the cheapest ways from some places, with the queue of the textbook.
std::vector<std::uint64_t> plainCosts(const PassageCosts& costs, const std::vector<std::size_t>& seeds) {
  using Waiting = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue;
  std::vector<std::uint64_t> least(costs.box().count(), kFar);
  for (std::size_t seed : seeds)
    if (costs.holds(seed)) queue.push({least[seed] = 0, seed});
  auto steps = costs.box().steps();
  while (!queue.empty()) {
    auto [cost, place] = queue.top();
    queue.pop();
    if (cost != least[place]) continue;
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t to :
           {place - std::size_t(steps[std::size_t(axis)]), place + std::size_t(steps[std::size_t(axis)])}) {
        if (!costs.holds(to)) continue;
        std::uint64_t next = cost + std::uint64_t(costs.cost(place, to, axis));
        if (next < least[to]) queue.push({least[to] = next, to});
      }
  }
  return least;
}

TEST(DivideRegion, GivesEachVoxelToTheKindWhoseWayIsCheaper) {
  Progress progress;
  std::size_t own = 0, others = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomGrowing draw(seed);
    Shared<Volume> volume(draw.volume(seed % 2 ? SampleType::Int16 : SampleType::Float32, draw.dims()));
    Shared<LabelVolume> labels = labelsFor(*volume, {});
    GrowDomain domain(*volume, glm::dvec3(volume->worldFromVoxel * glm::dvec4(draw.voxel(volume->dims), 1.0)),
                      seed % 3 ? draw.direction() : glm::dvec3(0.0), draw.number(5.0, 60.0));
    RegionGrow region(volume, labels, 0, {.low = 40.0, .high = 80.0, .barriers = {}});
    for (int i = 0; i < 5; ++i) region.addSeed(draw.voxel(volume->dims));
    region.grow(domain, progress);
    PassageCosts costs(region, FinestVoxels(*volume), domain, progress);
    std::vector<std::size_t> in;
    for (std::size_t place = 0; place < costs.box().count(); ++place)
      if (costs.holds(place)) in.push_back(place);
    EXPECT_EQ(in.size(), region.voxelCount());
    if (in.empty()) continue;
    std::vector<std::size_t> seeds[2];
    for (int i = 0; i < 8; ++i) seeds[i % 2].push_back(in[std::size_t(draw.whole(0, int(in.size()) - 1))]);
    auto owners = divideRegion(costs, seeds[0], seeds[1], progress);
    auto toOwn = plainCosts(costs, seeds[0]), toOthers = plainCosts(costs, seeds[1]);
    for (std::size_t place : in) {
      Owner right = toOwn[place] == kFar && toOthers[place] == kFar ? Owner::Nobody
                    : toOwn[place] <= toOthers[place]               ? Owner::Own
                                                                    : Owner::Others;
      ASSERT_EQ(int(owners[place]), int(right)) << "draw " << seed;
      own += right == Owner::Own, others += right == Owner::Others;
    }
  }
  EXPECT_GT(own, 5000u);
  EXPECT_GT(others, 5000u);
}

TEST(DivideRegion, WaysCostTheSameFromEitherSideAndNeverNothing) {
  Progress progress;
  RandomGrowing draw(4);
  Shared<Volume> volume(draw.volume(SampleType::Int16, {40, 30, 20}));
  RegionGrow region(volume, labelsFor(*volume, {}), 0, {.low = 40.0, .high = 80.0, .barriers = {}});
  for (int i = 0; i < 30; ++i) region.addSeed(draw.voxel(volume->dims));
  region.grow(GrowDomain(), progress);
  PassageCosts costs(region, FinestVoxels(*volume), GrowDomain(), progress);
  int steps = 0;
  for (std::size_t place = 0; place < costs.box().count(); ++place)
    for (int axis = 0; axis < 3 && costs.holds(place); ++axis) {
      std::size_t to = place + std::size_t(costs.box().steps()[std::size_t(axis)]);
      if (!costs.holds(to)) continue;
      ++steps;
      int cost = costs.cost(place, to, axis);
      ASSERT_EQ(cost, costs.cost(to, place, axis));
      ASSERT_GE(cost, 1);
      ASSERT_LE(cost, costs.mostCost());
    }
  EXPECT_GT(steps, 10000);
}

/// Between voxels of 1, in sixteenths: a step along an axis, over an edge and over a corner, each rounded.
int chamferLength(glm::ivec3 to) {
  glm::ivec3 a = glm::abs(to);
  int longest = std::max({a.x, a.y, a.z}), shortest = std::min({a.x, a.y, a.z});
  int middle = a.x + a.y + a.z - longest - shortest;
  return 28 * shortest + 23 * (middle - shortest) + 16 * (longest - middle);
}

TEST(Thickness, LengthsAreThoseOfTheShortestWays) {
  RandomGrowing draw(11);
  RoomyBox box({3, 4, 5}, {14, 11, 9});
  std::vector<glm::ivec3> from;
  Lengths lengths(box.count(), kFarAway);
  for (int i = 0; i < 5; ++i) {
    from.push_back(box.first() + draw.voxel({14, 11, 9}));
    lengths[box.at(from.back())] = 0;
  }
  spreadLengths(box, glm::dmat3(1.0), lengths);
  for (glm::ivec3 v = box.first(); v.z < box.end().z; ++v.z)
    for (v.y = box.first().y; v.y < box.end().y; ++v.y)
      for (v.x = box.first().x; v.x < box.end().x; ++v.x) {
        int least = kFarAway;
        for (glm::ivec3 seed : from) least = std::min(least, chamferLength(v - seed));
        ASSERT_EQ(int(lengths[box.at(v)]), least) << v.x << " " << v.y << " " << v.z;
      }
}

TEST(Thickness, IsTheRadiusOfTheLargestBallThatHoldsAVoxel) {
  RandomGrowing draw(12);
  int thickest = 0;
  for (int round = 0; round < 4; ++round) {
    glm::ivec3 size(16, 13, 11);
    RoomyBox box(glm::ivec3(0), size);
    Lengths depths(box.count(), kFarAway);
    for (int i = 0; i < 3 + 4 * round; ++i) depths[box.at(draw.voxel(size))] = 0;
    spreadLengths(box, glm::dmat3(1.0), depths);
    for (std::size_t place = 0; place < box.count(); ++place)
      if (depths[place] == kFarAway) depths[place] = 0;  // the room
    Progress progress;
    auto levels = thicknessLevels(box, glm::dmat3(1.0), depths, progress);
    auto forBox = [&](const auto& body) {
      for (glm::ivec3 v(0); v.z < size.z; ++v.z)
        for (v.y = 0; v.y < size.y; ++v.y)
          for (v.x = 0; v.x < size.x; ++v.x) body(v);
    };
    forBox([&](glm::ivec3 v) {
      int right = 0;
      forBox([&](glm::ivec3 centre) {
        for (int level = right + 1; level < 12; ++level) {
          long radius = std::lround(kLengthUnit * std::pow(kThicker, level));
          if (depths[box.at(centre)] < radius) break;
          if (chamferLength(v - centre) < radius) right = level;
        }
      });
      ASSERT_EQ(int(levels[box.at(v)]), right);
      thickest = std::max(thickest, right);
    });
  }
  EXPECT_GE(thickest, 5);
}

}  // namespace
}  // namespace velum::growth
