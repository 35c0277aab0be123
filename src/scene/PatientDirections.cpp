#include "scene/PatientDirections.h"

#include "scene/Scene.h"

namespace velum::scene {

bool hasPatientDirections(const Scene& scene) {
  if (scene.volume.data) return scene.volume.data->isOrientationKnown;
  if (scene.model.data) return false;
  if (!scene.labels.data) return !hasData(scene);
  // A grid along the axes that begins at the origin is where readers put one of which nothing is said.
  const glm::dmat4& m = scene.labels.data->worldFromVoxel();
  bool isPlain = glm::dvec3(m[3]) == glm::dvec3(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 along(0.0);
    along[axis] = glm::length(glm::dvec3(m[axis]));
    isPlain = isPlain && glm::dvec3(m[axis]) == along;
  }
  return !isPlain;
}

}  // namespace velum::scene
