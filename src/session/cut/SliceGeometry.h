#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "velum/scene/Cut.h"
#include "velum/scene/SliceFrame.h"
#include "velum/session/cut/SliceCutTool.h"

namespace velum::session {

/// A plane's line on a slice, pixels.
struct PlaneLine {
  glm::dvec2 point, along, across;  ///< along and across: unit; across: to where it takes away
};
/// Nothing when the plane lies along the slice.
std::optional<PlaneLine> planeLine(const scene::SliceFrame& frame, const scene::Cut& cut);

/// Screen direction of a world direction; zero length when it stands across the slice.
glm::dvec2 onScreen(const scene::SliceFrame& frame, glm::dvec3 direction);

/// The part of the line p + t d inside the rectangle from low to high.
std::optional<std::pair<glm::dvec2, glm::dvec2>> clipLine(glm::dvec2 p, glm::dvec2 d, glm::dvec2 low, glm::dvec2 high);

/// Where the slice crosses the sheet of a membrane; closed curves end where they begin. Pixels.
std::vector<std::vector<glm::dvec2>> sheetCurves(const scene::SliceFrame& frame, const scene::Cut& cut,
                                                 const scene::SheetShape& live);
/// The two ends of a membrane's frame on a slice, pixels; nothing where it does not cross it.
std::optional<std::pair<glm::dvec2, glm::dvec2>> frameLine(const scene::SliceFrame& frame, const scene::Cut& cut);
/// Ends that resize, knobs that turn, an arrow that moves along the normal.
std::vector<SliceHandle> membraneHandles(const scene::SliceFrame& frame, const scene::Cut& cut);

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b);

}  // namespace velum::session
