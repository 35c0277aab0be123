#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "core/LabelCover.h"

namespace velum::io {

/// The way from the middle of a voxel to that of the next along an axis, indices of the labels' grid. One of them may
/// lie beyond the grid, which ends half a voxel beyond its outermost ones.
struct BorderWay {
  glm::ivec3 from{0};
  int axis = 0;
  glm::ivec3 to() const;
  glm::dvec3 at(double part) const;
};

glm::ivec3 unitAlong(int axis);
/// Label of a voxel; 0 beyond the grid.
inline std::uint16_t idAt(const StructureField& field, glm::ivec3 voxel) { return field.cover().labels()->at(voxel); }

/// What part of a way between voxels of two structures is the first one's, 0..1: by the function that says whose places
/// are, StructureField::at(), and so the same for whichever of the two asks. Any thread.
double partOf(const StructureField& field, const BorderWay& way);

}  // namespace velum::io
