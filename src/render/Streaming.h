#pragma once
#include <cstddef>
#include <vector>

namespace velum::render {

/// How much of a streamed volume is there.
struct Streaming {
  std::vector<double> shares;  ///< of what rays meet, 0..1, by the level at which it is shown, the finest first; empty:
                               ///< nothing is streamed, or rays meet nothing
  std::size_t missing = 0;     ///< bricks on their way
  double coarser = 1.0;        ///< how many times coarser than pixels all is, as there is no room
  double usedBytes = 0, budgetBytes = 0;  ///< of the GPU's memory
};

}  // namespace velum::render
