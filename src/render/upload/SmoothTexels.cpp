#include "SmoothTexels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "GradientTexels.h"
#include "velum/core/Parallel.h"

namespace velum::render {

namespace {

/// Voxels on either side that a texel is made of: what is farther counts for less than a two hundredth.
constexpr int kReach = 5;
constexpr int kMostFiner = 8;
constexpr std::size_t kMostTaps = 32;

/// What a texel takes from a row of voxels, the first weight from voxel `first`.
struct Taps {
  int first = 0;
  std::vector<float> weights;
  float share = 0.0;  ///< Of splines: from the voxel before the place to the one after it.
};

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

/// The taps of texels from..to that lie `finer` to a voxel.
std::vector<Taps> splineTaps(int finer, int from, int to) {
  std::vector<Taps> taps;
  for (int texel = from; texel < to; ++texel) taps.push_back(splineTaps((texel + 0.5) / finer - 0.5));
  return taps;
}

/// A Gaussian around each of the voxels from..to.
std::vector<Taps> gaussianTaps(double sigma, int from, int to) {
  int reach = int(std::ceil(2.5 * sigma));
  std::vector<float> weights;
  float sum = 0.0f;
  for (int n = -reach; n <= reach; ++n) {
    weights.push_back(sigma > 0.0 ? float(std::exp(-0.5 * n * n / (sigma * sigma))) : 1.0f);
    sum += weights.back();
  }
  for (float& weight : weights) weight /= sum;
  std::vector<Taps> taps;
  for (int voxel = from; voxel < to; ++voxel) taps.push_back({voxel - reach, weights, 0.0f});
  return taps;
}

struct Span {
  int low = 0, high = 0;
};

/// The voxels that taps ask for, of so many that there are.
Span askedBy(const std::vector<Taps>& taps, int whole) {
  int low = std::clamp(taps.front().first, 0, whole - 1);
  return {low, std::clamp(taps.back().first + int(taps.back().weights.size()), low + 1, whole)};
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

/// A block of numbers, x fastest, of which the voxels along one axis become what the taps make of them.
/// @param inner, outer  how many numbers lie side by side, and how many times the axis is met
/// @param held          the voxels along the axis that the block has, of `whole` that there are; what lies beyond the
///                      border is as the border
/// @param isLimited     keep between neighbours beside edges
std::vector<float> resample(const float* numbers, std::size_t inner, int outer, Span held, int whole,
                            const std::vector<Taps>& taps, bool isLimited) {
  constexpr std::size_t kPiece = 16;  // numbers that are summed side by side
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
    std::size_t i = 0;
    for (; i + kPiece <= inner; i += kPiece) {
      std::array<float, kPiece> sums{};
      for (std::size_t n = 0; n < count; ++n)
        for (std::size_t k = 0; k < kPiece; ++k) sums[k] += t.weights[n] * rows[n][i + k];
      std::copy(sums.begin(), sums.end(), row + i);
    }
    for (; i < inner; ++i)
      for (std::size_t n = 0; n < count; ++n) row[i] += t.weights[n] * rows[n][i];
    if (!isLimited) return;
    for (i = 0; i < inner; ++i) {
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

/// Texels where there were voxels, of planes of which only those held are there.
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
  return resample(numbers, width * std::size_t(dims.y * finer.y) * each, 1, held, dims.z,
                  splineTaps(finer.z, z0, z1), isLimited);
}

/// Gaussian widths along each axis, voxels, that make a gradient wide where voxels are narrow.
glm::dvec3 wideningOf(const Volume& volume) {
  // Of the coarsest spacing. Wider ones show fewer stairs (0.6 of the angles at 0.6) and less of what lies in a slice.
  constexpr double kWidth = 0.4;
  glm::dvec3 spacing = spacingOf(volume), sigma(0.0);
  double coarsest = std::max(spacing.x, std::max(spacing.y, spacing.z));
  for (int axis = 0; axis < 3; ++axis) {
    double ratio = std::clamp(coarsest / spacing[axis], 1.0, double(kMostFiner));
    if (volume.dims[axis] > 1) sigma[axis] = kWidth * std::sqrt(ratio * ratio - 1.0);
  }
  return sigma;
}

}  // namespace

glm::ivec3 smoothFactors(const Volume& volume) {
  glm::dvec3 spacing = spacingOf(volume);
  double finest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  glm::ivec3 finer(1);
  for (int axis = 0; axis < 3; ++axis)
    if (volume.dims[axis] > 1)
      finer[axis] = int(std::clamp(std::round(spacing[axis] / finest), 1.0, double(kMostFiner)));
  if (finer == glm::ivec3(1)) finer = glm::min(volume.dims, glm::ivec3(2));
  return finer;
}

std::vector<float> smoothPlanes(const VolumeTexels& source, glm::ivec3 finer, int z0, int z1) {
  Span held = askedBy(splineTaps(finer.z, z0, z1), source.dims.z);
  std::vector<float> scratch;
  const float* values = source.planes<float>(held.low, held.high, scratch);
  return refine(values, 1, source.dims, held, finer, z0, z1, true);
}

std::vector<float> SmoothGradients::widePlanes(int low, int high) const {
  const VolumeTexels& source = *mSource;
  glm::ivec3 dims = source.dims;
  glm::dvec3 sigma = wideningOf(*source.volume);
  auto tapsZ = gaussianTaps(sigma.z, low, high);
  Span held = askedBy(tapsZ, dims.z);
  int first = std::max(0, held.low - 1), planes = held.high - held.low;
  std::vector<float> scratch;
  const float* values = source.planes<float>(first, std::min(dims.z, held.high + 1), scratch);
  auto narrow = takeDifferences(values, dims, first, held.low, held.high);
  auto planeSize = std::size_t(dims.x) * std::size_t(dims.y);
  auto row = std::size_t(dims.x) * 3;
  auto wide = resample(&narrow[0].x, 3, dims.y * planes, {0, dims.x}, dims.x, gaussianTaps(sigma.x, 0, dims.x), false);
  wide = resample(wide.data(), row, planes, {0, dims.y}, dims.y, gaussianTaps(sigma.y, 0, dims.y), false);
  wide = resample(wide.data(), row * std::size_t(dims.y), 1, held, dims.z, tapsZ, false);
  // As strong as it is there: what is modulated by its length keeps its look.
  std::size_t before = planeSize * std::size_t(low - held.low);
  parallelFor(0, dims.y * (high - low), [&](int job) {
    for (std::size_t i = std::size_t(job) * std::size_t(dims.x), end = i + std::size_t(dims.x); i < end; ++i) {
      glm::vec3 here = narrow[before + i], there = glm::make_vec3(&wide[i * 3]);
      float length = glm::length(there);
      if (length > 0.0f) here = there * (glm::length(here) / length);
      here /= glm::vec3(mFiner);
      std::copy_n(&here.x, 3, &wide[i * 3]);
    }
  });
  return wide;
}

std::vector<float> SmoothGradients::planes(int z0, int z1) {
  glm::ivec3 dims = mSource->dims;
  Span asked = askedBy(splineTaps(mFiner.z, z0, z1), dims.z);
  // Planes that the last call had come again.
  int kept = asked.low < mLow ? 0 : std::clamp(mHigh - asked.low, 0, mHigh - mLow);
  std::size_t plane = std::size_t(dims.x) * std::size_t(dims.y) * 3;
  mWide.erase(mWide.begin(), mWide.end() - std::ptrdiff_t(plane * std::size_t(kept)));
  mLow = asked.low;
  if (mLow + kept < asked.high) {
    auto more = widePlanes(mLow + kept, asked.high);
    mWide.insert(mWide.end(), more.begin(), more.end());
  }
  mHigh = mLow + int(mWide.size() / plane);
  return refine(mWide.data(), 3, dims, {mLow, mHigh}, mFiner, z0, z1, false);
}

}  // namespace velum::render
