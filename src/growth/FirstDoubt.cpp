#include "growth/FirstDoubt.h"

#include <algorithm>
#include <cmath>

#include "growth/GrowDomain.h"

namespace velum::growth {

namespace {

constexpr double kDarkest = 0.01;
/// Of a plane through the data's box, and of what is something in it.
constexpr double kGoodPart = 0.3, kMost = 0.6;

}  // namespace

bool reachesTheDarkest(const Volume& volume, const scene::Growth& step) {
  double least = quantile(computeHistogram(volume, 4096, step.channel, step.timeStep), kDarkest);
  return step.low <= std::max(least, volume.range.x);
}

double firstSlabEnd(const Volume& volume, const scene::Growth& step) {
  GrowDomain domain(volume, step.centre, step.axis, step.distance);
  if (domain.isEverywhere()) return 0.0;
  double begin = domain.depthRange(glm::ivec3(0), volume.dims - 1).x - domain.layer();
  return std::max(begin, 0.0) + slabThickness(volume);
}

bool isMostOfItsPlane(const Volume& volume, const LabelVolume& labels, const scene::Growth& step) {
  GrowDomain domain(volume, step.centre, step.axis, step.distance);
  if (domain.isEverywhere()) return false;
  double end = firstSlabEnd(volume, step);
  GrowDomain slab = domain.between(end - slabThickness(volume), std::min(end, step.distance));
  double least = 0.5 * (volume.range.x + step.low);
  std::size_t all = 0, matter = 0, mine = 0;
  for (glm::ivec3 v(0); v.z < volume.dims.z; ++v.z)
    for (v.y = 0; v.y < volume.dims.y; ++v.y) {
      RowSpan span = slab.rowSpan(v.y, v.z, volume.dims.x);
      all += std::size_t(std::max(span.end - span.first, 0));
      for (v.x = span.first; v.x < span.end; ++v.x) {
        matter += valueAt(volume, v, step.channel, step.timeStep) > least;
        mine += int(labels.at(v)) == step.structure;
      }
    }
  return double(mine) > kGoodPart * double(all) && double(mine) > kMost * double(matter);
}

}  // namespace velum::growth
