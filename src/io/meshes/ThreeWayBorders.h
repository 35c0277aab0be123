#pragma once
#include "core/LabelCover.h"
#include "io/meshes/SurfaceShape.h"

namespace velum::io {

/// The points of a surface before they were moved to the border.
struct PointsOnWays {
  const std::vector<glm::dvec3>& halfway;     ///< each point in the middle of its way (BorderWay)
  const std::vector<std::uint8_t>& hasThird;  ///< for each point StructureShares::hasThird() of its way
};

/// Leads the surface of a structure up to the lines where three structures meet, or two and unlabelled material.
/// Triangles between points on the ways from voxel to voxel would cut these lines off and leave a groove between
/// structures that touch. The surface gets a point in each face of a cell in which three meet, and one within the cell;
/// the points are the same for the surfaces of all three. A closed surface stays closed.
/// @param points  the points of `shape` as they were before
void joinWhereThreeMeet(SurfaceShape& shape, const PointsOnWays& points, const StructureField& field);

}  // namespace velum::io
