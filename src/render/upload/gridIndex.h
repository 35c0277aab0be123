#pragma once
#include <cstddef>
#include <glm/glm.hpp>

namespace velum::render {

/// The number of cells of a grid, and the index of a cell among all of them, x fastest.
inline std::size_t countOf(glm::ivec3 grid) { return std::size_t(grid.x) * std::size_t(grid.y) * std::size_t(grid.z); }
inline std::size_t indexIn(glm::ivec3 grid, glm::ivec3 at) {
  return (std::size_t(at.z) * std::size_t(grid.y) + std::size_t(at.y)) * std::size_t(grid.x) + std::size_t(at.x);
}
/// The cell with an index.
inline glm::ivec3 cellIn(glm::ivec3 grid, std::size_t place) {
  auto x = std::size_t(grid.x), y = std::size_t(grid.y);
  return {int(place % x), int(place / x % y), int(place / (x * y))};
}

}  // namespace velum::render
