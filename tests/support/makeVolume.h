#pragma once
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "core/LabelVolume.h"
#include "core/Volume.h"

/// Small volumes made by a function, for tests.
namespace velum {

/// Voxels with the given spacing (negative: that axis runs backwards), turned about an oblique axis, whose middle is at
/// `centre`.
inline glm::dmat4 centredFrame(glm::ivec3 dims, glm::dvec3 spacing = glm::dvec3(1.0), double turnRad = 0.0,
                               glm::dvec3 centre = glm::dvec3(0.0)) {
  glm::dmat4 m = glm::translate(glm::dmat4(1.0), centre);
  if (turnRad != 0.0) m = glm::rotate(m, turnRad, glm::normalize(glm::dvec3(1.0, 2.0, -0.5)));
  m = glm::scale(m, spacing);
  return glm::translate(m, -0.5 * (glm::dvec3(dims) - 1.0));
}

/// A volume whose values are `valueOf(glm::ivec3 voxel)`: raw = (value - offset) / scale, rounded for whole numbers.
template <class ValueOf>
Volume makeVolume(glm::ivec3 dims, SampleType type, ValueOf valueOf, const glm::dmat4& worldFromVoxel = glm::dmat4(1.0),
                  double scale = 1.0, double offset = 0.0) {
  Volume v;
  v.dims = dims;
  v.type = type;
  v.scale = scale;
  v.offset = offset;
  v.worldFromVoxel = worldFromVoxel;
  v.voxels.resize(timeStepBytes(v));
  visitSamples(v, [&](auto* samples) {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(samples)>>;
    auto* out = const_cast<T*>(samples);
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) {
          double raw = (double(valueOf(glm::ivec3(x, y, z))) - offset) / scale;
          *out++ = std::is_integral_v<T> ? T(std::lround(raw)) : T(raw);
        }
  });
  computeRange(v);
  return v;
}

/// Labels whose ids are `idOf(glm::ivec3 voxel)`, with a table of the ids in use.
template <class IdOf>
LabelVolume makeLabels(glm::ivec3 dims, IdOf idOf, const glm::dmat4& worldFromVoxel = glm::dmat4(1.0)) {
  LabelVolume labels(dims, worldFromVoxel);
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ids.push_back(std::uint16_t(idOf(glm::ivec3(x, y, z))));
  labels.write({0, 0, 0}, dims, ids);
  for (auto id : labels.idsInUse())
    labels.table.push_back({id, "structure " + std::to_string(id), defaultLabelColor(id), 1.0f});
  return labels;
}

/// 0..1, the same for the same voxel and seed.
inline double hashNoise(glm::ivec3 v, std::uint32_t seed = 1) {
  std::uint32_t h = std::uint32_t(v.x) * 73856093u ^ std::uint32_t(v.y) * 19349663u ^ std::uint32_t(v.z) * 83492791u ^
                    seed * 2654435761u;
  h ^= h >> 16, h *= 2246822519u, h ^= h >> 13, h *= 3266489917u, h ^= h >> 16;
  return double(h) / 4294967295.0;
}

}  // namespace velum
