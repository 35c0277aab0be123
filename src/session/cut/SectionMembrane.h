#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"
#include "scene/SheetShape.h"
#include "session/cut/SectionCutTool.h"

/// Curves and handles that only a membrane has on a section. Pixels of the section's plane.
namespace velum::session {

/// Where the section crosses the sheet of a membrane; closed curves end where they begin. Pixels.
std::vector<std::vector<glm::dvec2>> sheetCurves(const scene::SectionPlane& plane, const scene::Cut& cut,
                                                 const scene::SheetShape& live);
/// The two ends of a membrane's rest plane on a section, pixels; nothing where the plane does not cross the section.
std::optional<std::pair<glm::dvec2, glm::dvec2>> frameLine(const scene::SectionPlane& plane, const scene::Cut& cut);
/// A membrane's handles on a section: ends that resize, knobs that turn, an arrow that moves along the normal.
std::vector<SectionHandle> membraneHandles(const scene::SectionPlane& plane, const scene::Cut& cut);

}  // namespace velum::session
