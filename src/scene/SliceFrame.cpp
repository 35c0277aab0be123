#include "velum/scene/SliceFrame.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace velum::scene {

namespace {

constexpr double kMargin = 1.04;

glm::dvec3 unitOr(glm::dvec3 v, glm::dvec3 fallback) {
  double length = glm::length(v);
  return length > 1e-12 && std::isfinite(length) ? v / length : fallback;
}

/// A turn about an axis without the noise of the sines, so that four quarters give the same slice again.
glm::dvec3 turned(glm::dvec3 v, double angle, glm::dvec3 axis) {
  glm::dvec3 out(glm::rotate(glm::dmat4(1.0), angle, axis) * glm::dvec4(v, 0.0));
  for (int i = 0; i < 3; ++i)
    if (std::abs(out[i]) < 1e-12) out[i] = 0.0;
  return out;
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
  if (scene.volume.data) {
    glm::dvec3 mm = spacingMm(*scene.volume.data);
    return std::min(mm.x, std::min(mm.y, mm.z));
  }
  if (scene.labels.data) {
    glm::dmat3 axes(scene.labels.data->worldFromVoxel());
    return std::min(glm::length(axes[0]), std::min(glm::length(axes[1]), glm::length(axes[2])));
  }
  return 1.0;
}

void scrollSlice(Scene& scene, SliceKind kind, double steps) {
  SliceFrame frame = makeSliceFrame(scene, kind, glm::dvec2(1.0));
  Bounds bounds = computeBounds(scene);
  // A step is a voxel along the normal, so that a slice across thick planes shows each plane once.
  double step = sliceStepMm(scene);
  if (scene.volume.data) {
    glm::dmat3 axes(scene.volume.data->worldFromVoxel);
    double best = -1.0;
    for (int i = 0; i < 3; ++i) {
      double along = std::abs(glm::dot(glm::normalize(axes[i]), frame.normal));
      if (along > best) best = along, step = glm::length(axes[i]);
    }
  }
  glm::dvec3& cross = scene.slices.crosshairMm;
  cross = glm::clamp(cross + frame.normal * (steps * step), bounds.min, bounds.max);
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
