#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace velum::render {

/// Some of the cells of a grid, which has at most 64 along each axis (cellGridFor): a word is a row of them.
struct CellSet {
  CellSet() = default;
  explicit CellSet(glm::ivec3 cells) : size(cells), rows(std::size_t(cells.y) * std::size_t(cells.z), 0) {}
  glm::ivec3 size{0};
  std::vector<std::uint64_t> rows;  ///< [z][y], bit x
  bool operator==(const CellSet&) const = default;
};

/// How far a leap goes at most, in cells.
constexpr std::uint8_t kFarthestLeap = 12;

/// For each cell, x fastest, how far it is to the nearest of two sets: Chebyshev distances in cells, at most
/// kFarthestLeap. Under a millisecond for 64^3 cells: sets grow by words.
std::vector<glm::u8vec2> makeSkipMap(const CellSet& first, const CellSet& second);

}  // namespace velum::render
