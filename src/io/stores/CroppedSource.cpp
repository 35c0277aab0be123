#include "io/stores/CroppedSource.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "core/Memory.h"

namespace velum::io {

CroppedSource::CroppedSource(std::shared_ptr<const VoxelSource> source, const VoxelBox& box) : mBox(box) {
  VoxelLevel level = source->levels()[std::size_t(box.level)];
  glm::ivec3 end = box.origin + box.size;
  bool isInside = glm::all(glm::greaterThanEqual(box.origin, glm::ivec3(0))) &&
                  glm::all(glm::greaterThan(box.size, glm::ivec3(0))) && glm::all(glm::lessThanEqual(end, level.dims));
  if (!isInside)
    throw ArgumentError(fmt::format(
        "a box from voxel {} {} {} to before {} {} {} does not lie in the {} x {} x {} voxels", box.origin.x,
        box.origin.y, box.origin.z, end.x, end.y, end.z, level.dims.x, level.dims.y, level.dims.z));
  level.worldFromVoxel[3] = level.worldFromVoxel * glm::dvec4(glm::dvec3(box.origin), 1.0);
  level.dims = box.size;
  level.brickSize = glm::min(level.brickSize, level.dims);
  mHead = source->head();
  mHead.voxels.clear();
  mHead.gaps.clear();
  mHead.finer = nullptr;
  mHead.dims = level.dims;
  mHead.worldFromVoxel = level.worldFromVoxel;
  mLevels = {level};
  mChannelWindows = source->channelWindows();
  mBricks = std::make_unique<BrickCache>(std::move(source), std::size_t(brickBudget()));
}

void CroppedSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address), one = box;
  one.channels = one.timeSteps = 1;
  std::size_t sample = sampleSize(mHead.type);
  for (int t = 0; t < box.timeSteps; ++t)
    for (int c = 0; c < box.channels; ++c) {
      Volume part = mBricks->read({mBox.level, mBox.origin + box.origin, box.size}, box.channel + c, box.timeStep + t);
      SampleTarget from{part.voxels.data(), std::ptrdiff_t(sample)}, to = target;
      from.y = from.x * box.size.x, from.z = from.y * box.size.y;
      to.first += c * target.channel + t * target.timeStep;
      copySamples(one, sample, from, to);
    }
}

}  // namespace velum::io
