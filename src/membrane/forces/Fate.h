#pragma once
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"

namespace velum::membrane {

/// Computes the Fate of a membrane by looking at each protected voxel of a grid. @param voxels  all protected voxels,
/// or blocks of them
/// @param cut  the membrane: which side it removes @param side  tells the side of the sheet that points are on @throw
/// Cancelled
Fate measureFate(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side, Progress& progress);

/// The side of points for a sheet that hangs flat: above where z > 0.
SideOfPoints sideOfPlane();

}  // namespace velum::membrane
