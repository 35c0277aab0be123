#pragma once
#include "core/LabelCover.h"
#include "io/meshes/SurfaceShape.h"

namespace velum::io {

/// Points of a surface before they moved to the border.
struct PointsOnWays {
  const std::vector<glm::dvec3>& halfway;     ///< in the middle of their ways
  const std::vector<std::uint8_t>& hasThird;  ///< whether in a cell that the way bounds there is a third structure
};

/// Leads the surface of a structure up to where three meet, or two and what has no label: triangles between points on
/// the ways from voxel to voxel would cut that off, and leave a groove between those that touch. It gets a point in
/// each face of a cell where three meet, and one within the cell, the same for whichever of the three it is. What was
/// closed stays closed.
/// @param points  the shape's, as they were
void joinWhereThreeMeet(SurfaceShape& shape, const PointsOnWays& points, const StructureField& field);

}  // namespace velum::io
