#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "velum/core/Fields.h"

namespace velum::scene {

/// Where the particles of a sheet are, in the local frame of its cut: x and y across the frame from its middle, z along
/// the axis, mm. Row by row, x fastest; the outermost particles lie on the frame. Two triangles a mesh: lower left,
/// lower right, upper right; lower left, upper right, upper left.
struct SheetShape {
  glm::ivec2 particles{0};
  std::vector<glm::vec3> places;
  bool operator==(const SheetShape&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("particles", o.particles, FieldInfo{"", {0, 260}, "Particles along the frame's width and height."});
    visit("places", o.places, FieldInfo{"mm", {}, "Frame-local x, y, z of each particle, row by row."});
  }
};

}  // namespace velum::scene
