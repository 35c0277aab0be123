#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "core/LabelCover.h"

namespace velum::io {

/// The way from the middle of a voxel to the middle of the next voxel along an axis, in indices of the labels' grid.
/// One of the two voxels may lie beyond the grid, which ends half a voxel beyond the middles of its outermost voxels.
struct BorderWay {
  glm::ivec3 from{0};
  int axis = 0;
  glm::ivec3 to() const;
  glm::dvec3 at(double part) const;
};

glm::ivec3 unitAlong(int axis);
/// Label of a voxel; 0 beyond the grid.
inline std::uint16_t idAt(const StructureField& field, glm::ivec3 voxel) { return field.cover().labels()->at(voxel); }

/// The part, 0..1, of a way between voxels of two structures that belongs to the structure of the first voxel. Decided
/// by StructureField::at(), which tells to which structure places belong, so that both structures get the same border.
/// Any thread.
double partOf(const StructureField& field, const BorderWay& way);

}  // namespace velum::io
