#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Counts.h"
#include "core/Model.h"

namespace velum::render {

/// What became of each instance of a picture's model ([VE] 3), a bit each, copy by copy, in words of 32.
struct InstanceBits {
  std::uint64_t count = 0;             ///< of instances, over all copies
  std::vector<std::uint32_t> removed;  ///< no part of it is drawn
  std::vector<std::uint32_t> shown;    ///< some pixel shows it
  glm::ivec2 pictureSize{0};           ///< of the picture that says so, pixels
  bool isRemoved(std::uint64_t i) const { return (removed[i >> 5] >> (i & 31u) & 1u) != 0u; }
  bool isShown(std::uint64_t i) const { return (shown[i >> 5] >> (i & 31u) & 1u) != 0u; }
  /// The one of kCountKinds that it is of.
  CountOf kindOf(std::uint64_t i) const {
    return isRemoved(i) ? CountOf::Clipped : isShown(i) ? CountOf::Visible : CountOf::Hidden;
  }
};

/// Counts by type, by their places in the model. Cost: a look at each word of the bits.
std::vector<Counts> countTypes(const Model& model, const InstanceBits& bits);

/// Sums by compartment, by their places in the model: of its own types and of those of all below it.
std::vector<Counts> countCompartments(const Model& model, const std::vector<Counts>& types);

}  // namespace velum::render
