#include "session/cut/CutEdit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Assert.h"
#include "scene/Scene.h"
#include "session/cut/NewCut.h"
#include "session/cut/ShapeTraits.h"

namespace velum::session {

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
  NewCut at = newCutIn(scene);
  scene::Cut cut;
  cut.shape = shape;
  if (scene::isMembrane(cut)) cut.membrane.emplace();
  cut.centre = scene.sections.isPlaced ? scene.sections.crosshair : at.data.middle;
  traitsOf(shape).make(cut, at);
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

namespace {

/// As wide and high as the data across the cut's axis, about its middle; the reach goes with it.
void fitFrame(const scene::Scene& scene, scene::Cut& cut) {
  glm::dmat3 frame = cutFrame(cut);
  DataBox data = dataOf(scene);
  glm::dvec3 edges(0.0);
  for (int i = 0; i < 3; ++i) edges[i] = glm::dot(glm::abs(frame[i]), data.edges);
  cut.size = frameSize(edges.x, edges.y);
  cut.centre = data.middle + frame[2] * glm::dot(cut.centre - data.middle, frame[2]);
}

}  // namespace

scene::Cut alignedCut(const scene::Scene& scene, scene::Cut cut, glm::dvec3 axis) {
  if (cut.shape == scene::CutShape::Plane) {
    // The foot of the data's middle on the plane is what the plane shows the middle of.
    glm::dvec3 middle = dataOf(scene).middle, old = cutFrame(cut)[2];
    cut.centre = middle - old * glm::dot(middle - cut.centre, old);
    cut.invert = false;
  }
  cut.axis = axis;
  cut.spinDeg = 0.0;
  if (scene::isMembrane(cut)) fitFrame(scene, cut);
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
  DataBox data = dataOf(scene);
  glm::dvec3 axis = cutFrame(cut)[2];
  return {glm::dot(cut.centre - data.middle, axis), glm::dot(data.edges * 0.5, glm::abs(axis))};
}

scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offset) {
  cut.centre += cutFrame(cut)[2] * (offset - cutPosition(scene, cut).offset);
  return cut;
}

std::string newCutName(const scene::Scene& scene, scene::CutShape shape) {
  auto isTaken = [&](const std::string& name) {
    return std::any_of(scene.cuts.begin(), scene.cuts.end(), [&](const auto& cut) { return cut.name == name; });
  };
  auto ofShape =
      std::count_if(scene.cuts.begin(), scene.cuts.end(), [&](const auto& cut) { return cut.shape == shape; });
  for (auto number = ofShape + 1;; ++number)
    if (auto name = fmt::format("{} {}", traitsOf(shape).title, number); !isTaken(name)) return name;
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

const scene::TypeSpare* findTypeSpare(const scene::Cut& cut, std::string_view path) {
  auto found = std::find_if(cut.model.spares.begin(), cut.model.spares.end(),
                            [path](const scene::TypeSpare& spare) { return spare.type == path; });
  return found == cut.model.spares.end() ? nullptr : &*found;
}

scene::TypeSpare typeSpareFor(const scene::Cut& cut, std::string_view path) {
  scene::TypeSpare spare;
  spare.share = 0.0;
  for (std::string_view at = path; !at.empty();) {
    if (const scene::TypeSpare* own = findTypeSpare(cut, at)) {
      spare = *own;
      break;
    }
    std::size_t dot = at.rfind('.');
    at = dot == std::string_view::npos ? std::string_view() : at.substr(0, dot);
  }
  spare.type = path;
  return spare;
}

scene::TypeSpare& ownTypeSpare(scene::Cut& cut, std::string_view path) {
  auto isIt = [path](const scene::TypeSpare& spare) { return spare.type == path; };
  auto found = std::find_if(cut.model.spares.begin(), cut.model.spares.end(), isIt);
  if (found != cut.model.spares.end()) return *found;
  return cut.model.spares.emplace_back(typeSpareFor(cut, path));
}

void setTypeShare(scene::Cut& cut, std::string_view path, double share) {
  ownTypeSpare(cut, path).share = std::clamp(share, 0.0, 1.0);
}

void removeTypeSpare(scene::Cut& cut, std::string_view path) {
  std::erase_if(cut.model.spares, [path](const scene::TypeSpare& spare) { return spare.type == path; });
}

}  // namespace velum::session
