#pragma once
#include <glm/glm.hpp>

#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"

namespace velum::membrane {

/// A tolerance, in voxels: a voxel on the rest plane, or on the edge of the rest plane, must not change sides by the
/// last digits of its position.
constexpr double kHair = 1e-4;

/// The box of a membrane's rest plane and reach, for testing the voxels of a grid.
struct FrameBox {
  glm::dmat4 localFromVoxel{1.0};
  glm::dvec3 half{0.0};  ///< half the cut's size and a hair more, so that voxels on the box's edge are inside
  double hair = 0.0;

  FrameBox(const scene::Cut& cut, const glm::dmat4& worldFromVoxel)
      : localFromVoxel(glm::inverse(scene::worldFromCut(cut)) * worldFromVoxel),
        hair(kHair * glm::length(glm::dvec3(localFromVoxel[0]))) {
    half = cut.size * 0.5 + hair;
  }
  glm::dvec3 local(glm::dvec3 voxel) const { return glm::dvec3(localFromVoxel * glm::dvec4(voxel, 1.0)); }
  bool holds(glm::dvec3 local) const { return glm::all(glm::lessThanEqual(glm::abs(local), half)); }
};

/// True when the mask has an entry for each voxel of the box.
inline bool holdsItsBox(const ProtectedVoxels& voxels) {
  glm::ivec3 size = voxels.box.end - voxels.box.min;
  return voxels.mask.size() == std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
}

}  // namespace velum::membrane
