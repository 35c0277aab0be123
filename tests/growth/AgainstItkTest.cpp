#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "RandomGrowing.h"
#include "growByItk.h"
#include "growth/RegionGrow.h"
#include "io/volumes/ReadVolume.h"

namespace velum::growth {
namespace {

/// Compares one region voxel by voxel. @return its voxels
std::size_t expectWhatItkGrows(const Shared<Volume>& volume, glm::ivec3 seed, double low, double high) {
  RegionGrow region(volume, LabelVolume(volume->dims, volume->worldFromVoxel), 0, {low, high});
  Progress progress;
  if (valueAt(*volume, seed) >= low && valueAt(*volume, seed) <= high) region.addSeed(seed);
  region.grow({}, progress);
  auto wanted = growByItk(*volume, seed, low, high).voxels;
  std::size_t differ = 0, i = 0;
  for (int z = 0; z < volume->dims.z; ++z)
    for (int y = 0; y < volume->dims.y; ++y)
      for (int x = 0; x < volume->dims.x; ++x) differ += (wanted.at(i++) != 0) != region.has({x, y, z});
  EXPECT_EQ(differ, 0u) << "seed " << seed.x << "," << seed.y << "," << seed.z << ", " << low << " to " << high;
  return region.voxelCount();
}

TEST(AgainstItk, RandomRegionsAreTheSameVoxelForVoxel) {
  std::size_t all = 0;
  const SampleType types[] = {SampleType::UInt8, SampleType::Int16, SampleType::UInt16, SampleType::Float32};
  for (unsigned seed = 0; seed < 60; ++seed) {
    RandomGrowing random(seed);
    Volume v = random.volume(types[seed % 4], random.dims());
    v.scale = 1.0, v.offset = 0.0;  // ITK compares raw samples
    Shared<Volume> volume(std::move(v));
    for (int i = 0; i < 3; ++i) {
      double low = random.whole(20, 70), high = low + random.whole(5, 60);
      all += expectWhatItkGrows(volume, random.voxel(volume->dims), low, high);
    }
  }
  EXPECT_GT(all, 300000u);
}

TEST(AgainstItk, RegionsOfARealScanAreTheSame) {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  if (!folder) GTEST_SKIP() << "VELUM_TEST_DATA names no folder";
  auto path = std::filesystem::path(folder) / "volumes" / "ct_heart_aorta_cta.nii.gz";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  scene::Source source;
  source.path = path.string();
  Progress progress;
  Volume read = io::readVolume(source, progress);
  ASSERT_EQ(read.scale, 1.0);
  ASSERT_EQ(read.offset, 0.0);
  Shared<Volume> volume(std::move(read));
  RandomGrowing random(5);
  std::size_t all = 0;
  for (int i = 0; i < 12; ++i) {
    glm::ivec3 seed = random.voxel(volume->dims);
    double value = valueAt(*volume, seed), width = random.number(50, 400);
    all += expectWhatItkGrows(volume, seed, std::floor(value - width), std::ceil(value + width));
  }
  // Air, soft tissue and bone are there.
  EXPECT_GT(all, 100000u);
}

}  // namespace
}  // namespace velum::growth
