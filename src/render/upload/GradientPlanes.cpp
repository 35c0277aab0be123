#include "render/upload/GradientPlanes.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "core/Parallel.h"
#include "render/upload/BlockGradients.h"
#include "render/upload/GradientTexels.h"
#include "render/upload/Resample.h"

namespace velum::render {

namespace {

std::size_t planeSizeOf(glm::ivec3 dims) { return std::size_t(dims.x) * std::size_t(dims.y) * 3; }

/// A direction from the wide gradient, as long as the narrow one.
glm::vec3 merged(glm::vec3 narrow, glm::vec3 wide) {
  const float kApart = std::cos(glm::radians(20.0f)), kTogether = std::cos(glm::radians(10.0f));
  float length = glm::length(narrow), wideLength = glm::length(wide);
  if (length == 0.0f || wideLength == 0.0f) return narrow;
  narrow /= length;
  wide /= wideLength;
  float share = glm::smoothstep(kApart, kTogether, glm::dot(narrow, wide));
  return glm::normalize(glm::mix(narrow, wide, share)) * length;
}

}  // namespace

glm::dvec3 gradientWidths(glm::dvec3 spacing, glm::ivec3 dims) {
  constexpr double kWidth = 1.0;    // of the finest spacing
  constexpr double kStretch = 0.4;  // of the coarsest one: wider shows fewer stairs and less of what lies in a slice
  // Of a turned grid the last digits differ: the same data has the same gradients however it lies.
  glm::dvec3 widths(0.0);
  double finest = std::min(spacing.x, std::min(spacing.y, spacing.z));
  double coarsest = std::max(spacing.x, std::max(spacing.y, spacing.z));
  for (int axis = 0; axis < 3; ++axis) {
    double ratio = std::clamp(coarsest / spacing[axis], 1.0, 8.0);
    double stretch = kStretch * std::sqrt(ratio * ratio - 1.0);
    if (dims[axis] > 1) widths[axis] = std::round(1e4 * std::hypot(kWidth * finest / spacing[axis], stretch)) / 1e4;
  }
  return widths;
}

glm::ivec3 gradientReach(glm::dvec3 spacing, glm::ivec3 dims) {
  glm::dvec3 widths = gradientWidths(spacing, dims);
  glm::ivec3 reach;
  // The Gaussian's, a voxel for the differences and one for their neighbours' lengths.
  for (int axis = 0; axis < 3; ++axis) reach[axis] = int(gaussianTaps(widths[axis], 0, 1)[0].weights.size()) / 2 + 2;
  return reach;
}

template <class Make>
const float* SlidingPlanes::slide(int askedLow, int askedHigh, std::size_t planeSize, const Make& make) {
  int high = low + int(numbers.size() / planeSize);
  int kept = askedLow < low ? 0 : std::max(0, high - askedLow);
  numbers.erase(numbers.begin(), numbers.end() - std::ptrdiff_t(planeSize * std::size_t(kept)));
  low = askedLow;
  if (low + kept < askedHigh) {
    std::vector<float> more = make(low + kept, askedHigh);
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  return numbers.data();
}

std::vector<float> GradientPlanes::narrowPlanes(int low, int high) const {
  glm::ivec3 dims = mSource->dims;
  int first = std::max(0, low - 1);
  std::vector<float> scratch;
  const float* values = mSource->planes<float>(first, std::min(dims.z, high + 1), scratch);
  return takeDifferences(values, dims, first, low, high);
}

std::vector<float> GradientPlanes::widePlanes(int low, int high) {
  glm::ivec3 dims = mSource->dims;
  glm::dvec3 widths = gradientWidths(spacingOf(*mSource->volume), dims);
  std::size_t planeSize = planeSizeOf(dims);
  auto tapsZ = gaussianTaps(widths.z, low, high);
  Span held = askedBy(tapsZ, dims.z);
  const float* narrow =
      mNarrow.slide(held.low, held.high, planeSize, [&](int first, int last) { return narrowPlanes(first, last); });
  const float* across = mAcross.slide(held.low, held.high, planeSize, [&](int first, int last) {
    int planes = last - first;
    auto rows = smoothRows(narrow + planeSize * std::size_t(first - held.low), 3, dims.x, dims.y * planes, widths.x);
    return resample(rows.data(), std::size_t(dims.x) * 3, planes, {0, dims.y}, dims.y,
                    gaussianTaps(widths.y, 0, dims.y));
  });
  auto wide = resample(across, planeSize, 1, held, dims.z, tapsZ);
  const float* here = narrow + planeSize * std::size_t(low - held.low);
  parallelFor(0, dims.y * (high - low), [&](int job) {
    for (std::size_t i = std::size_t(job) * std::size_t(dims.x), end = i + std::size_t(dims.x); i < end; ++i) {
      glm::vec3 gradient = merged(glm::make_vec3(here + i * 3), glm::make_vec3(&wide[i * 3])) / glm::vec3(mFiner);
      std::copy_n(&gradient.x, 3, &wide[i * 3]);
    }
  });
  return wide;
}

std::vector<float> GradientPlanes::planes(int z0, int z1) {
  glm::ivec3 dims = mSource->dims;
  Span asked = askedBy(splineTaps(mFiner.z, z0, z1), dims.z);
  const float* wide = mWide.slide(asked.low, asked.high, planeSizeOf(dims),
                                  [&](int first, int last) { return widePlanes(first, last); });
  return refine(wide, 3, dims, asked, mFiner, z0, z1);
}

PackedGradients planeGradients(const VolumeTexels& source, int z0, int z1, double longestGradient) {
  constexpr int kBlock = 64;  // texels along x and y
  glm::ivec3 dims = source.dims;
  glm::dvec3 spacing = spacingOf(*source.volume);
  glm::ivec3 reach = gradientReach(spacing, dims);
  int low = std::max(0, z0 - reach.z), high = std::min(dims.z, z1 + reach.z);
  std::vector<float> scratch;
  const float* planes = source.planes<float>(low, high, scratch);
  PackedGradients all(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(z1 - z0));
  int across = (dims.x + kBlock - 1) / kBlock, down = (dims.y + kBlock - 1) / kBlock;
  parallelFor(0, across * down, [&](int job) {
    glm::ivec3 first(job % across * kBlock, job / across * kBlock, z0);
    glm::ivec3 size = glm::min(glm::ivec3(dims.x, dims.y, z1), first + glm::ivec3(kBlock, kBlock, z1)) - first;
    glm::ivec3 from = glm::max(first - reach, glm::ivec3(0)), to = glm::min(first + size + reach, dims);
    glm::ivec3 held = to - from;
    thread_local std::vector<float> values;
    values.clear();
    for (int z = from.z; z < to.z; ++z)
      for (int y = from.y; y < to.y; ++y) {
        const float* row = planes + (std::size_t(z - low) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x);
        values.insert(values.end(), row + from.x, row + to.x);
      }
    PackedGradients block = blockGradients(values, held, spacing, {first - from, size}, longestGradient);
    auto* texels = block.data();
    for (int z = first.z; z < first.z + size.z; ++z)
      for (int y = first.y; y < first.y + size.y; ++y, texels += size.x)
        std::copy_n(texels, size.x,
                    &all[(std::size_t(z - z0) * std::size_t(dims.y) + std::size_t(y)) * std::size_t(dims.x) +
                         std::size_t(first.x)]);
  });
  return all;
}

}  // namespace velum::render
