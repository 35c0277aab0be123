#include "scene/SectionPlane.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/BrickCache.h"
#include "core/Vectors.h"

namespace velum::scene {

namespace {

constexpr double kMargin = 1.04;
/// Cosine from which two directions count as one: a tenth of a degree, a voxel in 500.
constexpr double kAligned = 0.9999985;

/// A turn about an axis without the noise of the sines, so that four quarters give the same section again.
glm::dvec3 turned(glm::dvec3 v, double angle, glm::dvec3 axis) {
  glm::dvec3 out(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
  for (int i = 0; i < 3; ++i)
    if (std::abs(out[i]) < 1e-12) out[i] = 0.0;
  return out;
}

/// The grid whose planes are scrolled through: the finest. @return false when there is none
bool gridOf(const Scene& scene, glm::ivec3& dims, glm::dmat4& worldFromVoxel) {
  if (scene.volume.data) {
    const Volume& volume = *scene.volume.data;
    dims = finestDims(volume);
    worldFromVoxel = volume.finer ? worldFromLevel(volume, 0) : volume.worldFromVoxel;
    return true;
  }
  if (!scene.labels.data) return false;
  dims = scene.labels.data->dims();
  worldFromVoxel = scene.labels.data->worldFromVoxel();
  return true;
}

/// The axis of a grid whose planes face along a direction; sheared grids (gantry tilt) have planes, too.
struct GridAxis {
  int index = 0;
  double cosine = -1.0;
  double plane = 1.0;  ///< from plane to plane
  double sign = 1.0;   ///< +1: the index grows along the direction
};
GridAxis axisAlong(const glm::dmat4& worldFromVoxel, glm::dvec3 direction) {
  glm::dmat3 normals = glm::transpose(glm::inverse(glm::dmat3(worldFromVoxel)));
  GridAxis best;
  for (int i = 0; i < 3; ++i) {
    double length = glm::length(normals[i]), cosine = glm::dot(normals[i], direction) / length;
    if (std::abs(cosine) > best.cosine) best = {i, std::abs(cosine), 1.0 / length, cosine < 0 ? -1.0 : 1.0};
  }
  return best;
}

}  // namespace

SectionPlane makeSectionPlane(const Scene& scene, SectionKind kind, glm::dvec2 size) {
  const Section& section = sectionOf(scene.sections, kind);
  SectionPlane plane;
  plane.size = glm::max(size, glm::dvec2(1.0));
  plane.normal = unitOr(section.normal, {0, 0, 1});
  glm::dvec3 up = section.up - plane.normal * glm::dot(section.up, plane.normal);
  glm::dvec3 helper = std::abs(plane.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  plane.up = unitOr(up, unitOr(helper - plane.normal * glm::dot(helper, plane.normal), {0, 1, 0}));
  plane.right = glm::cross(plane.up, plane.normal);
  Bounds bounds = computeBounds(scene);
  glm::dvec3 middle = (bounds.min + bounds.max) * 0.5, half = solidEdges(bounds.max - bounds.min) * 0.5;
  double height = section.height;
  if (!(height > 0)) {
    double tall = 2.0 * glm::dot(glm::abs(plane.up), half), wide = 2.0 * glm::dot(glm::abs(plane.right), half);
    height = kMargin * std::max(tall, wide * plane.size.y / plane.size.x);
  }
  plane.lengthPerPixel = height / plane.size.y;
  // The middle of the data, brought into the plane through the crosshair.
  glm::dvec3 foot = middle + plane.normal * glm::dot(scene.sections.crosshair - middle, plane.normal);
  plane.centre = foot + plane.right * section.pan.x + plane.up * section.pan.y;
  return plane;
}

glm::dvec3 worldFromSectionPixel(const SectionPlane& plane, glm::dvec2 pixel) {
  glm::dvec2 off = (pixel - plane.size * 0.5) * plane.lengthPerPixel;
  return plane.centre + plane.right * off.x - plane.up * off.y;
}

glm::dvec2 sectionPixelFromWorld(const SectionPlane& plane, glm::dvec3 world) {
  glm::dvec3 off = world - plane.centre;
  return plane.size * 0.5 + glm::dvec2(glm::dot(off, plane.right), -glm::dot(off, plane.up)) / plane.lengthPerPixel;
}

double heightOverSection(const SectionPlane& plane, glm::dvec3 world) {
  return glm::dot(world - plane.centre, plane.normal);
}

double sectionStep(const Scene& scene) {
  return scene.volume.data ? smallestSpacing(scene.volume.data->worldFromVoxel) : finestStep(scene);
}

double finestStep(const Scene& scene) {
  glm::ivec3 dims;
  glm::dmat4 axes;
  return gridOf(scene, dims, axes) ? smallestSpacing(axes) : 1.0;
}

int planesPerStep(const Scene& scene, const SectionPlane& plane) {
  if (!scene.volume.data || !scene.volume.data->finer) return 1;
  const Volume& volume = *scene.volume.data;
  double shown = axisAlong(worldFromLevel(volume, levelForPixel(volume, plane.lengthPerPixel)), plane.normal).plane;
  return std::max(1, int(std::lround(shown / axisAlong(worldFromLevel(volume, 0), plane.normal).plane)));
}

std::optional<SectionIndex> sectionIndex(const Scene& scene, SectionKind kind) {
  glm::ivec3 dims;
  glm::dmat4 worldFromVoxel;
  if (!gridOf(scene, dims, worldFromVoxel)) return std::nullopt;
  glm::dvec3 normal = makeSectionPlane(scene, kind, glm::dvec2(1.0)).normal;
  GridAxis axis = axisAlong(worldFromVoxel, normal);
  if (axis.cosine < kAligned) return std::nullopt;
  double place = glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(scene.sections.crosshair, 1.0))[axis.index];
  return SectionIndex{std::clamp(int(std::floor(place + 0.5)), 0, dims[axis.index] - 1), dims[axis.index]};
}

bool isOblique(const Sections& sections, SectionKind kind) {
  glm::dvec3 n = glm::abs(unitOr(sectionOf(sections, kind).normal, {0, 0, 1}));
  return std::max(n.x, std::max(n.y, n.z)) < kAligned;
}

std::string patientLetters(glm::dvec3 direction) {
  static constexpr char kPlus[] = "LPS", kMinus[] = "RAI";
  direction = unitOr(direction, glm::dvec3(0.0));
  int order[] = {0, 1, 2};
  std::sort(order, order + 3, [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
  std::string letters;
  // A tilt of less than eight degrees is not worth a letter.
  for (int axis : order)
    if (std::abs(direction[axis]) > 0.14) letters += direction[axis] > 0 ? kPlus[axis] : kMinus[axis];
  return letters;
}

Scene sectionScene(Scene scene) {
  Sections kept;
  kept.labelOpacity = scene.sections.labelOpacity;
  kept.interpolate = scene.sections.interpolate;
  kept.showCuts = scene.sections.showCuts;
  scene.sections = kept;
  for (auto& cut : scene.cuts) cut.name.clear();
  for (auto& structure : scene.labels.structures) structure.name.clear();
  scene.camera = {};
  scene.lighting = {};
  scene.lettering = {};
  scene.rayCast = {};
  scene.surfaces.clear();
  scene.volume.transfer = {};
  for (auto& look : scene.volume.channels) look.transfer = {}, look.name.clear();
  for (auto& cut : scene.cuts) {
    cut.face = {};
    cut.faceOpacity = 1.0;
    if (!cut.membrane) continue;
    Membrane membrane = drawnMembrane(std::move(*cut.membrane)), shown;
    shown.use = membrane.use;
    shown.shape = std::move(membrane.shape);
    shown.cloth = membrane.cloth;
    cut.membrane = std::move(shown);
  }
  return scene;
}

void moveCrosshair(Scene& scene, glm::dvec3 world) {
  Bounds bounds = computeBounds(scene);
  scene.sections.crosshair = glm::clamp(world, bounds.min, bounds.max);
}

void stepCrosshair(Scene& scene, SectionKind kind, glm::dvec2 steps) {
  SectionPlane plane = makeSectionPlane(scene, kind, glm::dvec2(1.0));
  double length = finestStep(scene);
  moveCrosshair(scene, scene.sections.crosshair + (plane.right * steps.x + plane.up * steps.y) * length);
}

void scrollSection(Scene& scene, SectionKind kind, double steps) {
  glm::dvec3 normal = makeSectionPlane(scene, kind, glm::dvec2(1.0)).normal;
  glm::dvec3& cross = scene.sections.crosshair;
  double move = steps * finestStep(scene);
  glm::ivec3 dims;
  glm::dmat4 worldFromVoxel;
  if (gridOf(scene, dims, worldFromVoxel)) {
    // A step is a voxel along the normal, so that a section across thick planes shows each plane once.
    GridAxis axis = axisAlong(worldFromVoxel, normal);
    move = steps * axis.plane;
    if (axis.cosine > kAligned) {
      double place = glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(cross, 1.0))[axis.index];
      double wanted = std::clamp(std::floor(place + 0.5) + axis.sign * std::trunc(steps), 0.0, dims[axis.index] - 1.0);
      move = (wanted - place) * axis.sign * axis.plane;
    }
  }
  // Along the normal as far as the data's box goes: an oblique section stops there and does not slide along its sides.
  Bounds bounds = computeBounds(scene);
  double most = std::abs(move);
  for (int i = 0; i < 3; ++i) {
    double d = normal[i] * (move < 0 ? -1.0 : 1.0);
    if (std::abs(d) < 1e-12) continue;
    most = std::min(most, std::max(0.0, ((d > 0 ? bounds.max[i] : bounds.min[i]) - cross[i]) / d));
  }
  cross += normal * (move < 0 ? -most : most);
}

void panSection(Scene& scene, SectionKind kind, glm::dvec2 size, glm::dvec2 dragPixels) {
  double length = makeSectionPlane(scene, kind, size).lengthPerPixel;
  sectionOf(scene.sections, kind).pan += glm::dvec2(-dragPixels.x, dragPixels.y) * length;
}

void zoomSection(Scene& scene, SectionKind kind, glm::dvec2 size, glm::dvec2 pixel, double factor) {
  SectionPlane before = makeSectionPlane(scene, kind, size);
  Section& section = sectionOf(scene.sections, kind);
  double smallest = 4.0 * sectionStep(scene), height = before.lengthPerPixel * before.size.y;
  section.height = std::clamp(height * factor, std::min(smallest, height), std::max(1e6, height));
  glm::dvec3 held = worldFromSectionPixel(before, pixel);
  glm::dvec2 moved = sectionPixelFromWorld(makeSectionPlane(scene, kind, size), held);
  panSection(scene, kind, size, pixel - moved);
}

void turnSections(Scene& scene, SectionKind kind, double angleRad) {
  glm::dvec3 axis = makeSectionPlane(scene, kind, glm::dvec2(1.0)).normal;
  for (SectionKind other : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal}) {
    if (other == kind) continue;
    Section& section = sectionOf(scene.sections, other);
    section.normal = turned(section.normal, angleRad, axis);
    section.up = turned(section.up, angleRad, axis);
  }
}

void resetSections(Scene& scene) {
  const Sections fresh;
  for (SectionKind kind : {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal})
    sectionOf(scene.sections, kind) = sectionOf(fresh, kind);
  scene.sections.isPlaced = false;
  placeSections(scene);
}

std::optional<glm::dvec2> stretchIn(glm::dvec2 point, glm::dvec2 along, glm::dvec2 low, glm::dvec2 high) {
  double from = -1e30, to = 1e30;
  for (int i = 0; i < 2; ++i) {
    if (std::abs(along[i]) < 1e-12) {
      if (point[i] < low[i] || point[i] > high[i]) return std::nullopt;
      continue;
    }
    double a = (low[i] - point[i]) / along[i], b = (high[i] - point[i]) / along[i];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  if (from >= to) return std::nullopt;
  return glm::dvec2(from, to);
}

}  // namespace velum::scene
