#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Counts.h"
#include "core/Model.h"

namespace velum::render {

/// What became of each instance of a picture's model ([VE] 3): arrays with a bit for each instance, copy by copy, in
/// words of 32.
struct InstanceBits {
  std::uint64_t count = 0;             ///< number of instances, over all copies
  std::vector<std::uint32_t> removed;  ///< bit set: no part of the instance is drawn
  std::vector<std::uint32_t> shown;    ///< bit set: some pixel shows the instance
  glm::ivec2 pictureSize{0};           ///< size of the picture that the bits were taken from, pixels
  bool isRemoved(std::uint64_t i) const { return (removed[i >> 5] >> (i & 31u) & 1u) != 0u; }
  bool isShown(std::uint64_t i) const { return (shown[i >> 5] >> (i & 31u) & 1u) != 0u; }
  /// The kind, of kCountKinds, that an instance belongs to.
  CountOf kindOf(std::uint64_t i) const {
    return isRemoved(i) ? CountOf::Clipped : isShown(i) ? CountOf::Visible : CountOf::Hidden;
  }
};

/// The counts of each type, in the order of Model::types. Cost: a look at each word of the bits.
std::vector<Counts> countTypes(const Model& model, const InstanceBits& bits);

/// The counts of each compartment, in the order of Model::compartments: sums over its own types and those of all
/// compartments below it.
std::vector<Counts> countCompartments(const Model& model, const std::vector<Counts>& types);

}  // namespace velum::render
