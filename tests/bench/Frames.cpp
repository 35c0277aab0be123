#include "Frames.h"

#include <cmath>

#include "core/LabelVolume.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"

namespace velum::bench {

namespace {

struct Grid {
  glm::dvec3 dims{1.0};
  glm::dmat4 worldFromVoxel{1.0};
};

Grid gridOf(const scene::Scene& scene) {
  if (scene.volume.data) return {glm::dvec3(scene.volume.data->dims), scene.volume.data->worldFromVoxel};
  return {glm::dvec3(scene.labels.data->dims()), scene.labels.data->worldFromVoxel()};
}

}  // namespace

std::optional<glm::dvec3> clickPlace(const Volume& volume, double low, double high) {
  auto isMeant = [&](glm::ivec3 p) {
    double value = valueAt(volume, p);
    return value >= low && value <= high;
  };
  glm::dvec3 middle = glm::dvec3(volume.dims - 1) * 0.5, best(-1.0);
  double nearest = 1e300;
  glm::ivec3 p;
  for (p.z = 1; p.z + 1 < volume.dims.z; ++p.z)
    for (p.y = 1; p.y + 1 < volume.dims.y; ++p.y)
      for (p.x = 1; p.x + 1 < volume.dims.x; ++p.x) {
        double distance = glm::length(glm::dvec3(p) - middle);
        if (distance >= nearest || !isMeant(p)) continue;
        bool isInside = true;
        for (int axis = 0; axis < 3; ++axis)
          for (int step : {-1, 1}) {
            glm::ivec3 q = p;
            q[axis] += step;
            isInside = isInside && isMeant(q);
          }
        if (isInside) nearest = distance, best = p;
      }
  if (best.x < 0.0) return std::nullopt;
  return glm::dvec3(volume.worldFromVoxel * glm::dvec4(best, 1.0));
}

scene::Cut membraneAcross(const scene::Scene& scene, glm::dvec3 along, double share) {
  Grid grid = gridOf(scene);
  glm::dvec3 centre(grid.worldFromVoxel * glm::dvec4((grid.dims - 1.0) * 0.5, 1.0));
  double extent = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    extent += std::abs(glm::dot(glm::dvec3(grid.worldFromVoxel[axis]), along)) * grid.dims[axis];
  scene::Scene seen = scene;
  seen.camera.target = centre;
  seen.camera.eye = centre + along * 1000.0;
  scene::Cut cut = session::makeCut(seen, scene::CutShape::Membrane);
  cut.axis = along;
  cut.centre = centre + along * (extent * (share - 0.5));
  return cut;
}

}  // namespace velum::bench
