#include "scene/VisibleFrame.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "scene/ModelView.h"
#include "scene/Presets.h"
#include "scene/ShownVoxels.h"

namespace velum::scene {

namespace {

constexpr double kMostFrameSamples = 2e6;
constexpr double kSpecks = 1e-3;  ///< of what shows, that may be outside of the picture
constexpr double kMargin = 1.08;
constexpr std::size_t kFewPlaces = 50;
// Of what is no patient.
constexpr double kBase = 0.03;       ///< of the whole, in which a base is flat
constexpr double kLeastBase = 0.25;  ///< of its side of the box that a base touches
constexpr double kOtherBase = 0.6;   ///< of a base, that no other end touches
constexpr double kLonger = 1.15;     ///< a way across that is not about as long as the other
constexpr double kFlat = 0.6;        ///< of its width, as high as which it is seen from above

/// Places, world, of those that show.
std::vector<glm::dvec3> placesOf(const ShownVoxels& voxels) {
  std::vector<glm::dvec3> places;
  std::size_t i = 0;
  for (int z = 0; z < voxels.dims.z; ++z)
    for (int y = 0; y < voxels.dims.y; ++y)
      for (int x = 0; x < voxels.dims.x; ++x, ++i)
        if (voxels.shown[i]) places.emplace_back(voxels.worldFromVoxel * glm::dvec4(x, y, z, 1.0));
  return places;
}

/// All but the outermost of some numbers, which are put into another order.
std::pair<double, double> withoutStrays(std::vector<double>& numbers) {
  auto spare = std::ptrdiff_t(double(numbers.size()) * kSpecks);
  auto low = numbers.begin() + spare, high = numbers.end() - 1 - spare;
  std::nth_element(numbers.begin(), low, numbers.end());
  double least = *low;
  std::nth_element(numbers.begin(), high, numbers.end());
  return {least, *high};
}

bool fitsWhatShows(const Scene& scene) {
  bool isColor = scene.volume.data && scene.volume.data->isColor;
  bool isBox = isColor || isAllMaterial(scene.volume.transfer.preset);
  bool isAlone = scene.surfaces.empty() && !scene.model.data && !isBox;
  return isAlone && (scene.volume.data || scene.labels.data);
}

double longestEdge(const glm::dmat4& worldFromVoxel) {
  double edge = 0.0;
  for (int axis = 0; axis < 3; ++axis) edge = std::max(edge, glm::length(glm::dvec3(worldFromVoxel[axis])));
  return edge;
}

const glm::dmat4& gridOf(const Scene& scene) {
  return scene.volume.data ? scene.volume.data->worldFromVoxel : scene.labels.data->worldFromVoxel();
}

/// The camera as near as all of the places let it come, from where it looks.
Camera fit(const Scene& scene, Camera camera, std::vector<glm::dvec3> places, double aspect) {
  // As the picture sees them: to the right, up, towards the eye.
  glm::dvec3 toEye = glm::normalize(camera.eye - camera.target), right = glm::normalize(glm::cross(camera.up, toEye)),
             up = glm::cross(toEye, right);
  glm::dmat3 seenFromWorld = glm::transpose(glm::dmat3(right, up, toEye));
  std::vector<double> across(places.size()), along(places.size()), depths(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = seenFromWorld * places[i];
    across[i] = places[i].x, along[i] = places[i].y, depths[i] = places[i].z;
  }
  auto [left, rightmost] = withoutStrays(across);
  auto [bottom, top] = withoutStrays(along);
  auto [back, front] = withoutStrays(depths);
  glm::dvec3 middle(0.5 * (left + rightmost), 0.5 * (bottom + top), 0.5 * (back + front));
  double voxel = longestEdge(gridOf(scene));
  // So far that all of them are inside of the pyramid that the eye sees.
  double tangent = std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5);
  std::vector<double>& distances = across;
  for (std::size_t i = 0; i < places.size(); ++i) {
    glm::dvec3 off = places[i] - middle;
    double wide = std::max((std::abs(off.x) + voxel) / aspect, std::abs(off.y) + voxel);
    distances[i] = wide * kMargin / tangent + off.z;
  }
  double distance = withoutStrays(distances).second;
  camera.height = 2.0 * kMargin * std::max(0.5 * (top - bottom) + voxel, (0.5 * (rightmost - left) + voxel) / aspect);
  camera.target = glm::transpose(seenFromWorld) * middle;
  camera.eye = camera.target + toEye * distance;
  return camera;
}

/// The box of places but for specks.
Bounds boundsOf(const std::vector<glm::dvec3>& places) {
  Bounds box;
  std::vector<double> numbers(places.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < places.size(); ++i) numbers[i] = places[i][axis];
    std::tie(box.min[axis], box.max[axis]) = withoutStrays(numbers);
  }
  return box;
}

/// How much of a side of the box something touches. @param end  of the axis: 0 or 1
double baseShare(const std::vector<glm::dvec3>& places, const Bounds& box, int axis, int end, double apart) {
  constexpr int kMostCells = 48;
  int a = (axis + 1) % 3, b = (axis + 2) % 3;
  glm::dvec3 edges = glm::max(box.max - box.min, glm::dvec3(apart));
  auto cellsAlong = [&](int along) { return std::clamp(int(edges[along] / (1.5 * apart)), 1, kMostCells); };
  glm::ivec2 cells(cellsAlong(a), cellsAlong(b));
  std::vector<bool> touched(std::size_t(cells.x * cells.y));
  double near = std::max(kBase * edges[axis], 1.5 * apart);
  for (const glm::dvec3& place : places) {
    double off = end == 0 ? place[axis] - box.min[axis] : box.max[axis] - place[axis];
    if (std::abs(off) > near) continue;
    glm::ivec2 cell(glm::floor(glm::dvec2(place[a] - box.min[a], place[b] - box.min[b]) /
                               glm::dvec2(edges[a], edges[b]) * glm::dvec2(cells)));
    if (cell.x < 0 || cell.y < 0 || cell.x >= cells.x || cell.y >= cells.y) continue;
    touched[std::size_t(cell.y * cells.x + cell.x)] = true;
  }
  return double(std::count(touched.begin(), touched.end(), true)) / double(touched.size());
}

/// Away from the base on which it stands; the third axis where there is none, or another end is as flat.
glm::dvec3 upOf(const std::vector<glm::dvec3>& places, const Bounds& box, double apart) {
  double shares[3][2];
  for (int axis = 0; axis < 3; ++axis)
    for (int end : {0, 1}) shares[axis][end] = baseShare(places, box, axis, end, apart);
  glm::dvec3 up(0, 0, 1);
  for (int axis = 0; axis < 3; ++axis)
    for (int end : {0, 1}) {
      double share = shares[axis][end], most = kOtherBase * share;
      bool isBase = share > kLeastBase;
      for (int other = 0; other < 3; ++other)
        for (int side : {0, 1}) isBase = isBase && ((other == axis && side == end) || shares[other][side] < most);
      if (!isBase) continue;
      up = glm::dvec3(0.0);
      up[axis] = end == 0 ? 1.0 : -1.0;
    }
  return up;
}

/// Looks at what is no patient from a corner: along the shorter of the ways across, and more from above at what is
/// flat.
void standUp(Camera& camera, const std::vector<glm::dvec3>& places, double apart) {
  Bounds box = boundsOf(places);
  glm::dvec3 edges = box.max - box.min, up = upOf(places, box, apart);
  int axis = std::abs(up.x) > 0.5 ? 0 : std::abs(up.y) > 0.5 ? 1 : 2, a = (axis + 1) % 3, b = (axis + 2) % 3;
  int main = edges[a] * kLonger < edges[b] ? a : b, beside = main == a ? b : a;
  bool isFlat = edges[axis] < kFlat * std::min(edges[a], edges[b]);
  glm::dvec3 toEye = (isFlat ? 0.8 : 0.35) * up;
  toEye[main] = -1.0;
  toEye[beside] = -0.55;
  camera.eye = camera.target + glm::normalize(toEye) * glm::length(camera.eye - camera.target);
  camera.up = up;
}

}  // namespace

Camera frameVisible(const Scene& scene, StandardView view, double aspect) {
  Camera camera = frameCamera(scene, view, aspect);
  if (!fitsWhatShows(scene)) return camera;
  std::vector<glm::dvec3> places = placesOf(shownVoxels(scene, kMostFrameSamples, kVeil));
  return places.size() < kFewPlaces ? camera : fit(scene, camera, std::move(places), aspect);
}

Camera firstCamera(const Scene& scene, double aspect) {
  if (isModelAlone(scene)) return frameModel(scene, bestSide(scene, aspect), aspect);
  StandardView view = defaultView(scene);
  Camera camera = frameCamera(scene, view, aspect);
  if (!fitsWhatShows(scene)) return camera;
  ShownVoxels shown = shownVoxels(scene, kMostFrameSamples, kVeil);
  std::vector<glm::dvec3> places = placesOf(shown);
  if (places.size() < kFewPlaces) return camera;
  if (view == StandardView::Oblique) standUp(camera, places, longestEdge(shown.worldFromVoxel));
  return fit(scene, camera, std::move(places), aspect);
}

}  // namespace velum::scene
