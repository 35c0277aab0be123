#include "session/structure/StructureValues.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

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

}  // namespace

std::map<int, StructureValues> measureValues(const LabelVolume& labels, const Volume& scan, int channel, int timeStep,
                                             Progress& progress) {
  glm::dmat4 labelFromScan = glm::inverse(labels.worldFromVoxel()) * worldFromVoxelIn(labels.lengthUnit(), scan);
  bool sharesGrid =
      labels.dims() == scan.dims && labels.worldFromVoxel() == worldFromVoxelIn(labels.lengthUnit(), scan);
  PlaneReader reader{
      labels,        scan,      std::clamp(channel, 0, scan.channels - 1), std::clamp(timeStep, 0, scan.timeSteps - 1),
      labelFromScan, sharesGrid};
  std::vector<Sums> planes(std::size_t(scan.dims.z));
  constexpr int kSlab = 16;  // planes between two looks at whether somebody has cancelled
  for (int z = 0; z < scan.dims.z; z += kSlab) {
    progress.report(double(z) / scan.dims.z, "measuring values");
    parallelFor(z, std::min(z + kSlab, scan.dims.z),
                [&](int plane) { planes[std::size_t(plane)] = reader.read(plane); });
  }
  // In the planes' order, so that the sums are the same whatever the machine.
  Sums all;
  for (const Sums& plane : planes)
    for (const auto& [id, sum] : plane) all[id].join(sum);
  std::map<int, StructureValues> values;
  for (const auto& [id, sum] : all) values[id] = valuesOf(sum);
  return values;
}

}  // namespace velum::session
