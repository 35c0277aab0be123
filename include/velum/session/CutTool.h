#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "velum/scene/Camera.h"
#include "velum/scene/Cut.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// What can be taken hold of on a cut: its arrow moves it along its axis, a knob tilts it.
enum class CutHandle { None, Arrow, KnobRight, KnobTop, KnobLeft, KnobBottom };

/// A cut as it is drawn over a picture. World, mm; sizes are constant in pixels.
struct CutGizmo {
  glm::dvec3 centreMm{0.0};  ///< where the arrow stands: middle of a plane's outline, a shape's own centre
  glm::dvec3 normal{0.0};    ///< unit; of a plane: towards what is removed
  glm::dvec3 arrowTipMm{0.0};
  double radiusMm = 0;                ///< of the ring that the knobs sit on
  glm::dvec3 right{0.0}, top{0.0};    ///< unit, in the plane, towards the first two knobs
  std::vector<glm::dvec3> outlineMm;  ///< a plane inside the scene's box: a convex polygon, empty when it misses
  std::vector<std::vector<glm::dvec3>> edgesMm;  ///< closed lines of a shape that is no plane
};

CutGizmo makeCutGizmo(const scene::Scene& scene, const scene::Cut& cut, glm::dvec2 pictureSize);

/// Where a handle is. World, mm.
glm::dvec3 handlePlaceMm(const CutGizmo& gizmo, CutHandle handle);

/// The handle under a pixel. @param reach  how far beside it may be taken, pixels
CutHandle handleAt(const CutGizmo& gizmo, const scene::Camera& camera, glm::dvec2 pictureSize, glm::dvec2 pixel,
                   double reach);

/// The cut after a drag, from how it was and how its gizmo stood when the drag began: a function of where the pointer
/// went, so that going back gives the cut that was.
scene::Cut dragCut(const scene::Cut& start, const CutGizmo& gizmo, CutHandle handle, const scene::Camera& camera,
                   glm::dvec2 pictureSize, glm::dvec2 from, glm::dvec2 to);

/// A plane through the middle of the scene that takes away the half before it, as the camera sees it.
scene::Cut cutFacingCamera(const scene::Scene& scene);

/// How far the plane stands from the middle of the scene along its normal, mm, and how far it can go while it meets the
/// scene's box (minus that to plus that).
struct CutPosition {
  double offsetMm = 0;
  double reachMm = 0;
};
CutPosition cutPosition(const scene::Scene& scene, const scene::Cut& cut);
/// The counterpart: the cut moved along its normal to an offset.
scene::Cut withOffset(const scene::Scene& scene, scene::Cut cut, double offsetMm);

}  // namespace velum::session
