#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

namespace velum {

/// Triangles in world space (LPS). Normals are per vertex, unit; empty when the file has none.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<std::uint32_t> indices;  ///< Three per triangle.
  std::string name;
  std::optional<glm::vec3> color;     ///< sRGB, where the file gives the whole mesh one colour.
  std::vector<std::string> warnings;  ///< What the reader had to assume or leave out, one line each.
};

}  // namespace velum
