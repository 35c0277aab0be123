#include "session/look/ValueHistogram.h"

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

constexpr int kBins = 4096;

bool isWhole(SampleType type) { return type != SampleType::Float32 && type != SampleType::Float64; }

/// Central difference along the three axes, value per; one-sided at the border.
double gradientLength(const Volume& volume, const glm::dmat3& worldFromStep, glm::ivec3 p, int channel, int timeStep) {
  glm::dvec3 difference(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 a = p, b = p;
    a[axis] = std::max(0, p[axis] - 1);
    b[axis] = std::min(volume.dims[axis] - 1, p[axis] + 1);
    if (a != b)
      difference[axis] =
          (valueAt(volume, b, channel, timeStep) - valueAt(volume, a, channel, timeStep)) / double(b[axis] - a[axis]);
  }
  return glm::length(worldFromStep * difference);
}

}  // namespace

Histogram valueHistogram(const Volume& volume, int channel, int timeStep) {
  int bins = kBins;
  double steps = (volume.range.y - volume.range.x) / std::max(std::abs(volume.scale), 1e-300) + 1.0;
  if (isWhole(volume.type) && steps < kBins) bins = std::max(2, int(steps + 0.5));
  return computeHistogram(volume, bins, channel, timeStep);
}

const Histogram& HistogramMemo::of(const scene::VolumeLayer& layer) {
  const Volume& volume = *layer.data;
  Key key{layer.data.id(), scene::shownChannel(layer), scene::shownTimeStep(layer)};
  if (!(key == mKey)) mHistogram = valueHistogram(volume, key.channel, key.timeStep);
  mKey = key;
  return mHistogram;
}

Histogram gradientHistogram(const Volume& volume, int channel, int timeStep) {
  constexpr double kMostSamples = 1e6;
  int step = std::max(1, int(std::cbrt(double(voxelCount(volume)) / kMostSamples)));
  glm::dmat3 worldFromStep = glm::transpose(glm::inverse(glm::dmat3(volume.worldFromVoxel)));
  std::vector<double> lengths;
  for (int z = step / 2; z < volume.dims.z; z += step)
    for (int y = step / 2; y < volume.dims.y; y += step)
      for (int x = step / 2; x < volume.dims.x; x += step) {
        double length = gradientLength(volume, worldFromStep, {x, y, z}, channel, timeStep);
        if (std::isfinite(length)) lengths.push_back(length);
      }
  Histogram histogram{std::vector<std::uint64_t>(256), {0.0, 1.0}};
  if (lengths.empty()) return histogram;
  auto high = lengths.begin() + std::ptrdiff_t(double(lengths.size() - 1) * 0.999);
  std::nth_element(lengths.begin(), high, lengths.end());
  histogram.range.y = *high > 0 ? *high : 1.0;
  for (double length : lengths) {
    if (length > histogram.range.y) continue;
    auto bin = std::size_t(length / histogram.range.y * 256.0);
    ++histogram.counts[std::min<std::size_t>(bin, 255)];
  }
  return histogram;
}

AxisView defaultView(const Histogram& histogram, const scene::TransferFunction& transfer) {
  if (!(histogram.range.y > histogram.range.x)) return {histogram.range.x, histogram.range.x + 1.0};
  double low = quantile(histogram, 0.0005), high = quantile(histogram, 0.9995);
  auto include = [&](double value) {
    if (value < histogram.range.x || value > histogram.range.y) return;
    low = std::min(low, value), high = std::max(high, value);
  };
  for (const auto& point : transfer.opacities) include(point.value);
  double margin = std::max(0.02 * (high - low), 1e-9 * (histogram.range.y - histogram.range.x));
  AxisView view{std::max(histogram.range.x, low - margin), std::min(histogram.range.y, high + margin)};
  return view.high > view.low ? view : AxisView{histogram.range.x, histogram.range.y};
}

std::vector<double> histogramHeights(const Histogram& histogram, AxisView view, int columns, bool logarithmic) {
  std::vector<double> heights(std::size_t(std::max(columns, 0)), 0.0);
  double binWidth = (histogram.range.y - histogram.range.x) / double(std::max<std::size_t>(1, histogram.counts.size()));
  if (!(binWidth > 0) || heights.empty()) return heights;
  int last = int(histogram.counts.size()) - 1;
  double perColumn = (view.high - view.low) / columns / binWidth;
  for (int i = 0; i < columns; ++i) {
    double from = (view.low - histogram.range.x) / binWidth + i * perColumn, to = from + perColumn;
    int a = int(std::floor(from)), b = std::max(a, int(std::ceil(to)) - 1);
    double sum = 0;
    for (int bin = std::max(a, 0); bin <= std::min(b, last); ++bin) sum += double(histogram.counts[std::size_t(bin)]);
    heights[std::size_t(i)] = sum / double(b - a + 1);
    if (logarithmic) heights[std::size_t(i)] = std::log1p(heights[std::size_t(i)]);
  }
  // Linear heights are measured by what nine tenths of the occupied columns stay below, three times that.
  std::vector<double> occupied;
  for (double height : heights)
    if (height > 0) occupied.push_back(height);
  if (occupied.empty()) return heights;
  std::sort(occupied.begin(), occupied.end());
  double full = occupied.back();
  if (!logarithmic) full = std::min(full, 3.0 * occupied[(occupied.size() - 1) * 9 / 10]);
  for (double& height : heights) height = std::min(1.0, height / full);
  return heights;
}

}  // namespace velum::session
