#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "velum/scene/Cut.h"
#include "velum/scene/SliceFrame.h"
#include "velum/session/cut/CutTool.h"
#include "velum/session/cut/SliceOutline.h"

namespace velum::session {

/// What can be taken hold of on a slice.
enum class SliceHandleKind {
  None,
  Move,  ///< moves in the slice; with `outwards`, as of a plane or by a membrane's arrow, along the cut's axis
  Turn,  ///< turns about the slice's normal, about `pivot`
  Face,  ///< moves one face of a box, a side of a membrane's frame, an end of a cylinder, the base of a cone; the
         ///< opposite one stays
  Side   ///< sets the radius of a sphere, cylinder or cone
};
struct SliceHandle {
  SliceHandleKind kind = SliceHandleKind::None;
  int axis = 0, sign = 0;    ///< which face
  glm::dvec2 place{0.0};     ///< pixels
  glm::dvec2 pivot{0.0};     ///< pixels
  glm::dvec2 outwards{0.0};  ///< Face, Side, Move along the axis: unit, the way it goes on the screen
  bool operator==(const SliceHandle&) const = default;
};

/// It moves the cut along its axis only, and is drawn as an arrow.
bool isArrow(const SliceHandle& handle);

/// The handles of a cut on a slice, in the order of who wins; empty when the slice misses it.
std::vector<SliceHandle> sliceHandles(const scene::SliceFrame& frame, const scene::Cut& cut);

/// The handle under a pixel; on the line of the outline, or of the sheet: Move. @param reach  pixels
SliceHandle sliceHandleAt(const scene::SliceFrame& frame, const scene::Cut& cut, glm::dvec2 pixel, double reach,
                          const scene::SheetShape& live = {});

/// The cut after a drag, from how it was when the drag began: going back gives the cut that was.
scene::Cut dragSliceCut(const scene::Cut& start, const scene::SliceFrame& frame, const SliceHandle& handle,
                        glm::dvec2 from, glm::dvec2 to, const CutSnap& snap = {});

/// The handle of the 3D view that does the same, for dragText() and dragLabel().
CutHandle likeInPicture(const SliceHandle& handle);

}  // namespace velum::session
