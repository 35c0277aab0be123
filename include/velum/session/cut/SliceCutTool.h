#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "velum/scene/Cut.h"
#include "velum/scene/SliceFrame.h"
#include "velum/session/cut/CutTool.h"

namespace velum::session {

/// What a cut is on a slice: every shape but a membrane is convex, so it is one line. Pixels of the slice's frame.
struct SliceOutline {
  std::vector<glm::dvec2> points;  ///< of a plane: the two ends of its line in the view; of a membrane: of the line of
                                   ///< its frame; empty when the slice misses it
  bool isClosed = false;
  glm::dvec2 removedSide{0.0};                  ///< of a plane: unit, across the line, to where it takes away
  std::vector<std::vector<glm::dvec2>> curves;  ///< of a membrane: where the slice crosses its sheet; closed ones end
                                                ///< where they begin
  std::vector<glm::dvec2> band;                 ///< of a membrane: the box within which its sheet stays
};
/// @param live  of a membrane: its shape as a solver has it; empty: as the cut says
SliceOutline sliceOutline(const scene::SliceFrame& frame, const scene::Cut& cut, const scene::SheetShape& live = {});

/// Length of the arrow that stands on a plane's line, towards what is removed.
constexpr double kSliceArrowPixels = 34.0;

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
