#include "session/structure/StructureValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/FinestVoxels.h"
#include "core/Parallel.h"
#include "session/structure/ValueSum.h"

namespace velum::session {

namespace {

using Sums = std::map<int, ValueSum>;

/// The label at a voxel of a scan.
struct LabelAt {
  const LabelVolume& labels;
  glm::dmat4 labelFromScan;
  bool sharesGrid;

  /// The voxel of the labels that is nearest; may lie beyond their grid.
  glm::ivec3 nearest(glm::ivec3 voxel) const {
    if (sharesGrid) return voxel;
    glm::dvec3 at = glm::floor(glm::dvec3(labelFromScan * glm::dvec4(voxel, 1.0)) + 0.5);
    return glm::ivec3(glm::clamp(at, glm::dvec3(-1.0), glm::dvec3(labels.dims())));
  }
};

/// One plane of the scan along z.
struct PlaneReader {
  LabelAt at;
  const Volume& scan;
  int channel, timeStep;

  Sums read(int z) const {
    Sums sums;
    ValueSum* here = nullptr;
    int known = 0;
    for (int y = 0; y < scan.dims.y; ++y)
      for (int x = 0; x < scan.dims.x; ++x) {
        int id = at.labels.at(at.nearest({x, y, z}));
        if (id == 0) continue;
        double value = valueAt(scan, {x, y, z}, channel, timeStep);
        if (!std::isfinite(value)) continue;
        // Neighbours are mostly of one structure.
        if (!here || id != known) here = &sums[known = id];
        here->add(value);
      }
    return sums;
  }
};

/// One layer of bricks of labels along z, of the voxels of a streamed scan's finest level.
struct LayerReader {
  LabelAt at;
  const FinestVoxels& scan;
  int channel, timeStep;

  Sums read(int layer) const {
    Sums sums;
    const LabelVolume& labels = at.labels;
    glm::ivec3 grid = labels.brickGrid();
    for (glm::ivec3 brick(0, 0, layer); brick.y < grid.y; ++brick.y)
      for (brick.x = 0; brick.x < grid.x; ++brick.x) {
        const LabelVolume::Brick& ids = labels.brick(brick);
        if (std::all_of(ids.begin(), ids.end(), [](std::uint16_t id) { return id == 0; })) continue;
        addBrick(sums, brick);
      }
    return sums;
  }

 private:
  /// Voxels of the scan of which the nearest one of the labels is one of a brick, in boxes that fit into memory.
  void addBrick(Sums& sums, glm::ivec3 brick) const {
    constexpr int kEdge = LabelVolume::kBrickSize, kMost = 64;
    auto [low, high] = scanBoxOf(brick * kEdge, kEdge);
    glm::ivec3 first;
    for (first.z = low.z; first.z < high.z; first.z += kMost)
      for (first.y = low.y; first.y < high.y; first.y += kMost)
        for (first.x = low.x; first.x < high.x; first.x += kMost) {
          glm::ivec3 size = glm::min(high - first, glm::ivec3(kMost));
          Volume part = scan.read(first, size, channel, timeStep);
          for (glm::ivec3 v(0); v.z < size.z; ++v.z)
            for (v.y = 0; v.y < size.y; ++v.y)
              for (v.x = 0; v.x < size.x; ++v.x) {
                glm::ivec3 label = at.nearest(first + v);
                if (glm::any(glm::lessThan(label, brick * kEdge)) || label / kEdge != brick) continue;
                if (int id = at.labels.at(label); id != 0)
                  if (double value = valueAt(part, v); std::isfinite(value)) sums[id].add(value);
              }
        }
  }
  /// The box of the scan around a cube of the labels.
  std::pair<glm::ivec3, glm::ivec3> scanBoxOf(glm::ivec3 first, int edge) const {
    glm::ivec3 dims = scan.grid().dims;
    if (at.sharesGrid) return {first, glm::min(first + edge, dims)};
    glm::dmat4 scanFromLabel = glm::inverse(at.labelFromScan);
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
    for (int i = 0; i < 8; ++i) {
      glm::dvec3 corner = glm::dvec3(first) - 0.5 + double(edge) * glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
      glm::dvec3 place(scanFromLabel * glm::dvec4(corner, 1.0));
      low = glm::min(low, place), high = glm::max(high, place);
    }
    glm::dvec3 end(dims);
    return {glm::ivec3(glm::clamp(glm::floor(low), glm::dvec3(0.0), end)),
            glm::ivec3(glm::clamp(glm::ceil(high) + 1.0, glm::dvec3(0.0), end))};
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
  channel = std::clamp(channel, 0, scan.channels - 1);
  timeStep = std::clamp(timeStep, 0, scan.timeSteps - 1);
  FinestVoxels finest(scan);
  const Volume& grid = finest.grid();
  LabelAt at{labels, glm::inverse(labels.worldFromVoxel()) * worldFromVoxelIn(labels.lengthUnit(), grid),
             isOnGrid(labels, grid)};
  Sums all = finest.isStreamed() ? sumsOf(LayerReader{at, finest, channel, timeStep}, labels.brickGrid().z, 4, progress)
                                 : sumsOf(PlaneReader{at, scan, channel, timeStep}, scan.dims.z, 16, progress);
  std::map<int, StructureValues> values;
  for (const auto& [id, sum] : all) values[id] = valuesOf(sum);
  return values;
}

}  // namespace velum::session
