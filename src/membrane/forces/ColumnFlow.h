#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// Maximum flow through the nodes of a lattice that hold something, by the pairs between them; edges down a column are
/// infinite, over whatever lies between. Neighbours across are kept by number, those in a column follow each other.
///
/// Incremental breadth-first search [IBFS]: trees of shortest paths grow from both terminals by turns, a path is filled
/// where they meet, and nodes that lose their way home are adopted at the smallest distance possible. What there is
/// none of costs nothing: memory and time go with the nodes, not with the lattice.
class ColumnFlow {
 public:
  enum Side : std::uint8_t {
    kOpen = 0,   ///< both are least cuts: above it, and below it
    kBelow = 1,  ///< below the sheet in every least cut
    kAbove = 2   ///< above it in every one
  };

  /// Nodes and capacities of a lattice. @param tieOf  which side a node is tied to, or kOpen: of column and layer
  /// @param metric  what is filled: pairs alone, or by them and what lies across two axes
  ColumnFlow(const CutLattice& lattice, CutMetric metric,
             const std::function<Side(std::size_t column, int layer)>& tieOf);

  /// Fills the lattice: first strips of it, on all cores, then what lies across them [MERGING].
  /// @param onPhase  called now and then, by one thread at a time; may throw, which leaves the flow useless
  void run(const std::function<void()>& onPhase);

  std::size_t count() const { return mNodes.size(); }
  Side side(std::size_t node) const { return Side(mNodes[node].tree); }
  /// The neighbours of a node. @param visit  gets their number, whether they must lie below wherever `node` does, lest
  /// the sheet cuts more than it must, and the same the other way round
  template <class Visit>
  void forEachNeighbour(std::size_t node, Visit visit) const {
    auto v = std::uint32_t(node);
    for (int direction = 0; direction < directions(); ++direction) {
      std::uint32_t u = next(v, direction);
      if (u != kNone) visit(std::size_t(u), residual(v, direction) > 0, residual(u, direction ^ 1) > 0);
    }
  }

 private:
  class Search;

  /// Directions are 0 up, 1 down, 2 +x, 3 -x, 4 +y, 5 -y, and the twelve across two axes; the opposite is
  /// `direction ^ 1`.
  struct Node {
    std::uint32_t across[4] = {kNone, kNone, kNone, kNone};
    std::int16_t room[4] = {};  ///< residual capacity to them
    std::int32_t up = 0;        ///< and to the next node up the column
    std::int32_t distance = 0;
    std::uint8_t tree = kOpen, parent = 0;
    bool hasBelow = false, hasAbove = false;
  };
  static constexpr std::uint32_t kNone = 0xffffffff;
  static constexpr std::int32_t kInfinite = std::numeric_limits<std::int32_t>::max();
  /// A node's edges across two axes.
  struct Diagonals {
    Diagonals() { std::fill(std::begin(across), std::end(across), kNone); }
    std::uint32_t across[12];
    std::int16_t room[12] = {};
  };
  static constexpr int kUp = 0, kAcross = 2, kDiagonal = 6;

  int directions() const { return mDiagonals.empty() ? kDiagonal : kDiagonal + int(std::size(mDiagonals[0].across)); }
  bool isSmooth() const { return !mDiagonals.empty(); }
  void join(const CutLattice& lattice, std::size_t column);
  std::vector<std::uint32_t> stripsOf(std::size_t first, std::size_t size) const;
  void joinAcross(const CutLattice& lattice, glm::ivec2 at, int direction);
  std::uint32_t next(std::uint32_t node, int direction) const {
    if (direction >= kAcross) return across(node, direction);
    if (direction == kUp) return mNodes[node].hasAbove ? node + 1 : kNone;
    return mNodes[node].hasBelow ? node - 1 : kNone;
  }
  std::int32_t residual(std::uint32_t from, int direction) const {
    if (direction >= kAcross) return room(from, direction);
    if (direction == kUp) return mNodes[from].up;
    return mNodes[from].hasBelow ? kInfinite : 0;
  }
  void push(std::uint32_t from, int direction, std::int32_t flow);

  std::uint32_t across(std::uint32_t node, int direction) const {
    return direction < kDiagonal ? mNodes[node].across[direction - kAcross]
                                 : mDiagonals[node].across[direction - kDiagonal];
  }
  std::uint32_t& across(std::uint32_t node, int direction) {
    return direction < kDiagonal ? mNodes[node].across[direction - kAcross]
                                 : mDiagonals[node].across[direction - kDiagonal];
  }
  std::int16_t room(std::uint32_t node, int direction) const {
    return direction < kDiagonal ? mNodes[node].room[direction - kAcross]
                                 : mDiagonals[node].room[direction - kDiagonal];
  }
  std::int16_t& room(std::uint32_t node, int direction) {
    return direction < kDiagonal ? mNodes[node].room[direction - kAcross]
                                 : mDiagonals[node].room[direction - kDiagonal];
  }

  std::vector<std::uint32_t> mRows;  ///< the first node of each row of columns, and the end
  std::vector<Node> mNodes;
  std::vector<Diagonals> mDiagonals;  ///< empty where pairs alone count
};

}  // namespace velum::membrane
