#include "membrane/sheet/BendStencil.h"

#include <array>
#include <map>
#include <utility>

#include "shared/cloth.h"

namespace velum::membrane {

namespace {

using Corner = std::pair<int, int>;  ///< y, x: place in the mesh, from the particle in question
using Edge = std::pair<Corner, Corner>;
using Opposite = std::map<Edge, std::vector<Corner>>;

/// Bending constraints of an interior particle: as an end of six edges and opposite to six, for two triangulations.
constexpr double kConstraints = 24.0;

void addTriangle(Opposite& edges, std::array<Corner, 3> corners) {
  for (int i = 0; i < 3; ++i) {
    Corner a = corners[std::size_t(i)], b = corners[std::size_t((i + 1) % 3)];
    edges[{std::min(a, b), std::max(a, b)}].push_back(corners[std::size_t((i + 2) % 3)]);
  }
}

/// Edges of the part of a mesh that reaches some meshes to either side, with the corners opposite to them.
Opposite triangulate(glm::ivec2 before, glm::ivec2 after, bool otherDiagonal) {
  Opposite edges;
  for (int y = -before.y; y < after.y; ++y)
    for (int x = -before.x; x < after.x; ++x) {
      Corner ll{y, x}, lr{y, x + 1}, ul{y + 1, x}, ur{y + 1, x + 1};
      addTriangle(edges, otherDiagonal ? std::array{ll, lr, ul} : std::array{ll, lr, ur});
      addTriangle(edges, otherDiagonal ? std::array{lr, ur, ul} : std::array{ll, ur, ul});
    }
  return edges;
}

double cotangent(glm::dvec2 a, glm::dvec2 b) { return glm::dot(a, b) / std::abs(a.x * b.y - a.y * b.x); }

/// Adds what one constraint asks of the particle at {0, 0}.
void addConstraint(std::array<double, shared::kStencil * shared::kStencil>& stencil, const Edge& edge,
                   const std::vector<Corner>& opposite, glm::dvec2 mesh) {
  Corner corners[] = {edge.first, edge.second, opposite[0], opposite[1]};
  auto place = [&](int i) { return glm::dvec2(corners[i].second, corners[i].first) * mesh; };
  glm::dvec2 along = place(1) - place(0);
  double c1 = cotangent(along, place(2) - place(0)), c2 = cotangent(along, place(3) - place(0));
  double c3 = cotangent(-along, place(2) - place(1)), c4 = cotangent(-along, place(3) - place(1));
  double k[] = {c3 + c4, c1 + c2, -c1 - c3, -c2 - c4};
  double length2 = 0, own = 0;
  for (int i = 0; i < 4; ++i) {
    length2 += k[i] * k[i];
    if (corners[i] == Corner{0, 0}) own = k[i];
  }
  if (own == 0) return;
  constexpr int kMiddle = shared::kStencil / 2;
  for (int i = 0; i < 4; ++i)
    stencil[std::size_t((corners[i].first + kMiddle) * shared::kStencil + corners[i].second + kMiddle)] +=
        own * k[i] / length2 / kConstraints;
}

}  // namespace

std::vector<float> bendStencils(glm::dvec2 mesh) {
  std::vector<float> out;
  for (int row = 0; row < shared::kBendClasses; ++row)
    for (int column = 0; column < shared::kBendClasses; ++column) {
      glm::ivec2 before(column / 3, row / 3), after(column % 3, row % 3);
      std::array<double, shared::kStencil * shared::kStencil> stencil{};
      for (bool otherDiagonal : {false, true})
        for (const auto& [edge, opposite] : triangulate(before, after, otherDiagonal))
          if (opposite.size() == 2) addConstraint(stencil, edge, opposite, mesh);
      out.insert(out.end(), stencil.begin(), stencil.end());
    }
  return out;
}

}  // namespace velum::membrane
