#include "membrane/forces/LeastCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "LeastCutOracle.h"
#include "makeVolume.h"
#include "membrane/forces/Bands.h"
#include "membrane/forces/Corridor.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

/// A lattice whose pairs are random whole numbers, a share of them 0.
CutLattice randomPairs(glm::ivec3 dims, double restLayer, unsigned seed, double share) {
  return makeLattice(dims, restLayer, [&](const auto& add) {
    std::mt19937 random(seed);
    for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        unsigned chance = random() % 1000, count = random() % 5;
        glm::ivec3 node(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
        if (chance < 1000.0 * share) add(node, axis, count);
      }
  });
}

LeastCut exact(const CutLattice& lattice, scene::MembraneSide side = scene::MembraneSide::Keep) {
  Progress progress;
  return computeLeastCut(lattice, side, CutMetric::Pairs, progress);
}

/// Calls visit(column, node) for all that hold something.
template <class Visit>
void forEachNode(const CutLattice& lattice, Visit visit) {
  for (std::size_t c = 0; c + 1 < lattice.first.size(); ++c)
    for (std::uint32_t v = lattice.first[c]; v < lattice.first[c + 1]; ++v) visit(c, v);
}

/// How far what lies on the wrong side of the sheet is from the rest plane, in all.
double strayOf(const CutLattice& lattice, const std::vector<int>& below) {
  double sum = 0.0;
  int flat = flatCount(lattice);
  forEachNode(lattice, [&](std::size_t c, std::uint32_t v) {
    int z = lattice.layer[v];
    if ((z < below[c]) != (z < flat)) sum += std::abs(z + 0.5 - flat);
  });
  return sum;
}

TEST(LeastCut, EqualsTheBestOfAllSheetsOnTinyLattices) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CutLattice lattice = randomPairs({4, 4, 6}, seed % 2 ? 2.5 : 2.0, seed, seed % 3 ? 0.5 : 0.2);
    double least = 1e30, stray = 1e30;
    forEachSheet(lattice, [&](const std::vector<int>& below) {
      double pairs = countCutPairs(lattice, below), away = strayOf(lattice, below);
      if (pairs > least || (pairs == least && away >= stray)) return;
      least = pairs;
      stray = away;
    });
    LeastCut nearest = exact(lattice, scene::MembraneSide::Nearest);
    EXPECT_DOUBLE_EQ(nearest.cutPairs, least) << "seed " << seed;
    EXPECT_DOUBLE_EQ(strayOf(lattice, nearest.below), stray) << "of those the nearest, seed " << seed;
    for (auto side : {scene::MembraneSide::Keep, scene::MembraneSide::Remove})
      EXPECT_DOUBLE_EQ(exact(lattice, side).cutPairs, least) << "seed " << seed;
  }
}

TEST(LeastCut, EqualsBoykovAndKolmogorov) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    glm::ivec3 dims(9 + int(seed), 21 - int(seed), 8 + int(seed % 5));
    CutLattice lattice = seed % 2 ? latticeFromMask(dims, dims.z / 2 - 0.5, tubes(dims, 4, 1.6, seed))
                                  : randomPairs(dims, 3.25, seed, 0.3);
    EXPECT_DOUBLE_EQ(exact(lattice).cutPairs, minimumCut(lattice)) << "seed " << seed;
  }
}

TEST(LeastCut, EqualsBoykovAndKolmogorovWhereMuchIsProtected) {
  glm::ivec3 dims(40, 36, 18);
  CutLattice lattice = latticeFromMask(dims, 8.5, tubes(dims, 25, 2.0, 7));
  EXPECT_DOUBLE_EQ(exact(lattice).cutPairs, minimumCut(lattice));
  EXPECT_GT(minimumCut(lattice), 20.0);
}

TEST(LeastCut, EqualsBoykovAndKolmogorovWhereItIsFilledInStrips) {
  glm::ivec3 dims(90, 100, 16);
  for (double share : {0.55, 0.9}) {
    CutLattice lattice = randomPairs(dims, 7.5, 3, share);
    ASSERT_GT(lattice.layer.size(), 120000u) << "strips begin at half of it";
    EXPECT_DOUBLE_EQ(exact(lattice).cutPairs, minimumCut(lattice)) << share;
  }
}

TEST(LeastCut, ColumnsOfMoreThanSixtyFourLayersAreNumberedRight) {
  glm::ivec3 dims(12, 10, 150);
  std::vector<std::uint8_t> mask = tubes(dims, 14, 1.8, 3);
  CutLattice lattice = latticeFromMask(dims, 74.5, mask);
  auto isProtected = [&](glm::ivec3 p) { return p.z < dims.z && mask[std::size_t((p.z * 10 + p.y) * 12 + p.x)] != 0; };
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        ASSERT_EQ(pairsAt(lattice, {x, y, z}, 2), isProtected({x, y, z}) && isProtected({x, y, z + 1}));
  EXPECT_DOUBLE_EQ(exact(lattice).cutPairs, minimumCut(lattice));
}

TEST(LeastCut, AnywhereInItsGapsTheSheetSeparatesTheSame) {
  glm::ivec3 dims(24, 20, 14);
  CutLattice lattice = latticeFromMask(dims, 6.5, tubes(dims, 9, 1.8, 3));
  LeastCut least = exact(lattice);
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<int> below = least.below;
    for (int y = 1; y + 1 < dims.y; ++y)
      for (int x = 1; x + 1 < dims.x; ++x) {
        auto c = std::size_t(y * dims.x + x);
        int low = std::max(least.gap[c].x + 1, 1), high = std::min(least.gap[c].y, dims.z - 1);
        ASSERT_LE(low, high);
        below[c] = low + int(random() % unsigned(high - low + 1));
      }
    EXPECT_EQ(countCutPairs(lattice, below), least.cutPairs);
  }
}

TEST(LeastCut, ASheetOfACoarsenedLatticeSeparatesTheSameInTheFineOne) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    glm::ivec3 dims(15 + int(seed % 2), 14 + int(seed / 2 % 2), 12 + int(seed / 4 % 2));
    CutLattice fine = randomPairs(dims, 5.5 + int(seed % 3), seed, 0.3), coarse = coarsened(fine);
    std::mt19937 random(seed);
    std::vector<int> below(std::size_t(coarse.dims.x * coarse.dims.y));
    EXPECT_EQ(refined(fine, sheetAt(coarse, std::vector<int>(below.size(), flatCount(coarse)))),
              std::vector<int>(std::size_t(dims.x * dims.y), flatCount(fine)));
    for (int& b : below) b = 1 + int(random() % unsigned(coarse.dims.z - 1));
    std::vector<int> spread = refined(fine, sheetAt(coarse, below));
    EXPECT_DOUBLE_EQ(countCutPairs(fine, spread), countCutPairs(coarse, below)) << "seed " << seed;
  }
}

TEST(LeastCut, WithinABandThatHoldsAllSheetsALatticeStaysWhole) {
  CutLattice lattice = randomPairs({9, 8, 7}, 2.5, 3, 0.4);
  std::vector<SheetRange> all(72, {0, 7});
  CutLattice part = within(lattice, all);
  EXPECT_EQ(part.first, lattice.first);
  EXPECT_EQ(part.layer, lattice.layer);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(part.pairs[axis], lattice.pairs[axis]);
}

TEST(LeastCut, InBandsItIsNoWorseThanCoarseAndHardlyWorseThanTheLeast) {
  Progress progress;
  constexpr std::size_t kFew = 5000;
  double found = 0.0, least = 0.0, flat = 0.0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    glm::ivec3 dims(70, 64, 48);
    CutLattice lattice = latticeFromMask(dims, 23.5, tubes(dims, 24, 3.2, seed));
    LeastCut cut = computeCutInBands(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress, kFew);
    LeastCut coarse =
        computeCutInBands(coarsened(lattice), scene::MembraneSide::Keep, CutMetric::Pairs, progress, kFew);
    EXPECT_DOUBLE_EQ(cut.cutPairs, countCutPairs(lattice, cut.below));
    EXPECT_LE(cut.cutPairs, coarse.cutPairs);
    EXPECT_GE(cut.cutPairs, exact(lattice).cutPairs);
    for (int c : {0, 37, 70 * 64 - 1}) EXPECT_EQ(cut.below[std::size_t(c)], flatCount(lattice)) << "on the frame";
    found += cut.cutPairs;
    least += exact(lattice).cutPairs;
    flat += countCutPairs(lattice, std::vector<int>(cut.below.size(), flatCount(lattice)));
  }
  EXPECT_GT(least, 100.0);
  EXPECT_LT(least, 0.5 * flat);
  EXPECT_LT(found, 1.25 * least);
}

TEST(LeastCut, InBandsItPassesWhatEndsOneLayerBeforeTheDataDoes) {
  Progress progress;
  glm::ivec3 dims(70, 66, 90);
  for (bool isLow : {true, false}) {
    // A post, cut near its end: the sheet is to go round that end, on every coarser lattice too.
    std::vector<std::uint8_t> mask(std::size_t(dims.x * dims.y * dims.z), 0);
    for (int z = isLow ? 1 : 0; z < (isLow ? dims.z : dims.z - 1); ++z)
      for (int y = 20; y < 46; ++y)
        for (int x = 20; x < 50; ++x) mask[std::size_t((z * dims.y + y) * dims.x + x)] = 1;
    CutLattice lattice = latticeFromMask(dims, isLow ? 19.5 : 69.5, mask);
    ASSERT_EQ(exact(lattice).cutPairs, 0.0);
    EXPECT_EQ(computeCutInBands(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress, 200).cutPairs, 0.0);
    EXPECT_EQ(computeCutInBands(lattice, scene::MembraneSide::Keep, CutMetric::Smooth, progress, 200).cutPairs, 0.0);
  }
}

TEST(LeastCut, BandsGoOnAroundASheetAtTheirEdgeUnlessTheLatticeEndsThere) {
  glm::ivec2 columns(60, 50);
  auto at = [&](int x, int y) { return std::size_t(y * columns.x + x); };
  std::vector<SheetRange> whole(3000, {1, 40}), ranges(3000, {10, 16});
  std::vector<int> below(3000, 13);
  EXPECT_TRUE(aroundEdges(columns, below, ranges, whole).empty());
  ranges[at(5, 5)] = {1, 13};     // its upper end
  ranges[at(50, 40)] = {13, 16};  // its lower end
  ranges[at(30, 5)] = {13, 13};   // it had no choice
  whole[at(30, 40)] = ranges[at(30, 40)] = {13, 16};
  std::vector<std::uint8_t> isNear = aroundEdges(columns, below, ranges, whole);
  ASSERT_EQ(isNear.size(), below.size());
  for (int y = 0; y < columns.y; ++y)
    for (int x = 0; x < columns.x; ++x) {
      auto isWithin = [&](glm::ivec2 p) { return std::max(std::abs(p.x - x), std::abs(p.y - y)) <= 8; };
      EXPECT_EQ(bool(isNear[at(x, y)]), isWithin({5, 5}) || isWithin({50, 40})) << x << ", " << y;
    }
}

TEST(LeastCut, InBandsASmallLatticeIsSolvedExactly) {
  Progress progress;
  glm::ivec3 dims(40, 36, 18);
  CutLattice lattice = latticeFromMask(dims, 8.5, tubes(dims, 25, 2.0, 7));
  EXPECT_EQ(computeCutInBands(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress).below,
            exact(lattice).below);
}

TEST(LeastCut, NearASheetEqualsTheBestOfAllNearIt) {
  Progress progress;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    CutLattice lattice = randomPairs({4, 4, 7}, seed % 2 ? 2.5 : 3.0, seed, 0.5);
    int flat = flatCount(lattice), band = 1 + int(seed % 2);
    std::vector<int> near(16, flat);
    for (int c : {5, 6, 9, 10}) near[std::size_t(c)] = 1 + int((seed * 7 + unsigned(c) * 5) % 6);
    double best = 1e30;
    forEachSheet(lattice, [&](const std::vector<int>& below) {
      for (int c : {5, 6, 9, 10})
        if (std::abs(below[std::size_t(c)] - near[std::size_t(c)]) > band) return;
      best = std::min(best, countCutPairs(lattice, below));
    });
    LeastCut found = computeLeastCutNear(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, near, band, progress);
    EXPECT_DOUBLE_EQ(found.cutPairs, best) << "seed " << seed;
  }
}

TEST(LeastCut, NearASheetInAWideBandIsTheLeastOfAll) {
  Progress progress;
  glm::ivec3 dims(24, 20, 12);
  CutLattice lattice = latticeFromMask(dims, 5.5, tubes(dims, 9, 1.8, 3));
  std::vector<int> near(std::size_t(dims.x * dims.y), 9);
  auto pairsWithin = [&](int band) {
    return computeLeastCutNear(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, near, band, progress).cutPairs;
  };
  EXPECT_DOUBLE_EQ(pairsWithin(12), exact(lattice).cutPairs);
  EXPECT_GT(pairsWithin(1), exact(lattice).cutPairs);
  EXPECT_THROW(
      computeLeastCutNear(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, std::vector<int>(3), 1, progress),
      ArgumentError);
}

TEST(LeastCut, StaysOnTheRestPlaneWhereNothingIsProtected) {
  for (double restPlane : {0.5, 3.0, 3.7, 6.99}) {
    CutLattice lattice = latticeFromMask({9, 7, 9}, restPlane, std::vector<std::uint8_t>(9 * 7 * 9, 0));
    for (int below : exact(lattice).below) EXPECT_EQ(below, int(std::floor(restPlane)) + 1);
  }
}

/// A ball around (12, 12, z) and a rest plane between the layers 9 and 10.
LeastCut aroundBall(double z, scene::MembraneSide side) {
  glm::ivec3 dims(25, 25, 20);
  std::vector<std::uint8_t> mask;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
    glm::dvec3 p(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
    mask.push_back(glm::length(p - glm::dvec3(12, 12, z)) < 5.5);
  }
  return exact(latticeFromMask(dims, 9.5, mask), side);
}

TEST(LeastCut, GoesAroundABallOnTheSideThatIsAskedFor) {
  auto middle = [](double z, scene::MembraneSide side) {
    LeastCut least = aroundBall(z, side);
    EXPECT_EQ(least.cutPairs, 0.0);
    for (int y = 0; y < 25; ++y)
      for (int x = 0; x < 25; ++x)
        if (std::hypot(x - 12.0, y - 12.0) > 8.0) {
          EXPECT_EQ(least.below[std::size_t(y * 25 + x)], 10);
        }
    return least.below[12 * 25 + 12];
  };
  // A ball of eleven layers around z: below the sheet it ends with layer z + 5.
  EXPECT_EQ(middle(8, scene::MembraneSide::Nearest), 14);
  EXPECT_EQ(middle(11, scene::MembraneSide::Nearest), 6);
  for (double z : {8.0, 11.0}) {
    EXPECT_EQ(middle(z, scene::MembraneSide::Keep), int(z) + 6);
    EXPECT_EQ(middle(z, scene::MembraneSide::Remove), int(z) - 5);
  }
}

TEST(LeastCut, WhatTheRestPlaneDoesNotMeetStaysOnItsSide) {
  // Slabs just behind and just in front of it: nothing asks the sheet to leave the rest plane.
  glm::ivec3 dims(12, 11, 16);
  std::vector<std::uint8_t> mask;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
    glm::ivec3 p(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
    bool isInner = p.x > 2 && p.y > 2 && p.x < 9 && p.y < 8;
    mask.push_back(isInner && (p.x < 6 ? p.z == 6 || p.z == 7 : p.z == 8 || p.z == 9));
  }
  CutLattice lattice = latticeFromMask(dims, 7.5, mask);
  for (auto side : {scene::MembraneSide::Keep, scene::MembraneSide::Remove, scene::MembraneSide::Nearest})
    for (int below : exact(lattice, side).below) EXPECT_EQ(below, 8);
}

TEST(LeastCut, AnywhereInItsCorridorAColumnSeparatesNoMore) {
  glm::ivec3 dims(24, 20, 14);
  CutLattice lattice = latticeFromMask(dims, 6.5, tubes(dims, 9, 1.8, 3));
  lattice.origin = {-12.0, 3.0, -6.75};
  lattice.step = {1.0, 2.0, 1.5};
  LeastCut least = exact(lattice);
  Corridor corridor = corridorAround(lattice, least);
  int moved = 0;
  for (int y = 1; y + 1 < dims.y; ++y)
    for (int x = 1; x + 1 < dims.x; ++x) {
      auto c = std::size_t(y * dims.x + x);
      if (pairsAt(lattice, {x, y, least.below[c] - 1}, 2) > 0.0) continue;  // it cuts there, and may be smoothed
      EXPECT_LT(corridor.room[c].x, corridor.room[c].y);
      for (float z : {corridor.room[c].x, corridor.room[c].y}) {
        std::vector<int> below = least.below;
        below[c] = int(std::floor((double(z) - lattice.origin.z) / lattice.step.z)) + 1;
        moved += below[c] != least.below[c];
        EXPECT_LE(countCutPairs(lattice, below), least.cutPairs) << x << ", " << y;
      }
    }
  EXPECT_GT(moved, 300);
}

TEST(LeastCut, RimAndReachHold) {
  glm::ivec3 dims(12, 11, 7);
  // Everything is protected: the best sheet is the flat one.
  CutLattice full = latticeFromMask(dims, 2.5, std::vector<std::uint8_t>(std::size_t(12 * 11 * 7), 1));
  for (int below : exact(full).below) EXPECT_EQ(below, 3);
  LeastCut least = exact(randomPairs(dims, 2.5, 3, 0.8));
  for (int y = 0; y < dims.y; ++y)
    for (int x = 0; x < dims.x; ++x) {
      int below = least.below[std::size_t(y * dims.x + x)];
      EXPECT_TRUE(below >= 1 && below <= 6);
      if (x == 0 || y == 0 || x == 11 || y == 10) {
        EXPECT_EQ(below, 3);
      }
    }
}

TEST(LeastCut, IsTheSameEveryTime) {
  glm::ivec3 dims(30, 30, 12);
  CutLattice lattice = latticeFromMask(dims, 5.5, tubes(dims, 12, 1.5, 5));
  EXPECT_EQ(exact(lattice).below, exact(lattice).below);
}

TEST(LeastCut, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  CutLattice lattice = randomPairs({5, 5, 5}, 2.5, 1, 0.5);
  EXPECT_THROW(computeLeastCut(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress), Cancelled);
}

TEST(LeastCut, RefusesWhatIsNotSound) {
  auto nothing = [](const auto&) {};
  EXPECT_THROW(makeLattice({0, 3, 3}, 1.0, nothing), ArgumentError);
  EXPECT_THROW(makeLattice({3, 3, 70000}, 1.0, nothing), ArgumentError);
  EXPECT_THROW(exact(makeLattice({5, 5, 5}, 9.5, nothing)), ArgumentError);
  EXPECT_THROW(latticeFromMask({3, 3, 3}, 1.5, std::vector<std::uint8_t>(26)), ArgumentError);
}

}  // namespace
}  // namespace velum::membrane
