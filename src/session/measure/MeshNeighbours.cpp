#include "session/measure/MeshNeighbours.h"

#include <algorithm>
#include <tuple>

namespace velum::session {

std::vector<std::array<std::uint32_t, 3>> neighboursOf(std::span<const std::uint32_t> indices) {
  struct Edge {
    std::uint32_t low, high, triangle, side;
  };
  std::vector<Edge> edges;
  edges.reserve(indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    std::uint32_t a = indices[i], b = indices[i % 3 == 2 ? i - 2 : i + 1];
    edges.push_back({std::min(a, b), std::max(a, b), std::uint32_t(i / 3), std::uint32_t(i % 3)});
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  std::vector<std::array<std::uint32_t, 3>> neighbours(indices.size() / 3);
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) neighbours[i] = {i, i, i};
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const Edge &a = edges[i], &b = edges[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    neighbours[a.triangle][a.side] = b.triangle;
    neighbours[b.triangle][b.side] = a.triangle;
    ++i;
  }
  return neighbours;
}

}  // namespace velum::session
