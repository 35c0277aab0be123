#pragma once
#include <span>

#include "vector/LineFit.h"
#include "vector/SettleCurves.h"

namespace velum::vector {

/// What points may lie about a curve near a joint: mean square and largest distance, pixels; how far it may turn,
/// radians.
inline constexpr double kJointSquare = 0.13, kJointLargest = 0.8, kJointBend = 1.6;

/// Where a line passes beside a point of a track and which way it goes there, by as many points around as one curve
/// goes along. @param first, end  of the points that are asked; at least two
Tangent jointAt(const Track& track, const LineFits& fits, int point, int first, int end);

/// Puts other curves in the place of those of a line that go too far from the fence: one that is nearer at its
/// farthest, or several, or what goes through the middles of the edges of pixels, which are near whatever the pixels
/// are.
/// @param pieces  one for each curve  @param most  pixels from the fence; a fiftieth more is let be, as a line that is
/// drawn on pixels lies half a pixel from them itself where it is nearly level
void holdCurves(const Track& track, const LineFits& fits, std::span<const FittedPiece> pieces, Outline& line,
                double most);

}  // namespace velum::vector
