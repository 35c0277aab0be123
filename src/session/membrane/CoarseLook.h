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

/// A look at what a membrane protects on a grid so coarse (some 50 places along each edge) that what becomes of it is
/// known in milliseconds. By value and by label only: gradients take seconds.
class CoarseLook {
 public:
  /// @throw Cancelled
  CoarseLook(const membrane::Potential& potential, const scene::ForceField& field, Progress& progress);

  /// The share of the places that are protected.
  double share() const;
  /// How deep one place is along a direction of length 1, in the world; and all of them.
  double depthAlong(glm::dvec3 axis) const;
  double wholeDepthAlong(glm::dvec3 axis) const;
  /// @param visit  gets the voxel of the data, and the point in the world, in the middle of each place that is
  /// protected
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
    double planePairs = 0, sheetPairs = 0;  ///< that the rest plane cuts, and the least cut
    membrane::Fate fate;                    ///< of all that is protected, by the least cut
    double cutShare() const { return planePairs > 0.0 ? sheetPairs / planePairs : 1.0; }
  };
  /// Of a membrane in this place with this reach. @throw Cancelled
  Outlook outlookOf(const scene::Cut& cut, Progress& progress) const;

 private:
  membrane::CoarseVoxels mVoxels;
};

/// A membrane in another place, or with another reach, and what comes of it.
struct Placed {
  scene::Cut cut;
  CoarseLook::Outlook outlook;
};
/// placedToKeep() by a look that has been taken.
std::optional<Placed> placedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress,
                                   bool isReachFree = true);
/// The shortest reach that keeps enough; nothing where none does.
std::optional<Placed> deepenedToKeep(const CoarseLook& look, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
