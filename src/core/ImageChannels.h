#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "core/Image.h"

namespace velum {

/// Index of the channel with this name; -1 when the picture has no such channel.
std::ptrdiff_t channelIndex(const Image& image, std::string_view name);

/// A picture of the named channels only, in the order of the names. Names of channels that the picture does not have
/// are left out.
Image channelsOf(const Image& image, const std::vector<std::string>& names);

/// Where the channels of a colour are in a picture.
struct ColorChannels {
  std::array<std::size_t, 3> color;  ///< red, green, blue
  std::ptrdiff_t alpha;              ///< -1: none
};

/// The colours of a picture: its own (R, G, B, A), and those of its layers ("inlay.R" ...).
std::vector<ColorChannels> colorsOf(const Image& image);

/// A sample, 0..1, as a whole number of a type, from the type's least to its most; NaN is black.
template <class Whole>
Whole wholeSample(float sample) {
  constexpr float kMost = float(std::numeric_limits<Whole>::max());
  return sample > 0.0f ? Whole(std::min(sample, 1.0f) * kMost + 0.5f) : Whole(0);
}

}  // namespace velum
