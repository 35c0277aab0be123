#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Camera.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What can be taken hold of on a cut in the 3D view.
enum class CutHandle {
  None,
  Arrow,  ///< moves along the axis
  KnobRight,
  KnobTop,
  KnobLeft,
  KnobBottom,  ///< the four knobs tilt the cut about its middle
  Ring,        ///< of a box: turns the box about its axis; of other shapes: tilts the cut, the ring's point follows the
               ///< pointer
  Centre,      ///< of a closed shape: moves the shape across the line of sight
  Square,      ///< of a closed shape: moves the shape across its axis
  FaceXMin,
  FaceXMax,
  FaceYMin,
  FaceYMax,
  FaceZMin,
  FaceZMax,  ///< faces of a box, ends of a cylinder, apex and base of a cone: the opposite face or end stays
  Radius,    ///< of a sphere, cylinder or cone
  CornerMinMin,
  CornerMaxMin,
  CornerMinMax,
  CornerMaxMax  ///< of a membrane's rest plane, by x and y: both sides that meet in the corner move, the opposite
                ///< corner stays
};

/// A place where a handle can be taken. World.
struct CutGrip {
  CutHandle handle = CutHandle::None;
  glm::dvec3 place{0.0};
  glm::dvec3 direction{0.0};  ///< unit, the direction in which a handle that resizes goes
};

/// The lines and handles with which a cut is drawn over a picture. World; sizes are constant in pixels.
struct CutGizmo {
  glm::dvec3 centre{0.0};  ///< where the arrow stands: the middle of a plane's outline, or of a shape
  glm::dvec3 normal{0.0};  ///< unit, the axis of the arrow; of a plane: towards what is removed
  glm::dvec3 arrowTip{0.0};
  double radius = 0;                ///< of the ring on which the knobs sit
  double pixel = 0;                 ///< length of a pixel at the centre
  glm::dvec3 right{0.0}, top{0.0};  ///< unit, in the plane, towards the first two knobs
  bool hasRing = false;
  std::vector<CutGrip> grips;
  std::vector<glm::dvec3> outline;             ///< of a plane inside the scene's box: a convex polygon, empty when the
                                               ///< plane misses the box
  std::vector<std::vector<glm::dvec3>> edges;  ///< closed lines of a shape that is no plane
};

CutGizmo makeCutGizmo(const scene::Scene& scene, const scene::Cut& cut, glm::dvec2 pictureSize);

/// Where a handle is. World; the gizmo's centre for a handle that the gizmo does not have.
glm::dvec3 handlePlace(const CutGizmo& gizmo, CutHandle handle);

/// Points of the ring, for drawing. World.
std::vector<glm::dvec3> ringPoints(const CutGizmo& gizmo);

/// The handle under a pixel. @param reach  how far beside a handle the pixel may be, pixels
CutHandle handleAt(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 pictureSize, glm::dvec2 pixel,
                   double reach);

/// On which side of the frame's middle a corner lies, along the frame's width and height: -1 or 1. @param corner  0..3
glm::dvec2 cornerSigns(int corner);

}  // namespace velum::session
