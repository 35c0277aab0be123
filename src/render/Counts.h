#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Model.h"

namespace velum::render {

/// What became of the instances of a type, or of several: each of them is one of the three.
struct TypeCount {
  std::uint64_t visible = 0;  ///< some pixel shows it
  std::uint64_t hidden = 0;   ///< drawn, but behind others, beside the picture, or smaller than a pixel sees
  std::uint64_t clipped = 0;  ///< removed by a cut, or of a type that is not shown
  std::uint64_t rendered() const { return visible + hidden; }
  std::uint64_t total() const { return visible + hidden + clipped; }
  TypeCount& operator+=(const TypeCount& other) {
    visible += other.visible, hidden += other.hidden, clipped += other.clipped;
    return *this;
  }
  bool operator==(const TypeCount&) const = default;
};

/// What became of each instance of a picture's model ([VE] 3), a bit each, copy by copy, in words of 32.
struct InstanceBits {
  std::uint64_t count = 0;             ///< of instances, over all copies
  std::vector<std::uint32_t> removed;  ///< no part of it is drawn
  std::vector<std::uint32_t> shown;    ///< some pixel shows it
  glm::ivec2 pictureSize{0};           ///< of the picture that says so, pixels
  bool isRemoved(std::uint64_t i) const { return (removed[i >> 5] >> (i & 31u) & 1u) != 0u; }
  bool isShown(std::uint64_t i) const { return (shown[i >> 5] >> (i & 31u) & 1u) != 0u; }
};

/// Counts by type, by their places in the model. Cost: a look at each word of the bits.
std::vector<TypeCount> countTypes(const Model& model, const InstanceBits& bits);

/// Sums by compartment, by their places in the model: of its own types and of those of all below it.
std::vector<TypeCount> countCompartments(const Model& model, const std::vector<TypeCount>& types);

}  // namespace velum::render
