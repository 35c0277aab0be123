#include "GridFlow.h"

#include <algorithm>
#include <limits>

namespace velum::membrane {

namespace {

constexpr std::uint8_t kRoot = 6, kOrphan = 7;
constexpr std::int32_t kInfinite = std::numeric_limits<std::int32_t>::max();
constexpr int kUp = 4, kDown = 5;
/// Nodes visited between two calls of onPhase: about a millisecond.
constexpr std::size_t kVisitsPerCall = 20000;

}  // namespace

GridFlow::GridFlow(glm::ivec3 dims)
    : mDims(dims), mNodes(std::size_t(dims.x + 2) * std::size_t(dims.y + 2) * std::size_t(dims.z + 2)) {
  std::ptrdiff_t z = 1, x = dims.z + 2, y = x * (dims.x + 2);
  std::ptrdiff_t offsets[6] = {x, -x, y, -y, z, -z};
  std::copy(std::begin(offsets), std::end(offsets), mOffset);
}

inline std::int32_t GridFlow::residual(std::uint32_t from, int direction) const {
  const Node& n = mNodes[from];
  if (direction < kUp) return n.side[direction];
  if (direction == kUp) return n.up;
  return mNodes[from - 1].tree == kDead ? 0 : kInfinite;
}

inline void GridFlow::push(std::uint32_t from, int direction, std::int32_t flow) {
  Node& n = mNodes[from];
  if (direction < kUp) {
    n.side[direction] -= flow;
    mNodes[std::size_t(std::ptrdiff_t(from) + mOffset[direction])].side[direction ^ 1] += flow;
  } else if (direction == kUp) {
    n.up -= flow;
  } else {
    mNodes[from - 1].up += flow;
  }
}

/// Sends up one column what it can carry: most of the flow, for one pass over the nodes.
void GridFlow::fillColumn(std::uint32_t bottom) {
  int count = mDims.z;
  mWanted.assign(std::size_t(count) + 1, 0);
  for (int z = count - 1; z >= 0; --z) {
    const Node& n = mNodes[bottom + std::uint32_t(z)];
    std::int64_t wanted = std::int64_t(std::max(-n.terminal, 0)) + std::min(n.up, mWanted[std::size_t(z) + 1]);
    mWanted[std::size_t(z)] = std::int32_t(std::min<std::int64_t>(wanted, kInfinite / 4));
  }
  std::int32_t carried = 0;
  for (int z = 0; z < count; ++z) {
    Node& n = mNodes[bottom + std::uint32_t(z)];
    if (n.tree == kDead) continue;
    std::int32_t own = std::clamp(mWanted[std::size_t(z)] - carried, 0, std::max(n.terminal, 0));
    n.terminal -= own;
    carried += own;
    std::int32_t kept = std::min(carried, std::max(-n.terminal, 0));
    n.terminal += kept;
    carried -= kept;
    n.up -= carried;
  }
}

void GridFlow::plantTrees() {
  for (int y = 0; y < mDims.y; ++y)
    for (int x = 0; x < mDims.x; ++x) {
      auto bottom = std::uint32_t(index(x, y, 0));
      fillColumn(bottom);
      for (std::uint32_t v = bottom; v < bottom + std::uint32_t(mDims.z); ++v) {
        Node& n = mNodes[v];
        if (n.tree == kDead || n.terminal == 0) continue;
        n.tree = n.terminal > 0 ? kSource : kSink;
        n.parent = kRoot;
        n.distance = 1;
        mFront[n.tree].push_back(v);
      }
    }
  mDistance[kSource] = mDistance[kSink] = 1;
}

void GridFlow::run(const std::function<void()>& onPhase) {
  plantTrees();
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
  while (!mFront[kSource].empty() && !mFront[kSink].empty())
    growCounted(mDistance[kSource] <= mDistance[kSink] ? kSource : kSink);
  // The flow is full. What the source still reaches is the lowest of the least cuts.
  while (!mFront[kSource].empty()) growCounted(kSource);
}

/// Lets a tree grow by one step in distance.
void GridFlow::grow(int tree) {
  mGrowing = tree;
  mNext.clear();
  for (std::size_t i = 0; i < mFront[tree].size(); ++i) visit(mFront[tree][i], tree);
  mFront[tree].swap(mNext);
  ++mDistance[tree];
  mGrowing = 0;
}

/// Takes free neighbours into the tree and fills the paths that open to the other tree.
void GridFlow::visit(std::uint32_t v, int tree) {
  auto isActive = [&] { return mNodes[v].tree == tree && mNodes[v].distance == mDistance[tree]; };
  for (int direction = 0; direction < 6 && isActive(); ++direction) {
    auto u = std::uint32_t(std::ptrdiff_t(v) + mOffset[direction]);
    Node& other = mNodes[u];
    if (other.tree == tree || other.tree == kDead) continue;
    while ((tree == kSource ? residual(v, direction) : residual(u, direction ^ 1)) > 0) {
      if (other.tree == kFree) {
        other.tree = std::uint8_t(tree);
        other.parent = std::uint8_t(direction ^ 1);
        other.distance = mDistance[tree] + 1;
        mNext.push_back(u);
      }
      if (other.tree == tree) break;
      if (tree == kSource)
        fillPath(v, direction, u);
      else
        fillPath(u, direction ^ 1, v);
      if (!isActive()) return;
    }
  }
}

std::int32_t GridFlow::bottleneck(std::uint32_t sourceSide, int direction, std::uint32_t sinkSide) const {
  std::int32_t flow = residual(sourceSide, direction);
  std::uint32_t v = sourceSide;
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    v = std::uint32_t(std::ptrdiff_t(v) + mOffset[d]);
    flow = std::min(flow, residual(v, d ^ 1));
  }
  flow = std::min(flow, mNodes[v].terminal);
  v = sinkSide;
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    flow = std::min(flow, residual(v, d));
    v = std::uint32_t(std::ptrdiff_t(v) + mOffset[d]);
  }
  return std::min(flow, -mNodes[v].terminal);
}

void GridFlow::orphan(std::uint32_t v) {
  Node& n = mNodes[v];
  n.parent = kOrphan;
  if (mOrphans.size() <= std::size_t(n.distance)) mOrphans.resize(std::size_t(n.distance) * 2 + 16);
  mOrphans[std::size_t(n.distance)].push_back(v);
  mFirstOrphan = std::min(mFirstOrphan, n.distance);
  mLastOrphan = std::max(mLastOrphan, n.distance);
}

/// Pushes flow between a node and its tree's terminal; nodes whose way home is full become orphans.
void GridFlow::pushAlong(std::uint32_t v, int tree, std::int32_t flow) {
  for (int d = mNodes[v].parent; d != kRoot; d = mNodes[v].parent) {
    auto home = std::uint32_t(std::ptrdiff_t(v) + mOffset[d]);
    std::uint32_t from = tree == kSource ? home : v;
    int direction = tree == kSource ? d ^ 1 : d;
    push(from, direction, flow);
    if (residual(from, direction) == 0) orphan(v);
    v = home;
  }
  mNodes[v].terminal -= tree == kSource ? flow : -flow;
  if (mNodes[v].terminal == 0) orphan(v);
}

void GridFlow::fillPath(std::uint32_t sourceSide, int direction, std::uint32_t sinkSide) {
  std::int32_t flow = bottleneck(sourceSide, direction, sinkSide);
  push(sourceSide, direction, flow);
  mFirstOrphan = kInfinite;
  pushAlong(sourceSide, kSource, flow);
  adoptOrphans(kSource);
  mFirstOrphan = kInfinite;
  pushAlong(sinkSide, kSink, flow);
  adoptOrphans(kSink);
}

void GridFlow::adoptOrphans(int tree) {
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
void GridFlow::adopt(std::uint32_t v, int tree) {
  Node& n = mNodes[v];
  std::int32_t nearest = kInfinite - 1;
  int parent = kOrphan;
  for (int direction = 0; direction < 6 && nearest >= n.distance; ++direction) {
    auto u = std::uint32_t(std::ptrdiff_t(v) + mOffset[direction]);
    const Node& other = mNodes[u];
    if (other.tree != tree || other.distance >= nearest) continue;
    if ((tree == kSource ? residual(u, direction ^ 1) : residual(v, direction)) == 0) continue;
    nearest = other.distance;
    parent = direction;
  }
  if (nearest + 1 == n.distance) {
    n.parent = std::uint8_t(parent);
    return;
  }
  // It moves away, so its children have to look for themselves.
  for (int direction = 0; direction < 6; ++direction) {
    auto u = std::uint32_t(std::ptrdiff_t(v) + mOffset[direction]);
    if (mNodes[u].tree == tree && mNodes[u].parent == (direction ^ 1)) orphan(u);
  }
  std::int32_t limit = mDistance[tree] + (mGrowing == tree ? 1 : 0);
  if (nearest + 1 > limit) {
    n.tree = kFree;
    return;
  }
  n.distance = nearest + 1;
  n.parent = std::uint8_t(parent);
  if (n.distance == mDistance[tree]) mFront[tree].push_back(v);
  if (n.distance > mDistance[tree]) mNext.push_back(v);
}

}  // namespace velum::membrane
