#include "render/upload/BlockGradients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "render/upload/GradientPlanes.h"
#include "render/upload/Resample.h"

// Rows of numbers, one number of each voxel side by side, and loops over rows without branches: compilers make eight of
// them at once.

namespace velum::render {

namespace {

using Numbers = std::vector<float>;

/// The strides of a block, and loops over its rows.
struct Rows {
  glm::ivec3 dims;
  std::size_t at(int y, int z) const {
    y = std::clamp(y, 0, dims.y - 1), z = std::clamp(z, 0, dims.z - 1);
    return (std::size_t(z) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
  }
  std::size_t count() const { return std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z); }
  template <class Body>
  void each(const Body& body) const {
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y) body(y, z, at(y, z));
  }
};

/// (a + 2 b + c) / 4 and c - a.
void smoothAndDiffer(const float* a, const float* b, const float* c, int count, float* smooth, float* differ) {
  for (int x = 0; x < count; ++x) smooth[x] = 0.25f * (a[x] + c[x]) + 0.5f * b[x];
  for (int x = 0; x < count; ++x) differ[x] = c[x] - a[x];
}
void smoothAlone(const float* a, const float* b, const float* c, int count, float* smooth) {
  for (int x = 0; x < count; ++x) smooth[x] = 0.25f * (a[x] + c[x]) + 0.5f * b[x];
}

/// A row with its ends repeated.
const float* padded(const float* row, int count, int pad, Numbers& scratch) {
  scratch.resize(std::size_t(count + 2 * pad));
  std::fill_n(scratch.begin(), pad, row[0]);
  std::copy_n(row, count, scratch.begin() + pad);
  std::fill_n(scratch.begin() + pad + count, pad, row[count - 1]);
  return scratch.data() + pad;
}

/// Differences over two voxels along each axis, smoothed by 1 2 1 across.
void takeNarrow(const Numbers& values, const Rows& rows, std::array<Numbers, 3>& out) {
  int n = rows.dims.x;
  auto count = std::size_t(n);
  thread_local Numbers smoothZ, differZ, scratch, line;
  smoothZ.resize(rows.count());
  differZ.resize(rows.count());
  line.resize(3 * count);
  rows.each([&](int y, int z, std::size_t at) {
    smoothAndDiffer(&values[rows.at(y, z - 1)], &values[at], &values[rows.at(y, z + 1)], n, &smoothZ[at], &differZ[at]);
  });
  for (auto& numbers : out) numbers.resize(rows.count());
  rows.each([&](int y, int z, std::size_t at) {
    std::size_t before = rows.at(y - 1, z), after = rows.at(y + 1, z);
    float *both = line.data(), *alongY = both + n, *alongZ = alongY + n;
    smoothAndDiffer(&smoothZ[before], &smoothZ[at], &smoothZ[after], n, both, alongY);
    smoothAlone(&differZ[before], &differZ[at], &differZ[after], n, alongZ);
    const float* p = padded(both, n, 1, scratch);
    for (int x = 0; x < n; ++x) out[0][at + std::size_t(x)] = p[x + 1] - p[x - 1];
    p = padded(alongY, n, 1, scratch);
    smoothAlone(p - 1, p, p + 1, n, &out[1][at]);
    p = padded(alongZ, n, 1, scratch);
    smoothAlone(p - 1, p, p + 1, n, &out[2][at]);
  });
}

/// Weights of a Gaussian, from its middle outwards.
std::vector<float> halfOf(double width) {
  auto taps = gaussianTaps(width, 0, 1).front().weights;
  return {taps.begin() + std::ptrdiff_t(taps.size() / 2), taps.end()};
}

/// Adds pairs of rows that lie as far from a middle one.
template <class RowAt>
void addPairs(const std::vector<float>& half, int count, const RowAt& rowAt, float* out) {
  const float* middle = rowAt(0);
  for (int x = 0; x < count; ++x) out[x] = half[0] * middle[x];
  for (int k = 1; k < int(half.size()); ++k) {
    const float *a = rowAt(-k), *b = rowAt(k);
    float weight = half[std::size_t(k)];
    for (int x = 0; x < count; ++x) out[x] += weight * (a[x] + b[x]);
  }
}

/// Smoothed along all three axes.
void takeWide(const Numbers& narrow, const Rows& rows, const std::array<std::vector<float>, 3>& halves,
              Numbers& scratch, Numbers& out) {
  int n = rows.dims.x;
  Numbers line;
  scratch.resize(rows.count());
  out.resize(rows.count());
  rows.each([&](int, int, std::size_t at) {
    const float* p = padded(&narrow[at], n, int(halves[0].size()), line);
    addPairs(
        halves[0], n, [&](int k) { return p + k; }, &out[at]);
  });
  rows.each([&](int y, int z, std::size_t at) {
    addPairs(
        halves[1], n, [&](int k) { return &out[rows.at(y + k, z)]; }, &scratch[at]);
  });
  rows.each([&](int y, int z, std::size_t at) {
    addPairs(
        halves[2], n, [&](int k) { return &scratch[rows.at(y, z + k)]; }, &out[at]);
  });
}

/// The direction of the wide gradient, unless it turns away, and the length of the narrow one: GradientPlanes'
/// merged().
void merge(const std::array<Numbers, 3>& narrow, std::array<Numbers, 3>& wide, Numbers& squares) {
  const float kApart = std::cos(glm::radians(20.0f)), kTogether = std::cos(glm::radians(10.0f));
  const float perSpan = 1.0f / (kTogether - kApart);
  constexpr float kTiny = 1e-30f;
  std::size_t count = narrow[0].size();
  squares.resize(count);
  const float *nx = narrow[0].data(), *ny = narrow[1].data(), *nz = narrow[2].data();
  float *wx = wide[0].data(), *wy = wide[1].data(), *wz = wide[2].data(), *square = squares.data();
  for (std::size_t i = 0; i < count; ++i) {
    float length2 = nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i];
    float wide2 = wx[i] * wx[i] + wy[i] * wy[i] + wz[i] * wz[i];
    float ofNarrow = 1.0f / std::sqrt(std::max(length2, kTiny)), ofWide = 1.0f / std::sqrt(std::max(wide2, kTiny));
    float dot = (nx[i] * wx[i] + ny[i] * wy[i] + nz[i] * wz[i]) * ofNarrow * ofWide;
    float share = std::min(std::max((dot - kApart) * perSpan, 0.0f), 1.0f);
    share = share * share * (3.0f - 2.0f * share);
    float a = (1.0f - share) * ofNarrow, b = share * ofWide;
    float x = a * nx[i] + b * wx[i], y = a * ny[i] + b * wy[i], z = a * nz[i] + b * wz[i];
    float scale = std::sqrt(length2) / std::sqrt(std::max(x * x + y * y + z * z, kTiny));
    wx[i] = x * scale, wy[i] = y * scale, wz[i] = z * scale;
    square[i] = length2;
  }
}

/// The largest of the 27 numbers around each.
void spreadLargest(Numbers& numbers, const Rows& rows, Numbers& scratch) {
  int n = rows.dims.x;
  scratch.resize(rows.count());
  auto largest = [n](const float* a, const float* b, const float* c, float* out) {
    for (int x = 0; x < n; ++x) out[x] = std::max(b[x], std::max(a[x], c[x]));
  };
  Numbers line;
  rows.each([&](int, int, std::size_t at) {
    const float* p = padded(&numbers[at], n, 1, line);
    largest(p - 1, p, p + 1, &scratch[at]);
  });
  rows.each([&](int y, int z, std::size_t at) {
    largest(&scratch[rows.at(y - 1, z)], &scratch[at], &scratch[rows.at(y + 1, z)], &numbers[at]);
  });
  rows.each([&](int y, int z, std::size_t at) {
    largest(&numbers[rows.at(y, z - 1)], &numbers[at], &numbers[rows.at(y, z + 1)], &scratch[at]);
  });
  numbers.swap(scratch);
}

/// What a thread keeps from block to block.
struct Scratch {
  std::array<Numbers, 3> narrow, wide;
  Numbers squares, spare;
};

}  // namespace

PackedGradients blockGradients(const std::vector<float>& values, glm::ivec3 dims, glm::dvec3 spacing,
                               const TexelBox& box, double longestGradient) {
  thread_local Scratch s;
  Rows rows{dims};
  takeNarrow(values, rows, s.narrow);
  glm::dvec3 widths = gradientWidths(spacing, dims);
  std::array<std::vector<float>, 3> halves{halfOf(widths.x), halfOf(widths.y), halfOf(widths.z)};
  for (std::size_t axis = 0; axis < 3; ++axis) takeWide(s.narrow[axis], rows, halves, s.spare, s.wide[axis]);
  merge(s.narrow, s.wide, s.squares);
  spreadLargest(s.squares, rows, s.spare);
  PackedGradients out(std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z));
  glm::u8vec4* texel = out.data();
  auto toShare = float(1.0 / longestGradient);
  for (int z = box.origin.z; z < box.origin.z + box.size.z; ++z)
    for (int y = box.origin.y; y < box.origin.y + box.size.y; ++y) {
      std::size_t row = rows.at(y, z);
      for (int x = box.origin.x; x < box.origin.x + box.size.x; ++x) {
        std::size_t i = row + std::size_t(std::clamp(x, 0, dims.x - 1));
        float longest = std::sqrt(s.squares[i]), toByte = longest > 0 ? 127.0f / longest : 0.0f;
        *texel++ = {std::uint8_t(s.wide[0][i] * toByte + 128.5f), std::uint8_t(s.wide[1][i] * toByte + 128.5f),
                    std::uint8_t(s.wide[2][i] * toByte + 128.5f),
                    std::uint8_t(255.0f * std::sqrt(std::min(1.0f, longest * toShare)) + 0.5f)};
      }
    }
  return out;
}

}  // namespace velum::render
