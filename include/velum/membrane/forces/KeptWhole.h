#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "velum/core/Task.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/scene/Scene.h"

namespace velum::membrane {

/// Says of many points at once on which side of a sheet they are. Called from several threads. Voxels on the rest plane
/// are handed over a hair below it, so that they count as below.
/// @param local  frame-local
/// @param above  same length: 1 above (removed), 0 below
using SideOfPoints = std::function<void(std::span<const glm::vec3> local, std::span<std::uint8_t> above)>;

/// How much of what is protected a clip leaves whole, and how far it strays to do so.
struct KeptWhole {
  std::int64_t cutAreaPlane = 0;     ///< 6-neighbour pairs of protected voxels that the rest plane separates
  std::int64_t cutAreaMembrane = 0;  ///< that the sheet separates
  double ratio = 1.0;  ///< membrane / plane; 1 where neither cuts, the membrane's count where the plane cuts none
  double meanDistance = 0.0;  ///< of the sheet from the rest plane
};

/// The voxels that can matter to a membrane: those within its frame and reach, and their neighbours.
VoxelBox voxelsInReach(const Potential& potential, const scene::Cut& cut);

/// Counts the protected pairs that a sheet separates, and those that the plane does. A pair counts when one of its
/// voxels lies within the rest plane's box. All cores. O(voxels of the box).
/// @param voxels    at least those of voxelsInReach()
/// @param side      of the sheet
/// @param meanDistance  of the sheet, handed through
KeptWhole measureKeptWhole(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side,
                           double meanDistance, Progress& progress);

/// Mean distance of a sheet from the rest plane, weighted by the area of the rest plane over which its triangles lie; a
/// folded sheet counts with each of its layers. Exact for its triangles. 0 for an empty shape.
double meanDistance(const scene::SheetShape& shape);

}  // namespace velum::membrane
