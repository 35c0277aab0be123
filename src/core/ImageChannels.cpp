#include "core/ImageChannels.h"

#include <algorithm>

namespace velum {

std::ptrdiff_t channelIndex(const Image& image, std::string_view name) {
  auto found = std::find(image.channels.begin(), image.channels.end(), name);
  return found == image.channels.end() ? -1 : found - image.channels.begin();
}

Image channelsOf(const Image& image, const std::vector<std::string>& names) {
  Image out{image.width, image.height, {}, {}};
  std::vector<std::size_t> columns;
  for (const auto& name : names) {
    std::ptrdiff_t column = channelIndex(image, name);
    if (column < 0) continue;
    out.channels.push_back(name);
    columns.push_back(std::size_t(column));
  }
  std::size_t count = std::size_t(image.width) * std::size_t(image.height);
  out.pixels.reserve(count * columns.size());
  for (std::size_t i = 0; i < count; ++i)
    for (auto c : columns) out.pixels.push_back(image.pixels[i * image.channels.size() + c]);
  return out;
}

std::vector<ColorChannels> colorsOf(const Image& image) {
  std::vector<ColorChannels> colors;
  for (const std::string& red : image.channels) {
    std::string layer = red.substr(0, red.size() - 1);
    if (red != layer + "R" || !(layer.empty() || layer.back() == '.')) continue;
    std::ptrdiff_t green = channelIndex(image, layer + "G"), blue = channelIndex(image, layer + "B");
    if (green < 0 || blue < 0) continue;
    colors.push_back({{std::size_t(channelIndex(image, red)), std::size_t(green), std::size_t(blue)},
                      channelIndex(image, layer + "A")});
  }
  return colors;
}

}  // namespace velum
