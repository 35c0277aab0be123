#pragma once
#include <cmath>

namespace velum {

/// The linear share that a share in sRGB stands for (IEC 61966-2-1), both 0..1. Shares below 0 are mirrored about 0.
template <class Number>
Number linearFromSrgb(Number share) {
  Number a = std::abs(share);
  return std::copysign(
      a <= Number(0.04045) ? a / Number(12.92) : std::pow((a + Number(0.055)) / Number(1.055), Number(2.4)), share);
}

/// The inverse of linearFromSrgb().
template <class Number>
Number srgbFromLinear(Number share) {
  Number a = std::abs(share);
  return std::copysign(
      a <= Number(0.0031308) ? a * Number(12.92) : Number(1.055) * std::pow(a, 1 / Number(2.4)) - Number(0.055), share);
}

}  // namespace velum
