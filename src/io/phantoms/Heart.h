#pragma once
#include <vector>

#include "io/phantoms/Phantom.h"

/// A heart that beats: world LPS in mm, origin in the middle of the scan. Shapes are defined at rest, which is the end
/// of the filling, and moved to where the beat takes them.
namespace velum::io::heart {

using namespace phantom;

/// The state of the heart at a time of its beat.
class Beat {
 public:
  /// @param phase  0..1, 0 the end of the filling; any other number is the same as its fraction
  explicit Beat(float phase);

  float squeeze = 0;   ///< How far the ventricles are contracted, 0..1: 1 at the end of the ejection.
  float filling = 0;   ///< How full the atria are, -0.5..1: they fill while the ventricles eject, contract before.
  float valve = 0;     ///< How far the mitral valve is open, 0..1.
  float ejection = 0;  ///< Widens aorta and pulmonary trunk, 0..1.

  /// Where a point at rest goes: the valves' plane comes down to the apex, the apex turns.
  Vec moved(Vec rest) const;
  /// Where a point was at rest: the inverse of moved().
  Vec rest(Vec moved) const;
};

// Inner surfaces of the chambers, and the heart's outer one; positions at rest, mm.
float leftVentricle(Vec p, const Beat& beat);
float rightVentricle(Vec p, const Beat& beat, float growMm);
float leftAtrium(Vec p, const Beat& beat, float growMm);
float rightAtrium(Vec p, const Beat& beat, float growMm);
float outerSurface(Vec p, const Beat& beat);
float mitralValve(Vec p, const Beat& beat);
/// Twigs of the coronary arteries on the outer surface at this time of the beat.
std::vector<Segment> coronaries(const Beat& beat);

}  // namespace velum::io::heart
