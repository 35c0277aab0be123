#include "core/Volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/Assert.h"
#include "core/BrickCache.h"
#include "core/ChannelHistogram.h"
#include "core/Parallel.h"

namespace velum {

namespace {

struct MinMax {
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
};

MinMax merge(const MinMax& a, const MinMax& b) { return {std::min(a.min, b.min), std::max(a.max, b.max)}; }

/// Smallest and largest finite sample. Written so that the compiler vectorises it: a NaN fails both comparisons, and an
/// infinity is masked by the finite limits.
template <class T>
MinMax minMaxOf(const T* begin, const T* end) {
  using Limits = std::numeric_limits<T>;
  T low = Limits::max();
  T high = Limits::lowest();
  for (const T* p = begin; p != end; ++p) {
    T value = *p;
    if constexpr (std::is_floating_point_v<T>) {
      bool finite = value >= Limits::lowest() && value <= Limits::max();
      low = finite && value < low ? value : low;
      high = finite && value > high ? value : high;
    } else {
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
  }
  if (low > high) return {};
  return {double(low), double(high)};
}

}  // namespace

std::size_t sampleSize(SampleType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<int>(type)];
}

std::size_t voxelCount(const Volume& volume) {
  return std::size_t(volume.dims.x) * std::size_t(volume.dims.y) * std::size_t(volume.dims.z);
}

std::size_t timeStepBytes(const Volume& volume) {
  return voxelCount(volume) * std::size_t(volume.channels) * sampleSize(volume.type);
}

glm::dvec3 spacingOf(const Volume& volume) {
  const auto& m = volume.worldFromVoxel;
  return {glm::length(glm::dvec3(m[0])), glm::length(glm::dvec3(m[1])), glm::length(glm::dvec3(m[2]))};
}

glm::dmat3 direction(const Volume& volume) {
  const auto& m = volume.worldFromVoxel;
  return {glm::normalize(glm::dvec3(m[0])), glm::normalize(glm::dvec3(m[1])), glm::normalize(glm::dvec3(m[2]))};
}

glm::dmat4 worldFromVoxelIn(LengthUnit unit, const Volume& volume) {
  glm::dmat4 m = volume.worldFromVoxel;
  double factor = unitsPer(volume.lengthUnit, unit);
  for (int column = 0; column < 4; ++column) m[column] = glm::dvec4(glm::dvec3(m[column]) * factor, m[column].w);
  return m;
}

void setLengthUnit(Volume& volume, LengthUnit unit) {
  volume.worldFromVoxel = worldFromVoxelIn(unit, volume);
  volume.lengthUnit = unit;
}

double valueAt(const Volume& volume, glm::ivec3 voxel, int channel, int timeStep) {
  VELUM_ASSERT(glm::all(glm::lessThan(glm::uvec3(voxel), glm::uvec3(volume.dims))), "the voxel lies in the volume");
  VELUM_ASSERT(channel >= 0 && channel < volume.channels && timeStep >= 0 && timeStep < volume.timeSteps,
               "channel and time step exist");
  std::size_t index =
      (std::size_t(voxel.z) * std::size_t(volume.dims.y) + std::size_t(voxel.y)) * std::size_t(volume.dims.x) +
      std::size_t(voxel.x);
  index = (index + std::size_t(timeStep) * voxelCount(volume)) * std::size_t(volume.channels) + std::size_t(channel);
  return visitSamples(volume, [&](auto* p) { return double(p[index]) * volume.scale + volume.offset; });
}

namespace {

/// Values of raw samples; {0, 0} where nothing finite is.
glm::dvec2 rangeOf(MinMax raw, const Volume& volume) {
  if (raw.min > raw.max) return {0.0, 0.0};
  double a = raw.min * volume.scale + volume.offset, b = raw.max * volume.scale + volume.offset;
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

void computeRange(Volume& volume) {
  VELUM_ASSERT(volume.voxels.size() == timeStepBytes(volume) * std::size_t(volume.timeSteps), "every sample is there");
  std::size_t count = voxelCount(volume) * std::size_t(volume.channels) * std::size_t(volume.timeSteps);
  MinMax raw = visitSamples(volume, [&](auto* p) {
    return parallelReduce(
        std::size_t(0), count, std::size_t(1) << 18, MinMax{},
        [p](std::size_t first, std::size_t end) { return minMaxOf(p + first, p + end); }, merge);
  });
  volume.range = rangeOf(raw, volume);
}

namespace {

/// Of the first time step.
glm::dvec2 rangeOfChannel(const Volume& volume, int channel) {
  VELUM_ASSERT(channel >= 0 && channel < volume.channels, "the channel exists");
  if (volume.channels == 1) return volume.range;
  auto stride = std::size_t(volume.channels), offset = std::size_t(channel);
  MinMax raw = visitSamples(volume, [&](auto* p) {
    return parallelReduce(
        std::size_t(0), voxelCount(volume), std::size_t(1) << 18, MinMax{},
        [=](std::size_t first, std::size_t end) {
          MinMax found;
          for (std::size_t i = first; i < end; ++i)
            if (auto value = double(p[i * stride + offset]); std::isfinite(value)) found = merge(found, {value, value});
          return found;
        },
        merge);
  });
  return rangeOf(raw, volume);
}

Histogram histogramOver(const Volume& volume, glm::dvec2 range, int bins, int channel, int timeStep) {
  VELUM_ASSERT(bins > 0, "there are bins");
  VELUM_ASSERT(channel >= 0 && channel < volume.channels && timeStep >= 0 && timeStep < volume.timeSteps,
               "channel and time step exist");
  Histogram histogram{std::vector<std::uint64_t>(std::size_t(bins)), range};
  double width = range.y - range.x;
  if (!(width > 0)) return histogram;
  double factor = bins / width * volume.scale;
  double base = (volume.offset - range.x) * bins / width;
  std::size_t count = voxelCount(volume);
  std::size_t stride = std::size_t(volume.channels);
  std::size_t first = std::size_t(timeStep) * count * stride + std::size_t(channel);
  // A hundred million voxels say no more about the shape of a histogram than every few of them; the odd step keeps
  // rows from being met at the same column.
  std::size_t skip = std::max<std::size_t>(1, count / 16'000'000) | 1;
  visitSamples(volume, [&](auto* p) {
    using T = std::remove_cvref_t<decltype(*p)>;
    for (std::size_t i = 0; i < count; i += skip) {
      T raw = p[first + i * stride];
      if constexpr (std::is_floating_point_v<T>) {
        if (!std::isfinite(raw)) continue;
      }
      int bin = std::clamp(int(double(raw) * factor + base), 0, bins - 1);
      ++histogram.counts[std::size_t(bin)];
    }
  });
  return histogram;
}

}  // namespace

Histogram computeHistogram(const Volume& volume, int bins, int channel, int timeStep) {
  return histogramOver(volume, volume.range, bins, channel, timeStep);
}

Histogram computeChannelHistogram(const Volume& volume, int channel, int bins) {
  return histogramOver(volume, rangeOfChannel(volume, channel), bins, channel, 0);
}

double quantile(const Histogram& histogram, double fraction) {
  VELUM_ASSERT(fraction >= 0.0 && fraction <= 1.0, "a fraction is from 0 to 1");
  std::uint64_t total = 0;
  for (auto c : histogram.counts) total += c;
  double wanted = fraction * double(total);
  std::uint64_t below = 0;
  double binWidth = (histogram.range.y - histogram.range.x) / double(std::max<std::size_t>(1, histogram.counts.size()));
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    below += histogram.counts[i];
    if (double(below) >= wanted) return histogram.range.x + binWidth * (double(i) + 0.5);
  }
  return histogram.range.y;
}

glm::dmat4 worldFromBox(const Volume& volume) {
  if (!volume.finer) return worldFromBox(volume.dims, volume.worldFromVoxel);
  return worldFromBox(volume.finer->bricks->source().levels().front().dims, worldFromLevel(volume, 0));
}

glm::dmat4 worldFromBox(glm::ivec3 dims, const glm::dmat4& worldFromVoxel) {
  glm::dmat4 voxelFromBox(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    voxelFromBox[axis][axis] = dims[axis];
    voxelFromBox[3][axis] = -0.5;
  }
  return worldFromVoxel * voxelFromBox;
}

glm::dvec3 centreOf(const Volume& volume) { return worldFromBox(volume) * glm::dvec4(glm::dvec3(0.5), 1.0); }

double radiusOf(const Volume& volume) {
  double radius = 0;
  glm::dmat3 m(worldFromBox(volume));
  for (int corner = 0; corner < 4; ++corner) {
    glm::dvec3 sign(1.0, corner & 1 ? -1.0 : 1.0, corner & 2 ? -1.0 : 1.0);
    radius = std::max(radius, glm::length(m * (sign * 0.5)));
  }
  return radius;
}

}  // namespace velum
