#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace velum {

/// Float samples, top row first, channels interleaved: shape [height][width][channels.size()].
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< "R", "G", "B", "A", "Z", "normal.X", ...
  std::vector<float> pixels;
};

}  // namespace velum
