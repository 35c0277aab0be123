#include "vector/Junctions.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "vector/LineFit.h"
#include "vector/StraightRuns.h"
#include "vector/TraceRegions.h"

namespace velum::vector {

namespace {

constexpr int kLook = 14;          // points of each border that pass
constexpr int kLongLook = 400;     // and of those that end, as far as they are straight
constexpr int kLeastLook = 4;      // with fewer a border says nothing
constexpr double kReach = 0.5;     // of a node from its corner
constexpr double kMostBend = 0.9;  // radians over both borders together
constexpr double kHold = 0.2;      // weight of the corner, of an edge's

/// The first points of a border from a node.
std::vector<glm::dvec2> pointsFrom(const std::vector<Track>& tracks, int leaving, int most) {
  const std::vector<glm::dvec2>& points = tracks[std::size_t(leaving / 2)].points;
  auto count = std::min(points.size(), std::size_t(most));
  if (leaving % 2 == 0) return {points.begin(), points.begin() + std::ptrdiff_t(count)};
  return {points.rbegin(), points.rbegin() + std::ptrdiff_t(count)};
}

glm::dvec2 within(glm::dvec2 place, glm::dvec2 corner, double reach) {
  double off = glm::distance(place, corner);
  return off <= reach ? place : corner + (place - corner) * (reach / off);
}

/// The line along which a border ends in a node: flat ones have long steps.
Tangent lineFrom(const std::vector<glm::dvec2>& points) {
  LineFits fits(points);
  int near = std::min(int(points.size()), kLook), end = longestRun(fits, points, 0, int(points.size()));
  Tangent line = fits.line(0, near).middle;
  if (end <= 2 * kLook) return line;
  Tangent about = fits.line(0, end).middle;
  about.place += about.direction * alongOf(about, points.front());
  auto curve = fitLocalCurve(std::span(points).first(std::size_t(end)), about, 2);
  return curve ? curve->tangent : line;
}

using Ends = std::array<std::vector<glm::dvec2>, 4>;

std::span<const glm::dvec2> nearEnd(const std::vector<glm::dvec2>& points) {
  return std::span(points).first(std::min(points.size(), std::size_t(kLook)));
}

/// How two borders go on into each other; nothing where they do not.
std::optional<LocalCurve> passing(std::span<const glm::dvec2> a, std::span<const glm::dvec2> b, glm::dvec2 corner) {
  if (a.size() < kLeastLook || b.size() < kLeastLook) return {};
  std::vector<glm::dvec2> points(a.rbegin(), a.rend());
  points.insert(points.end(), b.begin(), b.end());
  LineFits fits(points);
  auto half = int(a.size());
  FittedLine before = fits.line(0, half), after = fits.line(half, int(points.size()));
  if (glm::dot(before.middle.direction, after.middle.direction) < 0.6) return {};
  Tangent about{corner, glm::normalize(before.middle.direction + after.middle.direction)};
  auto curve = fitLocalCurve(points, about, 2);
  if (!curve || curve->meanSquare > 0.13 || curve->largest > 0.8 || curve->bend > kMostBend) return {};
  return curve;
}

/// The node between lines that all end there.
glm::dvec2 meetingPlace(const Ends& ends, glm::dvec2 corner) {
  std::array<double, 4> matrix{kHold, 0.0, 0.0, kHold};
  std::array<double, 2> answer{};
  for (const auto& points : ends) {
    if (int(points.size()) < kLeastLook) continue;
    Tangent line = lineFrom(points);
    glm::dvec2 across(-line.direction.y, line.direction.x);
    double off = glm::dot(across, line.place - corner);
    matrix[0] += across.x * across.x;
    matrix[1] += across.x * across.y;
    matrix[2] += across.x * across.y;
    matrix[3] += across.y * across.y;
    answer[0] += across.x * off;
    answer[1] += across.y * off;
  }
  if (!solveEquations(matrix, answer)) return corner;
  return within(corner + glm::dvec2(answer[0], answer[1]), corner, kReach);
}

/// A node on the edge of the picture stays on it.
Junction onEdge(const BorderNode& node, const Ends& ends, const std::array<bool, 4>& isEdge) {
  glm::dvec2 corner(node.corner);
  Junction junction{corner, {}};
  glm::dvec2 along = isEdge[0] || isEdge[2] ? glm::dvec2(1, 0) : glm::dvec2(0, 1);
  for (std::size_t way = 0; way < 4; ++way) {
    if (isEdge[way] || int(ends[way].size()) < kLeastLook) continue;
    Tangent line = lineFrom(ends[way]);
    if (auto crossing = crossingOf(line, {corner, along})) junction.place = within(*crossing, corner, 0.5);
  }
  return junction;
}

Junction placed(const BorderNode& node, const PixelBorders& borders, const std::vector<Track>& tracks) {
  Ends ends;
  std::array<bool, 4> isEdge{};
  for (std::size_t way = 0; way < 4; ++way) {
    if (node.leaving[way] < 0) continue;
    ends[way] = pointsFrom(tracks, node.leaving[way], kLongLook);
    const PixelBorder& border = borders.borders[std::size_t(node.leaving[way] / 2)];
    isEdge[way] = border.left == kOutside || border.right == kOutside;
  }
  if (std::count(isEdge.begin(), isEdge.end(), true) > 0) return onEdge(node, ends, isEdge);
  glm::dvec2 corner(node.corner);
  Junction junction{corner, {}};
  double least = kMostBend;
  bool passes = false;
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) {
      if (node.leaving[a] < 0 || node.leaving[b] < 0 || node.leaving[a] / 2 == node.leaving[b] / 2) continue;
      auto curve = passing(nearEnd(ends[a]), nearEnd(ends[b]), corner);
      if (!curve || curve->bend >= least) continue;
      least = curve->bend;
      passes = true;
      junction = {within(curve->tangent.place, corner, kReach), {}};
      junction.leaving[a] = -curve->tangent.direction;
      junction.leaving[b] = curve->tangent.direction;
    }
  if (!passes) junction.place = meetingPlace(ends, corner);
  return junction;
}

}  // namespace

Track trackOf(const PixelBorder& border) {
  Track track;
  track.isClosed = border.isClosed();
  track.fence.assign(border.corners.begin(), border.corners.end());
  track.points.reserve(track.fence.size());
  for (std::size_t i = 0; i + 1 < track.fence.size(); ++i)
    track.points.push_back(0.5 * (track.fence[i] + track.fence[i + 1]));
  return track;
}

std::vector<Junction> placeJunctions(const PixelBorders& borders, const std::vector<Track>& tracks) {
  std::vector<Junction> junctions;
  for (const BorderNode& node : borders.nodes) junctions.push_back(placed(node, borders, tracks));
  return junctions;
}

}  // namespace velum::vector
