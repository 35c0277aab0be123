#include "session/lettering/SeenSection.h"

#include <cstdlib>

#include "scene/SectionPlane.h"

namespace velum::session {

namespace {

constexpr int kGroundNoise = 24;  // of 255: what differs less from the ground is air

bool isLikeGround(std::uint32_t pixel, glm::vec3 ground) {
  for (int channel = 0; channel < 3; ++channel) {
    int value = int(pixel >> (16 - 8 * channel) & 255u);
    if (std::abs(value - int(255.0f * ground[channel])) > kGroundNoise) return false;
  }
  return true;
}

}  // namespace

Image seenOfSection(const render::SectionImage& section, const scene::SectionPlane& plane, glm::vec3 ground) {
  Image image{section.size.x, section.size.y, {"id", "instance", "position.X", "position.Y", "position.Z"}, {}};
  image.pixels.reserve(section.pixels.size() * image.channels.size());
  for (int y = 0; y < section.size.y; ++y)
    for (int x = 0; x < section.size.x; ++x) {
      std::size_t i = std::size_t(y) * std::size_t(section.size.x) + std::size_t(x);
      int id = section.structures.empty() ? 0 : section.structures[i];
      glm::dvec3 world = scene::worldFromSectionPixel(plane, glm::dvec2(x, y) + 0.5);
      image.pixels.insert(image.pixels.end(),
                          {float(id), id == 0 && isLikeGround(section.pixels[i], ground) ? -1.0f : 0.0f, float(world.x),
                           float(world.y), float(world.z)});
    }
  return image;
}

SectionMap::SectionMap(const render::SectionImage& section, glm::vec3 ground) {
  int step = mapStep(section.size.x);
  glm::ivec2 size = mapSize(section.size, step);
  mStructures.reserve(std::size_t(size.x) * std::size_t(size.y));
  for (int y = 0; y < section.size.y; y += step)
    for (int x = 0; x < section.size.x; x += step) {
      std::size_t i = std::size_t(y) * std::size_t(section.size.x) + std::size_t(x);
      int id = section.structures.empty() ? 0 : section.structures[i];
      mStructures.push_back(id == 0 && isLikeGround(section.pixels[i], ground) ? -1 : id);
    }
  mMap = {size, mStructures, {}, step};
}

}  // namespace velum::session
