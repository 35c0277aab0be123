#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::io {

/// Triangles in voxel space, in doubles: far from the origin floats would have steps of their own.
struct SurfaceShape {
  std::vector<glm::dvec3> positions, normals;
  std::vector<std::uint32_t> indices;
};

}  // namespace velum::io
