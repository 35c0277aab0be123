#include <gtest/gtest.h>

#include <span>

#include "TestFiles.h"
#include "core/VoxelSource.h"
#include "io/stores/AxisUnits.h"
#include "io/stores/Crc32c.h"

namespace velum::io {
namespace {

TEST(AxisUnits, AreThoseOfUdunits) {
  EXPECT_NEAR(*millimetresOf("micrometer"), 1e-3, 1e-15);
  EXPECT_NEAR(*millimetresOf("nanometer"), 1e-6, 1e-18);
  EXPECT_NEAR(*millimetresOf("meter"), 1e3, 1e-9);
  EXPECT_NEAR(*millimetresOf("um"), 1e-3, 1e-15);
  EXPECT_NEAR(*millimetresOf("angstrom"), 1e-7, 1e-15);
  EXPECT_FALSE(millimetresOf("second"));
  EXPECT_FALSE(millimetresOf(""));
  EXPECT_NEAR(*secondsPer("millisecond"), 1e-3, 1e-15);
  EXPECT_NEAR(*secondsPer("hour"), 3600, 1e-9);
}

TEST(Crc32c, IsTheSameWithAndWithoutTheInstruction) {
  std::string text = "123456789";
  EXPECT_EQ(crc32c(std::as_bytes(std::span(text))), 0xe3069283u);
  for (std::size_t count = 0; count < 40; ++count) {
    std::string bytes(count, char('a' + count));
    EXPECT_EQ(crc32c(std::as_bytes(std::span(bytes))), crc32cByTable(std::as_bytes(std::span(bytes))));
  }
}

TEST(VoxelSource, AVolumeInMemoryIsASourceOfOneLevel) {
  Volume v = rampVolume(SampleType::Int16, {70, 65, 3}, 2, 2);
  v.worldFromVoxel = obliqueMatrix(false, false);
  VolumeSource source{Shared<Volume>(v)};
  Progress progress;
  Volume again = readLevel(source, 0, progress);
  EXPECT_TRUE(again.voxels == v.voxels);
  EXPECT_EQ(again.worldFromVoxel, v.worldFromVoxel);
  EXPECT_EQ(levelWithin(source, 1e6), 0);
  EXPECT_FALSE(levelWithin(source, 1e3));
}

}  // namespace
}  // namespace velum::io
