#include "session/measure/SurfaceLeft.h"

#include <cmath>
#include <functional>

#include "core/Parallel.h"
#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "session/measure/VoxelFaces.h"

namespace velum::session {

namespace {

/// Faces that a cut passes are looked at in so many places along each edge.
constexpr int kPlacesAlongEdge = 8;

class KeptFaces {
 public:
  KeptFaces(const scene::Scene& scene, int structure)
      : mWorldFromVoxel(scene.labels.data->worldFromVoxel()),
        mKept(scene, worldOf(0.5 * glm::dvec3(scene.labels.data->dims() - 1))),
        mStructure(std::uint16_t(structure)) {
    glm::dmat3 axes(mWorldFromVoxel);
    mReach = 0.5 * (glm::length(axes[0]) + glm::length(axes[1]) + glm::length(axes[2]));
    // The distance to a sheet is measured along its frame's axis, which is further than to a steep sheet beside it.
    if (mKept.hasSheets()) mReach *= 3.0;
  }

  double shareOf(const VoxelFace& face) const {
    if (mKept.isEmpty()) return 1.0;
    glm::dvec3 middle = glm::dvec3(face.voxel) + 0.5 * glm::dvec3(face.way);
    double distance = mKept.distance(worldOf(middle), mStructure).distance;
    if (std::abs(distance) > mReach) return distance > 0.0 ? 1.0 : 0.0;
    glm::dvec3 along(face.way.x == 0, face.way.x != 0, 0.0), across = glm::cross(glm::dvec3(face.way), along);
    int left = 0;
    for (int i = 0; i < kPlacesAlongEdge; ++i)
      for (int j = 0; j < kPlacesAlongEdge; ++j) {
        glm::dvec2 at = (glm::dvec2(i, j) + 0.5) / double(kPlacesAlongEdge) - 0.5;
        left += mKept.keeps(worldOf(middle + at.x * along + at.y * across), mStructure) ? 1 : 0;
      }
    return double(left) / (kPlacesAlongEdge * kPlacesAlongEdge);
  }

 private:
  glm::dvec3 worldOf(glm::dvec3 voxel) const { return glm::dvec3(mWorldFromVoxel * glm::dvec4(voxel, 1.0)); }
  glm::dmat4 mWorldFromVoxel;
  render::KeptPlaces mKept;
  std::uint16_t mStructure;
  double mReach = 0.0;
};

}  // namespace

double surfaceLeft(const scene::Scene& scene, int structure, glm::ivec3 low, glm::ivec3 high, Progress& progress) {
  auto faces = voxelFaces(*scene.labels.data, std::uint16_t(structure), low, high, progress);
  KeptFaces kept(scene, structure);
  auto body = [&](std::size_t first, std::size_t end) {
    progress.throwIfCancelled();
    double area = 0.0;
    for (std::size_t i = first; i < end; ++i) area += faces[i].area * kept.shareOf(faces[i]);
    return area;
  };
  return parallelReduce(std::size_t(0), faces.size(), std::size_t(4096), 0.0, body, std::plus<>());
}

}  // namespace velum::session
