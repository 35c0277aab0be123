#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/phantoms/Sample.h"

/// What laws of phantoms ask of their parts.
namespace velum {

constexpr int kSize = 96;

inline io::Sample make(std::string_view name, int size = kSize) {
  Progress progress;
  return io::makeSample(name, size, progress);
}

/// Each phantom is made once for all cases.
inline const io::Sample& cached(const std::string& name) {
  static std::map<std::string, io::Sample> made;
  auto found = made.find(name);
  if (found == made.end()) found = made.emplace(name, make(name)).first;
  return found->second;
}

inline std::vector<std::uint16_t> idsOf(const LabelVolume& labels) {
  glm::ivec3 dims = labels.dims();
  std::vector<std::uint16_t> ids(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
  labels.read(glm::ivec3(0), dims, ids);
  return ids;
}

inline std::uint16_t idOf(const io::Sample& sample, std::string_view name) {
  for (const auto& info : sample.labels.table)
    if (info.name == name) return info.id;
  ADD_FAILURE() << "no label " << name;
  return 0;
}

/// Calls body(voxel) for every voxel of a label that is at least `margin` voxels away from other labels.
template <class Body>
void forEachVoxel(const io::Sample& sample, std::uint16_t id, int margin, Body body) {
  glm::ivec3 dims = sample.volume.dims;
  auto isDeep = [&](glm::ivec3 v) {
    for (int z = -margin; z <= margin; ++z)
      for (int y = -margin; y <= margin; ++y)
        for (int x = -margin; x <= margin; ++x)
          if (sample.labels.at(v + glm::ivec3(x, y, z)) != id) return false;
    return true;
  };
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        if (sample.labels.at({x, y, z}) == id && isDeep({x, y, z})) body(glm::ivec3(x, y, z));
}

struct LabelStatistics {
  std::size_t count = 0;
  double mean = 0.0;
  glm::dvec3 centre{0.0};
};

inline LabelStatistics measure(const io::Sample& sample, std::string_view name, int margin = 0) {
  LabelStatistics s;
  forEachVoxel(sample, idOf(sample, name), margin, [&](glm::ivec3 v) {
    ++s.count;
    s.mean += valueAt(sample.volume, v);
    s.centre += glm::dvec3(sample.volume.worldFromVoxel * glm::dvec4(v, 1.0));
  });
  if (s.count) s.mean /= double(s.count), s.centre /= double(s.count);
  return s;
}

/// Over what voxels hang together.
enum class Joint { Faces, FacesEdgesAndCorners };

/// The part of a label that hangs together with its lowest voxel.
inline double connectedPart(const io::Sample& sample, std::string_view name,
                            Joint joint = Joint::FacesEdgesAndCorners) {
  std::uint16_t id = idOf(sample, name);
  glm::ivec3 dims = sample.volume.dims;
  std::vector<std::uint16_t> ids = idsOf(sample.labels);
  auto indexOf = [&](glm::ivec3 v) { return std::size_t((v.z * dims.y + v.y) * dims.x + v.x); };
  auto total = std::count(ids.begin(), ids.end(), id);
  auto root = int(std::find(ids.begin(), ids.end(), id) - ids.begin());
  std::vector<glm::ivec3> open{{root % dims.x, root / dims.x % dims.y, root / dims.x / dims.y}};
  ids[std::size_t(root)] = 0;
  double reached = 0;
  while (!open.empty()) {
    glm::ivec3 v = open.back();
    open.pop_back();
    ++reached;
    for (int n = 0; n < 27; ++n) {
      glm::ivec3 step = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1, w = v + step;
      if (joint == Joint::Faces && std::abs(step.x) + std::abs(step.y) + std::abs(step.z) > 1) continue;
      if (glm::any(glm::lessThan(w, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(w, dims))) continue;
      if (ids[indexOf(w)] != id) continue;
      ids[indexOf(w)] = 0;
      open.push_back(w);
    }
  }
  return reached / double(total);
}

}  // namespace velum
