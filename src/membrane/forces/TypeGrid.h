#pragma once
#include <glm/glm.hpp>

#include "core/LabelVolume.h"
#include "core/Units.h"
#include "scene/ModelLayer.h"

namespace velum::membrane {

/// The grid of makeTypeGrid().
struct TypeLattice {
  double voxel = 1.0;  ///< edge, angstrom
  glm::ivec3 dims{1};
  glm::dmat4 worldFromVoxel{1.0};
};
TypeLattice typeLattice(const scene::ModelLayer& layer, const scene::ModelFrame& frame);

/// The types of a model as labels for a sheet: each voxel gets the type whose instances fill most of it, as the type's
/// number in the model, counted from 1; 0 where instances fill less than a quarter of the voxel. Shows all copies, as
/// if there were no cuts. Some tenths of a second. @param unit  of the world that the grid stands in
LabelVolume makeTypeGrid(const scene::ModelLayer& layer, const scene::ModelFrame& frame, LengthUnit unit);

}  // namespace velum::membrane
