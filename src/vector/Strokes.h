#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "vector/TraceSteps.h"

namespace velum::vector {

/// How hard a pen is pressed.
struct Pressure {
  double width = 0.0;  ///< share of the widest; 0: not at all
  int id = 0;          ///< of what the line belongs to there
};
/// @param way  along the line, unit
using PressureAt = std::function<Pressure(glm::dvec2 place, glm::dvec2 way)>;

/// Appends a line as strokes of one width each, end to end, whose `strength` is their width in sixteenths, at least
/// one. A width is kept until it is clearly another. @param apart  from place to place that are asked, pixels
void appendStrokes(const Outline& line, double apart, const PressureAt& pressureAt, std::vector<Stroke>& strokes);

/// Puts strokes of one id and one strength together where two of them, and no third, end in a place.
std::vector<Stroke> joinedStrokes(std::vector<Stroke> strokes);

/// Moves a line across itself. @param offAt  how far to the right, at a place and the way there, pixels
void moveAcross(Outline& line, const std::function<double(glm::dvec2 place, glm::dvec2 way)>& offAt);

}  // namespace velum::vector
