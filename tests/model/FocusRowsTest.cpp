#include "model/FocusRows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace velum {
namespace {

TEST(FloodSteps, ReachFromEachPixelToAnyOther) {
  for (glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(64, 64), glm::ivec2(65, 65), glm::ivec2(300, 12),
                          glm::ivec2(12, 300), glm::ivec2(200, 1), glm::ivec2(1, 200), glm::ivec2(257, 128)}) {
    // A step goes as far along each axis, or not at all: the axes are alike.
    std::set<int> reached{0};
    for (int step : model::floodSteps(size)) {
      std::set<int> next = reached;
      for (int from : reached) next.insert({from - step, from + step});
      reached = next;
    }
    for (int way = 0; way < std::max(size.x, size.y); ++way)
      EXPECT_TRUE(reached.contains(way) && reached.contains(-way)) << size.x << " x " << size.y << ": " << way;
  }
}

}  // namespace
}  // namespace velum
