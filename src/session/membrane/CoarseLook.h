#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/Task.h"
#include "membrane/forces/CoarseVoxels.h"
#include "membrane/forces/Fate.h"
#include "scene/Cut.h"
#include "scene/Membrane.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// A look at what a membrane protects, on a grid so coarse (some 50 places along each edge) that the fate of all of it
/// is known in milliseconds. Counts what is protected by value and by label only: gradients take seconds.
class CoarseLook {
 public:
  /// @throw Cancelled
  CoarseLook(const membrane::Potential& potential, const scene::ForceField& field, Progress& progress);

  /// The share of the grid's places that are protected.
  double share() const;
  /// How deep one place of the grid is along a direction of length 1, in the world; and how deep all of the grid is.
  double depthAlong(glm::dvec3 axis) const;
  double wholeDepthAlong(glm::dvec3 axis) const;
  /// @param visit  called for the middle of each place that is protected, with the voxel of the data and the point in
  /// the world
  template <class Visit>
  void forEachProtected(Visit visit) const {
    glm::ivec3 n = mVoxels.grid.box.end, at;
    const std::uint8_t* mask = mVoxels.grid.mask.data();
    for (at.z = 0; at.z < n.z; ++at.z)
      for (at.y = 0; at.y < n.y; ++at.y)
        for (at.x = 0; at.x < n.x; ++at.x)
          if (*mask++) visit(mVoxels.voxelOf(at), glm::dvec3(mVoxels.grid.worldFromVoxel * glm::dvec4(at, 1.0)));
  }

  struct Outlook {
    double planePairs = 0, sheetPairs = 0;  ///< neighbours that the rest plane parts; that the least cut parts
    membrane::Fate fate;                    ///< of all that is protected, with the least cut as the sheet
    double cutShare() const { return planePairs > 0.0 ? sheetPairs / planePairs : 1.0; }
  };
  /// What would come of a membrane in this place with this reach. @throw Cancelled
  Outlook outlookOf(const scene::Cut& cut, Progress& progress) const;

 private:
  membrane::CoarseVoxels mVoxels;
};

/// A membrane in another place, or with another reach, and what would come of it.
struct Placed {
  scene::Cut cut;
  CoarseLook::Outlook outlook;
};
/// placedToKeep() of FirstPlace.h with a look that was taken already.
std::optional<Placed> placedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress,
                                   bool isReachFree = true);
/// The membrane with the shortest reach by which enough is kept; nothing where no reach keeps enough.
std::optional<Placed> deepenedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
