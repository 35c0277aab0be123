#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "io/models/ModelParts.h"

namespace velum::io {

/// How the units of a strand follow each other.
struct StrandUnit {
  float step = 3.4f;      ///< angstrom along the curve
  float twistRad = 0.0f;  ///< turn about the curve from one unit to the next
};
/// Nucleotides of the B form and of strands of RNA: 12 a turn of 34 angstrom, 34.3 degrees each.
constexpr StrandUnit kNucleotide{34.0f / 12.0f, 0.59865f};

/// Calls @p body with poses at equal distances along a smooth curve through the points: z points along the curve, and x
/// turns about it by the twist alone.
/// @param points  two or more different points
void walkAlong(std::span<const glm::vec3> points, const StrandUnit& unit, const std::function<void(const Pose&)>& body);

}  // namespace velum::io
