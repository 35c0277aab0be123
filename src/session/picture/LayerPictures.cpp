#include "session/picture/LayerPictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/ImageChannels.h"
#include "core/LabelVolume.h"
#include "io/images/ImageFile.h"

namespace velum::session {

namespace {

constexpr int kBits = 16;
constexpr float kFarthest = 0.1f;  ///< How light the farthest place is: what is hit nowhere is darker still.

std::size_t pixelCount(const Image& image) { return std::size_t(image.width) * std::size_t(image.height); }

/// A picture of a colour for each pixel. @param colorOf  (number of the pixel)
template <class ColorOf>
Image colored(const Image& image, ColorOf colorOf) {
  Image out{image.width, image.height, {"R", "G", "B"}, {}};
  out.pixels.reserve(pixelCount(image) * 3);
  for (std::size_t i = 0; i < pixelCount(image); ++i) {
    glm::vec3 color = colorOf(i);
    out.pixels.insert(out.pixels.end(), {color.r, color.g, color.b});
  }
  return out;
}

/// One channel of a picture, by pixel; empty when the picture has no channel of the name.
std::vector<float> channelOf(const Image& image, const std::string& name) { return channelsOf(image, {name}).pixels; }

Image depthPicture(const Image& image, std::vector<float> depth) {
  float nearest = INFINITY, farthest = 0.0f;
  for (float z : depth)
    if (std::isfinite(z)) nearest = std::min(nearest, z), farthest = std::max(farthest, z);
  for (float& z : depth)
    z = std::isfinite(z) ? 1.0f - (1.0f - kFarthest) * (z - nearest) / std::max(1e-6f, farthest - nearest) : 0.0f;
  return {image.width, image.height, {"Y"}, std::move(depth)};
}

Image positionPicture(const Image& image, const std::vector<float>& depth) {
  std::vector<float> position = channelsOf(image, {"position.X", "position.Y", "position.Z"}).pixels;
  auto at = [&](std::size_t i) { return glm::vec3(position[i * 3], position[i * 3 + 1], position[i * 3 + 2]); };
  glm::vec3 low(INFINITY), high(-INFINITY);
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (std::isfinite(depth[i])) low = glm::min(low, at(i)), high = glm::max(high, at(i));
  return colored(image, [&](std::size_t i) {
    return std::isfinite(depth[i]) ? (at(i) - low) / glm::max(high - low, 1e-6f) : glm::vec3(0.0f);
  });
}

/// A colour of its own for each number, and none that is dark: its multiple by the golden ratio modulo 2^24,
/// which no two numbers below 2^24 have in common.
glm::vec3 colorOfInstance(std::uint32_t number) {
  std::uint32_t mixed = (number * 0x9e3779u) & 0xffffffu;  // odd, so that nothing is lost
  glm::vec3 bytes(float(mixed >> 16), float(mixed >> 8 & 0xffu), float(mixed & 0xffu));
  return 0.2f + 0.8f * bytes / 255.0f;
}

Image idPicture(const Image& image) {
  std::vector<float> structures = channelOf(image, "id"), instances = channelOf(image, "instance");
  return colored(image, [&](std::size_t i) {
    if (structures[i] > 0.0f) return defaultLabelColor(std::uint16_t(structures[i]));
    return instances[i] > 0.0f ? colorOfInstance(std::uint32_t(instances[i])) : glm::vec3(0.0f);
  });
}

}  // namespace

std::vector<std::string> colorChannels(const std::string& layer) {
  return {layer + ".R", layer + ".G", layer + ".B", layer + ".A"};
}

std::vector<std::filesystem::path> writeLayerPictures(const Image& image, const std::vector<glm::vec3>& typeColors,
                                                      double dpi, const std::filesystem::path& output) {
  std::vector<std::filesystem::path> files;
  auto write = [&](const Image& layer, const char* what) {
    auto path = output;
    path.replace_filename(fmt::format("{}.{}{}", output.stem().string(), what, output.extension().string()));
    io::writeImage(layer, path, {}, dpi, {}, kBits);
    files.push_back(path);
  };
  // Parts of an inlay, where the picture has them.
  for (const char* layer : kInlayLayers) {
    Image color = channelsOf(image, colorChannels(layer));
    if (color.channels.size() < 4) continue;
    color.channels = {"R", "G", "B", "A"};
    write(color, layer);
  }
  write({image.width, image.height, {"Y"}, channelOf(image, "A")}, "alpha");
  std::vector<float> depth = channelOf(image, "Z"), types = channelOf(image, "type");
  write(depthPicture(image, depth), "depth");
  write(positionPicture(image, depth), "position");
  std::vector<float> normals = channelsOf(image, {"normal.X", "normal.Y", "normal.Z"}).pixels;
  write(colored(image,
                [&](std::size_t i) {
                  return 0.5f + 0.5f * glm::vec3(normals[i * 3], normals[i * 3 + 1], normals[i * 3 + 2]);
                }),
        "normal");
  write(idPicture(image), "id");
  if (types.empty()) return files;
  write(colored(image,
                [&](std::size_t i) {
                  bool isType = types[i] >= 0.0f && types[i] < float(typeColors.size());
                  return isType ? typeColors[std::size_t(types[i])] : glm::vec3(0.0f);
                }),
        "type");
  return files;
}

}  // namespace velum::session
