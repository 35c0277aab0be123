#include "velum/session/extrusion/MaterialRange.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "velum/session/look/ShowThis.h"

namespace velum::session {

namespace {

/// Less opaque than this is hidden; a curve that falls to this share of a hump's height, and rises again, has a valley.
constexpr double kHidden = 0.005, kValley = 0.5;
/// Of the noise to either side of a material's middle.
constexpr double kSpreads = 3.0;
/// Share of the data beyond which there is nothing else worth telling apart.
constexpr double kEnd = 0.1;

/// From a value on, point by point, until the curve is hidden or rises again out of a valley; that place.
double endOfSegment(const std::vector<scene::OpacityPoint>& curve, double value, double limit) {
  bool up = limit > value;
  std::vector<scene::OpacityPoint> way{{value, scene::opacityAt(curve, value)}};
  for (const auto& point : curve)
    if (up ? point.value > value && point.value < limit : point.value < value && point.value > limit)
      way.push_back(point);
  if (!up) std::reverse(way.begin() + 1, way.end());
  way.push_back({limit, scene::opacityAt(curve, limit)});
  double highest = way[0].opacity;
  scene::OpacityPoint lowest = way[0];
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto &before = way[i - 1], &point = way[i];
    if (point.opacity < kHidden) {
      double t = before.opacity > point.opacity ? (before.opacity - kHidden) / (before.opacity - point.opacity) : 1.0;
      return std::lerp(before.value, point.value, std::clamp(t, 0.0, 1.0));
    }
    bool isValley = lowest.opacity < kValley * highest;
    if (isValley && point.opacity > lowest.opacity / kValley) return lowest.value;
    if (point.opacity <= lowest.opacity) lowest = point;
    if (point.opacity > highest) highest = point.opacity, lowest = point;
  }
  return limit;
}

}  // namespace

std::optional<MaterialRange> segmentOf(const scene::TransferFunction& transfer, double value, glm::dvec2 range) {
  if (scene::opacityAt(transfer.opacities, value) < kHidden) return std::nullopt;
  return MaterialRange{endOfSegment(transfer.opacities, value, std::min(range.x, value)),
                       endOfSegment(transfer.opacities, value, std::max(range.y, value))};
}

std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world) {
  HistogramMemo histograms;
  return materialRangeAt(layer, world, histograms);
}

std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world,
                                             HistogramMemo& histograms) {
  std::optional<Tissue> tissue = measureTissue(layer, world, histograms);
  if (!tissue) return std::nullopt;
  const Volume& volume = *layer.data;
  const Histogram& histogram = histograms.of(layer);
  double value = tissue->value;
  auto segment = segmentOf(scene::currentTransfer(layer), value, volume.range);
  if (!segment) {
    // Beside borders the middle of what was measured may be hidden though the place itself is seen.
    segment = segmentOf(scene::currentTransfer(layer), tissue->here, volume.range);
    if (segment) value = tissue->here;
  }
  bool isBrightest = value > quantile(histogram, 1.0 - kEnd), isDarkest = value < quantile(histogram, kEnd);
  double around = kSpreads * tissue->spread;
  MaterialRange material{tissue->low.value_or(isDarkest ? volume.range.x : value - around),
                         tissue->high.value_or(isBrightest ? volume.range.y : value + around)};
  if (!segment) return material;
  // What the curve tells apart is told apart; within its segment a material beside is left out.
  MaterialRange out = *segment;
  if (!isDarkest && tissue->low) out.low = std::max(out.low, *tissue->low);
  if (!isBrightest && tissue->high) out.high = std::min(out.high, *tissue->high);
  return out.low <= value && value <= out.high ? out : material;
}

}  // namespace velum::session
