#pragma once
#include <vector>

#include "PyramidSource.h"
#include "core/FinestVoxels.h"
#include "core/LabelVolume.h"

namespace velum::growth {

/// A volume that is streamed, and the same one in memory.
struct Twins {
  std::shared_ptr<PyramidSource> source;
  Shared<Volume> streamed, whole;

  Twins(Volume volume, glm::ivec3 brick, std::size_t cacheBytes = 1u << 28) {
    source = std::make_shared<PyramidSource>(volume, 3, brick);
    streamed = Shared<Volume>(streamedVolume(source, 2, cacheBytes));
    volume.worldFromVoxel = FinestVoxels(*streamed).grid().worldFromVoxel;  // as it is rounded
    whole = Shared<Volume>(std::move(volume));
  }
  glm::dvec3 world(glm::ivec3 voxel) const { return glm::dvec3(whole->worldFromVoxel * glm::dvec4(voxel, 1.0)); }
};

inline std::vector<std::uint16_t> idsOf(const LabelVolume& labels) {
  std::vector<std::uint16_t> ids(std::size_t(labels.dims().x) * std::size_t(labels.dims().y) *
                                 std::size_t(labels.dims().z));
  labels.read(glm::ivec3(0), labels.dims(), ids);
  return ids;
}

}  // namespace velum::growth
