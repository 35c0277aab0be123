#include "growth/FirstDoubt.h"

#include <algorithm>
#include <cmath>

#include "core/FinestVoxels.h"
#include "growth/GrowDomain.h"

namespace velum::growth {

namespace {

constexpr double kDarkest = 0.01;
/// Of a plane through the data's box, and of what is something in it.
constexpr double kGoodPart = 0.3, kMost = 0.6;

/// Calls body(voxel) for the voxels of a slab on some of the lines along the axis on which its depth changes most:
/// every so many voxels along the two others.
template <class Body>
void forLines(const GrowDomain& slab, glm::ivec3 dims, glm::ivec3 every, const Body& body) {
  glm::dvec3 rise;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 next(0);
    next[axis] = 1;
    rise[axis] = std::abs(slab.depth(next) - slab.depth(glm::ivec3(0)));
  }
  int along = rise.x >= rise.y && rise.x >= rise.z ? 0
              : rise.y >= rise.z                   ? 1
                                                   : 2,
      a = (along + 1) % 3, b = 3 - along - a;
  for (glm::ivec3 line(0); line[a] < dims[a]; line[a] += every[a])
    for (line[b] = 0; line[b] < dims[b]; line[b] += every[b]) {
      // Depths rise or fall along a line: to the slab by halves, then through it.
      glm::ivec3 v = line, last = line;
      last[along] = dims[along] - 1;
      bool rises = slab.depth(last) > slab.depth(line);
      int low = 0, high = dims[along];
      while (low < high) {
        v[along] = (low + high) / 2;
        bool isBefore = rises ? slab.depth(v) <= slab.from() : slab.depth(v) > slab.distance();
        isBefore ? low = v[along] + 1 : high = v[along];
      }
      for (v[along] = low; v[along] < dims[along] && slab.contains(v); ++v[along]) body(v);
    }
}

}  // namespace

bool reachesTheDarkest(const Volume& volume, const scene::Growth& step) {
  double least = quantile(computeHistogram(volume, 4096, step.channel, step.timeStep), kDarkest);
  return step.low <= std::max(least, volume.range.x);
}

double firstSlabEnd(const Volume& volume, const scene::Growth& step) {
  FinestVoxels voxels(volume);
  GrowDomain domain(voxels.grid(), step.centre, step.axis, step.distance);
  if (domain.isEverywhere()) return 0.0;
  double begin = domain.depthRange(glm::ivec3(0), voxels.grid().dims - 1).x - domain.layer();
  return std::max(begin, 0.0) + slabThickness(voxels.grid());
}

bool isMostOfItsPlane(const Volume& volume, const LabelVolume& labels, const scene::Growth& step) {
  FinestVoxels voxels(volume);
  const Volume& grid = voxels.grid();
  GrowDomain domain(grid, step.centre, step.axis, step.distance);
  if (domain.isEverywhere()) return false;
  double end = firstSlabEnd(volume, step);
  GrowDomain slab = domain.between(end - slabThickness(grid), std::min(end, step.distance));
  double least = 0.5 * (volume.range.x + step.low);
  std::size_t all = 0, matter = 0, mine = 0;
  auto look = [&](glm::ivec3 v, glm::ivec3 inMemory) {
    matter += valueAt(volume, inMemory, step.channel, step.timeStep) > least;
    mine += int(labels.at(v)) == step.structure;
    ++all;
  };
  if (voxels.isStreamed()) {
    glm::dmat4 coarseFromVoxel = glm::inverse(volume.worldFromVoxel) * grid.worldFromVoxel;
    forLines(slab, grid.dims, glm::max(grid.dims / volume.dims, glm::ivec3(1)), [&](glm::ivec3 v) {
      glm::dvec3 place(coarseFromVoxel * glm::dvec4(v, 1.0));
      look(v, glm::clamp(glm::ivec3(glm::floor(place + 0.5)), glm::ivec3(0), volume.dims - 1));
    });
  } else {
    for (glm::ivec3 v(0); v.z < volume.dims.z; ++v.z)
      for (v.y = 0; v.y < volume.dims.y; ++v.y) {
        RowSpan span = slab.rowSpan(v.y, v.z, volume.dims.x);
        for (v.x = span.first; v.x < span.end; ++v.x) look(v, v);
      }
  }
  return double(mine) > kGoodPart * double(all) && double(mine) > kMost * double(matter);
}

}  // namespace velum::growth
