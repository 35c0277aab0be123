#include "vector/PixelBorders.h"

#include <algorithm>
#include <cstdint>

#include "core/Assert.h"
#include "vector/TraceRegions.h"

namespace velum::vector {

namespace {

/// The four pixels around a corner.
struct Around {
  int aboveLeft, aboveRight, belowLeft, belowRight;
  /// Whether an edge leaves the corner in a way between different ids.
  std::array<bool, 4> edges() const {
    return {aboveRight != belowRight, belowLeft != belowRight, aboveLeft != belowLeft, aboveLeft != aboveRight};
  }
  bool isEven() const { return aboveLeft == aboveRight && aboveLeft == belowLeft && aboveLeft == belowRight; }
  bool isCrosswise() const { return aboveLeft == belowRight && aboveRight == belowLeft && aboveLeft != aboveRight; }
  bool isNode() const {
    auto edge = edges();
    auto count = std::count(edge.begin(), edge.end(), true);
    return count == 3 || (count == 4 && !isCrosswise());
  }
};

Around aroundOf(const IdGrid& grid, glm::ivec2 c) {
  return {grid.at(c.x - 1, c.y - 1), grid.at(c.x, c.y - 1), grid.at(c.x - 1, c.y), grid.at(c.x, c.y)};
}

int idLeftOf(const IdGrid& grid, glm::ivec2 c, int way) {
  constexpr std::array<glm::ivec2, 4> kLeft{{{0, -1}, {0, 0}, {-1, 0}, {-1, -1}}};
  glm::ivec2 pixel = c + kLeft[std::size_t(way)];
  return grid.at(pixel.x, pixel.y);
}
int idRightOf(const IdGrid& grid, glm::ivec2 c, int way) {
  constexpr std::array<glm::ivec2, 4> kRight{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  glm::ivec2 pixel = c + kRight[std::size_t(way)];
  return grid.at(pixel.x, pixel.y);
}

/// Walks along borders and marks the edges that it has passed.
class Walk {
 public:
  explicit Walk(const IdGrid& grid) : mGrid(grid), mSeen(std::size_t(grid.size.x + 1) * std::size_t(grid.size.y + 1)) {}

  PixelBorders all() {
    findNodes();
    for (int node = 0; node < int(mFound.nodes.size()); ++node)
      for (int way = 0; way < 4; ++way) {
        glm::ivec2 corner = mFound.nodes[std::size_t(node)].corner;
        if (aroundOf(mGrid, corner).edges()[std::size_t(way)] && mark(corner, way)) walk(corner, way, node);
      }
    for (int y = 0; y <= mGrid.size.y; ++y)
      for (int x = 0; x <= mGrid.size.x; ++x)
        if (mSeen[indexOf({x, y})] & kAsks)
          for (int way = 0; way < 2; ++way)
            if (aroundOf(mGrid, {x, y}).edges()[std::size_t(way)] && mark({x, y}, way)) walk({x, y}, way, -1);
    return std::move(mFound);
  }

 private:
  static constexpr std::uint8_t kAsks = 4;  // besides the marks of the edges to the right and down: there are edges

  std::size_t indexOf(glm::ivec2 c) const {
    return std::size_t(c.y) * std::size_t(mGrid.size.x + 1) + std::size_t(c.x);
  }

  /// Returns true where an edge was not marked before.
  bool mark(glm::ivec2 c, int way) {
    if (way >= 2) c += kWays[std::size_t(way)];
    std::uint8_t& seen = mSeen[indexOf(c)];
    auto bit = std::uint8_t(way % 2 == 0 ? 1 : 2);
    bool isNew = (seen & bit) == 0;
    seen |= bit;
    return isNew;
  }

  void findNodes() {
    for (int y = 0; y <= mGrid.size.y; ++y)
      for (int x = 0; x <= mGrid.size.x; ++x) {
        Around around = aroundOf(mGrid, {x, y});
        if (around.isEven()) continue;
        mSeen[indexOf({x, y})] |= kAsks;
        if (around.isNode()) mFound.nodes.push_back({{x, y}, {-1, -1, -1, -1}});
      }
  }

  int nodeAt(glm::ivec2 c) const {
    auto isBefore = [](const BorderNode& node, glm::ivec2 p) {
      return node.corner.y != p.y ? node.corner.y < p.y : node.corner.x < p.x;
    };
    auto found = std::lower_bound(mFound.nodes.begin(), mFound.nodes.end(), c, isBefore);
    return found != mFound.nodes.end() && found->corner == c ? int(found - mFound.nodes.begin()) : -1;
  }

  /// The way on from a corner that is no node.
  int next(const Around& around, glm::ivec2 c, int way) const {
    if (around.isCrosswise()) {
      // One turns around the pixels that stand alone.
      constexpr std::array<int, 4> kJoinedDown{1, 0, 3, 2}, kJoinedUp{3, 2, 1, 0};  // by way in which one comes
      return (joinsDown(mGrid, c) ? kJoinedDown : kJoinedUp)[std::size_t(way)];
    }
    auto edges = around.edges();
    for (int turn : {0, 1, 3})
      if (edges[std::size_t((way + turn) % 4)]) return (way + turn) % 4;
    VELUM_ASSERT(false, "a border goes on");
    return way;
  }

  /// Follows a border from a node, or (-1) all round.
  void walk(glm::ivec2 start, int startWay, int node) {
    int number = int(mFound.borders.size());
    PixelBorder border;
    border.left = idLeftOf(mGrid, start, startWay);
    border.right = idRightOf(mGrid, start, startWay);
    border.corners.push_back(start);
    glm::ivec2 at = start;
    int way = startWay;
    for (;;) {
      mark(at, way);
      at += kWays[std::size_t(way)];
      border.corners.push_back(at);
      Around around = aroundOf(mGrid, at);
      if (around.isNode()) {
        border.startNode = node;
        border.endNode = nodeAt(at);
        mFound.nodes[std::size_t(node)].leaving[std::size_t(startWay)] = 2 * number;
        mFound.nodes[std::size_t(border.endNode)].leaving[std::size_t((way + 2) % 4)] = 2 * number + 1;
        break;
      }
      way = next(around, at, way);
      if (node < 0 && at == start && way == startWay) break;
    }
    mFound.borders.push_back(std::move(border));
  }

  const IdGrid& mGrid;
  std::vector<std::uint8_t> mSeen;
  PixelBorders mFound;
};

}  // namespace

int IdGrid::at(int x, int y) const {
  bool isInside = x >= 0 && y >= 0 && x < size.x && y < size.y;
  return isInside ? ids[std::size_t(y) * std::size_t(size.x) + std::size_t(x)] : kOutside;
}

bool isCrosswise(const IdGrid& grid, glm::ivec2 corner) { return aroundOf(grid, corner).isCrosswise(); }

bool joinsDown(const IdGrid& grid, glm::ivec2 corner) {
  Around around = aroundOf(grid, corner);
  int down = 0, up = 0;
  for (int y = -2; y < 2; ++y)
    for (int x = -2; x < 2; ++x) {
      int id = grid.at(corner.x + x, corner.y + y);
      if (id == around.aboveLeft) ++down;
      if (id == around.aboveRight) ++up;
    }
  return down != up ? down < up : around.aboveLeft > around.aboveRight;
}

PixelBorders findPixelBorders(const IdGrid& grid) { return Walk(grid).all(); }

int wayOf(glm::ivec2 from, glm::ivec2 to) {
  for (int way = 0; way < 4; ++way)
    if (from + kWays[std::size_t(way)] == to) return way;
  VELUM_ASSERT(false, "corners are neighbours");
  return 0;
}

}  // namespace velum::vector
