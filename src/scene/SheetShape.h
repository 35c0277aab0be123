#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "core/Fields.h"

namespace velum::scene {

/// Where the particles of a sheet are, in the local frame of its cut: x and y across the rest plane from its middle, z
/// along the axis. Row by row, x fastest; the outermost particles lie on the frame. Two triangles a mesh: lower
/// left, lower right, upper right; lower left, upper right, upper left.
struct SheetShape {
  glm::ivec2 particles{0};
  std::vector<glm::vec3> places;
  // The frame in which it came to rest, as Cut has it. An axis of length 0: that of the cut itself.
  glm::dvec3 centre{0.0}, axis{0.0};
  double spinDeg = 0.0;
  int timeStep = -1;  ///< of the volume, from which the forces were; -1: not known
  bool operator==(const SheetShape&) const = default;
  static void fields(auto& o, auto& visit) {
    visit("particles", o.particles, FieldInfo{"", {0, 1024}, "Particles along the rest plane's width and height."});
    visit("places", o.places, FieldInfo{kLength, {}, "Frame-local x, y, z of each particle, row by row."});
    visit("centre", o.centre, FieldInfo{kLength, {}, "Middle of the rest plane in which it came to rest."});
    visit("axis", o.axis, FieldInfo{"", {}, "Normal of that frame; 0, 0, 0: that of the cut itself."});
    visit("spinDeg", o.spinDeg, FieldInfo{"deg", {-360, 360}, "Turn of that frame about its axis."});
    visit("timeStep", o.timeStep,
          FieldInfo{"", {-1, 1e6}, "Time step of the volume in which it came to rest; -1: any."});
  }
};

}  // namespace velum::scene
