#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "scene/Scene.h"

namespace velum::scene {

/// Where a section view looks: a rectangle of the world. World frame (LPS); pixels from the top left corner,
/// centres at halves.
struct SectionPlane {
  glm::dvec3 centre{0.0};                                   ///< middle of the view, in the section's plane
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, normal{0, 0, 1};  ///< orthonormal; normal towards the viewer
  glm::dvec2 size{1.0};                                     ///< pixels
  double lengthPerPixel = 1.0;
  bool operator==(const SectionPlane&) const = default;
};

/// @param size  of the view, pixels, positive
SectionPlane makeSectionPlane(const Scene& scene, SectionKind kind, glm::dvec2 size);

/// The point of the section's plane under a pixel.
glm::dvec3 worldFromSectionPixel(const SectionPlane& plane, glm::dvec2 pixel);
/// The pixel of the view onto which a point of the world is projected, along the section's normal.
glm::dvec2 sectionPixelFromWorld(const SectionPlane& plane, glm::dvec3 world);
/// How far a point lies before the plane, towards the viewer.
double heightOverSection(const SectionPlane& plane, glm::dvec3 world);

/// Which of the volume's planes a section shows: of the finest level, where it has several.
struct SectionIndex {
  int index = 0;  ///< 0..count-1
  int count = 1;
};
/// The volume's plane nearest to the crosshair, where the section lies along the voxels; nothing for an oblique
/// section.
std::optional<SectionIndex> sectionIndex(const Scene& scene, SectionKind kind);
/// True when the section does not face along one of the patient's axes.
bool isOblique(const Sections& sections, SectionKind kind);
/// The letters of the patient's directions in which a direction of the world points, the strongest first: "L", "SA"; ""
/// for none.
std::string patientLetters(glm::dvec3 direction);
/// The scene reduced to what a section's picture depends on beside its frame: without camera, light and names.
Scene sectionScene(Scene scene);

/// Puts the crosshair to a point, or to the nearest one inside the data's box.
void moveCrosshair(Scene& scene, glm::dvec3 world);
/// Moves the crosshair within a section by voxels of the finest level, to the right and up on the screen.
void stepCrosshair(Scene& scene, SectionKind kind, glm::dvec2 steps);
/// Moves the crosshair along the normal, towards the viewer, by voxels: onto the volume's planes where the section lies
/// along them, and never out of the data. Voxels are those of the finest level.
void scrollSection(Scene& scene, SectionKind kind, double steps);
/// Moves the view's rectangle by a drag in pixels.
void panSection(Scene& scene, SectionKind kind, glm::dvec2 size, glm::dvec2 dragPixels);
/// Zooms about the point under a pixel; a factor < 1 is nearer.
void zoomSection(Scene& scene, SectionKind kind, glm::dvec2 size, glm::dvec2 pixel, double factor);
/// Turns the other two sections about this one's normal, through the crosshair, radians: they become oblique together
/// and stay across each other.
void turnSections(Scene& scene, SectionKind kind, double angleRad);
/// Back to the patient's axes, all of the data in view.
void resetSections(Scene& scene);
/// How many planes of the finest level make one step of a section as it is seen: as many as lie in a plane of the level
/// that is shown there, so that each step shows something new. 1 where the volume is in memory.
int planesPerStep(const Scene& scene, const SectionPlane& plane);
/// Length of the smallest voxel edge, of the volume that is in memory.
double sectionStep(const Scene& scene);
/// The same of the finest level.
double finestStep(const Scene& scene);

/// The part of a line that lies in the rectangle from `low` to `high`, as multiples of `along` from `point` on; nothing
/// when it misses.
std::optional<glm::dvec2> stretchIn(glm::dvec2 point, glm::dvec2 along, glm::dvec2 low, glm::dvec2 high);

}  // namespace velum::scene
