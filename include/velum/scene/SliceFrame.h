#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "velum/scene/Scene.h"

namespace velum::scene {

/// Where a slice view looks: a rectangle of the world. World frame (mm, LPS); pixels from the top left corner, centres
/// at halves.
struct SliceFrame {
  glm::dvec3 centreMm{0.0};                                 ///< middle of the view, in the slice's plane
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, normal{0, 0, 1};  ///< orthonormal; normal towards the viewer
  glm::dvec2 size{1.0};                                     ///< pixels
  double mmPerPixel = 1.0;
  bool operator==(const SliceFrame&) const = default;
};

/// @param size  of the view, pixels, positive
SliceFrame makeSliceFrame(const Scene& scene, SliceKind kind, glm::dvec2 size);

/// The point of the slice's plane under a pixel.
glm::dvec3 worldFromSlicePixel(const SliceFrame& frame, glm::dvec2 pixel);
/// Where the foot of a point on the slice's plane is in the view.
glm::dvec2 slicePixelFromWorld(const SliceFrame& frame, glm::dvec3 worldMm);
/// How far a point lies before the plane, towards the viewer, mm.
double heightOverSlice(const SliceFrame& frame, glm::dvec3 worldMm);

/// Which of the volume's planes a slice shows.
struct SliceIndex {
  int index = 0;  ///< 0..count-1
  int count = 1;
};
/// The plane nearest to the crosshair where the slice lies along the voxels; nothing for an oblique one.
std::optional<SliceIndex> sliceIndex(const Scene& scene, SliceKind kind);
/// True when the slice does not face along one of the patient's axes.
bool isOblique(const Slices& slices, SliceKind kind);
/// Where a direction of the world points in the patient, the strongest part first: "L", "SA", "" for none.
std::string patientLetters(glm::dvec3 direction);
/// The scene reduced to what a slice's picture depends on beside its frame: without camera, light and names.
Scene sliceScene(Scene scene);

/// Puts the crosshair to a point, or to the nearest one inside the data's box.
void moveCrosshair(Scene& scene, glm::dvec3 worldMm);
/// Moves the crosshair within a slice by voxels, to the right and up on the screen.
void stepCrosshair(Scene& scene, SliceKind kind, glm::dvec2 steps);
/// Moves the crosshair along the normal, towards the viewer, by voxels: onto the volume's planes where the slice lies
/// along them, and never out of the data.
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
