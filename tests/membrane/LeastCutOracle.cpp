#include "LeastCutOracle.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cmath>
#include <random>
#include <vector>

namespace velum::membrane {

void forEachSheet(const CutLattice& lattice, const std::function<void(const std::vector<int>& below)>& visit) {
  glm::ivec3 n = lattice.dims;
  std::vector<int> below(std::size_t(n.x * n.y), flatCount(lattice));
  std::vector<std::size_t> inner;
  for (int y = 1; y + 1 < n.y; ++y)
    for (int x = 1; x + 1 < n.x; ++x) inner.push_back(std::size_t(y * n.x + x));
  for (auto c : inner) below[c] = 1;
  while (true) {
    visit(below);
    std::size_t i = 0;
    for (; i < inner.size() && below[inner[i]] == n.z - 1; ++i) below[inner[i]] = 1;
    if (i == inner.size()) return;
    ++below[inner[i]];
  }
}

double minimumCut(const CutLattice& lattice) {
  using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
  using Edge = Traits::edge_descriptor;
  using Graph = boost::adjacency_list<
      boost::vecS, boost::vecS, boost::directedS,
      boost::property<boost::vertex_index_t, long,
                      boost::property<boost::vertex_color_t, boost::default_color_type,
                                      boost::property<boost::vertex_distance_t, long,
                                                      boost::property<boost::vertex_predecessor_t, Edge>>>>,
      boost::property<
          boost::edge_capacity_t, double,
          boost::property<boost::edge_residual_capacity_t, double, boost::property<boost::edge_reverse_t, Edge>>>>;
  constexpr double kInfinite = 1e9;
  glm::ivec3 n = lattice.dims;
  std::size_t count = std::size_t(n.x * n.y * n.z), source = count, sink = count + 1;
  Graph graph(count + 2);
  auto capacity = boost::get(boost::edge_capacity, graph);
  auto reverse = boost::get(boost::edge_reverse, graph);
  auto join = [&](std::size_t a, std::size_t b, double forth, double back) {
    Edge e = boost::add_edge(a, b, graph).first, r = boost::add_edge(b, a, graph).first;
    capacity[e] = forth;
    capacity[r] = back;
    reverse[e] = r;
    reverse[r] = e;
  };
  std::size_t step[3] = {1, std::size_t(n.x), std::size_t(n.x * n.y)};
  for (std::size_t at = 0; at < count; ++at) {
    glm::ivec3 p(int(at) % n.x, int(at) / n.x % n.y, int(at) / (n.x * n.y));
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] + 1 == n[axis]) continue;
      double cost = pairsAt(lattice, p, axis);
      join(at, at + step[axis], cost, axis == 2 ? kInfinite : cost);
    }
    bool rim = p.x == 0 || p.y == 0 || p.x + 1 == n.x || p.y + 1 == n.y;
    if (p.z == 0 || (rim && p.z <= lattice.restLayer))
      join(source, at, kInfinite, 0.0);
    else if (p.z + 1 == n.z || rim)
      join(at, sink, kInfinite, 0.0);
  }
  return boost::boykov_kolmogorov_max_flow(graph, source, sink);
}

std::vector<std::uint8_t> tubes(glm::ivec3 dims, int count, double radius, unsigned seed) {
  std::mt19937 random(seed);
  auto inside = [&] {
    auto along = [&](int n) { return double(random() % unsigned(n)); };
    double x = along(dims.x), y = along(dims.y);
    return glm::dvec3(x, y, along(dims.z));
  };
  std::vector<std::uint8_t> mask(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
  for (int i = 0; i < count; ++i) {
    glm::dvec3 a = inside(), b = inside(), d = b - a;
    std::size_t at = 0;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x, ++at) {
          glm::dvec3 p = glm::dvec3(x, y, z) - a;
          double t = std::clamp(glm::dot(p, d) / std::max(glm::dot(d, d), 1e-9), 0.0, 1.0);
          if (glm::length(p - t * d) <= radius) mask[at] = 1;
        }
  }
  return mask;
}

}  // namespace velum::membrane
