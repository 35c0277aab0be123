#pragma once
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "core/Task.h"
#include "membrane/forces/Kernels.h"
#include "scene/SceneFwd.h"
#include "scene/SheetShape.h"

namespace velum::membrane {

/// Tells for many points at once on which side of a sheet each of them is. Called from several threads. Voxels on the
/// rest plane are passed a hair lower, so that they count as below.
/// @param local  frame-local
/// @param above  written, one for each point: 1 above the sheet (removed), 0 below
using SideOfPoints = std::function<void(std::span<const glm::vec3> local, std::span<std::uint8_t> above)>;

/// What becomes of all protected material of a membrane, near its sheet and far from it, as shares of the material's
/// volume. The three shares sum up to 1.
struct Fate {
  double kept = 1.0;     ///< share that lies on the side that stays
  double removed = 0.0;  ///< share that is removed whole: pieces (joined by voxels' faces) of which at most 2 % stay
  double cutOff = 0.0;   ///< share that is removed from pieces of which a part stays
  bool isOfSomething = false;  ///< some material is protected
  bool operator==(const Fate&) const = default;
};

/// How much of the protected material a clipping sheet leaves whole, and how far it strays from the rest plane to do
/// so.
struct KeptWhole {
  std::int64_t cutAreaPlane = 0;     ///< 6-neighbour pairs of protected voxels that the rest plane separates
  std::int64_t cutAreaMembrane = 0;  ///< such pairs that the sheet separates
  double ratio = 1.0;  ///< membrane's count / plane's; 1 where both are 0, the membrane's count where the plane's is 0
  double meanDistance = 0.0;  ///< of the sheet from the rest plane
  /// Plane's pairs that lie whole above, below the sheet
  std::int64_t planeAbove = 0, planeBelow = 0;
  Fate fate;  ///< result of measureFate(), where that was asked for
};

/// What becomes of the material that the rest plane would cut, as shares that sum up to 1.
struct Shares {
  double kept = 1.0;     ///< stays whole
  double removed = 0.0;  ///< is taken away whole
  double cut = 0.0;      ///< is cut, there or elsewhere
};
/// Shares::cut is the ratio, at most 1; the rest is divided between the other two as planeAbove and planeBelow are.
/// @param cut  the membrane, which says which side is removed
Shares sharesOf(const KeptWhole& figure, const scene::Cut& cut);

/// True when the sheet cuts more than its rest plane although it hangs by the sided rule and nothing that was put in by
/// hand holds it there: then the flat sheet should be taken instead.
bool isWorseThanFlat(const KeptWhole& figure, const scene::Cut& cut);
/// The figures of the flat sheet, derived from those of another sheet of the same membrane.
KeptWhole figureOfFlat(const KeptWhole& other);

/// The box of the voxels that can matter to a membrane: those within its frame and reach, and their neighbours.
VoxelBox voxelsInReach(const Potential& potential, const scene::Cut& cut);
/// The same of any grid of voxels.
VoxelBox voxelsInReach(glm::ivec3 dims, const glm::dmat4& worldFromVoxel, const scene::Cut& cut);

/// Counts the protected pairs that a sheet separates, and those that the rest plane separates. A pair counts when one
/// of its voxels lies within the rest plane's box. All cores. O(voxels of the box).
/// @param voxels  at least those of voxelsInReach()
/// @param side  tells the side of the sheet that points are on @param meanDistance  of the sheet from the rest plane;
/// copied into the result
KeptWhole measureKeptWhole(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side,
                           double meanDistance, Progress& progress);

/// Mean distance of a sheet from the rest plane, weighted by the area of the rest plane over which its triangles lie; a
/// folded sheet counts with each of its layers. Exact for its triangles. 0 for an empty shape.
double meanDistance(const scene::SheetShape& shape);

}  // namespace velum::membrane
