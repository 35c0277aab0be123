#include "scene/LitSpheres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/Error.h"
#include "scene/LitSphereTable.h"

namespace velum::scene {

namespace {

// As illustrators have it: from the upper left, in front.
const glm::vec3 kTowardsLight = glm::normalize(glm::vec3(-0.50f, 0.62f, 0.72f));
const glm::vec3 kTowardsBounce = glm::normalize(glm::vec3(0.62f, -0.70f, 0.10f));
const glm::vec3 kTowardsEye(0.0f, 0.0f, 1.0f);

glm::vec3 rampAt(const LitSphereRow& row, float shade) {
  if (row.steps > 0) {
    // Steps with edges a little soft, so that they are smooth in a picture.
    float at = shade * float(row.steps), whole = std::floor(at);
    shade = (whole + glm::smoothstep(0.78f, 1.0f, at - whole)) / float(row.steps);
  }
  float low = glm::smoothstep(0.0f, 1.0f, std::clamp(2.0f * shade, 0.0f, 1.0f));
  float high = glm::smoothstep(0.0f, 1.0f, std::clamp(2.0f * shade - 1.0f, 0.0f, 1.0f));
  return glm::mix(glm::mix(row.dark, row.middle, low), row.light, high);
}

/// Bright sky over a dark horizon, as polished metal shows them: 0..1.
float surroundings(glm::vec3 n) {
  glm::vec3 mirrored = 2.0f * n.z * n - kTowardsEye;
  float high = mirrored.y - 0.25f * mirrored.x;
  float sky = glm::mix(1.0f, 0.45f, glm::smoothstep(0.05f, 1.0f, high));
  float ground = glm::mix(0.08f, 0.5f, glm::smoothstep(0.0f, 1.0f, -high));
  return glm::mix(ground, sky, glm::smoothstep(-0.30f, 0.22f, high));
}

glm::vec3 colorOf(const LitSphereRow& row, glm::vec3 n) {
  float lambert = glm::dot(n, kTowardsLight);
  // A little darker than light is: painters keep the lightest tones for few places.
  float shade = std::pow(std::clamp((lambert + row.soft) / (1.0f + row.soft), 0.0f, 1.0f), 1.4f);
  shade = glm::mix(shade, surroundings(n), row.mirror);
  glm::vec3 color = rampAt(row, shade);
  color += row.bounce * glm::smoothstep(0.1f, 1.0f, glm::dot(n, kTowardsBounce));
  float edge = std::pow(1.0f - std::clamp(n.z, 0.0f, 1.0f), row.rimPower);
  color = glm::mix(color, row.rim, row.rimShare * edge);
  glm::vec3 halfway = glm::normalize(kTowardsLight + kTowardsEye);
  float highlight = row.shine * std::pow(std::max(0.0f, glm::dot(n, halfway)), row.gloss);
  color = glm::mix(color, glm::vec3(1.0f), std::min(1.0f, highlight));
  return glm::clamp(color, glm::vec3(0.0f), glm::vec3(1.0f));
}

/// The normal of the sphere in a picture that it fills; beyond it that of its rim. @param at  -1..1, up
glm::vec3 normalAt(glm::vec2 at) {
  float r = glm::length(at);
  if (r >= 1.0f) return {at / r, 0.0f};
  return {at, std::sqrt(1.0f - r * r)};
}

template <class ColorAt>
Image makeImage(int size, ColorAt colorAt) {
  Image image{size, size, {"R", "G", "B"}, {}};
  image.pixels.reserve(std::size_t(size) * std::size_t(size) * 3);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      glm::vec3 color = colorAt(x, y);
      image.pixels.insert(image.pixels.end(), {color.r, color.g, color.b});
    }
  return image;
}

}  // namespace

std::span<const LitSphereName> litSpheres() { return litSphereTable().names(); }

glm::vec3 litSphereColor(std::string_view name, glm::vec3 n) { return colorOf(litSphereTable().at(name), n); }

Image makeLitSphere(std::string_view name, int size) {
  const LitSphereRow& row = litSphereTable().at(name);
  return makeImage(size, [&](int x, int y) {
    glm::vec2 at = (glm::vec2(float(x), float(y)) + 0.5f) * 2.0f / float(size) - 1.0f;
    return colorOf(row, normalAt({at.x, -at.y}));
  });
}

Image fitLitSphere(const Image& picture) {
  int edge = std::min(picture.width, picture.height);
  std::size_t channels = picture.channels.size();
  if (edge < 1 || channels < 1) throw ArgumentError("a picture of a lit sphere is empty");
  glm::ivec2 corner((picture.width - edge) / 2, (picture.height - edge) / 2);
  // The mean of all pixels that one of ours covers, at least the nearest.
  auto range = [&](int i) {
    int from = i * edge / kLitSphereSize, to = (i + 1) * edge / kLitSphereSize;
    return glm::ivec2(from, std::max(from + 1, to));
  };
  return makeImage(kLitSphereSize, [&](int x, int y) {
    glm::ivec2 across = range(x), down = range(y);
    glm::vec3 sum(0.0f);
    for (int v = down.x; v < down.y; ++v)
      for (int u = across.x; u < across.y; ++u) {
        auto at = std::size_t(v + corner.y) * std::size_t(picture.width) + std::size_t(u + corner.x);
        const float* p = &picture.pixels[at * channels];
        sum += channels < 3 ? glm::vec3(p[0]) : glm::vec3(p[0], p[1], p[2]);
      }
    glm::vec3 mean = sum / float((across.y - across.x) * (down.y - down.x));
    return glm::clamp(mean, glm::vec3(0.0f), glm::vec3(1.0f));
  });
}

}  // namespace velum::scene
