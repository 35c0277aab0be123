#include "session/extrusion/MaterialRange.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/Error.h"
#include "core/FinestVoxels.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/extrusion/Populations.h"
#include "session/look/ShowThis.h"

namespace velum::session {

namespace {

/// Less opaque than this is hidden; a curve that falls to this share of a hump's height, and rises again, has a valley.
constexpr double kHidden = 0.005, kValley = 0.5;
/// Of the noise to either side of a material's middle.
constexpr double kSpreads = 3.0;
/// Share of the data beyond which there is nothing else worth telling apart.
constexpr double kEnd = 0.1;
/// Voxels around the place within which materials lie beside it.
constexpr int kNeighbourhood = 16;
/// As many, and those that are looked at from the next voxel.
constexpr int kRoom = kNeighbourhood + 2;
/// A material that is shown, too, is another one where it ends before this share of the way to the value, and is not as
/// bright as this share of the data. Tuned, with the neighbourhood and the constants of populations, on the rows of
/// RealPulls that say so, and held against the others.
constexpr double kApart = 0.75, kBright = 0.03;
/// Share of what is around from which on it is all one material.
constexpr double kAlone = 0.9;
/// Share of what is around from which on a material that is shown, too, is one of its own.
constexpr double kLeastOther = 0.15;
/// Of what is around: as much of brighter values is another material, and no tail of this one.
constexpr double kLeastBrighter = 0.02;

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

/// The values of the voxels around a place, where they are numbers.
std::vector<double> valuesAround(const scene::VolumeLayer& layer, glm::dvec3 world) {
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer);
  int timeStep = scene::shownTimeStep(layer);
  glm::ivec3 middle(glm::floor(glm::dvec3(glm::inverse(volume.worldFromVoxel) * glm::dvec4(world, 1.0)) + 0.5));
  glm::ivec3 first = glm::max(middle - kNeighbourhood, glm::ivec3(0));
  glm::ivec3 last = glm::min(middle + kNeighbourhood, volume.dims - 1);
  std::vector<double> values;
  for (glm::ivec3 p = first; p.z <= last.z; ++p.z)
    for (p.y = first.y; p.y <= last.y; ++p.y)
      for (p.x = first.x; p.x <= last.x; ++p.x)
        if (double value = valueAt(volume, p, channel, timeStep); std::isfinite(value)) values.push_back(value);
  return values;
}

/// The material that a value is of, where that is a peak which the curve shows.
const Population* ownOf(const std::vector<Population>& populations, double value, double foot) {
  const Population* own = nullptr;
  for (const auto& one : populations)
    if (one.middle >= foot && one.holds(value)) own = &one;
  return own;
}

/// True where a darker material is another one than that of a value, not the same, thinner.
/// @param bright  what few of all values reach
bool isApart(const Population& darker, double value, double bright) {
  return darker.upperEnd() < glm::mix(darker.middle, value, kApart) && darker.middle < bright;
}

/// Where a material begins that the curve shows from a foot on: there, where it becomes visible; above what is darker,
/// lies beside it and is shown, too; lower where all that lies beside it is one material that the curve hides, halfway
/// to that, but not in its noise.
double lowOf(const std::vector<Population>& populations, double foot, double value, double bright) {
  double low = foot;
  const Population* hidden = nullptr;
  for (const auto& one : populations) {
    bool isShown = one.middle + one.spread > foot;
    if (one.middle < value && isShown && one.share > kLeastOther && isApart(one, value, bright))
      low = std::max(low, one.upperEnd());
    if (!isShown) hidden = &one;
  }
  bool isAlone = hidden && hidden->share > kAlone && low == foot;
  if (!isAlone) return low;
  return std::min(foot, std::max(0.5 * (hidden->middle + value), hidden->upperEnd() + hidden->spread));
}

/// Where a material ends that is a peak: before what is brighter and shown by the same segment.
double highOf(double end, const Population& own, const std::vector<double>& around) {
  auto brighter =
      std::count_if(around.begin(), around.end(), [&](double value) { return value > own.upperEnd() && value <= end; });
  return double(brighter) > kLeastBrighter * double(around.size()) ? own.upperEnd() : end;
}

/// Of a segment of the curve, what belongs to the material of a value.
/// @param all  values of the whole data
MaterialRange withoutOthers(MaterialRange segment, double value, const Tissue& tissue,
                            const std::vector<double>& around, const Histogram& all) {
  std::vector<Population> beside = populationsOf(around);
  const Population* own = ownOf(beside, value, segment.low);
  MaterialRange range = segment;
  range.low = lowOf(beside, segment.low, own ? own->middle : value, quantile(all, 1.0 - kBright));
  // What is still brighter than the brightest tenth is more of it, as dense bone is of spongy.
  bool isBrightest = value > quantile(all, 1.0 - kEnd);
  if (own && !isBrightest) range.high = highOf(segment.high, *own, around);
  // Both the middle of what was measured and the place belong to it, unless noise has put that out of the segment.
  for (double each : {value, tissue.here})
    if (each >= segment.low && each <= segment.high)
      range.low = std::min(range.low, each), range.high = std::max(range.high, each);
  return range;
}

bool isShown(const scene::TransferFunction& transfer, double value) {
  return !(scene::opacityAt(transfer.opacities, value) < kHidden);
}

/// Calls body(voxel, weight) for the voxels between which the picture interpolates at a place in voxels.
template <class Body>
void forCorners(const Volume& volume, glm::dvec3 place, const Body& body) {
  glm::dvec3 first = glm::floor(place), part = place - first;
  for (int corner = 0; corner < 8; ++corner) {
    glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    glm::dvec3 weight = glm::mix(1.0 - part, part, glm::dvec3(step));
    glm::ivec3 voxel = glm::clamp(glm::ivec3(first) + step, glm::ivec3(0), volume.dims - 1);
    body(voxel, weight.x * weight.y * weight.z);
  }
}

/// What is seen at a place whose own voxel is hidden: of the voxels around it the nearest that the curve shows. A shell
/// is clicked on at its rim, where the picture, which interpolates, shows it already, but half of the voxels are what
/// lies beside it.
/// @return the middle of that voxel, world; nothing where the picture shows nothing either
std::optional<glm::dvec3> shownBeside(const scene::VolumeLayer& layer, glm::dvec3 world) {
  const Volume& volume = *layer.data;
  const scene::TransferFunction& transfer = scene::currentTransfer(layer);
  int channel = scene::shownChannel(layer);
  int timeStep = scene::shownTimeStep(layer);
  glm::dvec3 place(glm::inverse(volume.worldFromVoxel) * glm::dvec4(world, 1.0));
  double seen = 0.0, most = 0.0;
  std::optional<glm::ivec3> nearest;
  forCorners(volume, place, [&](glm::ivec3 voxel, double weight) {
    double value = valueAt(volume, voxel, channel, timeStep);
    if (weight > 0.0) seen += weight * value;
    if (weight > most && isShown(transfer, value)) most = weight, nearest = voxel;
  });
  if (!nearest || !isShown(transfer, seen)) return std::nullopt;
  return glm::dvec3(volume.worldFromVoxel * glm::dvec4(*nearest, 1.0));
}

/// The voxels around a place that decide, of the finest level of a volume that is streamed; nothing outside of it.
std::optional<VoxelBox> boxAround(const scene::VolumeLayer& layer, glm::dvec3 world) {
  if (!layer.data || !layer.data->finer) return std::nullopt;
  glm::dvec3 place(glm::inverse(worldFromLevel(*layer.data, 0)) * glm::dvec4(world, 1.0)), end(finestDims(*layer.data));
  bool isInside = glm::all(glm::greaterThanEqual(place, glm::dvec3(-0.5))) && glm::all(glm::lessThan(place, end - 0.5));
  if (!isInside) return std::nullopt;
  return VoxelBox{0, glm::ivec3(glm::floor(place + 0.5)) - kRoom, glm::ivec3(2 * kRoom + 1)};
}

/// The same as a volume.
std::optional<scene::VolumeLayer> finestAround(const scene::VolumeLayer& layer, glm::dvec3 world) {
  auto box = boxAround(layer, world);
  if (!box) return std::nullopt;
  scene::VolumeLayer near = layer;
  try {
    near.data = Shared<Volume>(FinestVoxels(*layer.data).read(box->origin, box->size, -1, scene::shownTimeStep(layer)));
  } catch (const InputError&) {  // the coarse level says it as well as it can
    return std::nullopt;
  }
  near.timeStep = 0;
  return near;
}

/// @param histogram  of the whole data
std::optional<MaterialRange> rangeIn(const scene::VolumeLayer& layer, glm::dvec3 world, const Histogram& histogram) {
  std::optional<Tissue> tissue = measureTissue(layer, world, histogram);
  if (!tissue) return std::nullopt;
  const Volume& volume = *layer.data;
  const scene::TransferFunction& transfer = scene::currentTransfer(layer);
  // Beside borders the middle of what was measured may be hidden though the place itself is seen.
  for (double value : {tissue->value, tissue->here})
    if (auto segment = segmentOf(transfer, value, volume.range))
      return withoutOthers(*segment, value, *tissue, valuesAround(layer, world), histogram);
  // Asked once more at most: that voxel is shown.
  if (auto beside = shownBeside(layer, world)) return rangeIn(layer, *beside, histogram);
  double value = tissue->value, around = kSpreads * tissue->spread;
  bool isBrightest = value > quantile(histogram, 1.0 - kEnd), isDarkest = value < quantile(histogram, kEnd);
  return MaterialRange{tissue->low.value_or(isDarkest ? volume.range.x : value - around),
                       tissue->high.value_or(isBrightest ? volume.range.y : value + around)};
}

}  // namespace

std::optional<MaterialRange> segmentOf(const scene::TransferFunction& transfer, double value, glm::dvec2 range) {
  if (scene::opacityAt(transfer.opacities, value) < kHidden) return std::nullopt;
  return MaterialRange{endOfSegment(transfer.opacities, value, std::min(range.x, value)),
                       endOfSegment(transfer.opacities, value, std::max(range.y, value))};
}

bool isInMemoryAround(const scene::VolumeLayer& layer, glm::dvec3 world) {
  auto box = boxAround(layer, world);
  return !box || layer.data->finer->bricks->has(*box, -1, scene::shownTimeStep(layer));
}

void bringAround(const scene::VolumeLayer& layer, glm::dvec3 world) { (void)finestAround(layer, world); }

std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world) {
  HistogramMemo histograms;
  return materialRangeAt(layer, world, histograms);
}

std::optional<MaterialRange> materialRangeAt(const scene::VolumeLayer& layer, glm::dvec3 world,
                                             HistogramMemo& histograms) {
  if (!layer.data) return std::nullopt;
  auto finest = finestAround(layer, world);
  return rangeIn(finest ? *finest : layer, world, histograms.of(layer));
}

}  // namespace velum::session
