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

/// Says of many points at once on which side of a sheet they are. Called from several threads. Voxels on the rest plane
/// are handed over a hair below it, so that they count as below.
/// @param local  frame-local
/// @param above  same length: 1 above (removed), 0 below
using SideOfPoints = std::function<void(std::span<const glm::vec3> local, std::span<std::uint8_t> above)>;

/// What becomes of all that a membrane protects, near its sheet and far from it, by volume. The three sum up to 1.
struct Fate {
  double kept = 1.0;           ///< lies on the side that stays
  double removed = 0.0;        ///< is taken away whole: pieces, by voxels' faces, of which 2 % stay at most
  double cutOff = 0.0;         ///< is taken away of pieces of which a part stays
  bool isOfSomething = false;  ///< anything is protected at all
  bool operator==(const Fate&) const = default;
};

/// How much of what is protected a clip leaves whole, and how far it strays to do so.
struct KeptWhole {
  std::int64_t cutAreaPlane = 0;     ///< 6-neighbour pairs of protected voxels that the rest plane separates
  std::int64_t cutAreaMembrane = 0;  ///< that the sheet separates
  double ratio = 1.0;  ///< membrane / plane; 1 where neither cuts, the membrane's count where the plane cuts none
  double meanDistance = 0.0;                    ///< of the sheet from the rest plane
  std::int64_t planeAbove = 0, planeBelow = 0;  ///< of the plane's pairs: those that lie above, below the sheet whole
  Fate fate;                                    ///< measureFate(), where somebody has asked it
};

/// What becomes of what the rest plane would cut; they sum up to 1.
struct Shares {
  double kept = 1.0;     ///< stays whole
  double removed = 0.0;  ///< is taken away whole
  double cut = 0.0;      ///< is cut, there or elsewhere
};
/// `cut` is the ratio, 1 at most; what it leaves is shared out as the plane's pairs that the sheet does not separate.
/// @param cut  the membrane, for which side it removes
Shares sharesOf(const KeptWhole& figure, const scene::Cut& cut);

/// The sheet cuts more than its rest plane, by the sided rule and with nothing that hands have put in to hold it there:
/// the flat sheet is to be taken.
bool isWorseThanFlat(const KeptWhole& figure, const scene::Cut& cut);
/// Of the flat sheet, given those of another one.
KeptWhole figureOfFlat(const KeptWhole& other);

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
