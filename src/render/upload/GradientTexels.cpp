#include "GradientTexels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "velum/core/Parallel.h"

namespace velum::render {

template <class Texel>
std::vector<glm::u8vec4> computeGradients(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1,
                                          double longestGradient) {
  auto width = std::size_t(dims.x), height = std::size_t(dims.y);
  auto rowAt = [&](int y, int z) {
    y = std::clamp(y, 0, dims.y - 1), z = std::clamp(z, 0, dims.z - 1);
    return texels + (std::size_t(z - firstPlane) * height + std::size_t(y)) * width;
  };
  auto visitRow = [&](int y, int z, auto&& visit) {
    const Texel *here = rowAt(y, z), *y0 = rowAt(y - 1, z), *y1 = rowAt(y + 1, z), *below = rowAt(y, z - 1),
                *above = rowAt(y, z + 1);
    auto at = [&](int x, int x0, int x1) {
      visit(x, glm::vec3(float(here[x1]) - float(here[x0]), float(y1[x]) - float(y0[x]),
                         float(above[x]) - float(below[x])));
    };
    at(0, 0, std::min(1, dims.x - 1));
    for (int x = 1; x < dims.x - 1; ++x) at(x, x - 1, x + 1);
    if (dims.x > 1) at(dims.x - 1, dims.x - 2, dims.x - 1);
  };
  int low = std::max(0, z0 - 1), high = std::min(dims.z, z1 + 1);
  std::vector<float> squares(width * height * std::size_t(high - low));
  parallelFor(0, (high - low) * dims.y, [&](int job) {
    float* row = &squares[std::size_t(job) * width];
    visitRow(job % dims.y, low + job / dims.y, [&](int x, glm::vec3 g) { row[x] = glm::dot(g, g); });
  });
  std::vector<glm::u8vec4> gradients(width * height * std::size_t(z1 - z0));
  float toShare =
      float(1.0 / (longestGradient * (std::is_same_v<Texel, float> ? 1.0 : double(std::numeric_limits<Texel>::max()))));
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
    int z = z0 + job / dims.y, y = job % dims.y;
    std::vector<float> largest(width + 2, 0.0f);  // of the nine rows around; one more at each end
    for (int c = std::max(low, z - 1); c < std::min(high, z + 2); ++c)
      for (int b = std::max(0, y - 1); b < std::min(dims.y, y + 2); ++b) {
        const float* row = &squares[(std::size_t(c - low) * height + std::size_t(b)) * width];
        for (std::size_t x = 0; x < width; ++x) largest[x + 1] = std::max(largest[x + 1], row[x]);
      }
    glm::u8vec4* row = &gradients[std::size_t(job) * width];
    visitRow(y, z, [&](int x, glm::vec3 g) {
      const float* around = &largest[std::size_t(x)];
      float longest = std::sqrt(std::max(around[0], std::max(around[1], around[2])));
      float toByte = longest > 0 ? 127.0f / longest : 0.0f;
      row[x] = {std::uint8_t(g.x * toByte + 128.5f), std::uint8_t(g.y * toByte + 128.5f),
                std::uint8_t(g.z * toByte + 128.5f),
                std::uint8_t(255.0f * std::sqrt(std::min(1.0f, longest * toShare)) + 0.5f)};
    });
  });
  return gradients;
}

template std::vector<glm::u8vec4> computeGradients(const std::uint8_t*, glm::ivec3, int, int, int, double);
template std::vector<glm::u8vec4> computeGradients(const std::uint16_t*, glm::ivec3, int, int, int, double);
template std::vector<glm::u8vec4> computeGradients(const float*, glm::ivec3, int, int, int, double);

}  // namespace velum::render
