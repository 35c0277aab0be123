#include "membrane/forces/OpenParts.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace velum::membrane {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Nodes that lie on one side together; each is known by one of them.
class Bundles {
 public:
  explicit Bundles(std::size_t count) : mParent(count) { std::iota(mParent.begin(), mParent.end(), 0u); }
  std::uint32_t of(std::size_t node) {
    auto v = std::uint32_t(node);
    while (mParent[v] != v) v = mParent[v] = mParent[mParent[v]];
    return v;
  }
  void join(std::size_t a, std::size_t b) {
    std::uint32_t u = of(a), v = of(b);
    mParent[std::max(u, v)] = std::min(u, v);
  }

 private:
  std::vector<std::uint32_t> mParent;
};

/// Below wherever the first one is.
using Follows = std::pair<std::uint32_t, std::uint32_t>;

/// The cheapest choice among bundles of which some follow others: a minimum cut, by Boost.
/// @param gain  of each bundle: what it is worth to have it below, or above where it is negative
/// @return 1 below, and where it makes no difference
std::vector<std::uint8_t> cheapestChoice(std::span<const std::int64_t> gain, std::span<const Follows> follows) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Edge = Traits::edge_descriptor;
  using VertexProperties =
      boost::property<boost::vertex_index_t, long,
                      boost::property<boost::vertex_color_t, boost::default_color_type,
                                      boost::property<boost::vertex_distance_t, long,
                                                      boost::property<boost::vertex_predecessor_t, Edge>>>>;
  using EdgeProperties = boost::property<
      boost::edge_capacity_t, std::int64_t,
      boost::property<boost::edge_residual_capacity_t, std::int64_t, boost::property<boost::edge_reverse_t, Edge>>>;
  using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, VertexProperties, EdgeProperties>;
  constexpr std::int64_t kInfinite = std::numeric_limits<std::int64_t>::max() / 4;
  std::size_t source = gain.size(), sink = source + 1;
  Graph graph(gain.size() + 2);
  auto capacity = boost::get(boost::edge_capacity, graph);
  auto reverse = boost::get(boost::edge_reverse, graph);
  auto join = [&](std::size_t a, std::size_t b, std::int64_t room) {
    Edge forth = boost::add_edge(a, b, graph).first, back = boost::add_edge(b, a, graph).first;
    capacity[forth] = room;
    capacity[back] = 0;
    reverse[forth] = back;
    reverse[back] = forth;
  };
  for (std::size_t i = 0; i < gain.size(); ++i) {
    if (gain[i] > 0) join(source, i, gain[i]);
    if (gain[i] < 0) join(i, sink, -gain[i]);
  }
  for (auto [first, then] : follows) join(first, then, kInfinite);
  boost::boykov_kolmogorov_max_flow(graph, source, sink);
  auto colour = boost::get(boost::vertex_color, graph);
  std::vector<std::uint8_t> below;
  for (std::size_t i = 0; i < gain.size(); ++i)
    below.push_back(colour[i] != boost::color_traits<boost::default_color_type>::white());
  return below;
}

class OpenParts {
 public:
  OpenParts(const CutLattice& lattice, const ColumnFlow& flow)
      : mLattice(lattice), mFlow(flow), mBundles(flow.count()), mDecided(flow.count(), 0) {
    for (std::size_t v = 0; v < flow.count(); ++v) mBelow.push_back(flow.side(v) == ColumnFlow::kBelow);
    for (std::size_t v = 0; v < flow.count(); ++v) {
      if (!isOpen(v)) continue;
      mFlow.forEachNeighbour(v, [&](std::size_t u, bool forth, bool back) {
        if (u > v && isOpen(u) && forth && back) mBundles.join(u, v);
      });
    }
  }

  /// Puts the whole parts that the rest plane meets on one side, with what must follow them.
  void decideMet(bool below) {
    std::vector<std::uint8_t> known = findAttached();
    std::vector<std::size_t> decided;
    for (std::size_t v = 0; v < mFlow.count(); ++v) {
      if (!isOpen(v) || known[v]) continue;
      std::vector<std::size_t> part = partOf(v, known);
      if (isMet(part)) decided.insert(decided.end(), part.begin(), part.end());
    }
    for (std::size_t v : decided) decide(v, below);
    while (!decided.empty()) {
      std::size_t v = decided.back();
      decided.pop_back();
      mFlow.forEachNeighbour(v, [&](std::size_t u, bool forth, bool back) {
        if (!(below ? forth : back) || !isOpen(u)) return;
        decide(u, below);
        decided.push_back(u);
      });
    }
  }

  void decideNearest() {
    std::vector<std::uint32_t> number(mFlow.count(), kNone);
    std::vector<std::int64_t> gain;
    std::vector<Follows> follows;
    auto numberOf = [&](std::size_t v) {
      std::uint32_t bundle = mBundles.of(v);
      if (number[bundle] == kNone) {
        number[bundle] = std::uint32_t(gain.size());
        gain.push_back(0);
      }
      return number[bundle];
    };
    int flat = flatCount(mLattice);
    for (std::size_t v = 0; v < mFlow.count(); ++v) {
      if (!isOpen(v)) continue;
      std::uint32_t own = numberOf(v);
      gain[own] += 2 * flat - 1 - 2 * mLattice.layer[v];
      mFlow.forEachNeighbour(v, [&](std::size_t u, bool forth, bool) {
        if (forth && isOpen(u) && numberOf(u) != own) follows.emplace_back(own, numberOf(u));
      });
    }
    std::sort(follows.begin(), follows.end());
    follows.erase(std::unique(follows.begin(), follows.end()), follows.end());
    std::vector<std::uint8_t> below = cheapestChoice(gain, follows);
    for (std::size_t v = 0; v < mFlow.count(); ++v)
      if (isOpen(v)) mBelow[v] = below[number[mBundles.of(v)]];
  }

  std::vector<std::uint8_t> below() && { return std::move(mBelow); }

 private:
  bool isOpen(std::size_t v) const { return mFlow.side(v) == ColumnFlow::kOpen && !mDecided[v]; }
  void decide(std::size_t v, bool below) {
    mDecided[v] = 1;
    mBelow[v] = below;
  }

  /// Marks the open nodes that hang together with decided ones.
  std::vector<std::uint8_t> findAttached() const {
    std::vector<std::uint8_t> attached(mFlow.count(), 0);
    for (std::size_t v = 0; v < mFlow.count(); ++v)
      if (!isOpen(v)) partOf(v, attached);
    return attached;
  }

  /// The open nodes that hang together with one, which is the first; marks them.
  std::vector<std::size_t> partOf(std::size_t first, std::vector<std::uint8_t>& known) const {
    std::vector<std::size_t> part{first};
    known[first] = 1;
    for (std::size_t i = 0; i < part.size(); ++i)
      forEachPair(part[i], [&](std::size_t u) {
        if (!isOpen(u) || known[u]) return;
        known[u] = 1;
        part.push_back(u);
      });
    return part;
  }

  /// It lies on both sides of the rest plane, and in the data.
  bool isMet(std::span<const std::size_t> part) const {
    int flat = flatCount(mLattice);
    auto isPlaced = [&](std::size_t v) { return !mLattice.isPlaced.empty() && mLattice.isPlaced[v]; };
    if (std::any_of(part.begin(), part.end(), isPlaced)) return false;
    auto isBehind = [&](std::size_t v) { return mLattice.layer[v] < flat; };
    return std::any_of(part.begin(), part.end(), isBehind) && !std::all_of(part.begin(), part.end(), isBehind);
  }

  /// The neighbours that a node has pairs with: not those across a gap in its column.
  template <class Visit>
  void forEachPair(std::size_t v, Visit visit) const {
    mFlow.forEachNeighbour(v, [&](std::size_t u, bool, bool) {
      bool isInColumn = u + 1 == v || v + 1 == u;
      if (isInColumn && mLattice.pairs[2][std::min(u, v)] == 0) {
        // The next number may also be the next column's first node, which is a neighbour by its own pairs.
        if (mLattice.layer[u] != mLattice.layer[v]) return;
      }
      visit(u);
    });
  }

  const CutLattice& mLattice;
  const ColumnFlow& mFlow;
  Bundles mBundles;
  std::vector<std::uint8_t> mBelow, mDecided;
};

}  // namespace

std::vector<std::uint8_t> decideOpenParts(const CutLattice& lattice, const ColumnFlow& flow, scene::MembraneSide side,
                                          Progress& progress) {
  progress.throwIfCancelled();
  OpenParts parts(lattice, flow);
  if (side != scene::MembraneSide::Nearest) parts.decideMet(side == scene::MembraneSide::Keep);
  progress.throwIfCancelled();
  parts.decideNearest();
  return std::move(parts).below();
}

}  // namespace velum::membrane
