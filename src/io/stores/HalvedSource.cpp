#include "io/stores/HalvedSource.h"

#include "io/stores/ReadBox.h"
#include "io/stores/ReduceBlocks.h"

namespace velum::io {

HalvedSource::HalvedSource(const VoxelSource& finer, int level) : mFiner(finer), mLevel(level) {
  const VoxelLevel& from = finer.levels()[std::size_t(level)];
  glm::dmat4 finerFromHalved(1.0);
  for (int axis = 0; axis < 3; ++axis) finerFromHalved[axis][axis] = 2.0, finerFromHalved[3][axis] = 0.5;
  VoxelLevel halved;
  halved.dims = (from.dims + 1) / 2;
  halved.brickSize = from.brickSize;
  halved.worldFromVoxel = from.worldFromVoxel * finerFromHalved;
  mLevels = {halved};
  mHead.dims = halved.dims;
  mHead.type = finer.head().type;
  mHead.worldFromVoxel = halved.worldFromVoxel;
  mHead.lengthUnit = finer.head().lengthUnit;
  mHead.scale = finer.head().scale;
  mHead.offset = finer.head().offset;
}

template <class Body>
void HalvedSource::forFiner(glm::ivec3 brick, const Body& body) const {
  glm::ivec3 grid = bricksOf(mFiner.levels()[std::size_t(mLevel)]);
  for (int i = 0; i < 8; ++i) {
    BrickAddress address{mLevel, 2 * brick + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), 0, 0};
    if (glm::all(glm::lessThan(address.brick, grid))) body(address);
  }
}

void HalvedSource::read(const BrickAddress& address, const SampleTarget& target) const {
  BrickBox box = boxOf(*this, address), fine;
  fine.origin = 2 * box.origin;
  fine.size = glm::min(2 * box.size, mFiner.levels()[std::size_t(mLevel)].dims - fine.origin);
  Bytes ids(bytesOf(fine, mHead.type)), halved(bytesOf(box, mHead.type)), brick;
  SampleTarget all = targetIn(ids.data(), fine, mHead.type);
  forFiner(address.brick, [&](const BrickAddress& from) {
    BrickBox there = boxOf(mFiner, from), first = there;
    brick.resize(bytesOf(there, mHead.type));
    SampleTarget samples = targetIn(brick.data(), there, mHead.type), to = all;
    mFiner.read(from, samples);
    first.channels = first.timeSteps = 1;
    glm::ivec3 at = there.origin - fine.origin;
    to.first += at.x * all.x + at.y * all.y + at.z * all.z;
    copySamples(first, sampleSize(mHead.type), samples, to);
  });
  reduceBlocks(mHead.type, Reduction::Majority, ids.data(), fine.size, box.size, glm::ivec3(2), halved.data());
  copySamples(box, sampleSize(mHead.type), targetIn(halved.data(), box, mHead.type), target);
}

std::optional<glm::dvec2> HalvedSource::range(const BrickAddress& address) const {
  bool isZero = true;
  forFiner(address.brick, [&](const BrickAddress& from) { isZero = isZero && mFiner.range(from) == glm::dvec2(0.0); });
  return isZero ? std::optional(glm::dvec2(0.0)) : std::nullopt;
}

}  // namespace velum::io
