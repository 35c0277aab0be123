#pragma once
#include "velum/core/Task.h"
#include "velum/membrane/forces/CoarseVoxels.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// A look at what a membrane protects on a grid so coarse (some 50 places along each edge) that what becomes of it is
/// known in milliseconds. By value and by label only: gradients take seconds.
class CoarseLook {
 public:
  /// @throw Cancelled
  CoarseLook(const membrane::Potential& potential, const scene::ForceField& field, Progress& progress);

  /// The share of the places that are protected.
  double share() const;
  /// How deep one place is along a direction of length 1, in the world.
  double depthAlong(glm::dvec3 axis) const;
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

  struct Pairs {
    double plane = 0, sheet = 0;  ///< that the rest plane cuts, and the least cut
  };
  /// Of a membrane in this place with this reach. @throw Cancelled
  Pairs pairsOf(const scene::Cut& cut, Progress& progress) const;

 private:
  membrane::CoarseVoxels mVoxels;
};

/// firstPlaceOf() by a look that has been taken.
std::optional<glm::dvec3> firstPlaceOf(const CoarseLook& look, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
