#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/SheetShape.h"

namespace velum::membrane {

/// A line along which a plane crosses a sheet.
struct SheetCurve {
  std::vector<glm::vec3> places;  ///< corners of a line, in the frame of the sheet
  bool isClosed = false;          ///< the last corner is joined to the first; open lines end on the sheet's rim
};

/// The lines in which the plane dot(normal, p) = distance crosses a sheet, in any order. A sheet that lies in the plane
/// gives none. Any thread; cost: the triangles.
std::vector<SheetCurve> crossPlane(const scene::SheetShape& shape, glm::vec3 normal, float distance);

}  // namespace velum::membrane
