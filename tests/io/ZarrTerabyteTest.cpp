// A terabyte of real files, each of them there many times.
#include <gtest/gtest.h>

#include <random>

#include "PeakMemory.h"
#include "RepeatedStore.h"
#include "TempFolder.h"
#include "core/BrickCache.h"
#include "io/volumes/ReadLevel.h"

namespace velum::io {
namespace {

/// Compares a brick with the field. @return whether it is the same
bool isField(const VoxelSource& source, const RepeatedField& field, const BrickAddress& address) {
  BrickBox box = boxOf(source, address);
  std::vector<std::uint16_t> samples(std::size_t(box.size.x) * std::size_t(box.size.y) * std::size_t(box.size.z));
  source.read(address, {reinterpret_cast<std::byte*>(samples.data()), 2, 2 * box.size.x,
                        std::ptrdiff_t(2) * box.size.x * box.size.y});
  const std::uint16_t* sample = samples.data();
  for (int z = 0; z < box.size.z; ++z)
    for (int y = 0; y < box.size.y; ++y)
      for (int x = 0; x < box.size.x; ++x)
        if (*sample++ != field.at(address.level, box.origin + glm::ivec3(x, y, z))) return false;
  return true;
}

TEST(ZarrTerabyte, OpensInLittleMemoryAndHoldsItsFieldEverywhere) {
  TempFolder folder;
  RepeatedField field;
  writeRepeatedStore(folder / "large.ome.zarr", {10240, 10240, 5120}, field);
  Volume volume;
  std::size_t peak = peakGrowth([&] {
    Progress progress;
    scene::Source source;
    source.path = folder / "large.ome.zarr";
    volume = readFitting(openPyramid(source), source, false, progress);
  });
  ASSERT_TRUE(volume.finer);
  const VoxelSource& source = volume.finer->bricks->source();
  EXPECT_GT(levelBytes(source, 0), 1e12);
  EXPECT_LT(peak, std::size_t(300) << 20);
  std::mt19937 random(5);
  for (int level = 0; level < int(source.levels().size()); ++level) {
    glm::ivec3 bricks = bricksOf(source.levels()[std::size_t(level)]);
    for (int i = 0; i < 20; ++i) {
      BrickAddress address{level};
      // The first are the corners, where edges of the volume cut shards.
      for (int axis = 0; axis < 3; ++axis)
        address.brick[axis] = i < 8 ? (i >> axis & 1) * (bricks[axis] - 1) : int(random() % unsigned(bricks[axis]));
      ASSERT_TRUE(isField(source, field, address))
          << level << ": " << address.brick.x << ' ' << address.brick.y << ' ' << address.brick.z;
    }
  }
}

}  // namespace
}  // namespace velum::io
