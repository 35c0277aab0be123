#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// A set of cells of a grid that has at most 64 cells along each axis (cellGridFor()): a word holds a row of cells.
struct CellSet {
  CellSet() = default;
  explicit CellSet(glm::ivec3 cells) : size(cells), rows(std::size_t(cells.y) * std::size_t(cells.z), 0) {}
  glm::ivec3 size{0};
  std::vector<std::uint64_t> rows;  ///< [z][y], bit x
  bool operator==(const CellSet&) const = default;
};

/// The farthest leap, in cells.
constexpr std::uint8_t kFarthestLeap = 12;

/// Size of a map in texels: the cells of the eight octants of directions follow each other along z. In an octant's
/// number bit 0 is set where x grows, bit 1 where y grows, bit 2 where z grows.
inline glm::ivec3 skipMapSize(glm::ivec3 cells) { return {cells.x, cells.y, 8 * cells.z}; }

/// For each octant of directions and each cell, x fastest, the distances to the nearest cell of `first`, and of
/// `second`, in these directions: Chebyshev distances in cells, at most kFarthestLeap. Under 3 ms for 64^3 cells on two
/// cores: sets grow by words.
std::vector<glm::u8vec2> makeSkipMap(const CellSet& first, const CellSet& second);

}  // namespace velum::render
