#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "velum/core/Task.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/membrane/forces/LeastCut.h"
#include "velum/scene/Scene.h"

namespace velum::membrane {

/// Says of many points at once on which side of a sheet they are. Called from several threads. Voxels on the slice are
/// handed over a hair below it, so that they count as below.
/// @param local  frame-local mm
/// @param above  same length: 1 above (removed), 0 below
using SideOfPoints = std::function<void(std::span<const glm::vec3> local, std::span<std::uint8_t> above)>;

/// How much of what is protected a clip leaves whole, and how far it strays to do so.
struct KeptWhole {
  std::int64_t cutAreaPlane = 0;     ///< 6-neighbour pairs of protected voxels that the frame's plane separates
  std::int64_t cutAreaMembrane = 0;  ///< that the sheet separates
  double ratio = 1.0;  ///< membrane / plane; 1 where neither cuts, the membrane's count where the plane cuts none
  double meanDistanceMm = 0.0;  ///< of the sheet from the slice
};

/// The voxels that can matter to a membrane: those within its frame and reach, and their neighbours.
VoxelBox voxelsInReach(const Potential& potential, const scene::Cut& cut);

/// Counts the protected pairs that a sheet separates, and those that the plane does. A pair counts when one of its
/// voxels lies within the frame's box. All cores. O(voxels of the box).
/// @param voxels    at least those of voxelsInReach()
/// @param side      of the sheet
/// @param meanDistanceMm  of the sheet, handed through
KeptWhole measureKeptWhole(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side,
                           double meanDistanceMm, Progress& progress);

/// Mean distance of a sheet from the slice, weighted by the area of the frame over which its triangles lie; a folded
/// sheet counts with each of its layers. Exact for its triangles. 0 for an empty shape.
double meanDistanceMm(const scene::SheetShape& shape);

/// A lattice over a membrane's frame and reach with a ring of columns outside the frame, and a layer outside the reach
/// at both ends. Where the frame's axes are the volume's, nodes are the voxels; else they are as far apart along each
/// axis as voxels are along it. Each protected pair with a voxel in the frame's box is counted between the nodes that
/// they are nearest to; pairs that step along several axes at once are shared out to the paths between their nodes.
/// @param coarsening  nodes are so many voxels apart along each axis, >= 1
CutLattice gatherLattice(const ProtectedVoxels& voxels, const scene::Cut& cut, double coarsening = 1.0);

/// The sheet of a least cut as an answer to measureKeptWhole: stairs between the lattice's columns, and the plane
/// beyond it. The lattice and the cut are copied.
SideOfPoints sideOfLeastCut(const CutLattice& lattice, const LeastCut& cut);
/// Its mean distance from the slice over the frame, mm.
double meanDistanceMm(const CutLattice& lattice, const LeastCut& least, const scene::Cut& cut);

/// The least cut area that any single-valued sheet in the frame and reach can have: the limit of the quality figure.
struct KeptWholeLimit {
  KeptWhole figure;
  CutLattice lattice;
  LeastCut least;
  double coarsening = 1.0;  ///< > 1: the lattice is that much coarser than the voxels, as there were too many of them
};
/// Solves the least cut exactly on the lattice of gatherLattice(), and counts what its sheet separates as
/// measureKeptWhole() does. @throw Cancelled
KeptWholeLimit computeLimit(const ProtectedVoxels& voxels, const scene::Cut& cut, Progress& progress);

}  // namespace velum::membrane
