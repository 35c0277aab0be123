#pragma once
#include <glm/glm.hpp>

#include "session/lettering/PlaceNames.h"

namespace velum::session {

/// A straight piece of a leader.
struct Segment {
  glm::dvec2 from, to;
};

/// True where two pieces have a point in common.
bool isCrossing(const Segment& a, const Segment& b);
/// True where a piece has a point in the inside of a rectangle.
bool isCrossing(const Segment& segment, const Rectangle& rectangle);
/// True where two rectangles have a point of their insides in common.
bool isCrossing(const Rectangle& a, const Rectangle& b);
/// A vector of the length 1; of none the other one.
inline glm::dvec2 unitOr(glm::dvec2 v, glm::dvec2 other) {
  double length = glm::length(v);
  return length > 1e-9 ? v / length : other;
}
/// From a place to the nearest point of a piece, pixels.
double distanceTo(const Segment& segment, glm::dvec2 place);
Rectangle grown(const Rectangle& rectangle, double by);
/// The leader to an anchor: from the side of a block that looks to it, of names around a subject from that which looks
/// more to it; of others from above or below only where the anchor is there.
/// @param away  how far from the block it begins, pixels
Segment leaderOf(const Rectangle& block, glm::dvec2 anchor, double away, scene::NameOrder order);

/// Ways in ems between what is written: from words to the picture's edge, to other words, to their leader, to the
/// subject.
constexpr double kNameMargin = 0.6, kNameGap = 0.3, kLeaderGap = 0.3, kSubjectGap = 1.6;
/// How near to another's anchor a leader seems to lead there, ems.
constexpr double kAnchorGap = 0.35;

/// A place of a name with its leader. @param low  corner of the block
NamePlace placeAt(const NameToPlace& name, glm::dvec2 low, const NameRoom& room);
/// True where two names cannot both stand where they are: blocks, or a block and a leader, too near, or leaders that
/// cross.
bool areInTheWay(const NamePlace& a, const NamePlace& b, double em);

}  // namespace velum::session
