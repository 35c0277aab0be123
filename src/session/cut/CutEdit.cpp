#include "velum/session/cut/CutEdit.h"

#include <algorithm>
#include <cmath>

#include "velum/core/Assert.h"
#include "velum/core/Vectors.h"
#include "velum/scene/Project.h"

namespace velum::session {

namespace {

/// A view along an axis gives a direction along it, without the noise of the sines.
glm::dvec3 cleaned(glm::dvec3 v) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(v[i]) < 1e-9) v[i] = 0.0;
  return v;
}

struct Data {
  glm::dvec3 middle, edges;
};

Data dataOf(const scene::Scene& scene) {
  scene::Bounds bounds = scene::computeBounds(scene);
  return {(bounds.min + bounds.max) * 0.5, solidEdges(bounds.max - bounds.min)};
}

glm::dvec3 towardsEye(const scene::Scene& scene) { return cleaned(-scene::cameraBasis(scene.camera).forward); }

/// True while nobody has moved the crosshair from where data is opened with it.
bool isCrosshairAtRest(const scene::Scene& scene) {
  if (!scene.sections.isPlaced) return true;
  scene::Scene opened = scene;
  opened.sections.isPlaced = false;
  scene::placeSections(opened);
  glm::dvec3 off = opened.sections.crosshair - scene.sections.crosshair;
  return glm::length(off) < 1e-6 * glm::length(dataOf(scene).edges);
}

/// The crosshair, where it was put somewhere; else where a box or sphere of a third of the data opens the side that
/// faces the eye, about half of it outside.
glm::dvec3 placeOfClosed(const scene::Scene& scene, const Data& data, glm::dvec3 toEye) {
  if (!isCrosshairAtRest(scene)) return scene.sections.crosshair;
  glm::dvec3 reach = glm::abs(toEye) / data.edges;
  double toSide = 0.5 / std::max(reach.x, std::max(reach.y, reach.z));
  return data.middle + toEye * (toSide * 0.75);
}

/// A frame as wide and high as the data, along those of its axes that face the eye; through the crosshair.
void hangMembrane(scene::Cut& cut, const scene::Scene& scene, const Data& data, glm::dvec3 toEye) {
  glm::dmat3 axes(1.0);
  glm::dvec3 edges = data.edges, middle = data.middle;
  if (scene.volume.data) {
    const Volume& volume = *scene.volume.data;
    axes = direction(volume);
    edges = spacingOf(volume) * glm::dvec3(volume.dims);
    middle = centreOf(volume);
  }
  glm::dvec3 along = glm::transpose(axes) * toEye, size = glm::abs(along);
  int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  glm::dvec3 z = cleaned(axes[k] * (along[k] < 0 ? -1.0 : 1.0));
  glm::dvec3 x = cleaned(axes[(k + 1) % 3]);
  setCutFrame(cut, glm::dmat3(x, glm::cross(z, x), z));
  cut.centre = middle + z * glm::dot(cut.centre - middle, z);
  cut.size = {edges[(k + 1) % 3], edges[(k + 2) % 3], 0.22 * std::sqrt(edges[(k + 1) % 3] * edges[(k + 2) % 3])};
}

}  // namespace

glm::dmat3 cutFrame(const scene::Cut& cut) { return glm::dmat3(scene::worldFromCut(cut)); }

void setCutFrame(scene::Cut& cut, const glm::dmat3& frame) {
  VELUM_ASSERT(std::abs(glm::determinant(frame)) > 1e-6, "the frame has three directions");
  cut.axis = cleaned(glm::normalize(frame[2]));
  cut.spinDeg = 0.0;
  glm::dmat3 unspun = cutFrame(cut);
  double spin = glm::degrees(std::atan2(glm::dot(frame[0], unspun[1]), glm::dot(frame[0], unspun[0])));
  cut.spinDeg = std::abs(spin) < 1e-9 ? 0.0 : spin;
}

scene::Cut makeCut(const scene::Scene& scene, scene::CutShape shape) {
  Data data = dataOf(scene);
  glm::dvec3 crosshair = scene.sections.isPlaced ? scene.sections.crosshair : data.middle;
  glm::dvec3 toEye = towardsEye(scene);
  double third = std::min(data.edges.x, std::min(data.edges.y, data.edges.z)) / 3.0;
  double through = glm::dot(glm::abs(toEye), data.edges);
  scene::Cut cut;
  cut.shape = shape;
  if (scene::isMembrane(cut)) cut.membrane.emplace();
  cut.centre = crosshair;
  switch (shape) {
    case scene::CutShape::Plane:
      cut.axis = nearestAxis(toEye);
      break;
    case scene::CutShape::Box:
      cut.axis = {0, 0, 1};
      cut.size = data.edges / 3.0;
      cut.centre = placeOfClosed(scene, data, toEye);
      break;
    case scene::CutShape::Sphere:
      cut.axis = {0, 0, 1};
      cut.size = glm::dvec3(third);
      cut.centre = placeOfClosed(scene, data, toEye);
      break;
    case scene::CutShape::Cylinder:
      cut.axis = toEye;
      cut.size = {third, third, through};
      break;
    case scene::CutShape::Cone:
      cut.axis = toEye;
      cut.size = {2.0 * third, 2.0 * third, through * 0.5};
      break;
    case scene::CutShape::Membrane:
      hangMembrane(cut, scene, data, toEye);
      break;
  }
  return cut;
}

scene::Cut cutFacingCamera(const scene::Scene& scene) {
  scene::Cut cut;
  cut.centre = dataOf(scene).middle;
  cut.axis = towardsEye(scene);
  return cut;
}

std::optional<scene::Cut> cutThrough(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  glm::dvec3 normal = glm::cross(b - a, c - a);
  double longest = std::max(glm::length(b - a), std::max(glm::length(c - a), glm::length(c - b)));
  // A triangle flatter than a thousandth of its length gives no direction that can be trusted.
  if (!(glm::length(normal) > 1e-3 * longest * longest)) return std::nullopt;
  scene::Cut cut;
  cut.centre = (a + b + c) / 3.0;
  cut.axis = cleaned(glm::normalize(normal));
  if (glm::dot(cut.axis, towardsEye(scene)) < 0) cut.axis = -cut.axis;
  return cut;
}

glm::dvec3 nearestAxis(glm::dvec3 direction) {
  int best = 2;
  for (int i = 1; i >= 0; --i)
    if (std::abs(direction[i]) > std::abs(direction[best])) best = i;
  glm::dvec3 axis(0.0);
  axis[best] = direction[best] < 0 ? -1.0 : 1.0;
  return axis;
}

scene::Cut alignedCut(const scene::Scene& scene, scene::Cut cut, glm::dvec3 axis) {
  if (cut.shape == scene::CutShape::Plane) {
    // The foot of the data's middle on the plane is what the plane shows the middle of.
    glm::dvec3 middle = dataOf(scene).middle, old = cutFrame(cut)[2];
    cut.centre = middle - old * glm::dot(middle - cut.centre, old);
    cut.invert = false;
  }
  cut.axis = axis;
  cut.spinDeg = 0.0;
  return cut;
}

AxisAngles anglesFromAxis(glm::dvec3 axis) {
  double length = glm::length(axis);
  if (!(length > 1e-12)) return {};
  axis /= length;
  AxisAngles angles;
  angles.elevationDeg = glm::degrees(std::asin(std::clamp(axis.z, -1.0, 1.0)));
  bool isUpright = std::hypot(axis.x, axis.y) < 1e-9;
  angles.azimuthDeg = isUpright ? 0.0 : glm::degrees(std::atan2(axis.x, -axis.y));
  return angles;
}

glm::dvec3 axisFromAngles(AxisAngles angles) {
  double azimuth = glm::radians(angles.azimuthDeg), elevation = glm::radians(angles.elevationDeg);
  return cleaned(
      {std::sin(azimuth) * std::cos(elevation), -std::cos(azimuth) * std::cos(elevation), std::sin(elevation)});
}

CutPosition cutPosition(const scene::Scene& scene, const scene::Cut& cut) {
  Data data = dataOf(scene);
  glm::dvec3 axis = cutFrame(cut)[2];
  return {glm::dot(cut.centre - data.middle, axis), glm::dot(data.edges * 0.5, glm::abs(axis))};
}

scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offset) {
  cut.centre += cutFrame(cut)[2] * (offset - cutPosition(scene, cut).offset);
  return cut;
}

void replaceCut(scene::Scene& scene, scene::Cut moved) {
  scene::Cut* cut = scene::findCut(scene, moved.id);
  if (!cut) return;
  if (moved.membrane && cut->membrane) moved.membrane->shape = std::move(cut->membrane->shape);
  *cut = std::move(moved);
}

void setSpared(scene::Cut& cut, int structure, bool spared) {
  std::erase_if(cut.spares, [structure](const auto& spare) { return spare.structure == structure; });
  if (spared) cut.spares.push_back({structure});
  std::stable_sort(cut.spares.begin(), cut.spares.end(),
                   [](const auto& a, const auto& b) { return a.structure < b.structure; });
}

bool isSpared(const scene::Cut& cut, int structure) {
  auto found = std::find_if(cut.spares.begin(), cut.spares.end(),
                            [structure](const auto& spare) { return spare.structure == structure; });
  return found != cut.spares.end() && *found == scene::Spare{structure};
}

}  // namespace velum::session
