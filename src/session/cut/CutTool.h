#pragma once
#include <glm/glm.hpp>
#include <string>

#include "scene/Camera.h"
#include "scene/Cut.h"
#include "scene/Scene.h"
#include "scene/Units.h"
#include "session/cut/CutEdit.h"
#include "session/cut/CutGizmo.h"

namespace velum::session {

/// To what a drag is rounded while Shift is held: moves to whole voxels, turns to 15 degrees; a corner keeps the ratio
/// of its edges. Off by default.
struct CutSnap {
  bool on = false;
  glm::dmat3 worldFromVoxel{1.0};
};
CutSnap makeCutSnap(const scene::Scene& scene, bool on);

/// The cut after a drag, made from the cut and its gizmo as they were when the drag began: the result depends only on
/// where the pointer is, so that going back gives the cut that was.
scene::Cut dragCut(const scene::Cut& start, const CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                   glm::dvec2 pictureSize, glm::dvec2 from, glm::dvec2 to, const CutSnap& snap = {});

/// What a drag has done so far, in numbers: "12.5 mm", "30.0\u00b0". UTF-8.
std::string dragText(const scene::LengthFormat& lengths, const scene::Cut& start, const scene::Cut& now,
                     CutHandle handle);
/// The name of the undo step: "Move cut", "Tilt cut", "Turn cut", "Resize cut".
const char* dragLabel(const scene::Cut& cut, CutHandle handle);

/// Helpers that the sections use, too. Lengths are in scene units.
double snappedLength(double length, glm::dvec3 direction, const CutSnap& snap);
glm::dvec3 snappedShift(glm::dvec3 shift, const CutSnap& snap);
double snappedAngle(double rad, const CutSnap& snap);
/// Moves a corner of a frame by a length along the frame's width and height; the opposite corner stays.
/// @param smallest  the least edge that is left  @param keepsRatio  of width to height
scene::Cut withCornerMoved(scene::Cut cut, int corner, glm::dvec2 length, double smallest, bool keepsRatio);
/// Moves one face of a box, or one end of a cylinder or cone, outwards by a length; the opposite face or end stays.
/// @param axis, sign  which face: 0..2, -1 or 1  @param smallest  the least edge that is left
scene::Cut withFaceMoved(scene::Cut cut, int axis, int sign, double length, double smallest);
/// Turns a cut about a point. @param axis  unit
scene::Cut withTurn(scene::Cut cut, glm::dvec3 pivot, glm::dvec3 axis, double rad);

}  // namespace velum::session
