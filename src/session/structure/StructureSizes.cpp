#include "session/structure/StructureSizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "session/structure/StructureSurface.h"

namespace velum::session {

namespace {

constexpr int kBrick = LabelVolume::kBrickSize;
/// A structure fills this share of the picture's height in a close-up, so that its surroundings are seen, too.
/// Voxels that are looked at to find a place inside a structure: a few milliseconds.
constexpr double kSearchVoxels = 2e6;

struct Sum {
  std::uint64_t voxels = 0;
  glm::dvec3 places{0.0};
  glm::ivec3 low{std::numeric_limits<int>::max()}, high{-1};
  /// A row of voxels along x.
  void add(glm::ivec3 from, int count) {
    voxels += std::uint64_t(count);
    places += glm::dvec3(double(count) * (from.x + 0.5 * (count - 1)), double(count) * from.y, double(count) * from.z);
    low = glm::min(low, from);
    high = glm::max(high, from + glm::ivec3(count - 1, 0, 0));
  }
};

void addBrick(std::vector<Sum>& sums, const LabelVolume::Brick& brick, glm::ivec3 corner, glm::ivec3 inside) {
  bool uniform = brick.size() == 1;
  if (uniform && brick[0] == 0) return;
  for (int z = 0; z < inside.z; ++z)
    for (int y = 0; y < inside.y; ++y) {
      glm::ivec3 start = corner + glm::ivec3(0, y, z);
      if (uniform) {
        sums[brick[0]].add(start, inside.x);
        continue;
      }
      const std::uint16_t* row = brick.data() + (std::size_t(z) * kBrick + std::size_t(y)) * kBrick;
      for (int x = 0; x < inside.x;) {
        int end = x + 1;
        while (end < inside.x && row[end] == row[x]) ++end;
        if (row[x] != 0) sums[row[x]].add(start + glm::ivec3(x, 0, 0), end - x);
        x = end;
      }
    }
}

}  // namespace

std::map<int, StructureSize> countStructures(const LabelVolume& labels, Progress& progress) {
  std::vector<Sum> sums(65536);
  glm::ivec3 grid = labels.brickGrid();
  for (int bz = 0; bz < grid.z; ++bz) {
    progress.report(double(bz) / grid.z, "measuring structures");
    for (int by = 0; by < grid.y; ++by)
      for (int bx = 0; bx < grid.x; ++bx) {
        glm::ivec3 corner = glm::ivec3(bx, by, bz) * kBrick;
        addBrick(sums, labels.brick({bx, by, bz}), corner, glm::min(labels.dims() - corner, glm::ivec3(kBrick)));
      }
  }
  double voxelVolume = std::abs(glm::determinant(glm::dmat3(labels.worldFromVoxel()))) / 1000.0;
  std::map<int, StructureSize> sizes;
  for (std::size_t id = 1; id < sums.size(); ++id)
    if (const Sum& sum = sums[id]; sum.voxels > 0)
      sizes[int(id)] = {sum.voxels, double(sum.voxels) * voxelVolume, 0.0, sum.places / double(sum.voxels), sum.low,
                        sum.high};
  return sizes;
}

std::map<int, StructureSize> measureStructures(const LabelVolume& labels, Progress& progress) {
  auto sizes = countStructures(labels, progress);
  for (const auto& [id, area] : measureSurfaces(labels, progress)) sizes.at(id).surface = area / 100.0;
  return sizes;
}

glm::dvec3 middleOfStructure(const LabelVolume& labels, int structure, const StructureSize& size) {
  auto toWorld = [&](glm::dvec3 voxel) { return glm::dvec3(labels.worldFromVoxel() * glm::dvec4(voxel, 1.0)); };
  glm::dvec3 box(size.high - size.low + 1);
  if (labels.at(glm::ivec3(glm::round(size.centroid))) == structure) return toWorld(size.centroid);
  int stride = std::max(1, int(std::ceil(std::cbrt(box.x * box.y * box.z / kSearchVoxels))));
  double nearest = std::numeric_limits<double>::infinity();
  glm::dvec3 found = size.centroid;
  // A stride that steps over a thin structure is halved until it meets it.
  for (; std::isinf(nearest) && stride > 0; stride /= 2)
    for (int z = size.low.z; z <= size.high.z; z += stride)
      for (int y = size.low.y; y <= size.high.y; y += stride)
        for (int x = size.low.x; x <= size.high.x; x += stride) {
          glm::dvec3 off = glm::dvec3(x, y, z) - size.centroid;
          double distance = glm::dot(off, off);
          if (distance >= nearest || labels.at({x, y, z}) != structure) continue;
          nearest = distance;
          found = {x, y, z};
        }
  return toWorld(found);
}

double radiusOfStructure(const LabelVolume& labels, const StructureSize& size) {
  glm::dvec3 box(size.high - size.low + 1);
  glm::dmat3 axes(labels.worldFromVoxel());
  double longest = 0.0;
  for (double x : {-0.5, 0.5})
    for (double y : {-0.5, 0.5}) longest = std::max(longest, glm::length(axes * (box * glm::dvec3(x, y, 0.5))));
  return longest;
}

scene::Camera closeUp(scene::Camera camera, glm::dvec3 middle, double radius, double aspect, double share) {
  double halfHeight = std::max(radius, 1e-6) / share / std::min(1.0, aspect);
  glm::dvec3 arm = camera.eye - camera.target;
  double length = glm::length(arm);
  glm::dvec3 toEye = length > 1e-12 ? arm / length : glm::dvec3(0, -1, 0);
  camera.target = middle;
  camera.height = 2.0 * halfHeight;
  camera.eye = middle + toEye * (halfHeight / std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5));
  return camera;
}

}  // namespace velum::session
