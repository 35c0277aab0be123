#include "growth/LabelsFor.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "core/FinestVoxels.h"
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

/// The voxels of other labels that are nearest to those of one brick.
class NearestBrick {
 public:
  NearestBrick(const LabelVolume& from, const glm::dmat4& fromVoxel, glm::ivec3 first, glm::ivec3 size)
      : mFrom(from), mFromVoxel(fromVoxel), mFirst(first), mSize(size) {}

  /// The id that all of them have; nothing where bricks around them have several.
  std::optional<std::uint16_t> only() const {
    glm::dvec3 low(1e300), high(-1e300);
    for (int corner = 0; corner < 8; ++corner) {
      glm::dvec3 place = nearest(mFirst + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2) * (mSize - 1));
      low = glm::min(low, place), high = glm::max(high, place);
    }
    glm::ivec3 first(low - 1.0), last(high + 1.0);  // a voxel more, whatever is rounded
    bool leaves = glm::any(glm::lessThan(first, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(last, mFrom.dims()));
    std::optional<std::uint16_t> id;
    if (leaves) id = 0;
    first = glm::max(first, glm::ivec3(0)) / kEdge, last = glm::min(last, mFrom.dims() - 1) / kEdge;
    for (int z = first.z; z <= last.z; ++z)
      for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
          const LabelVolume::Brick& brick = mFrom.brick({x, y, z});
          if (brick.size() > 1 || (id && *id != brick[0])) return std::nullopt;
          id = brick[0];
        }
    return id.value_or(std::uint16_t(0));
  }
  void read(std::vector<std::uint16_t>& ids) const {
    ids.clear();
    for (int z = 0; z < mSize.z; ++z)
      for (int y = 0; y < mSize.y; ++y)
        for (int x = 0; x < mSize.x; ++x) ids.push_back(mFrom.at(glm::ivec3(nearest(mFirst + glm::ivec3(x, y, z)))));
  }

 private:
  static constexpr int kEdge = LabelVolume::kBrickSize;
  /// Clamped to just outside.
  glm::dvec3 nearest(glm::ivec3 voxel) const {
    glm::dvec3 place(mFromVoxel * glm::dvec4(voxel, 1.0));
    return glm::clamp(glm::floor(place + 0.5), glm::dvec3(-1.0), glm::dvec3(mFrom.dims()));
  }

  const LabelVolume& mFrom;
  const glm::dmat4& mFromVoxel;
  glm::ivec3 mFirst, mSize;
};

/// By the nearest voxel, brick by brick: those that lie in bricks of one id take no time.
LabelVolume resample(const LabelVolume& from, const Volume& volume) {
  LabelVolume labels(volume.dims, volume.worldFromVoxel, volume.lengthUnit);
  labels.table = from.table;
  labels.name = from.name;
  labels.warnings = from.warnings;
  glm::dmat4 fromVoxel = glm::inverse(from.worldFromVoxel()) * volume.worldFromVoxel;
  constexpr int kEdge = LabelVolume::kBrickSize;
  glm::ivec3 grid = labels.brickGrid();
  for (int z = 0; z < grid.z; ++z) {
    std::vector<std::vector<std::uint16_t>> layer(std::size_t(grid.x) * std::size_t(grid.y));
    auto cornerOf = [&](std::size_t i) { return glm::ivec3(int(i) % grid.x, int(i) / grid.x, z) * kEdge; };
    auto sizeOf = [&](std::size_t i) { return glm::min(volume.dims - cornerOf(i), glm::ivec3(kEdge)); };
    parallelFor(std::size_t(0), layer.size(), [&](std::size_t i) {
      NearestBrick brick(from, fromVoxel, cornerOf(i), sizeOf(i));
      glm::ivec3 size = sizeOf(i);
      auto only = brick.only();
      if (!only)
        brick.read(layer[i]);
      else if (*only != 0)
        layer[i].assign(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z), *only);
    });
    for (std::size_t i = 0; i < layer.size(); ++i)
      if (!layer[i].empty()) labels.write(cornerOf(i), sizeOf(i), layer[i]);
  }
  return labels;
}

}  // namespace

Shared<LabelVolume> labelsFor(const Volume& volume, const Shared<LabelVolume>& given) {
  FinestVoxels voxels(volume);
  const Volume& grid = voxels.grid();
  if (!given) return LabelVolume(grid.dims, grid.worldFromVoxel, grid.lengthUnit);
  if (isOnGrid(*given, grid)) return given;
  LabelVolume labels = resample(*given, grid);
  labels.warnings.push_back(
      "the labels have another grid than the volume: what grows made them take its grid, by the nearest voxel");
  return labels;
}

}  // namespace velum::growth
