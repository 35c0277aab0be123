#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace velum {

/// Float samples, top row first, channels interleaved: shape [height][width][channels.size()].
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< "R", "G", "B", "A", "Z", "normal.X", ...
  std::vector<float> pixels;
};

/// Which of the channels has a name; -1: none has.
std::ptrdiff_t channelIndex(const Image& image, std::string_view name);

/// The channels named, in that order; those that the picture has not are left out.
Image channelsOf(const Image& image, const std::vector<std::string>& names);

}  // namespace velum
