#pragma once
#include "membrane/forces/Forces.h"
#include "scene/Cut.h"
#include "scene/SheetShape.h"

namespace velum::session {

/// Where a sheet is: its shape in the frame of a cut, under the forces of a time step. Without a shape it hangs flat.
struct SheetPlace {
  scene::SheetShape shape;
  scene::Cut cut;     ///< in whose frame the shape is
  int timeStep = -1;  ///< of the data whose forces hold it; -1: not known

  bool isFlat() const { return shape.places.empty(); }
  /// The same place of the world as a shape in another frame, with as many particles; empty when it hangs flat.
  scene::SheetShape in(const scene::Cut& frame) const;
  /// The sides of the sheet on which material lies, for forces that keep them; nothing when it hangs flat.
  membrane::CurrentSheet sidesIn(const scene::Cut& frame) const;
};

/// The place that a saved shape tells: in the frame in which the sheet came to rest, where the shape says so.
SheetPlace placeOf(const scene::SheetShape& saved, const scene::Cut& cut);
/// A sheet that hangs flat in a cut's frame, with so many particles.
SheetPlace flatPlace(const scene::Cut& cut, glm::ivec2 particles, int timeStep);

/// The cuts stand in the same place of the world.
bool haveSameFrame(const scene::Cut& a, const scene::Cut& b);

}  // namespace velum::session
