#include "render/upload/PackedTexels.h"

#include <algorithm>
#include <cstdint>

#include "core/Parallel.h"

namespace velum::render {

template <class Texel>
std::vector<glm::vec<4, Texel>> packTexels(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1) {
  auto width = std::size_t(dims.x), height = std::size_t(dims.y);
  auto rowAt = [&](int y, int z) {
    y = std::min(y, dims.y - 1), z = std::min(z, dims.z - 1);
    return texels + (std::size_t(z - firstPlane) * height + std::size_t(y)) * width;
  };
  std::vector<glm::vec<4, Texel>> packed(width * height * std::size_t(z1 - z0));
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
    int z = z0 + job / dims.y, y = job % dims.y;
    const Texel *here = rowAt(y, z), *next = rowAt(y + 1, z), *above = rowAt(y, z + 1), *both = rowAt(y + 1, z + 1);
    auto* row = &packed[std::size_t(job) * width];
    for (std::size_t x = 0; x < width; ++x) row[x] = {here[x], next[x], above[x], both[x]};
  });
  return packed;
}

template std::vector<glm::vec<4, std::uint8_t>> packTexels(const std::uint8_t*, glm::ivec3, int, int, int);
template std::vector<glm::vec<4, std::uint16_t>> packTexels(const std::uint16_t*, glm::ivec3, int, int, int);

}  // namespace velum::render
