#include "session/structure/StructureValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/FinestVoxels.h"
#include "core/Parallel.h"

namespace velum::session {

namespace {

/// Sums over the voxels of one structure, about its first value, so that few digits are lost.
struct ValueSum {
  std::uint64_t voxels = 0;
  double first = 0, sum = 0, squares = 0;
  double least = std::numeric_limits<double>::infinity(), most = -least;

  void add(double value) {
    if (voxels++ == 0) first = value;
    double off = value - first;
    sum += off;
    squares += off * off;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  void join(const ValueSum& other) {
    if (other.voxels == 0) return;
    if (voxels == 0) {
      *this = other;
      return;
    }
    double shift = other.first - first, count = double(other.voxels);
    squares += other.squares + 2 * shift * other.sum + count * shift * shift;
    sum += other.sum + count * shift;
    voxels += other.voxels;
    least = std::min(least, other.least);
    most = std::max(most, other.most);
  }
};
using Sums = std::map<int, ValueSum>;

StructureValues valuesOf(const ValueSum& sum) {
  double count = double(sum.voxels), mean = sum.sum / count;
  return {sum.voxels, sum.first + mean, std::sqrt(std::max(0.0, sum.squares / count - mean * mean)), sum.least,
          sum.most};
}

/// One plane of the scan along z.
struct PlaneReader {
  const LabelVolume& labels;
  const Volume& scan;
  int channel, timeStep;
  glm::dmat4 labelFromScan;
  bool sharesGrid;

  Sums read(int z) const {
    Sums sums;
    ValueSum* here = nullptr;
    int known = 0;
    for (int y = 0; y < scan.dims.y; ++y)
      for (int x = 0; x < scan.dims.x; ++x) {
        int id = idAt({x, y, z});
        if (id == 0) continue;
        double value = valueAt(scan, {x, y, z}, channel, timeStep);
        if (!std::isfinite(value)) continue;
        // Neighbours are mostly of one structure.
        if (!here || id != known) here = &sums[known = id];
        here->add(value);
      }
    return sums;
  }

 private:
  int idAt(glm::ivec3 voxel) const {
    if (sharesGrid) return labels.at(voxel);
    glm::dvec3 at = glm::floor(glm::dvec3(labelFromScan * glm::dvec4(voxel, 1.0)) + 0.5);
    bool isInside =
        glm::all(glm::greaterThanEqual(at, glm::dvec3(0.0))) && glm::all(glm::lessThan(at, glm::dvec3(labels.dims())));
    return isInside ? labels.at(glm::ivec3(at)) : 0;
  }
};

/// One layer of bricks of labels along z, which lie on the grid of a streamed scan's finest level.
struct LayerReader {
  const LabelVolume& labels;
  const FinestVoxels& scan;
  int channel, timeStep;

  Sums read(int layer) const {
    Sums sums;
    constexpr int kEdge = LabelVolume::kBrickSize;
    glm::ivec3 grid = labels.brickGrid();
    for (glm::ivec3 at(0, 0, layer); at.y < grid.y; ++at.y)
      for (at.x = 0; at.x < grid.x; ++at.x) {
        const LabelVolume::Brick& ids = labels.brick(at);
        if (std::all_of(ids.begin(), ids.end(), [](std::uint16_t id) { return id == 0; })) continue;
        glm::ivec3 first = at * kEdge, size = glm::min(labels.dims() - first, glm::ivec3(kEdge));
        Volume part = scan.read(first, size, channel, timeStep);
        for (glm::ivec3 v(0); v.z < size.z; ++v.z)
          for (v.y = 0; v.y < size.y; ++v.y)
            for (v.x = 0; v.x < size.x; ++v.x)
              if (int id = labels.at(first + v); id != 0)
                if (double value = valueAt(part, v); std::isfinite(value)) sums[id].add(value);
      }
    return sums;
  }
};

bool isOnGrid(const LabelVolume& labels, const Volume& scan) {
  return labels.dims() == scan.dims && labels.worldFromVoxel() == worldFromVoxelIn(labels.lengthUnit(), scan);
}

/// The sums of planes, or layers, in their order, so that they are the same whatever the machine.
template <class Reader>
Sums sumsOf(const Reader& reader, int count, int slab, Progress& progress) {
  std::vector<Sums> parts(static_cast<std::size_t>(count));
  for (int z = 0; z < count; z += slab) {  // planes between two looks at whether somebody has cancelled
    progress.report(double(z) / count, "measuring values");
    parallelFor(z, std::min(z + slab, count), [&](int part) { parts[std::size_t(part)] = reader.read(part); });
  }
  Sums all;
  for (const Sums& part : parts)
    for (const auto& [id, sum] : part) all[id].join(sum);
  return all;
}

}  // namespace

std::map<int, StructureValues> measureValues(const LabelVolume& labels, const Volume& scan, int channel, int timeStep,
                                             Progress& progress) {
  glm::dmat4 labelFromScan = glm::inverse(labels.worldFromVoxel()) * worldFromVoxelIn(labels.lengthUnit(), scan);
  channel = std::clamp(channel, 0, scan.channels - 1);
  timeStep = std::clamp(timeStep, 0, scan.timeSteps - 1);
  FinestVoxels finest(scan);
  Sums all;
  if (finest.isStreamed() && isOnGrid(labels, finest.grid()))
    all = sumsOf(LayerReader{labels, finest, channel, timeStep}, labels.brickGrid().z, 4, progress);
  else
    all = sumsOf(PlaneReader{labels, scan, channel, timeStep, labelFromScan, isOnGrid(labels, scan)}, scan.dims.z, 16,
                 progress);
  std::map<int, StructureValues> values;
  for (const auto& [id, sum] : all) values[id] = valuesOf(sum);
  return values;
}

}  // namespace velum::session
