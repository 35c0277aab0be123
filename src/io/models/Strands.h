#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "io/models/ModelParts.h"

namespace velum::io {

/// What a strand is made of, one after the other.
struct StrandUnit {
  float step = 3.4f;      ///< angstrom along the curve
  float twistRad = 0.0f;  ///< from one to the next, about it
};
/// Nucleotides of the B form and of strands of RNA: 12 a turn of 34 angstrom, 34.3 degrees each.
constexpr StrandUnit kNucleotide{34.0f / 12.0f, 0.59865f};

/// Calls @p body at equal distances along a smooth curve through the points: z along it, x carried on without turning
/// but for the twist.
/// @param points  two or more that differ
void walkAlong(std::span<const glm::vec3> points, const StrandUnit& unit, const std::function<void(const Pose&)>& body);

}  // namespace velum::io
