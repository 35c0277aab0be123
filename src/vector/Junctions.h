#pragma once
#include <array>
#include <vector>

#include "vector/CubicFit.h"
#include "vector/PixelBorders.h"

namespace velum::vector {

/// Where a node lies once borders are smooth, and which way they leave it, by way; nothing where they find it
/// themselves.
struct Junction {
  glm::dvec2 place{0.0};
  std::array<std::optional<glm::dvec2>, 4> leaving;  ///< unit
};

/// The middles of the edges of a border, a piece of the fence each, in the order of its corners.
Track trackOf(const PixelBorder& border);

/// Finds where borders meet: of those that go on smoothly into each other two do, without a kink; others end on them.
/// @param tracks  of all borders, by number
std::vector<Junction> placeJunctions(const PixelBorders& borders, const std::vector<Track>& tracks);

}  // namespace velum::vector
