#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

#include "membrane/forces/LeastCut.h"

namespace velum::membrane {

/// Maximum flow through the nodes of a lattice that hold something, by the pairs between them; edges down a column have
/// infinite capacity, also across nodes that hold nothing. Neighbours in other columns are kept by number; those in the
/// same column follow each other.
///
/// Incremental breadth-first search [IBFS]: trees of shortest paths grow from both terminals by turns, a path is filled
/// where they meet, and nodes that lose their way home are adopted at the smallest distance possible. Nodes that hold
/// nothing cost nothing: memory and time grow with the number of nodes that hold something, not with the lattice.
class ColumnFlow {
 public:
  enum Side : std::uint8_t {
    kOpen = 0,   ///< undecided: there are least cuts with the node above the sheet, and others with it below
    kBelow = 1,  ///< below the sheet in every least cut
    kAbove = 2   ///< above the sheet in every least cut
  };

  /// Nodes and capacities of a lattice. @param tieOf  which side the node in a column and layer is tied to, or kOpen
  /// @param metric  which capacities count: pairs alone, or also the diagonals across two axes
  ColumnFlow(const CutLattice& lattice, CutMetric metric,
             const std::function<Side(std::size_t column, int layer)>& tieOf);

  /// Computes the maximum flow: first within strips of the lattice, on all cores, then across them [MERGING].
  /// @param onPhase  called now and then, by one thread at a time; may throw, which leaves the flow useless
  void run(const std::function<void()>& onPhase);

  std::size_t count() const { return mNodes.size(); }
  Side side(std::size_t node) const { return Side(mNodes[node].tree); }
  /// The neighbours of a node. @param visit  gets the number of the neighbour, whether the neighbour must lie below the
  /// sheet wherever `node` does (or the sheet would cut more than it must), and whether `node` must wherever the
  /// neighbour does
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
    std::int16_t room[4] = {};  ///< residual capacity to the neighbours in `across`
    std::int32_t up = 0;        ///< residual capacity to the next node up the column
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
