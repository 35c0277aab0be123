#pragma once
#include <algorithm>
#include <cmath>

namespace velum::gui {

/// How much coarser than the view its pictures are while something moves, along each side: at first,
constexpr double kFirstScaleSoftware = 6.0, kFirstScaleHardware = 1.5;
/// and at most.
constexpr double kLargestScale = 14.0;
/// How long the rays and instances of a coarse picture may take, ms: this leaves room for tables, light and the
/// window's composition under 50 ms.
constexpr double kCoarseTargetMs = 15.0;

/// The scale of the next coarse picture. @param scale  of the last coarse picture  @param drawMs  how long the rays and
/// instances of the last one took
inline double adaptedScale(double scale, double drawMs) {
  if (drawMs <= 1.2 * kCoarseTargetMs && drawMs >= 0.6 * kCoarseTargetMs) return scale;
  double wanted = scale * std::sqrt(drawMs / kCoarseTargetMs);
  return std::clamp(0.5 * (scale + wanted), 1.0, kLargestScale);
}

}  // namespace velum::gui
