#include "velum/membrane/forces/LeastCut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "LeastCutOracle.h"
#include "makeVolume.h"

namespace velum::membrane {
namespace {

/// A few random tubes across a lattice.
std::vector<std::uint8_t> tubes(glm::ivec3 dims, int count, double radius, unsigned seed) {
  std::mt19937 random(seed);
  auto inside = [&] {
    auto along = [&](int n) { return double(random() % unsigned(n)); };
    double x = along(dims.x), y = along(dims.y);
    return glm::dvec3(x, y, along(dims.z));
  };
  std::vector<std::uint8_t> mask(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
  for (int i = 0; i < count; ++i) {
    glm::dvec3 a = inside(), b = inside(), d = b - a;
    std::size_t at = 0;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x, ++at) {
          glm::dvec3 p = glm::dvec3(x, y, z) - a;
          double t = std::clamp(glm::dot(p, d) / std::max(glm::dot(d, d), 1e-9), 0.0, 1.0);
          if (glm::length(p - t * d) <= radius) mask[at] = 1;
        }
  }
  return mask;
}

/// A lattice whose pairs are random whole numbers, a share of them 0.
CutLattice randomPairs(glm::ivec3 dims, double restLayer, unsigned seed, double share) {
  std::mt19937 random(seed);
  CutLattice lattice = makeLattice(dims, restLayer);
  for (auto& pairs : lattice.pairs)
    for (float& p : pairs) p = double(random() % 1000) < 1000.0 * share ? float(random() % 5) : 0.0f;
  return lattice;
}

LeastCut exact(const CutLattice& lattice, const LeastCutOptions& options = {}) {
  Progress progress;
  return computeLeastCut(lattice, options, progress);
}

TEST(LeastCut, EqualsTheBestOfAllSheetsOnTinyLattices) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    CutLattice lattice = randomPairs({4, 4, 6}, seed % 2 ? 2.5 : 2.0, seed, 0.5);
    LeastCutOptions options{double(seed % 7), 1.0, seed % 3 ? 0.25 : 0.0};
    LeastCut least = exact(lattice, options);
    EXPECT_DOUBLE_EQ(least.cost, bestOfAllSheets(lattice, options)) << "seed " << seed;
  }
}

TEST(LeastCut, EqualsBoykovAndKolmogorov) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    glm::ivec3 dims(9 + int(seed), 21 - int(seed), 8 + int(seed % 5));
    CutLattice lattice = seed % 2 ? latticeFromMask(dims, dims.z / 2 - 0.5, tubes(dims, 4, 1.6, seed))
                                  : randomPairs(dims, 3.25, seed, 0.3);
    LeastCutOptions options{seed % 4 ? 200.0 : 3.0, 1.0, seed % 3 ? 0.0625 : 0.0};
    EXPECT_DOUBLE_EQ(exact(lattice, options).cost, minimumCut(lattice, options)) << "seed " << seed;
  }
}

TEST(LeastCut, EqualsBoykovAndKolmogorovWhereMuchIsProtected) {
  glm::ivec3 dims(40, 36, 18);
  CutLattice lattice = latticeFromMask(dims, 8.5, tubes(dims, 25, 2.0, 7));
  EXPECT_DOUBLE_EQ(exact(lattice).cost, minimumCut(lattice, {}));
}

TEST(LeastCut, NearASheetEqualsTheBestOfAllNearIt) {
  Progress progress;
  for (unsigned seed = 1; seed <= 30; ++seed) {
    CutLattice lattice = randomPairs({4, 4, 7}, seed % 2 ? 2.5 : 3.0, seed, 0.5);
    LeastCutOptions options{double(seed % 7), 1.0, seed % 3 ? 0.25 : 0.0};
    int flat = flatCount(lattice), band = 1 + int(seed % 2);
    std::vector<int> near(16, flat);
    for (int c : {5, 6, 9, 10}) near[std::size_t(c)] = 1 + int((seed * 7 + unsigned(c) * 5) % 6);
    // The four inner columns, one digit each.
    double best = 1e30;
    int choices = 2 * band + 1;
    for (int code = 0; code < choices * choices * choices * choices; ++code) {
      std::vector<int> below(16, flat);
      int rest = code;
      for (int c : {5, 6, 9, 10}) {
        below[std::size_t(c)] = std::clamp(near[std::size_t(c)] - band + rest % choices, 1, 6);
        rest /= choices;
      }
      best = std::min(best, evaluateSheet(lattice, options, below).cost);
    }
    EXPECT_DOUBLE_EQ(computeLeastCutNear(lattice, options, near, band, progress).cost, best) << "seed " << seed;
  }
}

TEST(LeastCut, NearASheetInAWideBandIsTheLeastOfAll) {
  Progress progress;
  glm::ivec3 dims(24, 20, 12);
  CutLattice lattice = latticeFromMask(dims, 5.5, tubes(dims, 9, 1.8, 3));
  std::vector<int> near(std::size_t(dims.x * dims.y), 9);
  EXPECT_DOUBLE_EQ(computeLeastCutNear(lattice, {}, near, 12, progress).cost, exact(lattice).cost);
  EXPECT_GT(computeLeastCutNear(lattice, {}, near, 1, progress).cost, exact(lattice).cost);
  EXPECT_THROW(computeLeastCutNear(lattice, {}, std::vector<int>(3), 1, progress), ArgumentError);
}

TEST(LeastCut, StaysOnTheRestPlaneWhereNothingIsProtected) {
  for (double restPlane : {0.5, 3.0, 3.7, 6.99}) {
    CutLattice lattice = makeLattice({9, 7, 9}, restPlane);
    for (int below : exact(lattice).below) EXPECT_EQ(below, int(std::floor(restPlane)) + 1);
  }
}

TEST(LeastCut, GoesAroundABall) {
  // Its middle lies below the rest plane, so the sheet passes above it; the way below would be longer.
  glm::ivec3 dims(25, 25, 20);
  std::vector<std::uint8_t> mask;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i) {
    glm::dvec3 p(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y));
    mask.push_back(glm::length(p - glm::dvec3(12, 12, 8)) < 5.5);
  }
  CutLattice lattice = latticeFromMask(dims, 9.5, mask);
  LeastCut least = exact(lattice);
  EXPECT_EQ(least.cutPairs, 0.0);
  for (int y = 0; y < dims.y; ++y)
    for (int x = 0; x < dims.x; ++x) {
      int below = least.below[std::size_t(y * dims.x + x)];
      EXPECT_GE(below, 10);
      if (std::hypot(x - 12.0, y - 12.0) > 8.0) {
        EXPECT_EQ(below, 10);
      }
    }
}

TEST(LeastCut, RimAndReachHold) {
  glm::ivec3 dims(12, 11, 7);
  // Everything is protected: the best sheet is the flat one.
  CutLattice full = latticeFromMask(dims, 2.5, std::vector<std::uint8_t>(std::size_t(12 * 11 * 7), 1));
  for (int below : exact(full).below) EXPECT_EQ(below, 3);
  LeastCut least = exact(randomPairs(dims, 2.5, 3, 0.8), {50.0, 0.0, 0.0});
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

TEST(LeastCut, FastIsNeverBetterAndSeldomMuchWorse) {
  LeastCutOptions fast;
  fast.fast = true;
  double sumExact = 0.0, sumFast = 0.0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    glm::ivec3 dims(72, 64, 20);
    CutLattice lattice = latticeFromMask(dims, 9.5, tubes(dims, 20, 2.2, seed));
    double best = exact(lattice).cost, banded = exact(lattice, fast).cost;
    EXPECT_GE(banded, best);
    sumExact += best;
    sumFast += banded;
  }
  EXPECT_LE(sumFast, 1.1 * sumExact);
}

TEST(LeastCut, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(computeLeastCut(makeLattice({5, 5, 5}, 2.5), {}, progress), Cancelled);
}

TEST(LeastCut, RefusesWhatIsNotSound) {
  Progress progress;
  EXPECT_THROW(makeLattice({0, 3, 3}, 1.0), ArgumentError);
  EXPECT_THROW(computeLeastCut(makeLattice({5, 5, 5}, 9.5), {}, progress), ArgumentError);
  EXPECT_THROW(computeLeastCut(makeLattice({5, 5, 5}, 2.5), {-1.0}, progress), ArgumentError);
  CutLattice torn = makeLattice({5, 5, 5}, 2.5);
  torn.pairs[1].pop_back();
  EXPECT_THROW(computeLeastCut(torn, {}, progress), ArgumentError);
}

}  // namespace
}  // namespace velum::membrane
