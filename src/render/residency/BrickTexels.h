#pragma once
#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/BrickCache.h"
#include "render/residency/PageGrid.h"
#include "render/upload/TransferTable.h"
#include "render/upload/VolumeTexels.h"

namespace velum::render {

/// Cells along an edge of a brick, of each of which the range of texels is known.
inline constexpr int kRangeCells = 4;

/// Smallest and largest texel in each of a brick's cells, with a halo of one voxel; x fastest.
using BrickRanges = std::array<glm::vec2, kRangeCells * kRangeCells * kRangeCells>;

/// What goes into a slot.
struct BrickTexels {
  std::vector<std::byte> texels;       ///< of kSlotEdge^3, as the plan says
  std::vector<glm::u8vec4> gradients;  ///< as packGradients() makes them
  BrickRanges ranges;
};

/// Which values of a volume become texels, and how.
struct TexelRecipe {
  std::shared_ptr<BrickCache> bricks;
  int channel = 0, timeStep = 0;
  bool isMixed = false;
  MixTable mix;  ///< where channels are mixed
  TexelPlan plan;
  glm::dvec2 range{0.0};       ///< of the volume's values, for what is not a number
  double longestGradient = 1;  ///< texels
};

/// Reads a brick and makes its texels: the same, to the last bit, as those that the whole level would have there.
/// Cost: the voxels of a slot and of a border as wide as gradients reach. Any thread.
/// @throw InputError when a brick cannot be read
BrickTexels makeBrickTexels(const TexelRecipe& recipe, const PageGrid& grid, const PageBrick& brick);

}  // namespace velum::render
