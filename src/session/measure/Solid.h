#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "session/measure/MeshWay.h"

namespace velum::session {

/// A box of the world.
struct WorldBox {
  glm::dvec3 low{0.0}, high{0.0};
};

/// A body of a scene whose surface is seen.
struct Solid {
  std::function<bool(glm::dvec3 world)> holds;  ///< any thread; without what the cuts have removed
  std::string problem;                          ///< why there is none; then `holds` is empty
};

/// How fine the data is in which bodies lie, and where it lies.
struct SolidGrid {
  double fineness = 1.0;   ///< the smallest edge of a voxel, scene units
  double roughness = 1.0;  ///< the longest edge by the smallest
  WorldBox box;            ///< nothing is beyond it
};
/// Of the labels where structures lie at both places, else of the volume; without a problem only where there is one.
struct SolidPlace {
  SolidGrid grid;
  bool isStructure = false;
  std::string problem;
};
SolidPlace solidPlaceAt(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b);

/// The body under two places of a surface: the structure in which, or next to which, both lie, or all structures where
/// they are two; else what has at least a value: that of the isosurface where one is shown, else the mean of the values
/// at the places, faces of cuts left out. The scene must outlive it.
/// @param place  solidPlaceAt()  @param box  that will be asked about  @param step  the least that matters: of a
/// streamed volume the level is read whose voxels are as fine
/// @throw Cancelled; InputError when a brick cannot be read. Any thread.
Solid solidUnder(const scene::Scene& scene, const SolidPlace& place, glm::dvec3 a, glm::dvec3 b, const WorldBox& box,
                 double step, Progress& progress);

/// The surface of a solid within a box, open where it leaves the box: by marching tetrahedra over a grid, with places
/// found to a hundredth of a step, from which what is left of steps between voxels is smoothed. All cores.
/// @param rounds  of smoothing  @throw Cancelled
WayMesh surfaceOf(const Solid& solid, const WorldBox& box, double step, int rounds, Progress& progress);

}  // namespace velum::session
