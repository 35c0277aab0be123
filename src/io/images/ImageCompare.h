#pragma once
#include "core/Image.h"

namespace velum::io {

/// How far two pictures differ, channel-wise in 0..255 for display-referred values.
struct ImageDifference {
  double maxDifference = 0;    ///< 0..255
  double rms = 0;              ///< 0..255
  double failingFraction = 0;  ///< Share of pixels with a channel over the threshold, 0..1.
};
/// @param threshold  0..255. @throw InputError when sizes or channel counts differ
ImageDifference compareImages(const Image& a, const Image& b, double threshold);
/// Absolute difference, scaled so that `threshold` is mid grey.
Image differenceImage(const Image& a, const Image& b, double threshold);

}  // namespace velum::io
