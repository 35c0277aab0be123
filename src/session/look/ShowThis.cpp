#include "session/look/ShowThis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "scene/Scene.h"
#include "scene/Shown.h"

namespace velum::session {

namespace {

using Curve = std::vector<scene::OpacityPoint>;

constexpr double kShoulder = 1.5, kFoot = 3.0;  // of the bump, spreads from its middle: 87 % and all of normal noise
constexpr double kOpacity = 0.6;                // a unit of material: solid, with soft edges
constexpr double kDark = 0.3;                   // luminance below which a colour is lost in shadows
constexpr int kNear = 2, kWide = 6;             // voxels around the place: what is meant, and more of the same
constexpr int kBesideVoxels = 8;                // voxels within which another material is beside the place
constexpr double kOther = 0.12;                 // of the data's range: by so much other materials differ
constexpr int kFewest = 4;                      // of 26 directions: fewer are noise
constexpr double kTolerance = 4e-4;             // of a simplified curve: a tenth of the faintest veil in a preset

/// The value as the transfer function sees it: of colour volumes, the brightness.
double shownValue(const Volume& volume, glm::ivec3 voxel, int channel, int timeStep) {
  if (!volume.isColor) return valueAt(volume, voxel, channel, timeStep);
  double scale = volume.range.y > 255 ? 255.0 / volume.range.y : 1.0;
  glm::dvec3 rgb;
  for (int c = 0; c < 3; ++c) rgb[c] = std::clamp(valueAt(volume, voxel, c, timeStep) * scale, 0.0, 255.0);
  return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

struct Sample {
  double steepness, value;  ///< square of the gradient, any unit
};

/// The voxels with finite values within `radius` of the voxel in the middle.
std::vector<Sample> voxelsAround(const scene::VolumeLayer& layer, glm::ivec3 middle, int radius) {
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer);
  int timeStep = scene::shownTimeStep(layer);
  glm::ivec3 last = volume.dims - 1;
  auto at = [&](glm::ivec3 p) { return shownValue(volume, glm::clamp(p, glm::ivec3(0), last), channel, timeStep); };
  glm::ivec3 first = glm::max(middle - radius, glm::ivec3(0)), end = glm::min(middle + radius, last);
  std::vector<Sample> samples;
  for (glm::ivec3 p = first; p.z <= end.z; ++p.z)
    for (p.y = first.y; p.y <= end.y; ++p.y)
      for (p.x = first.x; p.x <= end.x; ++p.x) {
        Sample sample{0.0, at(p)};
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 step(0);
          step[axis] = 1;
          double difference = at(p + step) - at(p - step);
          sample.steepness += difference * difference;
        }
        if (std::isfinite(sample.value) && std::isfinite(sample.steepness)) samples.push_back(sample);
      }
  return samples;
}

/// The values of the half with the smaller gradients.
std::vector<double> evenHalf(std::vector<Sample> samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.steepness < b.steepness; });
  std::vector<double> values;
  for (std::size_t i = 0; i < (samples.size() + 1) / 2; ++i) values.push_back(samples[i].value);
  return values;
}

/// Middle and spread of the shortest stretch that holds half of the values and lies at the wanted value: of two
/// materials, those of the material that was pointed at.
Tissue tissueOf(std::vector<double> values, double wanted) {
  std::sort(values.begin(), values.end());
  std::size_t half = values.size() / 2, best = 0;
  auto length = [&](std::size_t i) { return values[i + half] - values[i]; };
  auto cost = [&](std::size_t i) {
    return length(i) + 2.0 * std::max({0.0, values[i] - wanted, wanted - values[i + half]});
  };
  for (std::size_t i = 0; i + half < values.size(); ++i)
    if (cost(i) < cost(best)) best = i;
  // Half of a normal distribution lies within 0.6745 standard deviations of its middle.
  return {values[best + half / 2], length(best) / (2.0 * 0.6745)};
}

/// Values along a line of voxels from a place, without the place itself.
std::vector<double> valuesAlong(const scene::VolumeLayer& layer, glm::ivec3 from, glm::dvec3 direction) {
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer);
  int timeStep = scene::shownTimeStep(layer);
  std::vector<double> values;
  for (int i = 1; i <= kBesideVoxels; ++i) {
    glm::ivec3 at(glm::floor(glm::dvec3(from) + direction * double(i) + 0.5));
    if (glm::any(glm::lessThan(at, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(at, volume.dims))) break;
    double value = shownValue(volume, at, channel, timeStep);
    if (!std::isfinite(value)) break;
    values.push_back(value);
  }
  return values;
}

/// The share of a list's values from the smallest on; nothing of a list that is too short to mean anything.
std::optional<double> shareOf(std::vector<double> values, double share) {
  if (int(values.size()) < kFewest) return std::nullopt;
  std::sort(values.begin(), values.end());
  return values[std::size_t(share * double(values.size() - 1))];
}

/// Goes out in 26 directions to the first other material, and takes the middle between its value and the place's: of
/// several materials on one side, the one that is nearer in value.
void findBorders(const scene::VolumeLayer& layer, glm::ivec3 place, double here, double range, Tissue& tissue) {
  std::vector<double> darker, brighter;
  for (int i = 0; i < 27; ++i) {
    glm::dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 13) continue;
    std::vector<double> values = valuesAlong(layer, place, glm::normalize(way));
    auto other = std::find_if(values.begin(), values.end(),
                              [&](double value) { return std::abs(value - here) > kOther * range; });
    if (other == values.end()) continue;
    double sign = *other < here ? -1.0 : 1.0;
    // On to where the step ends.
    while (other + 1 != values.end() && sign * (other[1] - other[0]) > 0.02 * range) ++other;
    (sign < 0 ? darker : brighter).push_back(0.5 * (here + *other));
  }
  tissue.low = shareOf(std::move(darker), 0.6);
  tissue.high = shareOf(std::move(brighter), 0.4);
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

using Opacity = std::function<double(double)>;

/// The values between which an old curve and a tissue's bump are straight, ascending.
std::vector<double> cornersOf(const Curve& old, const Tissue& tissue) {
  std::vector<double> values;
  for (double corner : {-kFoot, -kShoulder, kShoulder, kFoot}) values.push_back(tissue.value + corner * tissue.spread);
  for (const auto& point : old) {
    values.push_back(std::nextafter(point.value, -1e300));  // the foot of a step
    values.push_back(point.value);
  }
  std::sort(values.begin(), values.end());
  return values;
}

/// Adds where two functions that are straight between the corners cross.
void addCrossings(std::vector<double>& corners, const Opacity& f, const Opacity& g) {
  std::size_t count = corners.size();
  for (std::size_t i = 1; i < count; ++i) {
    double a = corners[i - 1], b = corners[i];
    double before = f(a) - g(a), after = f(b) - g(b);
    if (before * after < 0) corners.push_back(a + (b - a) * before / (before - after));
  }
  std::sort(corners.begin(), corners.end());
}

/// The curve through a function's values at the corners, without the points that it does not need.
Curve curveThrough(const std::vector<double>& corners, const Opacity& opacityOf) {
  Curve dense, curve;
  for (double value : corners) dense.push_back({value, opacityOf(value)});
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

std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world) {
  HistogramMemo histograms;
  return layer.data ? measureTissue(layer, world, histograms.of(layer)) : std::nullopt;
}

std::optional<Tissue> measureTissue(const scene::VolumeLayer& layer, glm::dvec3 world, const Histogram& histogram) {
  if (!layer.data) return std::nullopt;
  const Volume& volume = *layer.data;
  glm::dvec3 place(glm::inverse(volume.worldFromVoxel) * glm::dvec4(world, 1.0));
  glm::ivec3 last = volume.dims - 1;
  if (glm::any(glm::lessThan(place, glm::dvec3(-0.5))) || glm::any(glm::greaterThan(place, glm::dvec3(last) + 0.5)))
    return std::nullopt;
  glm::ivec3 middle = glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), last);
  auto here = voxelsAround(layer, middle, 0);
  if (here.empty()) return std::nullopt;
  Tissue borders;
  findBorders(layer, middle, here.front().value, quantile(histogram, 0.999) - quantile(histogram, 0.001), borders);
  auto withinBorders = [&](int radius) {
    auto samples = voxelsAround(layer, middle, radius);
    std::erase_if(samples, [&](const Sample& sample) {
      return (borders.low && sample.value < *borders.low) || (borders.high && sample.value > *borders.high);
    });
    return samples;
  };
  Tissue tissue = tissueOf(evenHalf(withinBorders(kNear)), here.front().value);
  // The same material a little farther off varies more than the noise here: as far as its values are like these. Where
  // a material is thin, or varies itself, what is like it may be mostly something else, as flesh is around bone.
  double range = volume.range.y - volume.range.x, least = range / 300.0;
  double like = std::max(4.0 * tissue.spread, range / 50.0);
  auto wide = withinBorders(kWide);
  std::erase_if(wide, [&](const Sample& sample) { return std::abs(sample.value - tissue.value) > like; });
  if (wide.size() > 1) {
    Tissue more = tissueOf(evenHalf(std::move(wide)), tissue.value);
    if (std::abs(more.value - tissue.value) <= std::max(tissue.spread, least)) tissue = more;
  }
  tissue.here = here.front().value;
  tissue.low = borders.low;
  tissue.high = borders.high;
  tissue.spread = std::max(tissue.spread, least);
  if (!(tissue.spread > 0)) tissue.spread = 1.0;
  return tissue;
}

std::optional<Tissue> showThis(scene::Scene& scene, glm::dvec3 world, bool add) {
  auto tissue = measureTissue(scene.volume, world);
  if (!tissue) return tissue;
  scene::TransferFunction& transfer = scene::currentTransfer(scene.volume);
  Curve old = transfer.opacities;
  double veil = 1.0 - std::pow(0.65, transfer.unitDistance / std::max(radiusOf(*scene.volume.data), 1e-9));
  Opacity faint = [&](double value) { return (add ? 1.0 : 0.15) * scene::opacityAt(old, value); };
  Opacity other = [&](double value) { return add ? faint(value) : std::min(faint(value), veil); };
  Opacity bump = [&](double value) { return kOpacity * bumpAt(*tissue, value); };
  auto corners = cornersOf(old, *tissue);
  if (!add) addCrossings(corners, faint, [veil](double) { return veil; });
  addCrossings(corners, other, bump);
  transfer.opacities = curveThrough(corners, [&](double value) { return std::max(other(value), bump(value)); });
  brighten(transfer.colors, *tissue);
  scene.rayCast.mode = scene::RenderMode::Volume;
  return tissue;
}

std::optional<Tissue> hideThis(scene::Scene& scene, glm::dvec3 world) {
  auto tissue = measureTissue(scene.volume, world);
  if (!tissue) return tissue;
  scene::TransferFunction& transfer = scene::currentTransfer(scene.volume);
  Curve old = transfer.opacities;
  transfer.opacities = curveThrough(cornersOf(old, *tissue), [&](double value) {
    return scene::opacityAt(old, value) * (1.0 - bumpAt(*tissue, value));
  });
  return tissue;
}

}  // namespace velum::session
