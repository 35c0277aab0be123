// The sheet that is smoothed near the one of the least pairs.
#include <gtest/gtest.h>

#include "LeastCutOracle.h"
#include "membrane/forces/LeastCut.h"

namespace velum::membrane {
namespace {

TEST(TwoLooks, SeparateHardlyMoreThanTheLeastPairs) {
  Progress progress;
  glm::ivec3 dims(140, 130, 60);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    CutLattice lattice = latticeFromMask(dims, 29.5, tubes(dims, 40, 2.5, seed));
    std::vector<int> flat(std::size_t(dims.x) * std::size_t(dims.y), flatCount(lattice));
    double least = computeLeastCut(lattice, scene::MembraneSide::Keep, CutMetric::Pairs, progress).cutPairs;
    LeastCut cut = computeSmoothNearPairs(lattice, scene::MembraneSide::Keep, progress);
    EXPECT_GE(cut.cutPairs, least);
    EXPECT_LE(cut.cutPairs, 1.1 * least + 10.0);
    EXPECT_LT(cut.cutPairs, 0.9 * countCutPairs(lattice, flat));
    EXPECT_EQ(cut.cutPairs, countCutPairs(lattice, cut.below));
  }
}

TEST(TwoLooks, LieWithinAFewLayersOfTheFirst) {
  Progress progress;
  glm::ivec3 dims(80, 80, 40);
  CutLattice lattice = latticeFromMask(dims, 19.5, tubes(dims, 25, 3.0, 7));
  LeastCut first = computeCutInBands(lattice, scene::MembraneSide::Nearest, CutMetric::Pairs, progress);
  LeastCut second = computeSmoothNearPairs(lattice, scene::MembraneSide::Nearest, progress);
  for (std::size_t c = 0; c < first.below.size(); ++c) EXPECT_LE(std::abs(first.below[c] - second.below[c]), 3);
}

}  // namespace
}  // namespace velum::membrane
