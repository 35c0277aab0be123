#include "render/upload/Resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/Parallel.h"

namespace velum::render {

namespace {

/// Voxels on either side that a texel is made of: what is farther counts for less than a two hundredth.
constexpr int kReach = 5;
constexpr std::size_t kMostTaps = 32;

/// The cubic B-spline.
double bSpline(double x) {
  x = std::abs(x);
  if (x < 1.0) return 2.0 / 3.0 - x * x * (1.0 - 0.5 * x);
  return x < 2.0 ? std::pow(2.0 - x, 3.0) / 6.0 : 0.0;
}

/// How much each voxel counts at a place between voxels: B-splines, of which the factors are such that their sum goes
/// through the voxels.
Taps splineTaps(double place) {
  const double pole = std::sqrt(3.0) - 2.0;
  int base = int(std::floor(place));
  Taps taps{base - kReach + 1, {}, float(place - base)};
  double sum = 0.0;
  std::array<double, 2 * kReach> weights{};
  for (int n = 0; n < 2 * kReach; ++n) {
    for (int i = base - 1; i <= base + 2; ++i)
      weights[std::size_t(n)] += std::pow(pole, std::abs(i - taps.first - n)) * bSpline(place - i);
    sum += weights[std::size_t(n)];
  }
  for (double weight : weights) taps.weights.push_back(float(weight / sum));
  return taps;
}

/// The weights of a Gaussian around a voxel.
std::vector<float> gaussian(double sigma) {
  int reach = int(std::ceil(2.5 * sigma));
  std::vector<float> weights;
  float sum = 0.0f;
  for (int n = -reach; n <= reach; ++n) {
    weights.push_back(sigma > 0.0 ? float(std::exp(-0.5 * n * n / (sigma * sigma))) : 1.0f);
    sum += weights.back();
  }
  for (float& weight : weights) weight /= sum;
  return weights;
}

/// Weighted sums of rows, sixteen numbers side by side.
void addUp(std::span<const float* const> rows, std::span<const float> weights, std::size_t length, float* out) {
  constexpr std::size_t kPiece = 16;
  std::size_t i = 0;
  for (; i + kPiece <= length; i += kPiece) {
    std::array<float, kPiece> sums{};
    for (std::size_t n = 0; n < rows.size(); ++n)
      for (std::size_t k = 0; k < kPiece; ++k) sums[k] += weights[n] * rows[n][i + k];
    std::copy(sums.begin(), sums.end(), out + i);
  }
  for (; i < length; ++i) {
    out[i] = 0.0f;
    for (std::size_t n = 0; n < rows.size(); ++n) out[i] += weights[n] * rows[n][i];
  }
}

/// A value between the middle two of four neighbours. It is farther out than both only where lines through either side
/// are, too: at a crest, not beside an edge.
float limited(float value, glm::vec4 around, float share) {
  float a = around.x, b = around.y, c = around.z, d = around.w;
  // What is not a number concerns those beside it.
  if (!std::isfinite(value)) return share < 0.5f ? b : c;
  float fromLow = b + (b - a) * share, fromHigh = c + (c - d) * (1.0f - share);
  float least = std::min(std::min(b, c), std::max(fromLow, fromHigh));
  float most = std::max(std::max(b, c), std::min(fromLow, fromHigh));
  return std::clamp(value, least, most);
}

}  // namespace

Span askedBy(const std::vector<Taps>& taps, int whole) {
  int low = std::clamp(taps.front().first, 0, whole - 1);
  return {low, std::clamp(taps.back().first + int(taps.back().weights.size()), low + 1, whole)};
}

std::vector<Taps> splineTaps(int finer, int from, int to) {
  std::vector<Taps> taps;
  for (int texel = from; texel < to; ++texel)
    taps.push_back(finer == 1 ? Taps{texel, {1.0f}} : splineTaps((texel + 0.5) / finer - 0.5));
  return taps;
}

std::vector<Taps> gaussianTaps(double sigma, int from, int to) {
  auto weights = gaussian(sigma);
  std::vector<Taps> taps;
  for (int voxel = from; voxel < to; ++voxel) taps.push_back({voxel - int(weights.size() / 2), weights});
  return taps;
}

std::vector<float> smoothRows(const float* numbers, int perVoxel, int width, int rows, double sigma) {
  auto weights = gaussian(sigma);
  auto each = std::size_t(perVoxel), length = std::size_t(width) * each, reach = weights.size() / 2;
  std::vector<float> out(length * std::size_t(rows));
  parallelFor(0, rows, [&](int row) {
    const float* in = numbers + std::size_t(row) * length;
    std::vector<float> padded(length + 2 * reach * each);
    std::copy_n(in, length, padded.begin() + std::ptrdiff_t(reach * each));
    for (std::size_t i = 0; i < reach * each; ++i) {
      padded[i] = in[i % each];
      padded[reach * each + length + i] = in[length - each + i % each];
    }
    std::vector<const float*> shifted;
    for (std::size_t n = 0; n < weights.size(); ++n) shifted.push_back(&padded[n * each]);
    addUp(shifted, weights, length, &out[std::size_t(row) * length]);
  });
  return out;
}

std::vector<float> resample(const float* numbers, std::size_t inner, int outer, Span held, int whole,
                            const std::vector<Taps>& taps, bool isLimited) {
  auto plane = std::size_t(held.high - held.low) * inner;
  std::vector<float> out(inner * std::size_t(outer) * taps.size());
  auto takeTaps = [&](std::size_t block, std::size_t tap) {
    const Taps& t = taps[tap];
    auto rowOf = [&](int voxel) {
      return numbers + block * plane + std::size_t(std::clamp(voxel, 0, whole - 1) - held.low) * inner;
    };
    std::array<const float*, kMostTaps> rows;
    std::size_t count = t.weights.size();
    for (std::size_t n = 0; n < count; ++n) rows[n] = rowOf(t.first + int(n));
    float* row = &out[(block * taps.size() + tap) * inner];
    addUp({rows.data(), count}, t.weights, inner, row);
    if (!isLimited) return;
    for (std::size_t i = 0; i < inner; ++i) {
      glm::vec4 around(rows[kReach - 2][i], rows[kReach - 1][i], rows[kReach][i], rows[kReach + 1][i]);
      row[i] = limited(row[i], around, t.share);
    }
  };
  if (outer > 1)
    parallelFor(0, outer, [&](int block) {
      for (std::size_t tap = 0; tap < taps.size(); ++tap) takeTaps(std::size_t(block), tap);
    });
  else
    parallelFor(0, int(taps.size()), [&](int tap) { takeTaps(0, std::size_t(tap)); });
  return out;
}

std::vector<float> refine(const float* numbers, int perVoxel, glm::ivec3 dims, Span held, glm::ivec3 finer, int z0,
                          int z1, bool isLimited) {
  auto each = std::size_t(perVoxel);
  int planes = held.high - held.low;
  std::vector<float> along;
  if (finer.x > 1) {
    along = resample(numbers, each, dims.y * planes, {0, dims.x}, dims.x, splineTaps(finer.x, 0, dims.x * finer.x),
                     isLimited);
    numbers = along.data();
  }
  auto width = std::size_t(dims.x * finer.x);
  if (finer.y > 1) {
    along = resample(numbers, width * each, planes, {0, dims.y}, dims.y, splineTaps(finer.y, 0, dims.y * finer.y),
                     isLimited);
    numbers = along.data();
  }
  std::size_t plane = width * std::size_t(dims.y * finer.y) * each;
  if (finer.z == 1) {
    const float* first = numbers + plane * std::size_t(z0 - held.low);
    return {first, first + plane * std::size_t(z1 - z0)};
  }
  return resample(numbers, plane, 1, held, dims.z, splineTaps(finer.z, z0, z1), isLimited);
}

}  // namespace velum::render
