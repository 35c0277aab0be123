#include "vector/PlateBytes.h"

#include <array>

#include "core/Assert.h"
#include "core/ImageChannels.h"

namespace velum::vector {

std::vector<std::uint8_t> plateBytes(const Image& image, Alpha alpha) {
  std::vector<std::ptrdiff_t> channels;
  if (alpha != Alpha::Alone)
    for (const char* name : {"R", "G", "B"}) channels.push_back(channelIndex(image, name));
  for (std::ptrdiff_t channel : channels) VELUM_ASSERT(channel >= 0, "a plate has the channels R, G and B");
  if (alpha != Alpha::Without) channels.push_back(channelIndex(image, "A"));
  const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height), count = image.channels.size();
  std::vector<std::uint8_t> bytes(pixels * channels.size());
  for (std::size_t pixel = 0, at = 0; pixel < pixels; ++pixel)
    for (std::ptrdiff_t channel : channels)
      bytes[at++] = channel < 0 ? 255 : wholeSample<std::uint8_t>(image.pixels[pixel * count + std::size_t(channel)]);
  return bytes;
}

}  // namespace velum::vector
