#include "membrane/forces/ColumnFlow.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "core/Parallel.h"

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
constexpr int kMostFlowLayers = 1;

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

/// From the rest plane to the edge above a node, up to kMostFlowLayers.
int layersAway(const CutLattice& lattice, int layer) {
  return int(std::min(std::abs(layer + 0.5 - lattice.restLayer), double(kMostFlowLayers)));
}

/// Nodes visited between two calls of onPhase: about a millisecond.
constexpr std::size_t kVisitsPerCall = 20000;

/// Nodes of the smallest strips (about 5 MB), and how many times larger the next ones are.
constexpr std::size_t kStrip = 50000, kStripGrowth = 4;

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
    }
  for (int y = 0; y <= lattice.dims.y; ++y)
    mRows.push_back(lattice.first[std::size_t(y) * std::size_t(lattice.dims.x)]);
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

/// The search for paths among the nodes of a range.
class ColumnFlow::Search {
 public:
  Search(ColumnFlow& flow, std::uint32_t first, std::uint32_t end) : mFlow(flow), mFirst(first), mCount(end - first) {
    for (std::uint32_t v = first; v < end; ++v) {
      Node& n = place(v);
      if (n.parent == kRoot)
        mFront[n.tree].push_back(v);
      else
        n.tree = kOpen;
    }
  }
  /// Fills all paths within the range.
  void run(const std::function<void()>& onPhase);

 private:
  Node& place(std::uint32_t v) { return mFlow.mNodes[v]; }
  const Node& place(std::uint32_t v) const { return mFlow.mNodes[v]; }
  std::uint32_t next(std::uint32_t v, int direction) const {
    std::uint32_t u = mFlow.next(v, direction);
    return u - mFirst < mCount ? u : kNone;
  }
  std::int32_t residual(std::uint32_t from, int direction) const { return mFlow.residual(from, direction); }
  int directions() const { return mFlow.directions(); }
  void grow(int tree);
  void visit(std::uint32_t v, int tree);
  void fillPath(std::uint32_t below, int direction, std::uint32_t above);
  std::int32_t bottleneck(std::uint32_t below, int direction, std::uint32_t above) const;
  void pushAlong(std::uint32_t v, int tree, std::int32_t flow);
  void orphan(std::uint32_t v);
  void adoptOrphans(int tree);
  void adopt(std::uint32_t v, int tree);

  ColumnFlow& mFlow;
  std::uint32_t mFirst, mCount;
  std::vector<std::uint32_t> mFront[3];  ///< nodes at the tree's largest whole distance
  std::vector<std::uint32_t> mNext;      ///< nodes one further, while the tree grows
  std::int32_t mDistance[3] = {1, 1, 1};
  int mGrowing = 0;
  std::vector<std::vector<std::uint32_t>> mOrphans;  ///< by distance
  std::int32_t mFirstOrphan = 0, mLastOrphan = -1;
};

void ColumnFlow::run(const std::function<void()>& onPhase) {
  std::mutex mutex;
  auto tell = [&] {
    std::lock_guard lock(mutex);
    onPhase();
  };
  // Of a small tree little loses its way, and it stays in the cache; every other time strips lie across the seams.
  for (std::size_t size = kStrip; size < count() / 2; size *= kStripGrowth)
    for (std::size_t first : {size, size / 2}) {
      std::vector<std::uint32_t> strips = stripsOf(first, size);
      parallelFor(std::size_t(1), strips.size(),
                  [&](std::size_t i) { Search(*this, strips[i - 1], strips[i]).run(tell); });
    }
  Search(*this, 0, std::uint32_t(count())).run(tell);
}

/// Whole rows of columns, with about so many nodes. @return where each strip begins, and the end
std::vector<std::uint32_t> ColumnFlow::stripsOf(std::size_t first, std::size_t size) const {
  std::vector<std::uint32_t> strips{0};
  for (std::uint32_t row : mRows)
    if (row >= strips.back() + (strips.size() == 1 ? first : size)) strips.push_back(row);
  strips.push_back(std::uint32_t(count()));
  return strips;
}

void ColumnFlow::Search::run(const std::function<void()>& onPhase) {
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
void ColumnFlow::Search::grow(int tree) {
  mGrowing = tree;
  mNext.clear();
  for (std::size_t i = 0; i < mFront[tree].size(); ++i) visit(mFront[tree][i], tree);
  mFront[tree].swap(mNext);
  ++mDistance[tree];
  mGrowing = 0;
}

/// Takes free neighbours into the tree and fills the paths that open to the other tree.
void ColumnFlow::Search::visit(std::uint32_t v, int tree) {
  auto isActive = [&] { return place(v).tree == tree && place(v).distance == mDistance[tree]; };
  for (int direction = 0; direction < directions() && isActive(); ++direction) {
    std::uint32_t u = next(v, direction);
    if (u == kNone || place(u).tree == tree) continue;
    Node& other = place(u);
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

std::int32_t ColumnFlow::Search::bottleneck(std::uint32_t below, int direction, std::uint32_t above) const {
  std::int32_t flow = residual(below, direction);
  std::uint32_t v = below;
  for (int d = place(v).parent; d != kRoot; d = place(v).parent) {
    v = next(v, d);
    flow = std::min(flow, residual(v, d ^ 1));
  }
  v = above;
  for (int d = place(v).parent; d != kRoot; d = place(v).parent) {
    flow = std::min(flow, residual(v, d));
    v = next(v, d);
  }
  return flow;
}

void ColumnFlow::Search::orphan(std::uint32_t v) {
  Node& n = place(v);
  n.parent = kOrphan;
  if (mOrphans.size() <= std::size_t(n.distance)) mOrphans.resize(std::size_t(n.distance) * 2 + 16);
  mOrphans[std::size_t(n.distance)].push_back(v);
  mFirstOrphan = std::min(mFirstOrphan, n.distance);
  mLastOrphan = std::max(mLastOrphan, n.distance);
}

/// Pushes flow between a node and its tree's terminal; nodes whose way home is full become orphans.
void ColumnFlow::Search::pushAlong(std::uint32_t v, int tree, std::int32_t flow) {
  for (int d = place(v).parent; d != kRoot; d = place(v).parent) {
    std::uint32_t home = next(v, d), from = tree == kBelow ? home : v;
    int direction = tree == kBelow ? d ^ 1 : d;
    mFlow.push(from, direction, flow);
    if (residual(from, direction) == 0) orphan(v);
    v = home;
  }
}

void ColumnFlow::Search::fillPath(std::uint32_t below, int direction, std::uint32_t above) {
  std::int32_t flow = bottleneck(below, direction, above);
  mFlow.push(below, direction, flow);
  mFirstOrphan = kInfinite;
  pushAlong(below, kBelow, flow);
  adoptOrphans(kBelow);
  mFirstOrphan = kInfinite;
  pushAlong(above, kAbove, flow);
  adoptOrphans(kAbove);
}

void ColumnFlow::Search::adoptOrphans(int tree) {
  for (std::int32_t d = mFirstOrphan; d <= mLastOrphan; ++d) {
    // Adoption adds orphans at larger distances only.
    for (std::size_t i = 0; i < mOrphans[std::size_t(d)].size(); ++i) {
      std::uint32_t v = mOrphans[std::size_t(d)][i];
      if (place(v).parent == kOrphan) adopt(v, tree);
    }
    mOrphans[std::size_t(d)].clear();
  }
  mLastOrphan = -1;
}

/// Finds an orphan a new parent as near to the terminal as possible, or sets it free.
void ColumnFlow::Search::adopt(std::uint32_t v, int tree) {
  Node& n = place(v);
  std::int32_t nearest = kInfinite - 1;
  int parent = kOrphan;
  for (int direction = 0; direction < directions() && nearest >= n.distance; ++direction) {
    std::uint32_t u = next(v, direction);
    if (u == kNone || place(u).tree != tree || place(u).distance >= nearest) continue;
    if ((tree == kBelow ? residual(u, direction ^ 1) : residual(v, direction)) == 0) continue;
    nearest = place(u).distance;
    parent = direction;
  }
  if (nearest + 1 == n.distance) {
    n.parent = std::uint8_t(parent);
    return;
  }
  // It moves away, so its children have to look for themselves.
  for (int direction = 0; direction < directions(); ++direction) {
    std::uint32_t u = next(v, direction);
    if (u != kNone && place(u).tree == tree && place(u).parent == (direction ^ 1)) orphan(u);
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
