#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace velum::membrane {

/// Maximum flow through a lattice of columns: a node is joined to its six neighbours and, by `terminal`, to source or
/// sink; edges down a column are infinite. No edge lists: an edge is a direction.
///
/// Incremental breadth-first search [IBFS]: trees of shortest paths grow from both terminals by turns, a path is filled
/// where they meet, and nodes that lose their way home are adopted at the smallest distance possible.
class GridFlow {
 public:
  /// Directions are 0 +x, 1 -x, 2 +y, 3 -y, 4 +z (up), 5 -z; the opposite is `direction ^ 1`.
  struct Node {
    std::int32_t side[4] = {};  ///< residual capacity to the neighbours across
    std::int32_t up = 0;        ///< and to the node above
    std::int32_t terminal = 0;  ///< > 0 from the source, < 0 to the sink
    std::int32_t distance = 0;
    std::uint8_t tree = kDead;
    std::uint8_t parent = 0;
  };
  static constexpr std::uint8_t kFree = 0, kSource = 1, kSink = 2, kDead = 3;

  /// Nodes of dims, all dead: no flow goes through them.
  explicit GridFlow(glm::ivec3 dims);

  glm::ivec3 dims() const { return mDims; }
  /// The node at a place; one step outside the lattice is allowed, and dead.
  Node& node(int x, int y, int z) { return mNodes[index(x, y, z)]; }
  const Node& node(int x, int y, int z) const { return mNodes[index(x, y, z)]; }

  /// Fills the lattice; afterwards exactly the nodes that the source still reaches are in tree kSource.
  /// @param onPhase  called now and then; may throw, which leaves the lattice useless
  void run(const std::function<void()>& onPhase);

 private:
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(y + 1) * std::size_t(mDims.x + 2) + std::size_t(x + 1)) * std::size_t(mDims.z + 2) +
           std::size_t(z + 1);
  }
  std::int32_t residual(std::uint32_t from, int direction) const;
  void push(std::uint32_t from, int direction, std::int32_t flow);
  void fillColumn(std::uint32_t bottom);
  void plantTrees();
  void grow(int tree);
  void visit(std::uint32_t v, int tree);
  void fillPath(std::uint32_t sourceSide, int direction, std::uint32_t sinkSide);
  std::int32_t bottleneck(std::uint32_t sourceSide, int direction, std::uint32_t sinkSide) const;
  void pushAlong(std::uint32_t v, int tree, std::int32_t flow);
  void orphan(std::uint32_t v);
  void adoptOrphans(int tree);
  void adopt(std::uint32_t v, int tree);

  glm::ivec3 mDims;
  std::vector<Node> mNodes;
  std::ptrdiff_t mOffset[6];
  std::vector<std::uint32_t> mFront[3];  ///< nodes at the tree's largest whole distance
  std::vector<std::uint32_t> mNext;      ///< nodes one further, while the tree grows
  std::int32_t mDistance[3] = {};
  int mGrowing = 0;
  std::vector<std::vector<std::uint32_t>> mOrphans;  ///< by distance
  std::int32_t mFirstOrphan = 0, mLastOrphan = -1;
  std::vector<std::int32_t> mWanted;  ///< scratch of fillColumn
};

}  // namespace velum::membrane
