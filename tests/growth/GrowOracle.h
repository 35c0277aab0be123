#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Volume.h"
#include "growth/GrowRule.h"

namespace velum::growth {

/// Growing as it is defined, voxel by voxel with a plain queue.
class GrowOracle {
 public:
  GrowOracle(const Volume& volume, const LabelVolume& labels, int structure, GrowRule rule)
      : mVolume(volume), mRule(std::move(rule)), mOpen(voxelCount(volume)), mRegion(voxelCount(volume)) {
    each([&](glm::ivec3 v) {
      int label = labels.at(v);
      mRegion[index(v)] = structure != 0 && label == structure;
      mOpen[index(v)] = label == mRule.within && mayJoin(v);
    });
  }

  /// @param axis  zero: everywhere
  void step(const std::vector<glm::ivec3>& seeds, glm::dvec3 centre, glm::dvec3 axis, double distance) {
    std::vector<glm::ivec3> queue;
    each([&](glm::ivec3 v) {
      if (mRegion[index(v)]) queue.push_back(v);
    });
    for (auto seed : seeds) {
      if (!inside(seed)) continue;
      mRegion[index(seed)] |= mOpen[index(seed)];
      queue.push_back(seed);
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
      for (int axisOf = 0; axisOf < 3; ++axisOf)
        for (int side : {-1, 1}) {
          glm::ivec3 next = queue[i];
          next[axisOf] += side;
          if (!inside(next) || mRegion[index(next)] || !mOpen[index(next)]) continue;
          if (!isWithin(next, centre, axis, distance)) continue;
          mRegion[index(next)] = 1;
          queue.push_back(next);
        }
  }

  bool has(glm::ivec3 v) const { return mRegion[index(v)]; }
  std::size_t count() const {
    std::size_t count = 0;
    for (auto is : mRegion) count += is;
    return count;
  }
  template <class Body>
  void each(const Body& body) const {
    for (int z = 0; z < mVolume.dims.z; ++z)
      for (int y = 0; y < mVolume.dims.y; ++y)
        for (int x = 0; x < mVolume.dims.x; ++x) body(glm::ivec3(x, y, z));
  }

 private:
  bool inside(glm::ivec3 v) const {
    return glm::all(glm::greaterThanEqual(v, glm::ivec3(0))) && glm::all(glm::lessThan(v, mVolume.dims));
  }
  std::size_t index(glm::ivec3 v) const {
    return (std::size_t(v.z) * std::size_t(mVolume.dims.y) + std::size_t(v.y)) * std::size_t(mVolume.dims.x) +
           std::size_t(v.x);
  }
  glm::dvec3 world(glm::ivec3 v) const { return glm::dvec3(mVolume.worldFromVoxel * glm::dvec4(v, 1.0)); }
  bool isWithin(glm::ivec3 v, glm::dvec3 centre, glm::dvec3 axis, double distance) const {
    if (axis == glm::dvec3(0.0)) return true;
    double depth = glm::dot(world(v) - centre, axis / glm::length(axis));
    return depth > 0.0 && depth <= distance;
  }
  bool mayJoin(glm::ivec3 v) const {
    double value = valueAt(mVolume, v, mRule.channel, mRule.timeStep);
    if (!(value >= mRule.low && value <= mRule.high)) return false;
    if (std::isfinite(mRule.steepest) && !(slope(v) < mRule.steepest)) return false;
    for (const auto& barrier : mRule.barriers)
      for (std::size_t i = 0; i < barrier.path.size(); ++i) {
        glm::dvec3 a = barrier.path[i], b = barrier.path[i + 1 < barrier.path.size() ? i + 1 : i], p = world(v);
        double t = a == b ? 0.0 : glm::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
        if (glm::distance(p, glm::mix(a, b, t)) <= barrier.radius) return false;
      }
    return true;
  }
  /// Along the world's axes: voxel axes are turned, so the slope is solved for from three differences.
  double slope(glm::ivec3 v) const {
    glm::dmat3 steps(1.0);
    glm::dvec3 rises(0.0);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 a = v, b = v;
      if (a[axis] > 0) --a[axis];
      if (b[axis] + 1 < mVolume.dims[axis]) ++b[axis];
      steps[axis] = a == b ? glm::dvec3(mVolume.worldFromVoxel[axis]) : world(b) - world(a);
      rises[axis] =
          valueAt(mVolume, b, mRule.channel, mRule.timeStep) - valueAt(mVolume, a, mRule.channel, mRule.timeStep);
    }
    return glm::length(glm::inverse(glm::transpose(steps)) * rises);
  }

  const Volume& mVolume;
  GrowRule mRule;
  std::vector<std::uint8_t> mOpen, mRegion;
};

}  // namespace velum::growth
