#pragma once
#include <optional>
#include <span>

#include "vector/Drawing.h"

namespace velum::vector {

/// An end of a curve: where, and which way it goes there, if that is known.
struct CurveEnd {
  glm::dvec2 place{0.0};
  std::optional<glm::dvec2> direction;  ///< unit, the way the line is walked, at both ends
};

/// Points that a line should pass, and the line on which they lie, as far as it is known.
struct Track {
  std::vector<glm::dvec2> points;
  std::vector<glm::dvec2> fence;  ///< point i lies on the piece from fence i to i + 1
  bool isClosed = false;
};

/// How far a curve may be from what it goes along, pixels.
struct Nearness {
  double fence = 0.6;   ///< from the nearest of the fence's pieces
  double point = 1.05;  ///< from each point
  double mean = 0.36;   ///< root of the mean square from points
  double held = 0.0;    ///< from the fence, nowhere farther, whatever curves that takes; 0: not asked for
};

glm::dvec2 placeOn(glm::dvec2 from, const Curve& curve, double t);
/// The way a curve goes there, not unit.
glm::dvec2 wayOn(glm::dvec2 from, const Curve& curve, double t);
/// A place on a curve that is nearer to a point than another one: a step of Newton's. @param t  0..1
double nearer(glm::dvec2 from, const Curve& curve, glm::dvec2 point, double t);

/// The curve of least squares between two ends [SCHNEIDER]; nothing where none is as near as is asked for, or where it
/// would turn back on itself. Differs: what is near is asked of the fence, and where no direction is known at an end it
/// is found, too. @param first, end  points of the track between the ends; may be none
std::optional<Curve> fitCubic(const Track& track, int first, int end, const CurveEnd& from, const CurveEnd& to,
                              const Nearness& nearness);

/// Whether no place of a curve is farther than so many pixels from the fence along which it goes. @param first, end  as
/// above
bool liesWithin(const Track& track, int first, int end, glm::dvec2 from, const Curve& curve, double most);

/// The curve between two ends that is nearest to all points at its farthest, nearly: least squares again and again, in
/// which those count for more that are far off [LAWSON]; nothing where it comes no nearer than `most` to the fence.
std::optional<Curve> holdCubic(const Track& track, int first, int end, const CurveEnd& from, const CurveEnd& to,
                               double most);

}  // namespace velum::vector
