#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "velum/scene/Cut.h"
#include "velum/scene/SheetShape.h"
#include "velum/scene/SliceFrame.h"
#include "velum/session/cut/SliceCutTool.h"

/// What only a membrane has on a slice. Pixels of the slice's frame.
namespace velum::session {

/// Where the slice crosses the sheet of a membrane; closed curves end where they begin. Pixels.
std::vector<std::vector<glm::dvec2>> sheetCurves(const scene::SliceFrame& frame, const scene::Cut& cut,
                                                 const scene::SheetShape& live);
/// The two ends of a membrane's frame on a slice, pixels; nothing where it does not cross it.
std::optional<std::pair<glm::dvec2, glm::dvec2>> frameLine(const scene::SliceFrame& frame, const scene::Cut& cut);
/// Ends that resize, knobs that turn, an arrow that moves along the normal.
std::vector<SliceHandle> membraneHandles(const scene::SliceFrame& frame, const scene::Cut& cut);

}  // namespace velum::session
