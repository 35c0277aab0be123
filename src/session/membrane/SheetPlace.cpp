#include "session/membrane/SheetPlace.h"

#include "membrane/sheet/SheetIndex.h"
#include "membrane/sheet/Simulation.h"

namespace velum::session {

scene::SheetShape SheetPlace::in(const scene::Cut& frame) const {
  if (isFlat() || haveSameFrame(cut, frame)) return shape;
  return membrane::fitShape(membrane::carryOver(shape, cut, frame), shape.particles, frame.size);
}

membrane::CurrentSheet SheetPlace::sidesIn(const scene::Cut& frame) const {
  if (isFlat()) return {};
  return {membrane::heightOf(in(frame)), timeStep};
}

SheetPlace placeOf(const scene::SheetShape& saved, const scene::Cut& cut) {
  SheetPlace place{membrane::fitShape(saved, cut.membrane->cloth.particles, cut.size), cut, saved.timeStep};
  place.shape.timeStep = saved.timeStep;
  if (glm::length(saved.axis) > 0.0) {
    place.cut.centre = place.shape.centre = saved.centre;
    place.cut.axis = place.shape.axis = saved.axis;
    place.cut.spinDeg = place.shape.spinDeg = saved.spinDeg;
  }
  return place;
}

SheetPlace flatPlace(const scene::Cut& cut, glm::ivec2 particles, int timeStep) {
  SheetPlace place{membrane::flatShape(cut, particles), cut, timeStep};
  if (cut.membrane->repositioning == scene::Repositioning::Active) membrane::anchor(place.shape, cut, timeStep);
  return place;
}

bool haveSameFrame(const scene::Cut& a, const scene::Cut& b) {
  return a.centre == b.centre && a.axis == b.axis && a.spinDeg == b.spinDeg && a.size == b.size;
}

}  // namespace velum::session
