#pragma once
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/LeastCut.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// A lattice over a membrane's rest plane and reach with a ring of columns outside the rest plane, and a layer outside
/// the reach at both ends. Where the rest plane's axes are those of the volume, nodes are the voxels; else nodes are as
/// far apart along each axis of the frame as voxels are in that direction. Each protected pair with a voxel in the rest
/// plane's box is counted between the two nodes nearest to its voxels; a pair whose nodes differ along several axes is
/// divided among the paths between them.
/// @param coarsening  distance of nodes along each axis in voxels, >= 1
CutLattice gatherLattice(const ProtectedVoxels& voxels, const scene::Cut& cut, double coarsening = 1.0);

/// The sheet of a least cut as a SideOfPoints for measureKeptWhole(): a staircase from column to column of the lattice,
/// and the rest plane beyond the lattice. The lattice and the cut are copied.
SideOfPoints sideOfLeastCut(const CutLattice& lattice, const LeastCut& cut);
/// Mean distance of a least cut's sheet from the rest plane, over the area of the rest plane.
double meanDistance(const CutLattice& lattice, const LeastCut& least, const scene::Cut& cut);

/// The least cut area that any single-valued sheet in the frame and reach can have: the limit of the quality figure.
struct KeptWholeLimit {
  KeptWhole figure;
  CutLattice lattice;
  LeastCut least;
};
/// Solves the least cut exactly on the lattice of gatherLattice(), and counts what its sheet separates as
/// measureKeptWhole() does. @throw Cancelled
KeptWholeLimit computeLimit(const ProtectedVoxels& voxels, const scene::Cut& cut, Progress& progress);

}  // namespace velum::membrane
