#include "session/measure/Solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/Parallel.h"

namespace velum::session {

namespace {

/// The edges of a cube's six tetrahedra that begin at its lowest corner, by the corner at which they end: bits x, y, z.
constexpr std::array<glm::ivec3, 8> kCorners = {
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
/// Each leads from corner 0 to corner 7 along the axes in one of their orders.
constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

class Marching {
 public:
  Marching(const Solid& solid, const WorldBox& box, double step) : mSolid(solid), mLow(box.low), mStep(step) {
    mNodes = glm::ivec3(glm::max(glm::ceil((box.high - box.low) / step), glm::dvec3(1.0))) + 1;
    mInside.resize(std::size_t(mNodes.x) * std::size_t(mNodes.y) * std::size_t(mNodes.z));
    mLayers.resize(std::size_t(mNodes.z));
  }

  WayMesh surface(Progress& progress) {
    auto each = [&](int count, const auto& body) {
      parallelFor(0, count, [&](int z) {
        progress.throwIfCancelled();
        body(z);
      });
    };
    each(mNodes.z, [&](int z) { look(z); });
    each(mNodes.z, [&](int z) { cross(z); });
    std::uint32_t first = 0;
    for (Layer& layer : mLayers) {
      layer.first = first;
      first += std::uint32_t(layer.points.size());
    }
    each(mNodes.z - 1, [&](int z) { march(z); });
    WayMesh mesh;
    for (const Layer& layer : mLayers) {
      mesh.points.insert(mesh.points.end(), layer.points.begin(), layer.points.end());
      mesh.indices.insert(mesh.indices.end(), layer.indices.begin(), layer.indices.end());
    }
    return mesh;
  }

 private:
  /// Edges that begin in a layer of nodes and cross the surface, ascending, each with its point.
  struct Layer {
    std::vector<std::uint64_t> edges;
    std::vector<glm::dvec3> points;
    std::vector<std::uint32_t> indices;
    std::uint32_t first = 0;  ///< of its points among all
  };
  std::size_t numberOf(glm::ivec3 node) const {
    return (std::size_t(node.z) * std::size_t(mNodes.y) + std::size_t(node.y)) * std::size_t(mNodes.x) +
           std::size_t(node.x);
  }
  glm::dvec3 worldOf(glm::ivec3 node) const { return mLow + mStep * glm::dvec3(node); }

  void look(int z) {
    for (glm::ivec3 node(0, 0, z); node.y < mNodes.y; ++node.y)
      for (node.x = 0; node.x < mNodes.x; ++node.x) mInside[numberOf(node)] = mSolid.holds(worldOf(node)) ? 1 : 0;
  }

  void cross(int z) {
    Layer& layer = mLayers[std::size_t(z)];
    for (glm::ivec3 node(0, 0, z); node.y < mNodes.y; ++node.y)
      for (node.x = 0; node.x < mNodes.x; ++node.x)
        for (std::size_t corner = 1; corner < 8; ++corner) {
          glm::ivec3 end = node + kCorners[corner];
          if (glm::any(glm::greaterThanEqual(end, mNodes))) continue;
          bool isInside = mInside[numberOf(node)] != 0;
          if (isInside == (mInside[numberOf(end)] != 0)) continue;
          layer.edges.push_back(numberOf(node) * 8 + corner);
          layer.points.push_back(border(worldOf(node), worldOf(end), isInside));
        }
  }

  glm::dvec3 border(glm::dvec3 from, glm::dvec3 to, bool isFromInside) const {
    constexpr int kHalvings = 7;
    for (int i = 0; i < kHalvings; ++i) {
      glm::dvec3 middle = 0.5 * (from + to);
      (mSolid.holds(middle) == isFromInside ? from : to) = middle;
    }
    return 0.5 * (from + to);
  }

  std::uint32_t pointOn(glm::ivec3 node, int from, int to) const {
    glm::ivec3 start = node + kCorners[std::size_t(from)];
    const Layer& layer = mLayers[std::size_t(start.z)];
    std::uint64_t edge = numberOf(start) * 8 + std::uint64_t(from ^ to);
    auto found = std::lower_bound(layer.edges.begin(), layer.edges.end(), edge);
    return layer.first + std::uint32_t(found - layer.edges.begin());
  }

  void march(int z) {
    for (glm::ivec3 node(0, 0, z); node.y + 1 < mNodes.y; ++node.y)
      for (node.x = 0; node.x + 1 < mNodes.x; ++node.x) {
        int inside = 0;
        for (std::size_t c = 0; c < 8; ++c) inside |= mInside[numberOf(node + kCorners[c])] << c;
        if (inside == 0 || inside == 255) continue;
        for (const auto& corners : kTetrahedra) addTetrahedron(node, corners, inside);
      }
  }

  void addTetrahedron(glm::ivec3 node, std::span<const int, 4> corners, int inside) {
    std::array<int, 4> in{}, out{};
    std::size_t ins = 0, outs = 0;
    for (int corner : corners) (inside >> corner & 1 ? in[ins++] : out[outs++]) = corner;
    if (ins == 0 || outs == 0) return;
    auto on = [&](int a, int b) { return pointOn(node, std::min(a, b), std::max(a, b)); };
    auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      auto& indices = mLayers[std::size_t(node.z)].indices;
      indices.insert(indices.end(), {a, b, c});
    };
    if (ins == 1) return add(on(in[0], out[0]), on(in[0], out[1]), on(in[0], out[2]));
    if (outs == 1) return add(on(in[0], out[0]), on(in[1], out[0]), on(in[2], out[0]));
    std::uint32_t a = on(in[0], out[0]), b = on(in[0], out[1]), c = on(in[1], out[1]), d = on(in[1], out[0]);
    add(a, b, c);
    add(a, c, d);
  }

  const Solid& mSolid;
  glm::dvec3 mLow;
  double mStep;
  glm::ivec3 mNodes{0};
  std::vector<std::uint8_t> mInside;
  std::vector<Layer> mLayers;
};

/// Smooths steps, and then undoes most of what that takes from round shapes (as Taubin does).
void smooth(WayMesh& mesh, int rounds, Progress& progress) {
  constexpr double kIn = 0.5, kOut = -0.52;
  std::vector<glm::dvec3> sums(mesh.points.size());
  std::vector<int> counts(mesh.points.size());
  for (int round = 0; round < 2 * rounds; ++round) {
    progress.throwIfCancelled();
    std::fill(sums.begin(), sums.end(), glm::dvec3(0.0));
    std::fill(counts.begin(), counts.end(), 0);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
      sums[a] += mesh.points[b];
      sums[b] += mesh.points[a];
      ++counts[a], ++counts[b];
    }
    double share = round % 2 == 0 ? kIn : kOut;
    for (std::size_t i = 0; i < sums.size(); ++i)
      if (counts[i] > 0) mesh.points[i] += share * (sums[i] / double(counts[i]) - mesh.points[i]);
  }
}

}  // namespace

WayMesh surfaceOf(const Solid& solid, const WorldBox& box, double step, int rounds, Progress& progress) {
  WayMesh mesh = Marching(solid, box, step).surface(progress);
  smooth(mesh, rounds, progress);
  return mesh;
}

}  // namespace velum::session
