#pragma once
#include <cmath>

namespace velum {

/// A linear share of sRGB's (IEC 61966-2-1), both 0..1; what is below 0 is mirrored.
template <class Number>
Number linearFromSrgb(Number share) {
  Number a = std::abs(share);
  return std::copysign(
      a <= Number(0.04045) ? a / Number(12.92) : std::pow((a + Number(0.055)) / Number(1.055), Number(2.4)), share);
}

/// Back.
template <class Number>
Number srgbFromLinear(Number share) {
  Number a = std::abs(share);
  return std::copysign(
      a <= Number(0.0031308) ? a * Number(12.92) : Number(1.055) * std::pow(a, 1 / Number(2.4)) - Number(0.055), share);
}

}  // namespace velum
