#pragma once
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"

namespace velum::membrane {

/// Looks at each protected voxel of a grid. @param voxels  all that is protected, or blocks of it
/// @param cut  says which side is removed  @param side  of the sheet  @throw Cancelled
Fate measureFate(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side, Progress& progress);

/// The side of a sheet that hangs flat.
SideOfPoints sideOfPlane();

}  // namespace velum::membrane
