#include "growth/LabelsFor.h"

#include <algorithm>
#include <vector>

#include "core/Parallel.h"

namespace velum::growth {

namespace {

/// Voxels by which two grids may lie apart and count as one: what files round.
constexpr double kSamePlace = 0.01;

bool isOnGrid(const LabelVolume& labels, const Volume& volume) {
  if (labels.dims() != volume.dims) return false;
  glm::dmat4 labelFromVolume = glm::inverse(labels.worldFromVoxel()) * volume.worldFromVoxel;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 voxel = glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * glm::dvec3(volume.dims - 1);
    if (glm::length(glm::dvec3(labelFromVolume * glm::dvec4(voxel, 1.0)) - voxel) > kSamePlace) return false;
  }
  return true;
}

/// By the nearest voxel, layers of bricks at a time.
LabelVolume resample(const LabelVolume& from, const Volume& volume) {
  LabelVolume labels(volume.dims, volume.worldFromVoxel, volume.lengthUnit);
  labels.table = from.table;
  labels.name = from.name;
  labels.warnings = from.warnings;
  glm::dmat4 fromVoxel = glm::inverse(from.worldFromVoxel()) * volume.worldFromVoxel;
  glm::ivec3 dims = volume.dims;
  std::vector<std::uint16_t> ids(std::size_t(dims.x) * std::size_t(dims.y) * LabelVolume::kBrickSize);
  for (int first = 0; first < dims.z; first += LabelVolume::kBrickSize) {
    int count = std::min(dims.z - first, LabelVolume::kBrickSize);
    parallelFor(0, count * dims.y, [&](int row) {
      std::uint16_t* out = ids.data() + std::size_t(row) * std::size_t(dims.x);
      for (int x = 0; x < dims.x; ++x) {
        glm::dvec3 place(fromVoxel * glm::dvec4(x, row % dims.y, first + row / dims.y, 1.0));
        place = glm::clamp(glm::floor(place + 0.5), glm::dvec3(-1.0), glm::dvec3(from.dims()));
        out[x] = from.at(glm::ivec3(place));
      }
    });
    labels.write({0, 0, first}, {dims.x, dims.y, count}, ids);
  }
  return labels;
}

}  // namespace

Shared<LabelVolume> labelsFor(const Volume& volume, const Shared<LabelVolume>& given) {
  if (!given) return LabelVolume(volume.dims, volume.worldFromVoxel, volume.lengthUnit);
  if (isOnGrid(*given, volume)) return given;
  LabelVolume labels = resample(*given, volume);
  labels.warnings.push_back(
      "the labels have another grid than the volume: what grows made them take its grid, by the nearest voxel");
  return labels;
}

}  // namespace velum::growth
