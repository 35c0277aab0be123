#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "vector/TraceRegions.h"

/// Maps of ids to trace, and what is drawn again from what was traced, by brute force.
namespace velum::vector {

struct Picture {
  glm::ivec2 size{0};
  std::vector<int> ids;
  int at(glm::ivec2 p) const {
    bool isInside = p.x >= 0 && p.y >= 0 && p.x < size.x && p.y < size.y;
    return isInside ? ids[std::size_t(p.y) * std::size_t(size.x) + std::size_t(p.x)] : kOutside;
  }
  IdMap map() const { return {size, ids, {}}; }
};

/// Asks for the id of each pixel's middle.
inline Picture paint(glm::ivec2 size, const std::function<int(glm::dvec2)>& idAt) {
  Picture picture{size, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) picture.ids.push_back(idAt({x + 0.5, y + 0.5}));
  return picture;
}

inline glm::dvec2 placeAt(glm::dvec2 from, const Curve& curve, double t) {
  double s = 1.0 - t;
  return s * s * s * from + 3.0 * s * s * t * curve.control1 + 3.0 * s * t * t * curve.control2 + t * t * t * curve.end;
}

/// Calls with places along a line, about a tenth of a pixel apart.
template <class Call>
void walkAlong(const Outline& outline, double apart, const Call& call) {
  glm::dvec2 from = outline.start;
  call(from);
  for (const Curve& curve : outline.curves) {
    double length = glm::distance(from, curve.control1) + glm::distance(curve.control1, curve.control2) +
                    glm::distance(curve.control2, curve.end);
    int steps = std::max(4, int(length / apart));
    for (int i = 1; i <= steps; ++i) call(placeAt(from, curve, double(i) / steps));
    from = curve.end;
  }
}

/// The ids of pixels whose middles lie within the outlines of a region, by the even-odd rule, row by row.
inline Picture fill(glm::ivec2 size, const std::vector<Region>& regions) {
  Picture picture{size, std::vector<int>(std::size_t(size.x) * std::size_t(size.y))};
  for (const Region& region : regions) {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(size.y));
    for (const Outline& outline : region.outlines) {
      glm::dvec2 last = outline.start;
      walkAlong(outline, 0.1, [&](glm::dvec2 p) {
        int first = int(std::ceil(std::min(last.y, p.y) - 0.5)), end = int(std::ceil(std::max(last.y, p.y) - 0.5));
        for (int row = std::max(first, 0); row < std::min(end, size.y); ++row)
          crossings[std::size_t(row)].push_back(last.x + (row + 0.5 - last.y) / (p.y - last.y) * (p.x - last.x));
        last = p;
      });
    }
    for (int row = 0; row < size.y; ++row) {
      auto& at = crossings[std::size_t(row)];
      std::sort(at.begin(), at.end());
      for (std::size_t i = 0; i + 1 < at.size(); i += 2)
        for (int x = std::max(0, int(std::ceil(at[i] - 0.5))); x < std::min(size.x, int(std::ceil(at[i + 1] - 0.5)));
             ++x)
          picture.ids[std::size_t(row) * std::size_t(size.x) + std::size_t(x)] = region.id;
    }
  }
  return picture;
}

inline double distanceToStretch(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  glm::dvec2 way = b - a;
  double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(p, a + t * way);
}

/// How far a place is from the nearest edge of a pixel between two different ids; at least 3 where none is that near.
inline double distanceToEdges(const Picture& picture, glm::dvec2 place) {
  glm::ivec2 middle(glm::floor(place));
  double least = 3.0;
  for (int y = middle.y - 2; y <= middle.y + 2; ++y)
    for (int x = middle.x - 2; x <= middle.x + 2; ++x) {
      int own = picture.at({x, y});
      if (own != picture.at({x + 1, y})) least = std::min(least, distanceToStretch(place, {x + 1, y}, {x + 1, y + 1}));
      if (own != picture.at({x, y + 1})) least = std::min(least, distanceToStretch(place, {x, y + 1}, {x + 1, y + 1}));
    }
  return least;
}

/// What is wrong with what was traced.
struct Faults {
  double worst = 0.0;     ///< distance of a curve from the edges of pixels
  double meanSquare = 0;  ///< of these distances
  int wrong = 0;          ///< pixels that are drawn in another id
  int wrongInside = 0;    ///< those of them that touch no border
  std::size_t curves = 0;
  double per1000 = 0.0;  ///< curves for 1000 edges of pixels on borders
};

inline Faults faultsOf(const Picture& picture, const RegionMap& traced) {
  Faults faults;
  double count = 0.0;
  for (const Border& border : traced.borders) {
    faults.curves += border.line.curves.size();
    walkAlong(border.line, 0.25, [&](glm::dvec2 place) {
      double distance = distanceToEdges(picture, place);
      faults.worst = std::max(faults.worst, distance);
      faults.meanSquare += distance * distance;
      count += 1.0;
    });
  }
  faults.meanSquare /= std::max(count, 1.0);
  Picture drawn = fill(picture.size, traced.regions);
  double edges = 0.0;
  for (int y = 0; y < picture.size.y; ++y)
    for (int x = 0; x < picture.size.x; ++x) {
      int own = picture.at({x, y});
      bool touches = false;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i) touches = touches || picture.at({x + i, y + j}) != own;
      edges += (picture.at({x + 1, y}) != own) + (picture.at({x, y + 1}) != own);
      if (drawn.at({x, y}) == own) continue;
      ++faults.wrong;
      if (!touches) ++faults.wrongInside;
    }
  faults.per1000 = 1000.0 * double(faults.curves) / std::max(edges, 1.0);
  return faults;
}

}  // namespace velum::vector
