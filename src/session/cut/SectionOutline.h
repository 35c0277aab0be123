#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"

namespace velum::session {

/// The lines of a cut on a section. Pixels of the section's frame.
struct SectionOutline {
  std::vector<glm::dvec2> points;  ///< of a convex shape: its polygon; of a plane: the two ends of its line in the
                                   ///< view; of a membrane: the two ends of the line of its frame; empty when the
                                   ///< section misses the cut
  bool isClosed = false;
  glm::dvec2 removedSide{0.0};  ///< of a plane: unit, across the line, to the side that the plane removes
  std::vector<std::vector<glm::dvec2>> curves;  ///< where the section crosses the sheet of a membrane, or a shape that
                                                ///< is not convex; closed curves end where they begin
  std::vector<glm::dvec2> band;                 ///< of a membrane: the box within which its sheet stays
};
/// @param live  the shape that a membrane's sheet has now, from the solver; empty: the shape that the cut holds
SectionOutline sectionOutline(const scene::SectionPlane& plane, const scene::Cut& cut,
                              const scene::SheetShape& live = {});

/// Length of the arrow that stands on a plane's line and points to what is removed.
constexpr double kSectionArrowPixels = 34.0;

}  // namespace velum::session
