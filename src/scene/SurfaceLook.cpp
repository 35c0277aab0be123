#include "scene/SurfaceLook.h"

#include <algorithm>

#include "scene/Scene.h"

namespace velum::scene {

namespace {

constexpr double kLeastOpacity = 1.0 / 255.0;  ///< That anybody sees, of a unit of distance.
constexpr double kSolid = 0.25;                ///< From there on material counts as what one looks at.
constexpr double kMostVeils = 0.5;             ///< Share of what shows that may be less.
constexpr double kFoot = 0.6;                  ///< Where a surface begins, as a share of where it is opaque.
constexpr double kOpaque = 0.98;

/// Points of a curve with those put in at which it has an opacity.
std::vector<OpacityPoint> withPointsAt(const std::vector<OpacityPoint>& points, double opacity) {
  std::vector<OpacityPoint> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OpacityPoint* before = i > 0 ? &points[i - 1] : nullptr;
    if (before && (before->opacity - opacity) * (points[i].opacity - opacity) < 0.0) {
      double share = (opacity - before->opacity) / (points[i].opacity - before->opacity);
      out.push_back({before->value + share * (points[i].value - before->value), opacity});
    }
    out.push_back(points[i]);
  }
  return out;
}

void makeSurface(TransferFunction& transfer, double voxel) {
  double most = 0.0;
  for (const OpacityPoint& point : transfer.opacities) most = std::max(most, point.opacity);
  if (!(most > 0.0)) return;
  // What is nearly opaque, or of a haze the denser half.
  double opaque = std::min(kSolid, 0.5 * most), foot = kFoot * opaque;
  transfer.opacities = withPointsAt(withPointsAt(transfer.opacities, foot), opaque);
  for (OpacityPoint& point : transfer.opacities)
    point.opacity = kOpaque * std::clamp((point.opacity - foot) / (opaque - foot), 0.0, 1.0);
  transfer.unitDistance = std::min(transfer.unitDistance, voxel);
}

}  // namespace

bool isTranslucent(const TransferFunction& transfer, const Histogram& histogram) {
  double width = (histogram.range.y - histogram.range.x) / double(std::max<std::size_t>(histogram.counts.size(), 1));
  double shown = 0.0, veils = 0.0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    double opacity = opacityAt(transfer.opacities, histogram.range.x + (double(i) + 0.5) * width);
    if (opacity < kLeastOpacity) continue;
    shown += double(histogram.counts[i]);
    if (opacity < kSolid) veils += double(histogram.counts[i]);
  }
  return veils > kMostVeils * shown;
}

void makeSurface(Scene& scene) {
  if (!scene.volume.data) return;
  glm::dvec3 spacing = spacingOf(*scene.volume.data);
  double voxel = (spacing.x + spacing.y + spacing.z) / 3.0;
  if (!mixesChannels(scene.volume)) return makeSurface(currentTransfer(scene.volume), voxel);
  for (ChannelLook& look : scene.volume.channels) makeSurface(look.transfer, voxel);
}

}  // namespace velum::scene
