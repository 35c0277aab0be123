#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "velum/scene/Camera.h"
#include "velum/scene/Cut.h"
#include "velum/scene/Scene.h"
#include "velum/session/cut/CutEdit.h"

namespace velum::session {

/// What can be taken hold of on a cut in the 3D view.
enum class CutHandle {
  None,
  Arrow,  ///< moves along the axis
  KnobRight,
  KnobTop,
  KnobLeft,
  KnobBottom,  ///< knobs tilt about the middle
  Ring,        ///< of a box: turns it about its axis; of the others: tilts, the ring's point follows the pointer
  Centre,      ///< of a closed shape: moves it across the line of sight
  Square,      ///< of a closed shape: moves it across its axis
  FaceXMin,
  FaceXMax,
  FaceYMin,
  FaceYMax,
  FaceZMin,
  FaceZMax,  ///< faces of a box, ends of a cylinder, apex and base of a cone: the opposite one stays
  Radius,    ///< of a sphere, cylinder or cone
  CornerMinMin,
  CornerMaxMin,
  CornerMinMax,
  CornerMaxMax  ///< of a membrane's frame, by x and y: both sides there move, the opposite corner stays
};

/// A place where a handle is taken. World, mm.
struct CutGrip {
  CutHandle handle = CutHandle::None;
  glm::dvec3 placeMm{0.0};
  glm::dvec3 direction{0.0};  ///< unit, along which a resizing handle goes
};

/// A cut as it is drawn over a picture. World, mm; sizes are constant in pixels.
struct CutGizmo {
  glm::dvec3 centreMm{0.0};  ///< where the arrow stands: middle of a plane's outline, or of a shape
  glm::dvec3 normal{0.0};    ///< unit; of a plane: towards what is removed
  glm::dvec3 arrowTipMm{0.0};
  double radiusMm = 0;              ///< of the ring that the knobs sit on
  double pixelMm = 0;               ///< length of a pixel at the centre
  glm::dvec3 right{0.0}, top{0.0};  ///< unit, in the plane, towards the first two knobs
  bool hasRing = false;
  std::vector<CutGrip> grips;
  std::vector<glm::dvec3> outlineMm;  ///< a plane inside the scene's box: a convex polygon, empty when it misses
  std::vector<std::vector<glm::dvec3>> edgesMm;  ///< closed lines of a shape that is no plane
};

CutGizmo makeCutGizmo(const scene::Scene& scene, const scene::Cut& cut, glm::dvec2 pictureSize);

/// Where a handle is. World, mm; the middle for a handle that the gizmo does not have.
glm::dvec3 handlePlaceMm(const CutGizmo& gizmo, CutHandle handle);

/// Points of the ring, for drawing. World, mm.
std::vector<glm::dvec3> ringPointsMm(const CutGizmo& gizmo);

/// The handle under a pixel. @param reach  how far beside it may be taken, pixels
CutHandle handleAt(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 pictureSize, glm::dvec2 pixel,
                   double reach);

/// What a drag keeps to while Shift is held: whole voxels and 15 degrees; a corner: the ratio of its edges. Off by
/// default.
struct CutSnap {
  bool on = false;
  glm::dmat3 worldFromVoxel{1.0};
};
CutSnap makeCutSnap(const scene::Scene& scene, bool on);

/// The cut after a drag, from how it was and how its gizmo stood when the drag began: a function of where the pointer
/// went, so that going back gives the cut that was.
scene::Cut dragCut(const scene::Cut& start, const CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                   glm::dvec2 pictureSize, glm::dvec2 from, glm::dvec2 to, const CutSnap& snap = {});

/// What a drag has done so far, in numbers: "12.5 mm", "30.0\u00b0". UTF-8.
std::string dragText(const scene::Cut& start, const scene::Cut& now, CutHandle handle);
/// The name of the undo step: "Move cut", "Tilt cut", "Turn cut", "Resize cut".
const char* dragLabel(const scene::Cut& cut, CutHandle handle);

/// Helpers that the slices use, too.
double snappedLength(double mm, glm::dvec3 direction, const CutSnap& snap);
glm::dvec3 snappedShift(glm::dvec3 shiftMm, const CutSnap& snap);
double snappedAngle(double rad, const CutSnap& snap);
/// On which side of the middle a corner of a frame lies, along its width and height. @param corner  0..3
glm::dvec2 cornerSigns(int corner);
/// Moves a corner of a frame by mm along its width and height; the opposite one stays. @param keepsRatio  of its edges
scene::Cut withCornerMoved(scene::Cut cut, int corner, glm::dvec2 mm, double smallest, bool keepsRatio);
/// Moves one face of a box, an end of a cylinder or cone outwards by `mm`; the opposite one stays.
/// @param axis, sign  which face: 0..2, -1 or 1  @param smallest  the least that is left, mm
scene::Cut withFaceMoved(scene::Cut cut, int axis, int sign, double mm, double smallest);
/// Turns a cut about a point. @param axis  unit
scene::Cut withTurn(scene::Cut cut, glm::dvec3 pivotMm, glm::dvec3 axis, double rad);

}  // namespace velum::session
