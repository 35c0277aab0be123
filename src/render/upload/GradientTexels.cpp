#include "render/upload/GradientTexels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/gtc/type_ptr.hpp>

#include "core/Parallel.h"

namespace velum::render {

namespace {

/// One row of differences, each of values smoothed across it.
/// @param rowAt  rowAt(dy, dz): the row so many beside it
/// @param near   three rows of scratch, two values longer than the row
template <class RowAt>
void differRow(int width, const RowAt& rowAt, std::array<std::vector<float>, 3>& near, float* out) {
  auto& [smooth, alongY, alongZ] = near;
  const auto *below0 = rowAt(-1, -1), *below1 = rowAt(0, -1), *below2 = rowAt(1, -1), *here0 = rowAt(-1, 0),
             *here1 = rowAt(0, 0), *here2 = rowAt(1, 0), *above0 = rowAt(-1, 1), *above1 = rowAt(0, 1),
             *above2 = rowAt(1, 1);
  // Across the row.
  for (int x = 0; x < width; ++x) {
    float b0 = float(below0[x]), b1 = float(below1[x]), b2 = float(below2[x]);
    float h0 = float(here0[x]), h1 = float(here1[x]), h2 = float(here2[x]);
    float a0 = float(above0[x]), a1 = float(above1[x]), a2 = float(above2[x]);
    float below = b0 + 2.0f * b1 + b2, here = h0 + 2.0f * h1 + h2, above = a0 + 2.0f * a1 + a2;
    smooth[std::size_t(x) + 1] = (below + 2.0f * here + above) / 16.0f;
    alongY[std::size_t(x) + 1] = (b2 - b0 + 2.0f * (h2 - h0) + a2 - a0) / 16.0f;
    alongZ[std::size_t(x) + 1] = (above - below) / 16.0f;
  }
  for (auto* row : {&smooth, &alongY, &alongZ}) row->front() = (*row)[1], row->back() = (*row)[std::size_t(width)];
  // Along it.
  for (std::size_t x = 0; x < std::size_t(width); ++x) {
    out[3 * x] = smooth[x + 2] - smooth[x];
    out[3 * x + 1] = alongY[x] + 2.0f * alongY[x + 1] + alongY[x + 2];
    out[3 * x + 2] = alongZ[x] + 2.0f * alongZ[x + 1] + alongZ[x + 2];
  }
}

}  // namespace

template <class Texel>
std::vector<float> takeDifferences(const Texel* texels, glm::ivec3 dims, int firstPlane, int z0, int z1) {
  auto width = std::size_t(dims.x), height = std::size_t(dims.y);
  std::vector<float> differences(width * height * std::size_t(z1 - z0) * 3);
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
    auto rowAt = [&](int dy, int dz) {
      int y = std::clamp(job % dims.y + dy, 0, dims.y - 1), z = std::clamp(z0 + job / dims.y + dz, 0, dims.z - 1);
      return texels + (std::size_t(z - firstPlane) * height + std::size_t(y)) * width;
    };
    std::array<std::vector<float>, 3> near;
    for (auto& row : near) row.resize(width + 2);
    differRow(dims.x, rowAt, near, &differences[std::size_t(job) * width * 3]);
  });
  return differences;
}

PackedGradients packGradients(const std::vector<float>& differences, glm::ivec3 dims, int z0, int z1,
                              double longestGradient) {
  auto width = std::size_t(dims.x), height = std::size_t(dims.y);
  int low = std::max(0, z0 - 1), high = std::min(dims.z, z1 + 1);
  PackedGradients gradients(width * height * std::size_t(z1 - z0));
  float toShare = float(1.0 / longestGradient);
  parallelFor(0, (z1 - z0) * dims.y, [&](int job) {
    int z = z0 + job / dims.y, y = job % dims.y;
    auto differencesOf = [&](int b, int c) {
      return &differences[(std::size_t(c - low) * height + std::size_t(b)) * width * 3];
    };
    std::vector<float> largest(width + 2, 0.0f);  // squares, of the nine rows around; one more at each end
    for (int c = std::max(low, z - 1); c < std::min(high, z + 2); ++c)
      for (int b = std::max(0, y - 1); b < std::min(dims.y, y + 2); ++b) {
        const float* row = differencesOf(b, c);
        for (std::size_t x = 0; x < width; ++x) {
          glm::vec3 gradient = glm::make_vec3(row + 3 * x);
          largest[x + 1] = std::max(largest[x + 1], glm::dot(gradient, gradient));
        }
      }
    glm::u8vec4* out = &gradients[std::size_t(job) * width];
    const float* row = differencesOf(y, z);
    for (std::size_t x = 0; x < width; ++x) {
      float longest = std::sqrt(std::max(largest[x], std::max(largest[x + 1], largest[x + 2])));
      float toByte = longest > 0 ? 127.0f / longest : 0.0f;
      glm::vec3 share = glm::make_vec3(row + 3 * x) * toByte + 128.5f;
      out[x] = {std::uint8_t(share.x), std::uint8_t(share.y), std::uint8_t(share.z),
                std::uint8_t(255.0f * std::sqrt(std::min(1.0f, longest * toShare)) + 0.5f)};
    }
  });
  return gradients;
}

template std::vector<float> takeDifferences(const std::uint8_t*, glm::ivec3, int, int, int);
template std::vector<float> takeDifferences(const float*, glm::ivec3, int, int, int);

}  // namespace velum::render
