#include "FetchCount.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/Parallel.h"

namespace velum::bench {

namespace {

constexpr int kCell = 4;
constexpr int kTable = 4096;
constexpr double kOpaque = 0.998;       // as the renderer's
constexpr double kShadedFrom = 0.0005;  // as the renderer's: less opacity than this is not worth a gradient

/// What the rays need to know of a volume.
struct Field {
  const Volume* volume = nullptr;
  double low = 0, high = 1;      ///< Values of the table's ends.
  std::vector<double> sigma;     ///< 1/mm
  std::vector<int> opaqueBelow;  ///< How many entries below this one are not empty.
  glm::ivec3 cells{0};
  std::vector<char> isFull;  ///< By cell.

  double entryOf(double value) const { return std::clamp((value - low) / (high - low), 0.0, 1.0) * (kTable - 1); }
  bool cellIsFull(glm::dvec3 voxel) const {
    glm::ivec3 c = glm::clamp(glm::ivec3(voxel + 0.5) / kCell, glm::ivec3(0), cells - 1);
    return isFull[(std::size_t(c.z) * std::size_t(cells.y) + std::size_t(c.y)) * std::size_t(cells.x) +
                  std::size_t(c.x)] != 0;
  }
};

Field makeField(const scene::Scene& scene) {
  Field field;
  field.volume = scene.volume.data.operator->();
  const Volume& volume = *field.volume;
  const auto& transfer = scene.volume.transfer;
  field.low = volume.range.x;
  field.high = std::max(volume.range.y, volume.range.x + 1e-9);
  field.opaqueBelow.push_back(0);
  for (int i = 0; i < kTable; ++i) {
    double opacity = scene::opacityAt(transfer.opacities, glm::mix(field.low, field.high, double(i) / (kTable - 1)));
    field.sigma.push_back(-std::log(1.0 - std::min(opacity, 0.999)) / transfer.unitDistance);
    field.opaqueBelow.push_back(field.opaqueBelow.back() + (opacity > 0 ? 1 : 0));
  }
  field.cells = (volume.dims + kCell - 1) / kCell;
  field.isFull.assign(std::size_t(field.cells.x) * std::size_t(field.cells.y) * std::size_t(field.cells.z), 0);
  parallelFor(0, field.cells.z, [&](int cz) {
    for (int cy = 0; cy < field.cells.y; ++cy)
      for (int cx = 0; cx < field.cells.x; ++cx) {
        glm::ivec3 from = glm::max(glm::ivec3(cx, cy, cz) * kCell - 1, glm::ivec3(0));
        glm::ivec3 to = glm::min(glm::ivec3(cx, cy, cz) * kCell + kCell + 1, volume.dims);
        double low = 1e300, high = -1e300;
        for (int z = from.z; z < to.z; ++z)
          for (int y = from.y; y < to.y; ++y)
            for (int x = from.x; x < to.x; ++x) {
              double value = valueAt(volume, {x, y, z});
              low = std::min(low, value), high = std::max(high, value);
            }
        int a = int(field.entryOf(low)), b = std::min(kTable - 1, int(field.entryOf(high)) + 1);
        field.isFull[(std::size_t(cz) * std::size_t(field.cells.y) + std::size_t(cy)) * std::size_t(field.cells.x) +
                     std::size_t(cx)] = field.opaqueBelow[std::size_t(b) + 1] > field.opaqueBelow[std::size_t(a)];
      }
  });
  return field;
}

/// The value of the nearest voxel: near enough for counting.
double nearest(const Volume& volume, glm::dvec3 voxel) {
  return valueAt(volume, glm::clamp(glm::ivec3(voxel + 0.5), glm::ivec3(0), volume.dims - 1));
}

/// Follows one ray. Positions in voxels. @param perLength  voxels a millimetre along the ray
void countRay(const Field& field, glm::dvec3 origin, glm::dvec3 perLength, double step, FetchCount& count) {
  glm::dvec3 a = (-0.5 - origin) / perLength, b = (glm::dvec3(field.volume->dims) - 0.5 - origin) / perLength;
  glm::dvec3 near3 = glm::min(a, b), far3 = glm::max(a, b);
  double t = std::max({near3.x, near3.y, near3.z, 0.0}), end = std::min({far3.x, far3.y, far3.z});
  double left = 1.0;
  for (; t < end && left > 1.0 - kOpaque; t += step) {
    glm::dvec3 voxel = origin + t * perLength;
    if (!field.cellIsFull(voxel)) continue;
    count.samples += 1;
    double alpha = 1.0 - std::exp(-field.sigma[std::size_t(field.entryOf(nearest(*field.volume, voxel)))] * step);
    if (alpha * left > kShadedFrom) count.gradients += 6;
    left *= 1.0 - alpha;
  }
}

}  // namespace

FetchCount countFetches(const scene::Scene& scene, glm::ivec2 size) {
  constexpr int kStride = 4;  // of pixels, along both sides
  Field field = makeField(scene);
  const auto& camera = scene.camera;
  glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
  glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up)), up = glm::cross(right, forward);
  double tall = std::tan(glm::radians(camera.fieldOfViewDeg) * 0.5), wide = tall * size.x / size.y;
  glm::dmat4 voxelFromWorld = glm::inverse(field.volume->worldFromVoxel);
  glm::dvec3 spacing = spacingOf(*field.volume), eye(voxelFromWorld * glm::dvec4(camera.eye, 1.0));
  double step = scene.rayCast.stepVoxels * std::min({spacing.x, spacing.y, spacing.z});
  auto countRows = [&](int first, int end) {
    FetchCount count;
    for (int row = first; row < end; ++row)
      for (int x = 0; x < size.x; x += kStride) {
        glm::dvec2 at = glm::dvec2(2, -2) * (glm::dvec2(x, row * kStride) + 0.5) / glm::dvec2(size) + glm::dvec2(-1, 1);
        glm::dvec3 direction = glm::normalize(forward + at.x * wide * right + at.y * tall * up);
        countRay(field, eye, glm::dvec3(voxelFromWorld * glm::dvec4(direction, 0.0)) + 1e-12, step, count);
      }
    return count;
  };
  FetchCount total = parallelReduce(0, size.y / kStride, 1, FetchCount{}, countRows, [](FetchCount a, FetchCount b) {
    return FetchCount{a.samples + b.samples, a.gradients + b.gradients};
  });
  constexpr double kMillions = kStride * kStride * 1e-6;
  return {total.samples * kMillions, total.gradients * kMillions};
}

}  // namespace velum::bench
