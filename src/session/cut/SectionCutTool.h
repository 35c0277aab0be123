#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/Cut.h"
#include "scene/SectionPlane.h"
#include "session/cut/CutTool.h"
#include "session/cut/SectionOutline.h"

namespace velum::session {

/// What can be taken hold of on a section.
enum class SectionHandleKind {
  None,
  Move,  ///< moves the cut in the section; with `outwards`, as of a plane or by a membrane's arrow, along the cut's
         ///< axis
  Turn,  ///< turns the cut about `pivot` and the section's normal
  Face,  ///< moves one face of a box, a side of a membrane's rest plane, an end of a cylinder, the base of a cone; the
         ///< opposite face, side or end stays
  Side   ///< sets the radius of a sphere, cylinder or cone
};
struct SectionHandle {
  SectionHandleKind kind = SectionHandleKind::None;
  int axis = 0, sign = 0;    ///< which face, as of withFaceMoved()
  glm::dvec2 place{0.0};     ///< pixels
  glm::dvec2 pivot{0.0};     ///< pixels
  glm::dvec2 outwards{0.0};  ///< Face, Side, Move along the axis: unit, the way the handle goes on the screen
  bool operator==(const SectionHandle&) const = default;
};

/// True when the handle moves the cut along its axis only, and is drawn as an arrow.
bool isArrow(const SectionHandle& handle);

/// The handles of a cut on a section; where several lie under a pixel the first of them wins. Empty when the section
/// misses the cut.
std::vector<SectionHandle> sectionHandles(const scene::SectionPlane& plane, const scene::Cut& cut);

/// The handle under a pixel; on the line of the outline, or of the sheet: Move. @param reach  how far beside, pixels
/// @param live  as of sectionOutline()
SectionHandle sectionHandleAt(const scene::SectionPlane& plane, const scene::Cut& cut, glm::dvec2 pixel, double reach,
                              const scene::SheetShape& live = {});

/// The cut after a drag, made from the cut as it was when the drag began: going back gives the cut that was.
scene::Cut dragSectionCut(const scene::Cut& start, const scene::SectionPlane& plane, const SectionHandle& handle,
                          glm::dvec2 from, glm::dvec2 to, const CutSnap& snap = {});

/// The handle of the 3D view that does the same as a section's handle, for dragText() and dragLabel().
CutHandle likeInPicture(const SectionHandle& handle);

}  // namespace velum::session
