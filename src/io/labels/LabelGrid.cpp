#include "io/labels/LabelGrid.h"

#include <cmath>

#include "core/FinestVoxels.h"

namespace velum::io {

LabelGrid gridOf(const Volume& scan) {
  FinestVoxels finest(scan);
  const Volume& grid = finest.grid();
  return {grid.dims, grid.worldFromVoxel, grid.lengthUnit};
}

bool hasNoPlace(const Volume& v, const LabelGrid& scan) {
  if (!v.isSpacingKnown) return true;
  if (v.isOrientationKnown || glm::dvec3(v.worldFromVoxel[3]) != glm::dvec3(0.0)) return false;
  glm::dvec3 size = spacingOf(v) * millimetresPer(v.lengthUnit), ofScan;
  for (int i = 0; i < 3; ++i) {
    ofScan[i] = glm::length(glm::dvec3(scan.worldFromVoxel[i])) * millimetresPer(scan.unit);
    bool isStraight = std::abs(v.worldFromVoxel[i][i]) == glm::length(glm::dvec3(v.worldFromVoxel[i]));
    if (!isStraight) return false;
  }
  constexpr double kRounding = 1e-3;  // of sizes that another program wrote in single precision or in few digits
  return size == glm::dvec3(1.0) || glm::all(glm::lessThan(glm::abs(size / ofScan - 1.0), glm::dvec3(kRounding)));
}

}  // namespace velum::io
