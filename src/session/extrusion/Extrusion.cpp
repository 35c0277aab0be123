#include "session/extrusion/Extrusion.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "scene/Project.h"
#include "session/cut/CutEdit.h"
#include "session/cut/DragAlong.h"
#include "session/cut/SectionContour.h"
#include "session/extrusion/PulledEnd.h"

namespace velum::session {

namespace {

bool isEnd(double distance) { return distance > 0.0 && std::isfinite(distance); }

bool isExtrusion(const scene::Spare& spare) { return isEnd(spare.distance); }

auto spareOf(auto& cut, int structure) {
  return std::find_if(cut.spares.begin(), cut.spares.end(), [&](const auto& s) { return s.structure == structure; });
}

double sideOf(const scene::Cut& cut) { return cut.invert ? -1.0 : 1.0; }

}  // namespace

std::vector<Extrusion> extrusionsOf(const scene::Scene& scene) {
  std::vector<Extrusion> out;
  for (const auto& cut : scene.cuts)
    for (const auto& spare : cut.spares)
      if (isExtrusion(spare)) out.push_back({cut.id, spare.structure, spare.distance});
  return out;
}

double extrusionOf(const scene::Cut& cut, int structure) {
  auto found = spareOf(cut, structure);
  return found == cut.spares.end() ? 0.0 : found->distance;
}

void setExtrusion(scene::Cut& cut, int structure, double distance) {
  std::erase_if(cut.spares, [&](const auto& spare) { return spare.structure == structure; });
  if (!(distance > 0.0)) return;
  auto after =
      std::find_if(cut.spares.begin(), cut.spares.end(), [&](const auto& s) { return s.structure > structure; });
  cut.spares.insert(after, {structure, distance});
}

void resetExtrusions(scene::Scene& scene) {
  for (auto& cut : scene.cuts) std::erase_if(cut.spares, [](const auto& spare) { return isEnd(spare.distance); });
}

bool canPullFrom(const scene::Cut& cut) { return cut.enabled && !scene::isInlay(cut); }

bool isFlat(const scene::Cut& cut) { return cut.shape == scene::CutShape::Plane || scene::isMembrane(cut); }

double depthInCut(const scene::Cut& cut, glm::dvec3 world) {
  if (isFlat(cut)) return sideOf(cut) * glm::dot(world - cut.centre, cutFrame(cut)[2]);
  return -sideOf(cut) * shapeDistance(cut, world);
}

glm::dvec3 pullDirection(const scene::Cut& cut, glm::dvec3 world) {
  if (isFlat(cut)) return sideOf(cut) * cutFrame(cut)[2];
  double h = 1e-3 * std::max(cut.size.x, std::max(cut.size.y, cut.size.z));
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = h;
    gradient[axis] = depthInCut(cut, world + step) - depthInCut(cut, world - step);
  }
  double length = glm::length(gradient);
  return length > 0.0 ? gradient / length : cutFrame(cut)[2];
}

std::vector<int> cutsUnder(const scene::Scene& scene, glm::dvec3 world, int structure, double slack) {
  struct Candidate {
    double offFace;
    int cut;
  };
  std::vector<Candidate> found;
  for (const auto& cut : scene.cuts) {
    if (!canPullFrom(cut)) continue;
    double depth = depthInCut(cut, world), distance = extrusionOf(cut, structure);
    // A sheet lies anywhere within its reach.
    double onFace = scene::isMembrane(cut) ? slack + 0.5 * cut.size.z : slack;
    bool isOnFace = std::abs(depth) <= onFace;
    bool standsOut = isEnd(distance) && depth > 0.0 && depth <= distance + onFace;
    if (isOnFace || standsOut) found.push_back({std::max(0.0, std::abs(depth) - onFace), cut.id});
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.offFace < b.offFace; });
  std::vector<int> ids;
  for (const auto& one : found) ids.push_back(one.cut);
  return ids;
}

ExtrusionDrag::ExtrusionDrag(const ViewSpace& space, glm::dvec2 pixel, const scene::Cut& cut, glm::dvec3 world,
                             double distance)
    : mSpace(space), mFrom(pixel), mPlace(world), mDirection(pullDirection(cut, world)), mDistance(distance) {}

double ExtrusionDrag::distanceAt(glm::dvec2 pixel) const {
  return std::max(0.0, mDistance + dragAlong(mSpace, mFrom, pixel, mPlace, mDirection));
}

glm::dvec2 ExtrusionDrag::wayOut() const {
  constexpr double kStep = 10.0;  // pixels
  auto along = [&](glm::dvec2 way) { return dragAlong(mSpace, mFrom, mFrom + kStep * way, mPlace, mDirection); };
  double right = along({1, 0}), down = along({0, 1});
  if (std::abs(right) > std::abs(down)) return {right > 0.0 ? 1.0 : -1.0, 0.0};
  return {0.0, down < 0.0 ? -1.0 : 1.0};
}

std::optional<int> addJoinedPlane(scene::Scene& scene, int cut) {
  const scene::Cut* first = scene::findCut(scene, cut);
  if (!first || first->shape != scene::CutShape::Plane || scene.cuts.size() >= scene::kMostCuts) return std::nullopt;
  glm::dvec3 normal = sideOf(*first) * cutFrame(*first)[2];
  glm::dvec3 towardsEye = -scene::cameraBasis(scene.camera).forward;
  // Across the first, as near to the line of sight as that goes; looked at face on, from the patient's side.
  glm::dvec3 axis = towardsEye - glm::dot(towardsEye, normal) * normal;
  if (glm::length(axis) < 0.3) {
    axis = scene::cameraBasis(scene.camera).right;
    axis -= glm::dot(axis, normal) * normal;
  }
  // Along one of the patient's axes where the first is.
  glm::dvec3 snapped = nearestAxis(axis);
  if (std::abs(glm::dot(snapped, normal)) < 1e-6) axis = snapped;
  scene::Cut second;
  second.name = newCutName(scene, scene::CutShape::Plane);
  second.shape = scene::CutShape::Plane;
  second.joined = true;
  second.axis = glm::normalize(axis);
  scene::Bounds bounds = scene::computeBounds(scene);
  second.centre = scene.sections.isPlaced ? scene.sections.crosshair : (bounds.min + bounds.max) * 0.5;
  second.size = first->size;
  second.face = first->face;
  second.faceOpacity = first->faceOpacity;
  int id = scene::addCut(scene, second);
  auto place = scene.cuts.begin() + scene::cutPlace(scene, cut) + 1;
  std::rotate(place, scene.cuts.end() - 1, scene.cuts.end());
  return id;
}

std::vector<std::vector<glm::dvec3>> boxEdges(const scene::Scene& scene) {
  glm::ivec3 dims(0);
  glm::dmat4 worldFromVoxel(1.0);
  scene::Bounds bounds = scene::computeBounds(scene);
  if (const auto& volume = scene.volume.data) {
    dims = volume->dims;
    worldFromVoxel = volume->worldFromVoxel;
  } else if (const auto& labels = scene.labels.data) {
    dims = labels->dims();
    worldFromVoxel = labels->worldFromVoxel();
  }
  auto corner = [&](int i) {
    glm::dvec3 share(i & 1, i >> 1 & 1, i >> 2);
    if (dims.x == 0) return glm::mix(bounds.min, bounds.max, share);
    return glm::dvec3(worldFromVoxel * glm::dvec4(share * glm::dvec3(dims) - 0.5, 1.0));
  };
  std::vector<std::vector<glm::dvec3>> edges;
  for (int i = 0; i < 8; ++i)
    for (int axis = 1; axis < 8; axis *= 2)
      if (!(i & axis)) edges.push_back({corner(i), corner(i | axis)});
  return edges;
}

namespace {

/// The part of a convex polygon where a cut removes nothing.
std::vector<glm::dvec3> leftBy(const scene::Cut& cut, const std::vector<glm::dvec3>& polygon) {
  std::vector<glm::dvec3> out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    double da = depthInCut(cut, a), db = depthInCut(cut, b);
    if (da <= 0.0) out.push_back(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) out.push_back(glm::mix(a, b, da / (da - db)));
  }
  return out;
}

}  // namespace

std::vector<const scene::Cut*> joinedWith(const scene::Scene& scene, const scene::Cut& cut) {
  std::vector<const scene::Cut*> group;
  bool isIn = false;
  for (const auto& one : scene.cuts) {
    if (!one.joined) {
      if (isIn) break;
      group.clear();
    }
    isIn = isIn || one.id == cut.id;
    if (one.enabled && one.id != cut.id) group.push_back(&one);
  }
  return isIn ? group : std::vector<const scene::Cut*>{};
}

std::vector<std::vector<glm::dvec3>> partsLeftByOthers(const scene::Scene& scene, const scene::Cut& plane,
                                                       const std::vector<glm::dvec3>& outline) {
  std::vector<std::vector<glm::dvec3>> parts;
  for (const scene::Cut* other : joinedWith(scene, plane))
    if (auto part = leftBy(*other, outline); part.size() >= 3) parts.push_back(std::move(part));
  return parts;
}

std::optional<int> freeStructureId(const scene::Scene& scene) {
  std::set<int> taken;
  for (const auto& structure : scene.labels.structures) taken.insert(structure.id);
  if (scene.labels.data)
    for (const auto& info : scene.labels.data->table) taken.insert(info.id);
  for (const auto& growth : scene.labels.growths) taken.insert(growth.structure);
  int id = taken.empty() ? 1 : *taken.rbegin() + 1;
  if (id > 65535)
    for (id = 1; taken.count(id); ++id) {
    }
  return id <= 65535 ? std::optional(id) : std::nullopt;
}

}  // namespace velum::session
