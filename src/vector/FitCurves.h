#pragma once
#include <optional>

#include "vector/CubicFit.h"

namespace velum::vector {

/// A smooth line along a track, in few curves: corners stay corners, between them it has no kinks. Any thread, takes
/// about a microsecond a point.
/// @param from, to  ends of a track that is not closed @param track  at least one point
Outline fitCurves(const Track& track, const CurveEnd& from, const CurveEnd& to, const Nearness& nearness = {});
/// The same of a closed track. @param track  at least four points
Outline fitClosedCurves(const Track& track, const Nearness& nearness = {});

}  // namespace velum::vector
