#include "session/lettering/Leaders.h"

#include <algorithm>

namespace velum::session {

namespace {

/// Over 0: c lies to the one side of the line from a to b, below 0: to the other.
double sideOfLine(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool areBoxesApart(const Segment& a, const Segment& b) {
  return glm::any(glm::lessThan(glm::max(a.from, a.to), glm::min(b.from, b.to))) ||
         glm::any(glm::lessThan(glm::max(b.from, b.to), glm::min(a.from, a.to)));
}

Segment segmentOf(const NamePlace& place) { return {place.leader.front(), place.leader.back()}; }

}  // namespace

bool isCrossing(const Segment& a, const Segment& b) {
  if (areBoxesApart(a, b)) return false;
  auto isBetween = [](double one, double other) {
    return (one <= 0.0 && other >= 0.0) || (one >= 0.0 && other <= 0.0);
  };
  return isBetween(sideOfLine(a.from, a.to, b.from), sideOfLine(a.from, a.to, b.to)) &&
         isBetween(sideOfLine(b.from, b.to, a.from), sideOfLine(b.from, b.to, a.to));
}

bool isCrossing(const Segment& segment, const Rectangle& rectangle) {
  // The stretch of the segment that is between the rectangle's sides, along x and along y.
  double first = 0.0, last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    double from = segment.from[axis], way = segment.to[axis] - from;
    if (way == 0.0) {
      if (from <= rectangle.low[axis] || from >= rectangle.high[axis]) return false;
      continue;
    }
    double a = (rectangle.low[axis] - from) / way, b = (rectangle.high[axis] - from) / way;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

bool isCrossing(const Rectangle& a, const Rectangle& b) {
  return glm::all(glm::lessThan(a.low, b.high)) && glm::all(glm::lessThan(b.low, a.high));
}

double distanceTo(const Segment& segment, glm::dvec2 place) {
  glm::dvec2 way = segment.to - segment.from;
  double square = glm::dot(way, way), along = square > 0.0 ? glm::dot(place - segment.from, way) / square : 0.0;
  return glm::distance(place, segment.from + std::clamp(along, 0.0, 1.0) * way);
}

Rectangle grown(const Rectangle& rectangle, double by) { return {rectangle.low - by, rectangle.high + by}; }

Segment leaderOf(const Rectangle& block, glm::dvec2 anchor, double away, scene::NameOrder order) {
  glm::dvec2 middle = (block.low + block.high) * 0.5, half = (block.high - block.low) * 0.5;
  glm::dvec2 beyond = glm::max(block.low - anchor, anchor - block.high);
  bool isBeside = beyond.x > 0.0 && (order == scene::NameOrder::Columns || beyond.x >= beyond.y);
  if (isBeside) return {{anchor.x > middle.x ? block.high.x + away : block.low.x - away, middle.y}, anchor};
  // Not from a corner, which would look as if it were from beside.
  double reach = std::max(0.0, half.x - half.y);
  return {{std::clamp(anchor.x, middle.x - reach, middle.x + reach),
           anchor.y < middle.y ? block.low.y - away : block.high.y + away},
          anchor};
}

NamePlace placeAt(const NameToPlace& name, glm::dvec2 low, const NameRoom& room) {
  Rectangle block{low, low + name.size};
  // A leader begins no farther from its words than its anchor is.
  glm::dvec2 outside = glm::max(glm::max(block.low - name.anchor, name.anchor - block.high), glm::dvec2(0));
  double away = std::min(kLeaderGap * room.em, std::max(outside.x, outside.y) * 0.5);
  Segment leader = leaderOf(block, name.anchor, away, room.order);
  return {name.key, block, {leader.from, leader.to}};
}

bool areInTheWay(const NamePlace& a, const NamePlace& b, double em) {
  constexpr double kRounding = 1e-6;
  double gap = kNameGap * em - kRounding, near = gap * 0.5;
  return isCrossing(grown(a.block, gap), b.block) || isCrossing(segmentOf(a), grown(b.block, near)) ||
         isCrossing(segmentOf(b), grown(a.block, near)) || isCrossing(segmentOf(a), segmentOf(b));
}

}  // namespace velum::session
