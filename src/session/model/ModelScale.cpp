#include "session/model/ModelScale.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/Scene.h"

namespace velum::session {

namespace {

/// Beyond that the smaller of two things is a pixel or two of a picture that shows the larger.
constexpr double kMostApart = 400.0;
constexpr double kPartOfOthers = 1.0 / 3.0;

double longestEdge(glm::dvec3 edges) { return std::max(edges.x, std::max(edges.y, edges.z)); }

scene::Bounds boundsOfOthers(const scene::Scene& scene) {
  scene::Scene others = scene;
  others.model = {};
  return scene::computeBounds(others);
}

bool hasOthers(const scene::Scene& scene) {
  return scene.model.data && (scene.volume.data || scene.labels.data || !scene.surfaces.empty());
}

double edgeOfModel(const scene::Scene& scene) {
  scene::ModelBox box = scene::worldBoxOfModel(scene);
  return longestEdge(box.high - box.low);
}

}  // namespace

double othersByModel(const scene::Scene& scene) {
  if (!hasOthers(scene)) return 1.0;
  scene::Bounds others = boundsOfOthers(scene);
  double model = edgeOfModel(scene), edge = longestEdge(others.max - others.min);
  return model > 0.0 && edge > 0.0 ? edge / model : 1.0;
}

bool isOutOfScale(const scene::Scene& scene) {
  double times = othersByModel(scene);
  return times > kMostApart || times < 1.0 / kMostApart;
}

std::string scaleWords(const scene::Scene& scene) {
  if (!isOutOfScale(scene)) return {};
  double times = othersByModel(scene);
  std::string name = scene.model.data->name.empty() ? "the model" : scene.model.data->name;
  auto told = [](double number) {
    return number < 1e5 ? fmt::format("{:.0f}", number) : fmt::format("{:.0e}", number);
  };
  return times > 1.0
             ? fmt::format("{} is {} times smaller than the other data, and not seen beside them", name, told(times))
             : fmt::format("{} is {} times larger than the other data, which are not seen beside it", name,
                           told(1.0 / times));
}

void bringModelToSize(scene::Scene& scene) {
  if (!hasOthers(scene) || edgeOfModel(scene) <= 0.0) return;
  scene.model.enlargement *= kPartOfOthers * othersByModel(scene);
  scene.model.offset = glm::dvec3(0.0);
  scene::Bounds others = boundsOfOthers(scene);
  scene::ModelBox box = scene::worldBoxOfModel(scene);
  glm::dvec3 edges = others.max - others.min, own = box.high - box.low;
  glm::dvec3 right = glm::cross(scene.camera.target - scene.camera.eye, scene.camera.up);
  // Beside it along the axis that points to the right most, with a little room.
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(right[i]) > std::abs(right[axis])) axis = i;
  glm::dvec3 middle = 0.5 * (others.min + others.max);
  middle[axis] += (right[axis] < 0.0 ? -1.0 : 1.0) * (0.5 * edges[axis] + 0.6 * own[axis]);
  scene.model.offset = middle - 0.5 * (box.low + box.high);
}

}  // namespace velum::session
