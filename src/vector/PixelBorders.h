#pragma once
#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace velum::vector {

/// Ways along the edges of pixels: to the right, down, to the left, up.
inline constexpr std::array<glm::ivec2, 4> kWays{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// A border between two regions, along the edges of pixels.
struct PixelBorder {
  std::vector<glm::ivec2> corners;   ///< of pixels, each a pixel from the one before; closed: the last is the first
  int left = 0, right = 0;           ///< ids, as seen by who walks along it; kOutside beyond the picture
  int startNode = -1, endNode = -1;  ///< -1: it is closed, and no third region touches it
  bool isClosed() const { return startNode < 0; }
};

/// Where three regions or more meet.
struct BorderNode {
  glm::ivec2 corner{0};
  /// By way: the border that leaves in it, twice its number, plus 1 where it ends here; -1: none.
  std::array<int, 4> leaving{-1, -1, -1, -1};
};

struct PixelBorders {
  std::vector<PixelBorder> borders;
  std::vector<BorderNode> nodes;
};

/// The id of a pixel of a map whose ids are 0 or more; kOutside beyond it.
struct IdGrid {
  glm::ivec2 size{0};
  std::span<const int> ids;
  int at(int x, int y) const;
};

/// Whether the pixels above left and below right of a corner hang together there, where two ids lie crosswise: those
/// do of which fewer are around.
bool joinsDown(const IdGrid& grid, glm::ivec2 corner);
/// True where two ids lie crosswise around a corner.
bool isCrosswise(const IdGrid& grid, glm::ivec2 corner);

/// All borders, each once. Any thread, linear in pixels.
PixelBorders findPixelBorders(const IdGrid& grid);

/// Which way an edge between two neighbouring corners goes: an index of kWays.
int wayOf(glm::ivec2 from, glm::ivec2 to);

}  // namespace velum::vector
