#include "membrane/sheet/SheetCurve.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>

namespace velum::membrane {

namespace {

using EdgeKey = std::uint64_t;

/// The segments of the plane's lines on all triangles, by the edges of the mesh that they join.
class Segments {
 public:
  Segments(const scene::SheetShape& shape, glm::vec3 normal, float distance) : mShape(shape) {
    for (glm::vec3 p : shape.places) mHeights.push_back(glm::dot(normal, p) - distance);
    std::uint32_t across = std::uint32_t(shape.particles.x);
    for (std::uint32_t y = 0; y + 1 < std::uint32_t(shape.particles.y); ++y)
      for (std::uint32_t x = 0; x + 1 < across; ++x) {
        std::uint32_t v = y * across + x, above = v + across;
        add({v, v + 1, above + 1});
        add({v, above + 1, above});
      }
  }
  std::vector<SheetCurve> curves() {
    std::vector<SheetCurve> out;
    // Lines that end on the rim first, from their ends; what is left is closed.
    for (bool isClosed : {false, true})
      for (EdgeKey edge : mEdges)
        if ((isClosed || mNext[edge].count == 1) && !mUsed[edge]) out.push_back({follow(edge), isClosed});
    return out;
  }

 private:
  /// The edges that a line goes on to from an edge: one on the rim, else two.
  struct Next {
    std::array<EdgeKey, 2> to{};
    int count = 0;
  };
  static EdgeKey edgeOf(std::uint32_t a, std::uint32_t b) { return EdgeKey(std::min(a, b)) << 32 | std::max(a, b); }
  void add(std::array<std::uint32_t, 3> corner) {
    std::array<EdgeKey, 2> crossed{};
    std::size_t count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
      if ((mHeights[a] < 0) != (mHeights[b] < 0) && count < 2) crossed[count++] = edgeOf(a, b);
    }
    if (count < 2) return;
    for (std::size_t i = 0; i < 2; ++i) {
      auto [found, isNew] = mNext.try_emplace(crossed[i]);
      if (isNew) mEdges.push_back(crossed[i]);
      Next& next = found->second;
      if (next.count < 2) next.to[std::size_t(next.count++)] = crossed[1 - i];
    }
  }
  glm::vec3 placeOn(EdgeKey edge) const {
    std::size_t a = edge >> 32, b = edge & 0xffffffffu;
    return glm::mix(mShape.places[a], mShape.places[b], mHeights[a] / (mHeights[a] - mHeights[b]));
  }
  std::vector<glm::vec3> follow(EdgeKey edge) {
    std::vector<glm::vec3> places;
    for (bool more = true; more;) {
      mUsed[edge] = true;
      places.push_back(placeOn(edge));
      more = false;
      const Next& next = mNext[edge];
      for (int i = 0; i < next.count && !more; ++i)
        if (!mUsed[next.to[std::size_t(i)]]) edge = next.to[std::size_t(i)], more = true;
    }
    return places;
  }

  const scene::SheetShape& mShape;
  std::vector<float> mHeights;
  std::vector<EdgeKey> mEdges;  ///< as they were found: the same sheet gives the same lines
  std::unordered_map<EdgeKey, Next> mNext;
  std::unordered_map<EdgeKey, bool> mUsed;
};

}  // namespace

std::vector<SheetCurve> crossPlane(const scene::SheetShape& shape, glm::vec3 normal, float distance) {
  return Segments(shape, normal, distance).curves();
}

}  // namespace velum::membrane
