#pragma once
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/Image.h"
#include "vector/Drawing.h"

namespace velum::vector {

inline const glm::vec3 kRed{1.0f, 0.0f, 0.0f}, kWhite{1.0f}, kBlack{0.0f};

/// A picture of one colour. @param alpha  below 0: it has none
inline Image plainImage(int width, int height, glm::vec3 color = kWhite, float alpha = -1.0f) {
  Image image{width, height, {"R", "G", "B"}, {}};
  if (alpha >= 0.0f) image.channels.push_back("A");
  for (int i = 0; i < width * height; ++i) {
    image.pixels.insert(image.pixels.end(), {color.r, color.g, color.b});
    if (alpha >= 0.0f) image.pixels.push_back(alpha);
  }
  return image;
}

inline float sampleOf(const Image& image, int x, int y, std::size_t channel) {
  return image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * image.channels.size() + channel];
}

inline Shape filled(std::vector<Outline> outlines, glm::vec3 color = kBlack, double opacity = 1.0) {
  return {"", std::move(outlines), std::nullopt, Fill{color, opacity}};
}
inline Shape stroked(std::vector<Outline> outlines, Pen pen) { return {"", std::move(outlines), std::move(pen), {}}; }

inline Outline rectangle(glm::dvec2 low, glm::dvec2 high) {
  return outlineThrough({low, {high.x, low.y}, high, {low.x, high.y}}, true);
}

/// How much of a white picture is covered by black, pixels.
inline double coverOf(const Image& image) {
  double cover = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) cover += 1.0 - double(sampleOf(image, x, y, 0));
  return cover;
}

}  // namespace velum::vector
