#include "session/measure/Values.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "core/FinestVoxels.h"
#include "core/Parallel.h"
#include "render/kept/KeptPlaces.h"
#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/measure/ValueBetween.h"
#include "session/structure/ValueSum.h"

namespace velum::session {

namespace {

constexpr int kCube = 64;  // voxels along an edge of what is read at a time
constexpr int kMostOnLine = 20000;

/// A box of voxels, the last ones not included.
struct VoxelRange {
  glm::ivec3 low{0}, high{0};
};

/// The volume of a scene as it is shown.
struct ShownVolume {
  FinestVoxels voxels;
  int channel, timeStep;
  glm::dmat4 worldFromVoxel, voxelFromWorld;

  explicit ShownVolume(const scene::Scene& scene)
      : voxels(*scene.volume.data),
        channel(scene::shownChannel(scene.volume)),
        timeStep(scene::shownTimeStep(scene.volume)),
        worldFromVoxel(voxels.grid().worldFromVoxel),
        voxelFromWorld(glm::inverse(worldFromVoxel)) {}
  glm::ivec3 dims() const { return voxels.grid().dims; }
  glm::dvec3 worldOf(glm::dvec3 voxel) const { return glm::dvec3(worldFromVoxel * glm::dvec4(voxel, 1.0)); }
  glm::dvec3 voxelOf(glm::dvec3 world) const { return glm::dvec3(voxelFromWorld * glm::dvec4(world, 1.0)); }
  bool holds(glm::dvec3 voxel) const {
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(-0.5))) &&
           glm::all(glm::lessThanEqual(voxel, glm::dvec3(dims()) - 0.5));
  }
  /// The voxels of a box of voxel space that the volume has.
  VoxelRange rangeOf(glm::dvec3 low, glm::dvec3 high) const {
    glm::dvec3 end(dims());
    return {glm::ivec3(glm::clamp(glm::ceil(low - 1e-9), glm::dvec3(0.0), end)),
            glm::ivec3(glm::clamp(glm::floor(high + 1e-9) + 1.0, glm::dvec3(0.0), end))};
  }
};

using IsIn = std::function<bool(glm::ivec3 voxel)>;

ValueSum sumOfCube(const ShownVolume& volume, VoxelRange cube, const IsIn& isIn) {
  ValueSum sum;
  Volume part;
  glm::ivec3 v;
  for (v.z = cube.low.z; v.z < cube.high.z; ++v.z)
    for (v.y = cube.low.y; v.y < cube.high.y; ++v.y)
      for (v.x = cube.low.x; v.x < cube.high.x; ++v.x) {
        if (!isIn(v)) continue;
        // Cubes without any such voxel are not read.
        if (part.voxels.empty())
          part = volume.voxels.read(cube.low, cube.high - cube.low, volume.channel, volume.timeStep);
        if (double value = valueAt(part, v - cube.low); std::isfinite(value)) sum.add(value);
      }
  return sum;
}

/// @param isIn  any thread
StructureValues valuesOfVoxels(const ShownVolume& volume, VoxelRange range, const IsIn& isIn, Progress& progress) {
  glm::ivec3 size = glm::max(range.high - range.low, glm::ivec3(0)), cubes = (size + kCube - 1) / kCube;
  ValueSum all;
  auto joined = [](ValueSum a, const ValueSum& b) {
    a.join(b);
    return a;
  };
  for (int z = 0; z < cubes.z; ++z) {
    progress.report(double(z) / cubes.z, "Measuring values");
    auto body = [&](int first, int end) {
      ValueSum sum;
      for (int i = first; i < end; ++i) {
        progress.throwIfCancelled();
        glm::ivec3 low = range.low + kCube * glm::ivec3(i % cubes.x, i / cubes.x, z);
        sum.join(sumOfCube(volume, {low, glm::min(low + kCube, range.high)}, isIn));
      }
      return sum;
    };
    all.join(parallelReduce(0, cubes.x * cubes.y, 1, ValueSum(), body, joined));
  }
  return all.voxels > 0 ? valuesOf(all) : StructureValues();
}

/// The values of samples that lie near each other.
void readSamples(const ShownVolume& volume, std::vector<ProfileSample>& samples, std::size_t first, std::size_t end) {
  glm::dvec3 low(1e300), high(-1e300);
  for (std::size_t i = first; i < end; ++i) {
    glm::dvec3 at = volume.voxelOf(samples[i].place);
    if (!volume.holds(at)) continue;
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  if (low.x > high.x) return;
  glm::ivec3 from(glm::max(glm::floor(low), glm::dvec3(0.0)));
  glm::ivec3 to = glm::min(glm::ivec3(glm::floor(high)) + 2, volume.dims());
  from = glm::min(from, volume.dims() - 1);
  Volume part = volume.voxels.read(from, to - from, volume.channel, volume.timeStep);
  for (std::size_t i = first; i < end; ++i) {
    glm::dvec3 at = volume.voxelOf(samples[i].place);
    if (volume.holds(at)) samples[i].value = valueBetween(part, at - glm::dvec3(from));
  }
}

}  // namespace

StructureValues valuesInBall(const scene::Scene& scene, glm::dvec3 middle, double radius, glm::dvec3 normal,
                             Progress& progress) {
  ShownVolume volume(scene);
  glm::dvec3 at = volume.voxelOf(middle);
  // The box about a ball: along each axis of voxels as far as the row of the inverse is long.
  glm::dmat3 rows = glm::transpose(glm::dmat3(volume.voxelFromWorld));
  glm::dvec3 reach = radius * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  // A circle is as thick as a voxel is across it.
  bool isFlat = glm::length(normal) > 0.0;
  glm::dvec3 across = isFlat ? glm::normalize(normal) : glm::dvec3(0.0);
  glm::dmat3 edges = glm::inverse(glm::dmat3(volume.voxelFromWorld));
  double half = 0.5 * (std::abs(glm::dot(edges[0], across)) + std::abs(glm::dot(edges[1], across)) +
                       std::abs(glm::dot(edges[2], across)));
  auto isIn = [&](glm::ivec3 voxel) {
    glm::dvec3 way = volume.worldOf(voxel) - middle;
    double height = glm::dot(way, across);
    if (isFlat && (height <= -half * (1.0 - 1e-9) || height > half * (1.0 + 1e-9))) return false;
    return glm::length(way - height * across) <= radius * (1.0 + 1e-9);
  };
  StructureValues values = valuesOfVoxels(volume, volume.rangeOf(at - reach, at + reach), isIn, progress);
  if (values.voxels > 0 || !volume.holds(at)) return values;
  glm::ivec3 nearest(glm::clamp(glm::round(at), glm::dvec3(0.0), glm::dvec3(volume.dims()) - 1.0));
  return valuesOfVoxels(
      volume, {nearest, nearest + 1}, [](glm::ivec3) { return true; }, progress);
}

StructureValues valuesInBox(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress) {
  ShownVolume volume(scene);
  glm::dvec3 low = volume.voxelOf(a), high = volume.voxelOf(b), middle = 0.5 * (low + high);
  if (glm::dvec3 least = glm::min(low, high); true) high = glm::max(low, high), low = least;
  for (int i = 0; i < 3; ++i)
    if (std::floor(high[i] + 1e-9) < std::ceil(low[i] - 1e-9)) low[i] = high[i] = std::round(middle[i]);
  return valuesOfVoxels(
      volume, volume.rangeOf(low, high), [](glm::ivec3) { return true; }, progress);
}

StructureValues valuesLeft(const scene::Scene& scene, int structure, glm::ivec3 first, glm::ivec3 last,
                           Progress& progress) {
  ShownVolume volume(scene);
  const LabelVolume& labels = *scene.labels.data;
  glm::dmat4 voxelFromLabel = volume.voxelFromWorld * labels.worldFromVoxel();
  glm::dmat4 labelFromVoxel = glm::inverse(voxelFromLabel);
  glm::dvec3 low(1e300), high(-1e300);
  for (int i = 0; i < 8; ++i) {
    glm::ivec3 corner(i & 1, i >> 1 & 1, i >> 2);
    glm::dvec3 at = glm::mix(glm::dvec3(first) - 0.5, glm::dvec3(last) + 0.5, glm::dvec3(corner));
    glm::dvec3 voxel(voxelFromLabel * glm::dvec4(at, 1.0));
    low = glm::min(low, voxel);
    high = glm::max(high, voxel);
  }
  render::KeptPlaces kept(scene, volume.worldOf(0.5 * (low + high)));
  auto isIn = [&](glm::ivec3 voxel) {
    glm::ivec3 label(glm::floor(glm::dvec3(labelFromVoxel * glm::dvec4(voxel, 1.0)) + 0.5));
    if (labels.at(label) != structure) return false;
    return kept.isEmpty() || kept.keeps(volume.worldOf(voxel), std::uint16_t(structure));
  };
  return valuesOfVoxels(volume, volume.rangeOf(low, high), isIn, progress);
}

std::vector<ProfileSample> profileAlong(const scene::Scene& scene, glm::dvec3 a, glm::dvec3 b, Progress& progress) {
  constexpr std::size_t kAtOnce = 32;
  ShownVolume volume(scene);
  double length = glm::distance(a, b), step = 0.5 * smallestSpacing(volume.worldFromVoxel);
  auto steps = std::size_t(std::clamp(std::ceil(length / step), 1.0, double(kMostOnLine)));
  std::vector<ProfileSample> samples(steps + 1);
  for (std::size_t i = 0; i <= steps; ++i) {
    double share = double(i) / double(steps);
    samples[i] = {share * length, glm::mix(a, b, share), std::numeric_limits<double>::quiet_NaN()};
  }
  parallelFor(std::size_t(0), (samples.size() + kAtOnce - 1) / kAtOnce, [&](std::size_t part) {
    progress.throwIfCancelled();
    readSamples(volume, samples, part * kAtOnce, std::min((part + 1) * kAtOnce, samples.size()));
  });
  return samples;
}

}  // namespace velum::session
