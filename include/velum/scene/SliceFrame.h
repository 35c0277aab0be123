#pragma once
#include <glm/glm.hpp>

#include "velum/scene/Scene.h"

namespace velum::scene {

/// Where a slice view looks: a rectangle of the world. World frame (mm, LPS); pixels from the top left corner, centres
/// at halves.
struct SliceFrame {
  glm::dvec3 centreMm{0.0};                                 ///< middle of the view, in the slice's plane
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, normal{0, 0, 1};  ///< orthonormal; normal towards the viewer
  glm::dvec2 size{1.0};                                     ///< pixels
  double mmPerPixel = 1.0;
};

/// @param size  of the view, pixels, positive
SliceFrame makeSliceFrame(const Scene& scene, SliceKind kind, glm::dvec2 size);

/// The point of the slice's plane under a pixel.
glm::dvec3 worldFromSlicePixel(const SliceFrame& frame, glm::dvec2 pixel);
/// Where the foot of a point on the slice's plane is in the view.
glm::dvec2 slicePixelFromWorld(const SliceFrame& frame, glm::dvec3 worldMm);
/// How far a point lies before the plane, towards the viewer, mm.
double heightOverSlice(const SliceFrame& frame, glm::dvec3 worldMm);

/// Moves the crosshair through the data by steps of the smallest voxel edge along the normal, kept inside the data.
void scrollSlice(Scene& scene, SliceKind kind, double steps);
/// The view's rectangle after a drag by pixels.
void panSlice(Scene& scene, SliceKind kind, glm::dvec2 size, glm::dvec2 dragPixels);
/// Nearer by a factor < 1, about the point under a pixel.
void zoomSlice(Scene& scene, SliceKind kind, glm::dvec2 size, glm::dvec2 pixel, double factor);
/// Turns the other two slices about this one's normal, through the crosshair, radians: they become oblique together and
/// stay across each other.
void turnSlices(Scene& scene, SliceKind kind, double angleRad);
/// Back to the patient's axes, all of the data in view.
void resetSlices(Scene& scene);
/// Length of the smallest voxel edge, mm.
double sliceStepMm(const Scene& scene);

}  // namespace velum::scene
