#include "ColumnFlow.h"

#include <algorithm>
#include <cmath>

#include "velum/core/Parallel.h"

namespace velum::membrane {

namespace {

constexpr std::uint8_t kRoot = 30, kOrphan = 31;
/// The way to a neighbour, by direction; directions are numbered in the header.
constexpr int kSteps[18][3] = {{0, 0, 1},  {0, 0, -1},  {1, 0, 0},  {-1, 0, 0},  {0, 1, 0},  {0, -1, 0},
                               {1, 1, 0},  {-1, -1, 0}, {1, -1, 0}, {-1, 1, 0},  {1, 0, 1},  {-1, 0, -1},
                               {1, 0, -1}, {-1, 0, 1},  {0, 1, 1},  {0, -1, -1}, {0, 1, -1}, {0, -1, 1}};
/// What half a pair weighs along an axis and across two: a cut costs up to 1.20 times what one of the same area in
/// another direction does, which is nearly the least there is with these neighbours (1.19 by solid angles, [MINSURF]);
/// 1.73 where pairs alone count.
constexpr int kStraight = 5, kSlanted = 4;
/// Up a column it weighs as many more as there are layers to the rest plane, up to so many. Where all heights cost the
/// same the edge at the rest plane fills, and no other; else all would at once, each node would lose its way home, and
/// the flow through solid material took three times as long.
constexpr int kMostLayers = 1;

/// What lies between two nodes across two axes, in halves of pairs: as much as on the better way around the corner.
int pairsAround(const CutLattice& lattice, glm::ivec3 node, glm::ivec3 step) {
  auto between = [&](glm::ivec3 from, int axis) {
    if (step[axis] < 0) --from[axis];
    auto found = nodeAt(lattice, from);
    return found ? int(lattice.pairs[axis][*found]) : 0;
  };
  int first = step.x ? 0 : 1, second = step.z ? 2 : 1;
  glm::ivec3 byFirst = node, bySecond = node;
  byFirst[first] += step[first];
  bySecond[second] += step[second];
  return std::max(std::min(between(node, first), between(byFirst, second)),
                  std::min(between(node, second), between(bySecond, first)));
}

/// From the rest plane to the edge above a node, up to kMostLayers.
int layersAway(const CutLattice& lattice, int layer) {
  return int(std::min(std::abs(layer + 0.5 - lattice.restLayer), double(kMostLayers)));
}

/// Nodes visited between two calls of onPhase: about a millisecond.
constexpr std::size_t kVisitsPerCall = 20000;

}  // namespace

ColumnFlow::ColumnFlow(const CutLattice& lattice, CutMetric metric, const std::function<Side(std::size_t, int)>& tieOf)
    : mNodes(lattice.layer.size()) {
  if (metric == CutMetric::Smooth) mDiagonals.resize(mNodes.size());
  parallelFor(std::size_t(0), lattice.first.size() - 1, [&](std::size_t column) { join(lattice, column); });
  for (std::size_t column = 0; column + 1 < lattice.first.size(); ++column)
    for (std::uint32_t v = lattice.first[column]; v < lattice.first[column + 1]; ++v) {
      Side tie = tieOf(column, lattice.layer[v]);
      if (tie == kOpen) continue;
      mNodes[v].tree = tie;
      mNodes[v].parent = kRoot;
      mNodes[v].distance = 1;
      mFront[tie].push_back(v);
    }
  mDistance[kBelow] = mDistance[kAbove] = 1;
}

/// Edges of a column's nodes; each column writes to its own nodes only.
void ColumnFlow::join(const CutLattice& lattice, std::size_t column) {
  std::uint32_t first = lattice.first[column], end = lattice.first[column + 1];
  for (std::uint32_t v = first; v < end; ++v) {
    mNodes[v].hasBelow = v > first;
    mNodes[v].hasAbove = v + 1 < end;
    mNodes[v].up = lattice.pairs[2][v] * (isSmooth() ? kStraight + layersAway(lattice, lattice.layer[v]) : 1);
  }
  auto width = std::size_t(lattice.dims.x);
  glm::ivec2 at(column % width, column / width);
  for (int direction = kAcross; direction < directions(); ++direction) joinAcross(lattice, at, direction);
}

/// Edges of a column's nodes to those of another one, in one direction.
void ColumnFlow::joinAcross(const CutLattice& lattice, glm::ivec2 at, int direction) {
  glm::ivec3 step(kSteps[direction][0], kSteps[direction][1], kSteps[direction][2]);
  glm::ivec2 there = at + glm::ivec2(step);
  if (there.x < 0 || there.y < 0 || there.x >= lattice.dims.x || there.y >= lattice.dims.y) return;
  auto columnAt = [&](glm::ivec2 p) { return std::size_t(p.y) * std::size_t(lattice.dims.x) + std::size_t(p.x); };
  std::size_t column = columnAt(at), other = columnAt(there);
  std::uint32_t v = lattice.first[column], u = lattice.first[other];
  std::uint32_t end = lattice.first[column + 1], otherEnd = lattice.first[other + 1];
  while (v < end && u < otherEnd) {
    int apart = int(lattice.layer[v]) + step.z - int(lattice.layer[u]);
    if (apart == 0) {
      int weight = direction < kDiagonal ? (isSmooth() ? kStraight : 1) * lattice.pairs[step.x ? 0 : 1][std::min(v, u)]
                                         : kSlanted * pairsAround(lattice, glm::ivec3(at, lattice.layer[v]), step);
      if (weight > 0) {
        across(v, direction) = u;
        room(v, direction) = std::int16_t(weight);
      }
    }
    v += apart <= 0;
    u += apart >= 0;
  }
}

inline void ColumnFlow::push(std::uint32_t from, int direction, std::int32_t flow) {
  if (direction >= kAcross) {
    std::int16_t &forth = room(from, direction), &back = room(next(from, direction), direction ^ 1);
    forth = std::int16_t(forth - flow);
    back = std::int16_t(back + flow);
  } else if (direction == kUp) {
    mNodes[from].up -= flow;
  } else {
    mNodes[from - 1].up += flow;
  }
}

void ColumnFlow::run(const std::function<void()>& onPhase) {
  std::size_t visited = 0;
  auto growCounted = [&](int tree) {
    visited += mFront[tree].size();
    if (visited > kVisitsPerCall) {
      onPhase();
      visited = 0;
    }
    grow(tree);
  };
  // By turns, so that both trees stay shallow: of one large tree far more would lose its way at each path (two to four
  // times as long on lattices of tubes).
  while (!mFront[kBelow].empty() && !mFront[kAbove].empty())
    growCounted(mDistance[kBelow] <= mDistance[kAbove] ? kBelow : kAbove);
  // The flow is full. What a terminal still reaches is on its side in every least cut.
  for (int tree : {kBelow, kAbove})
    while (!mFront[tree].empty()) growCounted(tree);
}

/// Lets a tree grow by one step in distance.
void ColumnFlow::grow(int tree) {
  mGrowing = tree;
  mNext.clear();
  for (std::size_t i = 0; i < mFront[tree].size(); ++i) visit(mFront[tree][i], tree);
  mFront[tree].swap(mNext);
  ++mDistance[tree];
  mGrowing = 0;
}

/// Takes free neighbours into the tree and fills the paths that open to the other tree.
void ColumnFlow::visit(std::uint32_t v, int tree) {
  auto isActive = [&] { return mNodes[v].tree == tree && mNodes[v].distance == mDistance[tree]; };
  for (int direction = 0; direction < directions() && isActive(); ++direction) {
    std::uint32_t u = next(v, direction);
    if (u == kNone || mNodes[u].tree == tree) continue;
    Node& other = mNodes[u];
    while ((tree == kBelow ? residual(v, direction) : residual(u, direction ^ 1)) > 0) {
      if (other.tree == kOpen) {
        other.tree = std::uint8_t(tree);
        other.parent = std::uint8_t(direction ^ 1);
        other.distance = mDistance[tree] + 1;
        mNext.push_back(u);
      }
      if (other.tree == tree) break;
      if (tree == kBelow)
        fillPath(v, direction, u);
      else
        fillPath(u, direction ^ 1, v);
      if (!isActive()) return;
    }
  }
}

std::int32_t ColumnFlow::bottleneck(std::uint32_t below, int direction, std::uint32_t above) const {
  std::int32_t flow = residual(below, direction);
  std::uint32_t v = below;
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    v = next(v, d);
    flow = std::min(flow, residual(v, d ^ 1));
  }
  v = above;
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    flow = std::min(flow, residual(v, d));
    v = next(v, d);
  }
  return flow;
}

void ColumnFlow::orphan(std::uint32_t v) {
  Node& n = mNodes[v];
  n.parent = kOrphan;
  if (mOrphans.size() <= std::size_t(n.distance)) mOrphans.resize(std::size_t(n.distance) * 2 + 16);
  mOrphans[std::size_t(n.distance)].push_back(v);
  mFirstOrphan = std::min(mFirstOrphan, n.distance);
  mLastOrphan = std::max(mLastOrphan, n.distance);
}

/// Pushes flow between a node and its tree's terminal; nodes whose way home is full become orphans.
void ColumnFlow::pushAlong(std::uint32_t v, int tree, std::int32_t flow) {
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    std::uint32_t home = next(v, d), from = tree == kBelow ? home : v;
    int direction = tree == kBelow ? d ^ 1 : d;
    push(from, direction, flow);
    if (residual(from, direction) == 0) orphan(v);
    v = home;
  }
}

void ColumnFlow::fillPath(std::uint32_t below, int direction, std::uint32_t above) {
  std::int32_t flow = bottleneck(below, direction, above);
  push(below, direction, flow);
  mFirstOrphan = kInfinite;
  pushAlong(below, kBelow, flow);
  adoptOrphans(kBelow);
  mFirstOrphan = kInfinite;
  pushAlong(above, kAbove, flow);
  adoptOrphans(kAbove);
}

void ColumnFlow::adoptOrphans(int tree) {
  for (std::int32_t d = mFirstOrphan; d <= mLastOrphan; ++d) {
    // Adoption adds orphans at larger distances only.
    for (std::size_t i = 0; i < mOrphans[std::size_t(d)].size(); ++i) {
      std::uint32_t v = mOrphans[std::size_t(d)][i];
      if (mNodes[v].parent == kOrphan) adopt(v, tree);
    }
    mOrphans[std::size_t(d)].clear();
  }
  mLastOrphan = -1;
}

/// Finds an orphan a new parent as near to the terminal as possible, or sets it free.
void ColumnFlow::adopt(std::uint32_t v, int tree) {
  Node& n = mNodes[v];
  std::int32_t nearest = kInfinite - 1;
  int parent = kOrphan;
  for (int direction = 0; direction < directions() && nearest >= n.distance; ++direction) {
    std::uint32_t u = next(v, direction);
    if (u == kNone || mNodes[u].tree != tree || mNodes[u].distance >= nearest) continue;
    if ((tree == kBelow ? residual(u, direction ^ 1) : residual(v, direction)) == 0) continue;
    nearest = mNodes[u].distance;
    parent = direction;
  }
  if (nearest + 1 == n.distance) {
    n.parent = std::uint8_t(parent);
    return;
  }
  // It moves away, so its children have to look for themselves.
  for (int direction = 0; direction < directions(); ++direction) {
    std::uint32_t u = next(v, direction);
    if (u != kNone && mNodes[u].tree == tree && mNodes[u].parent == (direction ^ 1)) orphan(u);
  }
  std::int32_t limit = mDistance[tree] + (mGrowing == tree ? 1 : 0);
  if (nearest + 1 > limit) {
    n.tree = kOpen;
    return;
  }
  n.distance = nearest + 1;
  n.parent = std::uint8_t(parent);
  if (n.distance == mDistance[tree]) mFront[tree].push_back(v);
  if (n.distance > mDistance[tree]) mNext.push_back(v);
}

}  // namespace velum::membrane
