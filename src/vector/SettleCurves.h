#pragma once
#include <span>

#include "vector/CubicFit.h"

namespace velum::vector {

/// Which points of a track a curve of a line goes along.
struct FittedPiece {
  int first = 0, end = 0;
  bool isSmoothAfter = false;  ///< it goes on into the next curve without a kink, which the next joint keeps
  bool isFreeBefore = true, isFreeAfter = true;  ///< nobody says which way it goes at its ends
};

/// Moves the joints of a line across it, turns them and changes handles until the curves on both sides lie best: each
/// joint then knows what all points of two curves say, and points that are far off count for more, so that the line
/// comes within half a pixel of them where that can be. What does not lie better stays as it was.
/// @param pieces  one for each curve; the last is smooth after it where a closed line has no corner at its start
void settleCurves(const Track& track, std::span<const FittedPiece> pieces, Outline& line);

}  // namespace velum::vector
