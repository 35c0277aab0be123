#pragma once
#include "core/LabelVolume.h"
#include "core/Units.h"
#include "scene/ModelLayer.h"

namespace velum::membrane {

/// The structures of a model for a sheet: in each voxel the type whose instances fill most of it, by its number in the
/// model, from 1; 0 where instances fill less than a quarter. Of all copies, as if no cut were there.
/// Some tenths of a second. @param unit  of the world that the grid stands in
LabelVolume makeTypeGrid(const scene::ModelLayer& layer, LengthUnit unit);

}  // namespace velum::membrane
