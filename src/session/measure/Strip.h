#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "session/measure/MeshWay.h"

namespace velum::session {

/// Where a way through a strip of triangles bends about a corner of theirs.
struct StripCorner {
  std::uint32_t point = 0;  ///< of the mesh
  std::size_t gate = 0;     ///< a gate that has it: the edge between triangle `gate` of the strip and the next one
  double angle = 0.0;       ///< within the strip, radians, at least pi
};

/// The shortest way within a strip of triangles, each a neighbour of the one before it.
struct StripWay {
  MeshWay way;
  std::vector<StripCorner> corners;
};
StripWay straightWay(const WayMesh& mesh, const std::vector<std::uint32_t>& strip, glm::dvec3 from, glm::dvec3 to);

}  // namespace velum::session
