#include "io/stores/PlaceLevels.h"

#include <glm/gtc/matrix_transform.hpp>

#include "io/read/Placement.h"
#include "io/stores/AxisUnits.h"
#include "io/stores/PyramidPlan.h"

namespace velum::io {

glm::dmat4 finestFromLevel(glm::dvec3 factor) { return gridMatrix(factor, 0.5 * (factor - 1.0)); }

glm::dvec3 factorFromDims(glm::ivec3 finest, glm::ivec3 level) {
  glm::dvec3 factor;
  for (int axis = 0; axis < 3; ++axis) factor[axis] = blockFactor(finest[axis], level[axis]);
  return factor;
}

void placeLevels(ArrayPyramid& pyramid, const std::vector<glm::dmat4>& places, const std::string& unit) {
  Volume& head = pyramid.head;
  auto mm = millimetresOf(unit);
  head.lengthUnit = isAngstrom(unit) ? LengthUnit::Angstrom : LengthUnit::Millimetre;
  double perUnit = mm.value_or(1.0) * unitsPer(LengthUnit::Millimetre, head.lengthUnit);
  if (mm && *mm <= 1e-3) head.modality = Modality::Microscopy;
  head.isOrientationKnown = false;
  head.isSpacingKnown = mm.has_value() || glm::dmat3(places.front()) != glm::dmat3(1.0);
  if (head.isSpacingKnown && !mm)
    head.warnings.push_back(unit.empty()
                                ? "the file gives no unit of lengths; millimetres were taken"
                                : "the unit of lengths, " + inQuotes(unit) + ", is not known; millimetres were taken");
  for (std::size_t i = 0; i < places.size(); ++i) {
    Volume placed;
    placed.lengthUnit = head.lengthUnit;
    glm::dmat3 columns = glm::dmat3(places[i]) * perUnit;
    placeInWorld(placed, columns, glm::dvec3(places[i][3]) * perUnit, glm::dvec3(glm::length(columns[0])));
    pyramid.levels[i].worldFromVoxel = placed.worldFromVoxel;
    if (i > 0) continue;
    head.isSpacingKnown = head.isSpacingKnown && placed.isSpacingKnown;
    head.warnings.insert(head.warnings.end(), placed.warnings.begin(), placed.warnings.end());
  }
  head.worldFromVoxel = pyramid.levels.front().worldFromVoxel;
  head.dims = pyramid.levels.front().dims;
  pyramid.facts.unit = unit;
}

}  // namespace velum::io
