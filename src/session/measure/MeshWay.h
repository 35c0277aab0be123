#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/Task.h"

namespace velum::session {

/// Triangles on which ways are sought.
struct WayMesh {
  std::vector<glm::dvec3> points;
  std::vector<std::uint32_t> indices;  ///< three a triangle, in either order
};

struct MeshWay {
  double length = 0.0;
  std::vector<glm::dvec3> points;  ///< from one end to the other, with each place where the way crosses an edge
};

/// The place of a mesh that is nearest to a point.
struct MeshPlace {
  std::uint32_t triangle = 0;
  glm::dvec3 place{0.0};
  double distance = 1e300;
};
/// O(triangles), all cores. The mesh must have triangles.
MeshPlace nearestPlace(const WayMesh& mesh, glm::dvec3 point);

/// A way over triangles that no small change makes shorter. It is found among triangles, from middle to middle, and
/// then drawn straight: unfolded into a plane, and led past the other side of a corner where that is shorter, until no
/// corner is left at which it is. Nothing where the places do not hang together.
/// @throw Cancelled. Any thread.
std::optional<MeshWay> wayOverMesh(const WayMesh& mesh, const MeshPlace& from, const MeshPlace& to, Progress& progress);

}  // namespace velum::session
