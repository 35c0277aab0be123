#include "session/cut/NewCut.h"

#include <algorithm>
#include <cmath>

#include "core/Vectors.h"
#include "render/section/SectionImage.h"
#include "scene/Project.h"
#include "scene/SectionPlane.h"
#include "session/cut/CutEdit.h"

namespace velum::session {

namespace {

/// True where there is material that is drawn; of colours and mixed channels nobody knows.
bool shows(const scene::Scene& scene, glm::dvec3 world) {
  render::Probe there = render::probe(scene, world);
  if (!scene.volume.data) return there.structure != 0;
  return scene.volume.visible && there.values.size() == 1 &&
         scene::opacityAt(scene.volume.transfer.opacities, there.values[0]) > 0.05;
}

/// How far from the middle the eye's line comes upon the first material; the side of the box where it meets none.
double firstShown(const scene::Scene& scene, const DataBox& data, glm::dvec3 toEye, double toSide) {
  double step = scene::sectionStep(scene);
  for (double t = toSide; step > 0 && t > -toSide; t -= step)
    if (shows(scene, data.middle + toEye * t)) return t;
  return toSide;
}

/// Where the eye meets the data, and an eighth of their shortest edge deep: of a shape of a third of that edge some is
/// outside of them, however deep they are and whatever air is about them.
glm::dvec3 placeAtSide(const scene::Scene& scene, const DataBox& data, glm::dvec3 toEye, double third) {
  if (!isCrosshairAtRest(scene)) return scene.sections.crosshair;
  glm::dvec3 reach = glm::abs(toEye) / data.edges;
  double toSide = 0.5 / std::max(reach.x, std::max(reach.y, reach.z));
  return data.middle + toEye * (firstShown(scene, data, toEye, toSide) - 0.375 * third);
}

}  // namespace

bool isCrosshairAtRest(const scene::Scene& scene) {
  if (!scene.sections.isPlaced) return true;
  scene::Scene opened = scene;
  opened.sections.isPlaced = false;
  scene::placeSections(opened);
  glm::dvec3 off = opened.sections.crosshair - scene.sections.crosshair;
  return glm::length(off) < 1e-6 * glm::length(dataOf(scene).edges);
}

glm::dvec3 cleaned(glm::dvec3 v) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 1e-9) v[i] = 0.0;
  return v;
}

DataBox dataOf(const scene::Scene& scene) {
  scene::Bounds bounds = scene::computeBounds(scene);
  return {(bounds.min + bounds.max) * 0.5, solidEdges(bounds.max - bounds.min)};
}

glm::dvec3 towardsEye(const scene::Scene& scene) { return cleaned(-scene::cameraBasis(scene.camera).forward); }

NewCut newCutIn(const scene::Scene& scene) {
  DataBox data = dataOf(scene);
  glm::dvec3 toEye = towardsEye(scene);
  double third = std::min(data.edges.x, std::min(data.edges.y, data.edges.z)) / 3.0;
  return {scene, data, toEye, placeAtSide(scene, data, toEye, third), third, glm::dot(glm::abs(toEye), data.edges)};
}

glm::dvec3 frameSize(double width, double height) { return {width, height, 0.22 * std::sqrt(width * height)}; }

namespace {

constexpr double kMostLonger = 10.0;

/// The volume's box along its own axes, so large that it holds a model beside the volume, too.
DataBox boxAlong(const glm::dmat3& axes, const scene::Scene& scene) {
  const Volume& volume = *scene.volume.data;
  DataBox box{centreOf(volume), spacingOf(volume) * glm::dvec3(volume.dims)};
  if (!scene.model.data) return box;
  scene::ModelBox model = scene::worldBoxOfModel(scene);
  // One of another scale is not meant.
  if (glm::length(model.high - model.low) > kMostLonger * glm::length(box.edges)) return box;
  glm::dvec3 low = -0.5 * box.edges, high = 0.5 * box.edges;
  for (int corner = 0; corner < 8; ++corner) {
    glm::bvec3 isHigh(corner & 1, corner & 2, corner & 4);
    glm::dvec3 at = glm::transpose(axes) * (glm::mix(model.low, model.high, isHigh) - box.middle);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {box.middle + axes * (0.5 * (low + high)), high - low};
}

}  // namespace

void hangMembrane(scene::Cut& cut, const NewCut& at) {
  glm::dmat3 axes = at.scene.volume.data ? direction(*at.scene.volume.data) : glm::dmat3(1.0);
  auto [middle, edges] = at.scene.volume.data ? boxAlong(axes, at.scene) : at.data;
  glm::dvec3 along = glm::transpose(axes) * at.toEye, size = glm::abs(along);
  int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  glm::dvec3 z = cleaned(axes[k] * (along[k] < 0 ? -1.0 : 1.0));
  glm::dvec3 x = cleaned(axes[(k + 1) % 3]);
  setCutFrame(cut, glm::dmat3(x, glm::cross(z, x), z));
  cut.centre = middle + z * glm::dot(cut.centre - middle, z);
  cut.size = frameSize(edges[(k + 1) % 3], edges[(k + 2) % 3]);
}

}  // namespace velum::session
