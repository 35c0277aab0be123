#pragma once
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/forces/Kernels.h"
#include "membrane/forces/LeastCut.h"
#include "scene/SceneFwd.h"

namespace velum::membrane {

/// A lattice over a membrane's rest plane and reach with a ring of columns outside the rest plane, and a layer outside
/// the reach at both ends. Where the rest plane's axes are the volume's, nodes are the voxels; else they are as far
/// apart along each axis as voxels are along it. Each protected pair with a voxel in the rest plane's box is counted
/// between the nodes that they are nearest to; pairs that step along several axes at once are shared out to the paths
/// between their nodes.
/// @param coarsening  nodes are so many voxels apart along each axis, >= 1
CutLattice gatherLattice(const ProtectedVoxels& voxels, const scene::Cut& cut, double coarsening = 1.0);

/// The sheet of a least cut as an answer to measureKeptWhole: stairs between the lattice's columns, and the plane
/// beyond it. The lattice and the cut are copied.
SideOfPoints sideOfLeastCut(const CutLattice& lattice, const LeastCut& cut);
/// Its mean distance from the rest plane over the rest plane.
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
