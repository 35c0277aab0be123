#include "session/measure/Strip.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace velum::session {

namespace {

double crossOf(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// An edge through which the way goes, in the plane into which the strip is unfolded.
struct Gate {
  std::uint32_t left = 0, right = 0;  ///< points of the mesh
  glm::dvec2 atLeft{0.0}, atRight{0.0};
};

/// A triangle laid into the plane.
struct Laid {
  std::array<std::uint32_t, 3> points{};
  std::array<glm::dvec2, 3> at{};
};

/// Where the third corner of a triangle lies, given two of them.
/// @param along, away  of the third corner: along the edge from the first, and away from the edge
glm::dvec2 thirdOf(glm::dvec2 a, glm::dvec2 b, double along, double away) {
  double length = glm::distance(a, b);
  glm::dvec2 unit = length > 0.0 ? (b - a) / length : glm::dvec2(1.0, 0.0);
  return a + along * unit + away * glm::dvec2(-unit.y, unit.x);
}

/// Along the edge, and away from it.
glm::dvec2 heightOver(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  double length = glm::distance(a, b);
  if (!(length > 0.0)) return {0.0, glm::distance(a, c)};
  double along = glm::dot(c - a, b - a) / length;
  return {along, std::sqrt(std::max(0.0, glm::dot(c - a, c - a) - along * along))};
}

class Unfolding {
 public:
  Unfolding(const WayMesh& mesh, const std::vector<std::uint32_t>& strip) : mMesh(mesh) {
    const std::uint32_t* i = &mesh.indices[3 * std::size_t(strip.front())];
    mLast.points = {i[0], i[1], i[2]};
    glm::dvec2 height = heightOver(mesh.points[i[0]], mesh.points[i[1]], mesh.points[i[2]]);
    mLast.at = {glm::dvec2(0.0), glm::dvec2(glm::distance(mesh.points[i[0]], mesh.points[i[1]]), 0.0), height};
    mFirst = mLast;
    for (std::size_t next = 1; next < strip.size(); ++next) add(strip[next]);
  }
  const std::vector<Gate>& gates() const { return mGates; }
  glm::dvec2 inFirst(glm::dvec3 place) const { return laid(mFirst, place); }
  glm::dvec2 inLast(glm::dvec3 place) const { return laid(mLast, place); }

 private:
  glm::dvec2 laid(const Laid& triangle, glm::dvec3 place) const {
    glm::dvec3 a = mMesh.points[triangle.points[0]], u = mMesh.points[triangle.points[1]] - a,
               v = mMesh.points[triangle.points[2]] - a, w = place - a;
    double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v), wu = glm::dot(w, u), wv = glm::dot(w, v);
    double all = uu * vv - uv * uv;
    if (!(all > 0.0)) return triangle.at[0];
    double s = (vv * wu - uv * wv) / all, t = (uu * wv - uv * wu) / all;
    return triangle.at[0] + s * (triangle.at[1] - triangle.at[0]) + t * (triangle.at[2] - triangle.at[0]);
  }

  void add(std::uint32_t triangle) {
    const std::uint32_t* i = &mMesh.indices[3 * std::size_t(triangle)];
    auto has = [&](std::uint32_t point) { return point == i[0] || point == i[1] || point == i[2]; };
    std::size_t behind = !has(mLast.points[0]) ? 0 : !has(mLast.points[1]) ? 1 : 2;
    std::size_t p = (behind + 1) % 3, q = (behind + 2) % 3;
    std::uint32_t a = mLast.points[p], b = mLast.points[q], third = i[0];
    for (int k = 0; k < 3; ++k)
      if (i[k] != a && i[k] != b) third = i[k];
    glm::dvec2 atA = mLast.at[p], atB = mLast.at[q];
    // What is behind lies to the left of the edge from a to b: going on, b is to the left.
    bool isBehindLeft = crossOf(atB - atA, mLast.at[behind] - atA) > 0.0;
    Gate gate{b, a, atB, atA};
    if (!isBehindLeft) gate = {a, b, atA, atB};
    mGates.push_back(gate);
    glm::dvec2 height = heightOver(mMesh.points[a], mMesh.points[b], mMesh.points[third]);
    Laid laid;
    laid.points = {a, b, third};
    laid.at = {atA, atB, thirdOf(atA, atB, height.x, isBehindLeft ? -height.y : height.y)};
    mLast = laid;
  }

  const WayMesh& mMesh;
  Laid mFirst, mLast;
  std::vector<Gate> mGates;
};

/// A bend of the way in the plane.
struct Bend {
  glm::dvec2 at{0.0};
  std::size_t gate = 0;
  bool isLeft = false;
};

/// The shortest way through gates, pulled straight between their ends.
std::vector<Bend> bendsOf(const std::vector<Gate>& gates, glm::dvec2 from, glm::dvec2 to) {
  std::vector<Bend> bends;
  glm::dvec2 apex = from, left = from, right = from;
  std::size_t leftGate = 0, rightGate = 0;
  for (std::size_t i = 0; i <= gates.size(); ++i) {
    glm::dvec2 newLeft = i < gates.size() ? gates[i].atLeft : to, newRight = i < gates.size() ? gates[i].atRight : to;
    const Bend* bend = nullptr;
    Bend found;
    if (crossOf(right - apex, newRight - apex) >= 0.0) {
      if (apex == right || crossOf(left - apex, newRight - apex) < 0.0)
        right = newRight, rightGate = i;
      else
        found = {left, leftGate, true}, bend = &found;
    }
    if (!bend && crossOf(left - apex, newLeft - apex) <= 0.0) {
      if (apex == left || crossOf(right - apex, newLeft - apex) > 0.0)
        left = newLeft, leftGate = i;
      else
        found = {right, rightGate, false}, bend = &found;
    }
    if (!bend) continue;
    if (found.gate == gates.size()) break;  // the end itself
    // Gates that share the point find it again.
    bool isKnown = found.at == (bends.empty() ? from : bends.back().at);
    if (!isKnown) bends.push_back(found);
    apex = left = right = found.at;
    i = leftGate = rightGate = found.gate;
  }
  return bends;
}

/// Where a line crosses a gate, as a share of the way from its left end to its right one.
double crossingOf(const Gate& gate, glm::dvec2 from, glm::dvec2 to) {
  double a = crossOf(to - from, gate.atLeft - from), b = crossOf(to - from, gate.atRight - from);
  return a == b ? 0.5 : std::clamp(a / (a - b), 0.0, 1.0);
}

}  // namespace

StripWay straightWay(const WayMesh& mesh, const std::vector<std::uint32_t>& strip, glm::dvec3 from, glm::dvec3 to) {
  Unfolding unfolding(mesh, strip);
  const std::vector<Gate>& gates = unfolding.gates();
  glm::dvec2 start = unfolding.inFirst(from), end = unfolding.inLast(to);
  std::vector<Bend> bends = bendsOf(gates, start, end);
  StripWay found;
  found.way.points.push_back(from);
  glm::dvec2 before = start;
  std::size_t gate = 0;
  for (std::size_t i = 0; i <= bends.size(); ++i) {
    bool isEnd = i == bends.size();
    glm::dvec2 next = isEnd ? end : bends[i].at;
    found.way.length += glm::distance(before, next);
    std::size_t last = isEnd ? gates.size() : bends[i].gate;
    for (; gate < last; ++gate) {
      double share = crossingOf(gates[gate], before, next);
      found.way.points.push_back(glm::mix(mesh.points[gates[gate].left], mesh.points[gates[gate].right], share));
    }
    if (isEnd) break;
    const Bend& bend = bends[i];
    std::uint32_t point = bend.isLeft ? gates[bend.gate].left : gates[bend.gate].right;
    found.way.points.push_back(mesh.points[point]);
    glm::dvec2 in = before - bend.at, out = (i + 1 < bends.size() ? bends[i + 1].at : end) - bend.at;
    // Counterclockwise from where it comes to where it goes: what lies to the right.
    double angle = std::atan2(crossOf(in, out), glm::dot(in, out));
    if (angle < 0.0) angle += 2.0 * M_PI;
    found.corners.push_back({point, bend.gate, bend.isLeft ? angle : 2.0 * M_PI - angle});
    before = bend.at;
    ++gate;
  }
  found.way.points.push_back(to);
  return found;
}

}  // namespace velum::session
