#pragma once
#include "membrane/forces/Forces.h"
#include "scene/Cut.h"
#include "scene/SheetShape.h"

namespace velum::session {

/// Where a sheet is: its shape in the frame of a cut, under the forces of a time step. Without a shape the sheet hangs
/// flat.
struct SheetPlace {
  scene::SheetShape shape;
  scene::Cut cut;     ///< the cut in whose frame the shape is
  int timeStep = -1;  ///< of the data whose forces hold the sheet; -1: not known

  bool isFlat() const { return shape.places.empty(); }
  /// The shape that has the same place in the world in another frame, with as many particles; empty when the sheet
  /// hangs flat.
  scene::SheetShape in(const scene::Cut& frame) const;
  /// On which sides of the sheet material lies, for forces that keep the material there; nothing when the sheet hangs
  /// flat.
  membrane::CurrentSheet sidesIn(const scene::Cut& frame) const;
};

/// The place that a saved shape tells: in the frame in which the sheet came to rest where the shape names one, else in
/// that of the cut.
SheetPlace placeOf(const scene::SheetShape& saved, const scene::Cut& cut);
/// A sheet that hangs flat in a cut's frame, with that many particles.
SheetPlace flatPlace(const scene::Cut& cut, glm::ivec2 particles, int timeStep);

/// True when two cuts have the same frame: place, directions and size.
bool haveSameFrame(const scene::Cut& a, const scene::Cut& b);

}  // namespace velum::session
