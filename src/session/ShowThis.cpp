#include "velum/session/ShowThis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace velum::session {

namespace {

using Curve = std::vector<scene::OpacityPoint>;

constexpr double kShoulder = 1.5, kFoot = 3.0;  // of the bump, spreads from its middle: 87 % and all of normal noise
constexpr double kOpacity = 0.6;                // a unit of material: solid, with soft edges
constexpr double kDark = 0.3;                   // luminance below which a colour is lost in shadows
constexpr double kTolerance = 4e-4;             // of a simplified curve: a tenth of the faintest veil in a preset

/// The value as the transfer function sees it: of colour volumes, the brightness.
double shownValue(const Volume& volume, glm::ivec3 voxel, int channel, int frame) {
  if (!volume.isColor) return valueAt(volume, voxel, channel, frame);
  double scale = volume.range.y > 255 ? 255.0 / volume.range.y : 1.0;
  glm::dvec3 rgb;
  for (int c = 0; c < 3; ++c) rgb[c] = std::clamp(valueAt(volume, voxel, c, frame) * scale, 0.0, 255.0);
  return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double median(std::vector<double> values) {
  auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// 1 on the shoulders, 0 from the feet on.
double bumpAt(const Tissue& tissue, double value) {
  double away = std::abs(value - tissue.value) / tissue.spread;
  return std::clamp((kFoot - away) / (kFoot - kShoulder), 0.0, 1.0);
}

/// Keeps what a polyline needs to stay within the tolerance (Douglas and Peucker, by height).
void simplify(const Curve& in, std::size_t first, std::size_t last, Curve& out) {
  double largest = 0;
  std::size_t at = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    double width = in[last].value - in[first].value;
    double t = width > 0 ? (in[i].value - in[first].value) / width : 0.5;
    double error = std::abs(in[i].opacity - glm::mix(in[first].opacity, in[last].opacity, t));
    if (error > largest) largest = error, at = i;
  }
  if (largest > kTolerance) {
    simplify(in, first, at, out);
    simplify(in, at, last, out);
  } else {
    out.push_back(in[last]);
  }
}

/// The curve that has the opacities `opacityOf(value)`, which bends where the old one does, at the bump's corners, and
/// anywhere between.
Curve remade(const Curve& old, const Tissue& tissue, const std::function<double(double)>& opacityOf) {
  std::vector<double> values;
  for (double corner : {-kFoot, -kShoulder, kShoulder, kFoot}) values.push_back(tissue.value + corner * tissue.spread);
  for (const auto& point : old) {
    values.push_back(std::nextafter(point.value, -1e300));  // the foot of a step
    values.push_back(point.value);
  }
  auto [low, high] = std::minmax_element(values.begin(), values.end());
  double start = *low, width = *high - *low;
  constexpr int kSteps = 512;
  for (int i = 1; i < kSteps; ++i) values.push_back(start + width * i / kSteps);
  std::sort(values.begin(), values.end());
  Curve dense, curve;
  for (double value : values) dense.push_back({value, opacityOf(value)});
  curve.push_back(dense.front());
  simplify(dense, 0, dense.size() - 1, curve);
  return curve;
}

/// Gives the values of a tissue a tone that is not lost in shadows, where they have none.
void brighten(std::vector<scene::ColorPoint>& colors, const Tissue& tissue) {
  glm::vec3 color(scene::colorAt(colors, tissue.value));
  float luminance = glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
  if (luminance >= kDark) return;
  const glm::vec3 kFlesh(0.85f, 0.62f, 0.48f);
  color = luminance < 0.03f ? kFlesh : glm::min(glm::mix(color * (0.5f / luminance), kFlesh, 0.25f), glm::vec3(1.0f));
  double foot = kFoot * tissue.spread, shoulder = kShoulder * tissue.spread;
  scene::ColorPoint before{tissue.value - foot, glm::vec3(scene::colorAt(colors, tissue.value - foot))};
  scene::ColorPoint after{tissue.value + foot, glm::vec3(scene::colorAt(colors, tissue.value + foot))};
  std::erase_if(colors, [&](const scene::ColorPoint& p) { return std::abs(p.value - tissue.value) <= foot; });
  for (const auto& stop : {before, scene::ColorPoint{tissue.value - shoulder, color},
                           scene::ColorPoint{tissue.value + shoulder, color}, after})
    colors.push_back(stop);
  std::stable_sort(colors.begin(), colors.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
}

}  // namespace

std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 worldMm) {
  if (!layer.data) return std::nullopt;
  const Volume& volume = *layer.data;
  glm::dvec3 place(glm::inverse(volume.worldFromVoxel) * glm::dvec4(worldMm, 1.0));
  glm::ivec3 last = volume.dims - 1;
  if (glm::any(glm::lessThan(place, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(place, glm::dvec3(last) + 0.5)))
    return std::nullopt;
  int channel = std::clamp(layer.channel, 0, volume.channels - 1);
  int frame = std::clamp(layer.frame, 0, volume.frames - 1);
  glm::ivec3 middle = glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), last);
  auto at = [&](glm::ivec3 p) { return shownValue(volume, glm::clamp(p, glm::ivec3(0), last), channel, frame); };
  std::vector<std::pair<double, double>> voxels;  // gradient, value
  for (int i = 0; i < 125; ++i) {
    glm::ivec3 p = middle + glm::ivec3(i % 5, i / 5 % 5, i / 25) - 2;
    if (glm::any(glm::lessThan(p, glm::ivec3(0))) || glm::any(glm::greaterThan(p, last))) continue;
    double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 step(0);
      step[axis] = 1;
      double difference = at(p + step) - at(p - step);
      square += difference * difference;
    }
    double value = at(p);
    if (std::isfinite(value) && std::isfinite(square)) voxels.push_back({square, value});
  }
  if (voxels.empty()) return std::nullopt;
  std::stable_sort(voxels.begin(), voxels.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<double> values, distances;
  for (std::size_t i = 0; i < (voxels.size() + 1) / 2; ++i) values.push_back(voxels[i].second);
  Tissue tissue{median(values), 0};
  for (double value : values) distances.push_back(std::abs(value - tissue.value));
  tissue.spread = std::max(1.4826 * median(distances), (volume.range.y - volume.range.x) / 400.0);
  if (!(tissue.spread > 0)) tissue.spread = 1.0;
  return tissue;
}

std::optional<Tissue> showThis(scene::Scene& scene, glm::dvec3 worldMm, bool add) {
  auto tissue = measureTissue(scene.volume, worldMm);
  if (!tissue) return tissue;
  scene::TransferFunction& transfer = scene::currentTransfer(scene.volume);
  double veil = 1.0 - std::pow(0.65, transfer.unitDistanceMm / std::max(radiusMm(*scene.volume.data), 1e-9));
  Curve old = transfer.opacities;
  transfer.opacities = remade(old, *tissue, [&](double value) {
    double other = scene::opacityAt(old, value);
    if (!add) other = std::min(0.15 * other, veil);
    return std::max(other, kOpacity * bumpAt(*tissue, value));
  });
  brighten(transfer.colors, *tissue);
  scene.rayCast.mode = scene::RenderMode::Volume;
  return tissue;
}

std::optional<Tissue> hideThis(scene::Scene& scene, glm::dvec3 worldMm) {
  auto tissue = measureTissue(scene.volume, worldMm);
  if (!tissue) return tissue;
  scene::TransferFunction& transfer = scene::currentTransfer(scene.volume);
  Curve old = transfer.opacities;
  transfer.opacities =
      remade(old, *tissue, [&](double value) { return scene::opacityAt(old, value) * (1.0 - bumpAt(*tissue, value)); });
  return tissue;
}

}  // namespace velum::session
