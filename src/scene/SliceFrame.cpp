#include "velum/scene/SliceFrame.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "velum/core/Vectors.h"

namespace velum::scene {

namespace {

constexpr double kMargin = 1.04;
/// Cosine from which two directions count as one: a tenth of a degree, a voxel in 500.
constexpr double kAligned = 0.9999985;

/// A turn about an axis without the noise of the sines, so that four quarters give the same slice again.
glm::dvec3 turned(glm::dvec3 v, double angle, glm::dvec3 axis) {
  glm::dvec3 out(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
  for (int i = 0; i < 3; ++i)
    if (std::abs(out[i]) < 1e-12) out[i] = 0.0;
  return out;
}

/// The grid whose planes are scrolled through. @return false when there is none
bool gridOf(const Scene& scene, glm::ivec3& dims, glm::dmat4& worldFromVoxel) {
  if (scene.volume.data) {
    dims = scene.volume.data->dims;
    worldFromVoxel = scene.volume.data->worldFromVoxel;
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
  double planeMm = 1.0;  ///< from plane to plane
  double sign = 1.0;     ///< +1: the index grows along the direction
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

SliceFrame makeSliceFrame(const Scene& scene, SliceKind kind, glm::dvec2 size) {
  const Slice& slice = sliceOf(scene.slices, kind);
  SliceFrame frame;
  frame.size = glm::max(size, glm::dvec2(1.0));
  frame.normal = unitOr(slice.normal, {0, 0, 1});
  glm::dvec3 up = slice.up - frame.normal * glm::dot(slice.up, frame.normal);
  glm::dvec3 helper = std::abs(frame.normal.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, -1, 0);
  frame.up = unitOr(up, unitOr(helper - frame.normal * glm::dot(helper, frame.normal), {0, 1, 0}));
  frame.right = glm::cross(frame.up, frame.normal);
  Bounds bounds = computeBounds(scene);
  glm::dvec3 middle = (bounds.min + bounds.max) * 0.5, half = (bounds.max - bounds.min) * 0.5;
  double height = slice.heightMm;
  if (!(height > 0)) {
    double tall = 2.0 * glm::dot(glm::abs(frame.up), half), wide = 2.0 * glm::dot(glm::abs(frame.right), half);
    height = kMargin * std::max(std::max(tall, wide * frame.size.y / frame.size.x), 1e-6);
  }
  frame.mmPerPixel = height / frame.size.y;
  // The middle of the data, brought into the plane through the crosshair.
  glm::dvec3 foot = middle + frame.normal * glm::dot(scene.slices.crosshairMm - middle, frame.normal);
  frame.centreMm = foot + frame.right * slice.panMm.x + frame.up * slice.panMm.y;
  return frame;
}

glm::dvec3 worldFromSlicePixel(const SliceFrame& frame, glm::dvec2 pixel) {
  glm::dvec2 off = (pixel - frame.size * 0.5) * frame.mmPerPixel;
  return frame.centreMm + frame.right * off.x - frame.up * off.y;
}

glm::dvec2 slicePixelFromWorld(const SliceFrame& frame, glm::dvec3 worldMm) {
  glm::dvec3 off = worldMm - frame.centreMm;
  return frame.size * 0.5 + glm::dvec2(glm::dot(off, frame.right), -glm::dot(off, frame.up)) / frame.mmPerPixel;
}

double heightOverSlice(const SliceFrame& frame, glm::dvec3 worldMm) {
  return glm::dot(worldMm - frame.centreMm, frame.normal);
}

double sliceStepMm(const Scene& scene) {
  glm::ivec3 dims;
  glm::dmat4 axes;
  if (!gridOf(scene, dims, axes)) return 1.0;
  auto edge = [&](int i) { return glm::length(glm::dvec3(axes[i])); };
  return std::min(edge(0), std::min(edge(1), edge(2)));
}

std::optional<SliceIndex> sliceIndex(const Scene& scene, SliceKind kind) {
  glm::ivec3 dims;
  glm::dmat4 worldFromVoxel;
  if (!gridOf(scene, dims, worldFromVoxel)) return std::nullopt;
  glm::dvec3 normal = makeSliceFrame(scene, kind, glm::dvec2(1.0)).normal;
  GridAxis axis = axisAlong(worldFromVoxel, normal);
  if (axis.cosine < kAligned) return std::nullopt;
  double place = glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(scene.slices.crosshairMm, 1.0))[axis.index];
  return SliceIndex{std::clamp(int(std::floor(place + 0.5)), 0, dims[axis.index] - 1), dims[axis.index]};
}

bool isOblique(const Slices& slices, SliceKind kind) {
  glm::dvec3 n = glm::abs(unitOr(sliceOf(slices, kind).normal, {0, 0, 1}));
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

Scene sliceScene(Scene scene) {
  Slices kept;
  kept.labelOpacity = scene.slices.labelOpacity;
  kept.interpolate = scene.slices.interpolate;
  kept.showCuts = scene.slices.showCuts;
  scene.slices = kept;
  for (auto& cut : scene.cuts) cut.name.clear();
  for (auto& structure : scene.labels.structures) structure.name.clear();
  scene.camera = {};
  scene.lighting = {};
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

void moveCrosshair(Scene& scene, glm::dvec3 worldMm) {
  Bounds bounds = computeBounds(scene);
  scene.slices.crosshairMm = glm::clamp(worldMm, bounds.min, bounds.max);
}

void stepCrosshair(Scene& scene, SliceKind kind, glm::dvec2 steps) {
  SliceFrame frame = makeSliceFrame(scene, kind, glm::dvec2(1.0));
  double mm = sliceStepMm(scene);
  moveCrosshair(scene, scene.slices.crosshairMm + (frame.right * steps.x + frame.up * steps.y) * mm);
}

void scrollSlice(Scene& scene, SliceKind kind, double steps) {
  glm::dvec3 normal = makeSliceFrame(scene, kind, glm::dvec2(1.0)).normal;
  glm::dvec3& cross = scene.slices.crosshairMm;
  double move = steps * sliceStepMm(scene);
  glm::ivec3 dims;
  glm::dmat4 worldFromVoxel;
  if (gridOf(scene, dims, worldFromVoxel)) {
    // A step is a voxel along the normal, so that a slice across thick planes shows each plane once.
    GridAxis axis = axisAlong(worldFromVoxel, normal);
    move = steps * axis.planeMm;
    if (axis.cosine > kAligned) {
      double place = glm::dvec3(glm::inverse(worldFromVoxel) * glm::dvec4(cross, 1.0))[axis.index];
      double wanted = std::clamp(std::floor(place + 0.5) + axis.sign * std::trunc(steps), 0.0, dims[axis.index] - 1.0);
      move = (wanted - place) * axis.sign * axis.planeMm;
    }
  }
  // Along the normal as far as the data's box goes: an oblique slice stops there and does not slide along its sides.
  Bounds bounds = computeBounds(scene);
  double most = std::abs(move);
  for (int i = 0; i < 3; ++i) {
    double d = normal[i] * (move < 0 ? -1.0 : 1.0);
    if (std::abs(d) < 1e-12) continue;
    most = std::min(most, std::max(0.0, ((d > 0 ? bounds.max[i] : bounds.min[i]) - cross[i]) / d));
  }
  cross += normal * (move < 0 ? -most : most);
}

void panSlice(Scene& scene, SliceKind kind, glm::dvec2 size, glm::dvec2 dragPixels) {
  double mm = makeSliceFrame(scene, kind, size).mmPerPixel;
  sliceOf(scene.slices, kind).panMm += glm::dvec2(-dragPixels.x, dragPixels.y) * mm;
}

void zoomSlice(Scene& scene, SliceKind kind, glm::dvec2 size, glm::dvec2 pixel, double factor) {
  SliceFrame before = makeSliceFrame(scene, kind, size);
  Slice& slice = sliceOf(scene.slices, kind);
  double smallest = 4.0 * sliceStepMm(scene), height = before.mmPerPixel * before.size.y;
  slice.heightMm = std::clamp(height * factor, std::min(smallest, height), std::max(1e6, height));
  glm::dvec3 held = worldFromSlicePixel(before, pixel);
  glm::dvec2 moved = slicePixelFromWorld(makeSliceFrame(scene, kind, size), held);
  panSlice(scene, kind, size, pixel - moved);
}

void turnSlices(Scene& scene, SliceKind kind, double angleRad) {
  glm::dvec3 axis = makeSliceFrame(scene, kind, glm::dvec2(1.0)).normal;
  for (SliceKind other : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal}) {
    if (other == kind) continue;
    Slice& slice = sliceOf(scene.slices, other);
    slice.normal = turned(slice.normal, angleRad, axis);
    slice.up = turned(slice.up, angleRad, axis);
  }
}

void resetSlices(Scene& scene) {
  const Slices fresh;
  for (SliceKind kind : {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal})
    sliceOf(scene.slices, kind) = sliceOf(fresh, kind);
  scene.slices.isPlaced = false;
  placeSlices(scene);
}

}  // namespace velum::scene
