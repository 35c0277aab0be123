#pragma once
#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "core/BrickCache.h"
#include "render/residency/PageGrid.h"
#include "render/upload/BlockGradients.h"
#include "render/upload/TransferTable.h"
#include "render/upload/VolumeTexels.h"

namespace velum::render {

/// Cells along an edge of a brick, of each of which the range of texels is known.
inline constexpr int kRangeCells = 4;

/// Smallest and largest texels.
struct BrickRanges {
  std::array<glm::vec2, kRangeCells * kRangeCells * kRangeCells> cells;  ///< Of the voxels around; x fastest.
  glm::vec2 all{0.0f};  ///< Of the whole slot, with what neighbours lend.
};

/// What goes into a slot.
struct BrickTexels {
  Bytes texels;               ///< of kSlotEdge^3, as the plan says; empty: not worth a slot
  PackedGradients gradients;  ///< as packGradients() makes them
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

/// True when a brick of these ranges is worth a slot. Any thread.
using IsWorthSlot = std::function<bool(const BrickRanges&)>;

/// Reads a brick and makes its texels: those that the whole level would have there. Of a brick that is not worth a slot
/// only its ranges.
/// Cost: the voxels of a slot and of a border as wide as gradients reach. Any thread.
/// @throw InputError when a brick cannot be read
BrickTexels makeBrickTexels(const TexelRecipe& recipe, const PageGrid& grid, const PageBrick& brick,
                            const IsWorthSlot& isWorthSlot);

}  // namespace velum::render
