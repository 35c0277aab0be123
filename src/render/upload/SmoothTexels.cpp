#include "SmoothTexels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "velum/core/Parallel.h"

namespace velum::render {

namespace {

/// Voxels on either side that a texel is made of: what is farther counts for less than a two hundredth.
constexpr int kReach = 5;
constexpr int kTaps = 2 * kReach;

struct Taps {
  int first = 0;      ///< voxel of the first weight
  float share = 0.0;  ///< from the voxel before the place to the one after it
  std::array<float, kTaps> weights{};
};

/// The cubic B-spline.
double bSpline(double x) {
  x = std::abs(x);
  if (x < 1.0) return 2.0 / 3.0 - x * x * (1.0 - 0.5 * x);
  return x < 2.0 ? std::pow(2.0 - x, 3.0) / 6.0 : 0.0;
}

/// How much each voxel counts at a place between voxels: B-splines, of which the factors are such that their sum goes
/// through the voxels.
Taps tapsAt(double place) {
  const double pole = std::sqrt(3.0) - 2.0;
  int base = int(std::floor(place));
  Taps taps{base - kReach + 1, float(place - base), {}};
  double sum = 0.0;
  std::array<double, kTaps> weights{};
  for (int n = 0; n < kTaps; ++n) {
    for (int i = base - 1; i <= base + 2; ++i)
      weights[std::size_t(n)] += std::pow(pole, std::abs(i - taps.first - n)) * bSpline(place - i);
    sum += weights[std::size_t(n)];
  }
  for (std::size_t n = 0; n < kTaps; ++n) taps.weights[n] = float(weights[n] / sum);
  return taps;
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

/// The voxel coordinate of the middle of a texel.
double placeOf(int texel, int finer) { return (texel + 0.5) / finer - 0.5; }

/// A block of values, x fastest, of which the voxels along one axis become texels.
/// @param inner, outer  how many values lie side by side, and how many times the axis is met
/// @param first         the voxel with which the block begins along the axis, of `whole` that there are
std::vector<float> smoothAlong(const float* values, int inner, int outer, int first, int count, int whole, int finer,
                               int from, int to) {
  std::vector<float> out(std::size_t(inner) * std::size_t(outer) * std::size_t(to - from));
  std::vector<Taps> taps;
  for (int texel = from; texel < to; ++texel) taps.push_back(tapsAt(placeOf(texel, finer)));
  parallelFor(0, outer * (to - from), [&](int job) {
    const Taps& t = taps[std::size_t(job % (to - from))];
    const float* block = values + std::size_t(job / (to - from)) * std::size_t(count) * std::size_t(inner);
    std::array<const float*, kTaps> rows;
    for (int n = 0; n < kTaps; ++n)
      rows[std::size_t(n)] = block + std::size_t(std::clamp(t.first + n, 0, whole - 1) - first) * std::size_t(inner);
    float* row = &out[std::size_t(job) * std::size_t(inner)];
    for (int i = 0; i < inner; ++i) {
      float sum = 0.0f;
      for (std::size_t n = 0; n < kTaps; ++n) sum += t.weights[n] * rows[n][i];
      row[i] = limited(sum, {rows[kReach - 2][i], rows[kReach - 1][i], rows[kReach][i], rows[kReach + 1][i]}, t.share);
    }
  });
  return out;
}

}  // namespace

glm::ivec3 smoothFactors(const Volume& volume) {
  constexpr double kMost = 8.0;
  glm::dvec3 spacing = spacingOf(volume);
  double finest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  glm::ivec3 finer(1);
  for (int axis = 0; axis < 3; ++axis)
    if (volume.dims[axis] > 1) finer[axis] = int(std::clamp(std::round(spacing[axis] / finest), 1.0, kMost));
  if (finer == glm::ivec3(1)) finer = glm::min(volume.dims, glm::ivec3(2));
  return finer;
}

std::vector<float> smoothPlanes(const VolumeTexels& source, glm::ivec3 finer, int z0, int z1) {
  glm::ivec3 dims = source.dims, fine = dims * finer;
  // The voxels that count, with what lies beyond the border as its own.
  int low = std::clamp(int(std::floor(placeOf(z0, finer.z))) - kReach + 1, 0, dims.z - 1);
  int high = std::clamp(int(std::floor(placeOf(z1 - 1, finer.z))) + kReach + 1, low + 1, dims.z);
  int planes = high - low;
  std::vector<float> scratch, along;
  const float* values = source.planes<float>(low, high, scratch);
  if (finer.x > 1) {
    along = smoothAlong(values, 1, dims.y * planes, 0, dims.x, dims.x, finer.x, 0, fine.x);
    values = along.data();
  }
  if (finer.y > 1) {
    along = smoothAlong(values, fine.x, planes, 0, dims.y, dims.y, finer.y, 0, fine.y);
    values = along.data();
  }
  return smoothAlong(values, fine.x * fine.y, 1, low, planes, dims.z, finer.z, z0, z1);
}

}  // namespace velum::render
