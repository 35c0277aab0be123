#pragma once
#include <vector>

#include "velum/core/Task.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// A look at what a membrane protects on a grid so coarse (some 50 places along each edge) that what becomes of it is
/// known in milliseconds. By value and by label only: gradients take seconds.
class CoarseLook {
 public:
  /// @throw Cancelled
  CoarseLook(const scene::Scene& scene, const scene::ForceField& field, Progress& progress);

  const membrane::ProtectedVoxels& voxels() const { return mVoxels; }
  /// Nearest voxel of the data of each of them.
  glm::ivec3 voxelOf(glm::ivec3 place) const { return place * mStep + mStep / 2; }

  struct Pairs {
    double plane = 0, sheet = 0;  ///< that the rest plane cuts, and the least cut
  };
  /// Of a membrane in this place with this reach. @throw Cancelled
  Pairs pairsOf(const scene::Cut& cut, Progress& progress) const;

 private:
  glm::ivec3 mStep{1};
  membrane::ProtectedVoxels mVoxels;
};

}  // namespace velum::session
