// What draws a sheet: the cost, its minimum, and what it leaves alone.
#include "membrane/forces/Attraction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "LeastCutOracle.h"
#include "makeVolume.h"
#include "membrane/forces/Limit.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

/// Voxels of a grid with their strengths, and a frame over them whose columns are theirs.
struct Field {
  explicit Field(glm::ivec3 dims, double reach) {
    grid.box.end = dims;
    grid.worldFromVoxel = centredFrame(dims);
    grid.mask.assign(std::size_t(dims.x * dims.y * dims.z), 0);
    strengths.assign(grid.mask.size(), 0.0f);
    cut.shape = scene::CutShape::Membrane;
    cut.membrane.emplace();
    cut.axis = {0, 0, 1};
    cut.size = glm::dvec3(dims.x, dims.y, reach);
  }
  std::size_t at(glm::ivec3 p) const { return std::size_t((p.z * grid.box.end.y + p.y) * grid.box.end.x + p.x); }
  void put(glm::ivec3 p, float strength) {
    strengths[at(p)] = strength;
    grid.mask[at(p)] = strength > 0.0f;
  }
  CutLattice lattice() const { return gatherLattice(grid, cut); }
  Attraction attraction() const { return Attraction(lattice(), strengths, grid, cut); }
  ProtectedVoxels grid;
  std::vector<float> strengths;
  scene::Cut cut;
};

LeastCut leastOf(const CutLattice& lattice) {
  Progress progress;
  return computeLeastCut(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress);
}
LeastCut drawn(const Field& field) {
  Progress progress;
  return drawnCut(field.lattice(), leastOf(field.lattice()), field.attraction(), progress);
}

TEST(Attraction, TheSheetIsTheCheapestOfAllThatLeaveTheSameOnTheirSides) {
  int moved = 0;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 random(seed);
    Field field({2, 2, 4}, 4.0);
    for (int i = 0; i < 16; ++i) {
      unsigned kind = random() % 10;
      glm::ivec3 p(i % 2, i / 2 % 2, i / 4);
      field.put(p, kind < 5 ? -float(random() % 200) : kind < 7 && seed % 2 ? 100.0f : 0.0f);
    }
    CutLattice lattice = field.lattice();
    LeastCut least = leastOf(lattice), sheet = drawn(field);
    CutLattice costs = field.attraction().costs();
    double cheapest = 1e30;
    forEachSheet(lattice, [&](const std::vector<int>& below) {
      for (std::size_t c = 0; c < below.size(); ++c)
        if (below[c] <= least.gap[c].x || below[c] > least.gap[c].y) return;
      cheapest = std::min(cheapest, countCutPairs(costs, below));
    });
    EXPECT_DOUBLE_EQ(countCutPairs(costs, sheet.below), cheapest) << "seed " << seed;
    EXPECT_DOUBLE_EQ(sheet.cutPairs, least.cutPairs) << "what draws cuts nothing more, seed " << seed;
    moved += sheet.below != least.below;
  }
  EXPECT_GT(moved, 10);
}

/// A square of voxels that attract, off the middle.
Field patch(int edge, int height, float strength) {
  Field field({24, 24, 24}, 22.0);
  for (int y = 12 - edge / 2; y < 12 + edge / 2; ++y)
    for (int x = 12 - edge / 2; x < 12 + edge / 2; ++x) field.put({x, y, 12 + height}, strength);
  return field;
}

/// Columns of the patch in which the sheet lies at its voxels.
int followed(const Field& field, int height) {
  LeastCut sheet = drawn(field);
  CutLattice lattice = field.lattice();
  int count = 0;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      if (field.strengths[field.at({x, y, 12 + height})] >= 0.0f) continue;
      glm::ivec3 node(glm::round((glm::dvec3(x, y, 12 + height) - glm::dvec3(11.5) - lattice.origin) / lattice.step));
      int below = sheet.below[std::size_t(node.y * lattice.dims.x + node.x)];
      count += below == node.z || below == node.z + 1;
    }
  return count;
}

TEST(Attraction, APatchIsFollowedWhereItsStrengthIsWorthItsWalls) {
  // A wall costs 25 a face: e^2 c against 4 e h 25, and what being off the rest plane costs, 1 a layer.
  for (auto [edge, height] : {std::pair{8, 4}, {8, 2}, {12, 5}}) {
    double wall = 100.0 * height / edge + height;
    Field weak = patch(edge, height, float(-0.8 * wall)), strong = patch(edge, height, float(-1.3 * wall - 4.0));
    EXPECT_EQ(followed(weak, height), 0) << edge << ' ' << height;
    EXPECT_GT(followed(strong, height), edge * edge - 12) << edge << ' ' << height << ", but for its corners";
  }
}

TEST(Attraction, WhatAttractsAlikeIsFollowedInItsMiddle) {
  Field field({24, 24, 24}, 22.0);
  for (int z = 15; z < 20; ++z)
    for (int y = 1; y < 23; ++y)
      for (int x = 1; x < 23; ++x) field.put({x, y, z}, -300.0f);
  LeastCut sheet = drawn(field);
  CutLattice lattice = field.lattice();
  std::size_t middle = std::size_t(lattice.dims.y / 2 * lattice.dims.x + lattice.dims.x / 2);
  auto layer = field.attraction().layerAt(middle, sheet.below[middle]);
  ASSERT_TRUE(layer);
  EXPECT_NEAR(lattice.origin.z + *layer * lattice.step.z, 17.0 - 11.5, 0.5);
}

TEST(Attraction, InBandsTheSheetIsNearlyAsCheap) {
  // A wavy horizon over a lattice that is solved from coarse to fine.
  Field field({60, 60, 40}, 38.0);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) {
      int z = 22 + int(std::lround(4.0 * std::sin(0.15 * x) * std::cos(0.1 * y)));
      field.put({x, y, z}, -100.0f);
    }
  CutLattice lattice = field.lattice(), costs = field.attraction().costs();
  Progress progress;
  std::vector<SheetRange> all(std::size_t(lattice.dims.x * lattice.dims.y), {1, lattice.dims.z - 1});
  LeastCut exact = computeCutWithin(costs, all, progress, 10000000),
           bands = computeCutWithin(costs, all, progress, 3000);
  EXPECT_LE(exact.cutPairs, bands.cutPairs);
  EXPECT_LE(bands.cutPairs, 1.03 * exact.cutPairs);
}

/// A bar through the whole reach, of which one end is weak.
TEST(Attraction, WeakerIsCutRatherThanStronger) {
  for (bool isWeakAbove : {true, false}) {
    Field field({9, 9, 16}, 14.0);
    for (int z = 0; z < 16; ++z) field.put({4, 4, z}, (isWeakAbove ? z >= 10 : z < 6) ? 30.0f : 100.0f);
    field.grid.weight.resize(field.strengths.size());
    for (std::size_t i = 0; i < field.strengths.size(); ++i)
      field.grid.weight[i] = weightOf(double(field.strengths[i]), 100.0);
    CutLattice lattice = field.lattice();
    LeastCut least = leastOf(lattice);
    std::size_t column = std::size_t(lattice.dims.y / 2 * lattice.dims.x + lattice.dims.x / 2);
    bool isAbove = lattice.origin.z + (least.below[column] - 0.5) * lattice.step.z >= 0.0;
    EXPECT_EQ(isAbove, isWeakAbove);
    EXPECT_NEAR(least.cutPairs, 0.3, 0.02) << "a weak pair counts as a part of one";
  }
}

TEST(Attraction, AFieldIsAlikeWhereOneStrengthRepels) {
  scene::ForceField field;
  field.byValue = {{100, 50}, {200, 50}};
  EXPECT_TRUE(isAlike(field));
  EXPECT_FALSE(attracts(field));
  EXPECT_EQ(strongestOf(field), 50.0);
  field.byValue = {{0, -80}, {50, -80}, {50, 0}, {100, 0}, {100, 50}, {200, 50}};
  EXPECT_TRUE(isAlike(field)) << "what attracts is cut by no sheet";
  EXPECT_TRUE(attracts(field));
  field.byValue.push_back({300, 0});
  EXPECT_FALSE(isAlike(field)) << "a ramp";
  field.byValue.clear();
  field.byLabel = {{1, 100}, {2, -100}, {4, 100}};
  EXPECT_TRUE(isAlike(field));
  field.byLabel.push_back({3, 60});
  EXPECT_FALSE(isAlike(field));
}

}  // namespace
}  // namespace velum::membrane
