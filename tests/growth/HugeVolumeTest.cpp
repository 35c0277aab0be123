// A volume of 17 GB that nobody has: what grows in it takes the time and memory of its surroundings.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>

#include "core/BrickCache.h"
#include "core/FinestVoxels.h"
#include "growth/FirstDoubt.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"

namespace velum::growth {
namespace {

constexpr int kHuge = 2048, kCoarser = 16, kHugeBrick = 64;
constexpr double kTubeRadius = 8.0;

/// Where a tube that winds around the x axis is at some x; it ends before the borders.
glm::dvec2 tubeAt(int x) {
  double turn = 2.0 * 2.0 * 3.14159265 * x / kHuge;
  return glm::dvec2(1000.3 + 700.0 * std::cos(turn), 1000.7 + 700.0 * std::sin(turn));
}

bool isInTube(glm::dvec2 middle, int x, int y, int z) {
  glm::dvec2 off = glm::dvec2(y, z) - middle;
  return x > 10 && x < kHuge - 10 && glm::dot(off, off) <= kTubeRadius * kTubeRadius;
}

/// Two levels of bytes, whose bricks are computed as they are asked for.
class TubeSource : public VoxelSource {
 public:
  TubeSource() {
    mHead.dims = glm::ivec3(kHuge);
    mHead.range = {0, 200};
    mLevels.push_back({mHead.dims, glm::ivec3(kHugeBrick), 1, 1, glm::dmat4(1.0)});
    glm::dmat4 coarse(1.0);
    for (int axis = 0; axis < 3; ++axis) coarse[axis][axis] = kCoarser, coarse[3][axis] = 0.5 * (kCoarser - 1);
    mLevels.push_back({mHead.dims / kCoarser, glm::ivec3(kHugeBrick), 1, 1, coarse});
  }
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override {
    ++reads;
    BrickBox box = boxOf(*this, address);
    for (int x = 0; x < box.size.x; ++x) {
      glm::dvec2 middle = tubeAt(box.origin.x + x);
      for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
          target.first[x * target.x + y * target.y + z * target.z] =
              std::byte(isInTube(middle, box.origin.x + x, box.origin.y + y, box.origin.z + z) ? 150 : 20);
    }
  }
  mutable std::atomic<int> reads{0};

 private:
  Volume mHead;
};

Shared<Volume> hugeVolume(const std::shared_ptr<const TubeSource>& source) {
  Volume coarse = source->head();
  coarse.dims = source->levels()[1].dims;
  coarse.worldFromVoxel = source->levels()[1].worldFromVoxel;
  coarse.voxels.assign(voxelCount(coarse), std::byte(20));
  coarse.finer = std::make_shared<FinerLevels>(FinerLevels{std::make_shared<BrickCache>(source, 32u << 20), 1});
  return Shared<Volume>(std::move(coarse));
}

TEST(HugeVolume, AVesselOfItTakesTheBricksThatItGoesThrough) {
  auto source = std::make_shared<TubeSource>();
  Shared<Volume> volume = hugeVolume(source);
  scene::Growth step;
  step.structure = 1;
  step.seeds = {glm::dvec3(20.0, glm::floor(tubeAt(20)))};
  step.low = 100, step.high = 200;
  step.axis = {1, 0, 0};
  step.centre = {19.5, 0, 0};
  step.distance = 3000.0;
  Progress progress;
  Shared<LabelVolume> labels = labelsFor(*volume, {});
  ASSERT_EQ(labels->dims(), glm::ivec3(kHuge));
  Grown grown = Grower().grow(volume, labels, step, {.guard = true, .begun = {}}, progress);
  EXPECT_FALSE(grown.leak);
  std::size_t wanted = 0;
  for (int x = 20; x < kHuge - 10; ++x) {
    glm::dvec2 middle = tubeAt(x);
    for (int z = int(middle.y) - 10; z < int(middle.y) + 11; ++z)
      for (int y = int(middle.x) - 10; y < int(middle.x) + 11; ++y) wanted += isInTube(middle, x, y, z);
  }
  EXPECT_EQ(grown.voxels, wanted);
  EXPECT_GT(source->reads, 200);
  EXPECT_LT(source->reads, 1500) << "of 32768";
  EXPECT_LT(grown.labels->storedBytes(), 100u << 20);
  EXPECT_LE(volume->finer->bricks->bytes(), volume->finer->bricks->mostBytes());
  int reads = source->reads;
  step.distance = firstSlabEnd(*volume, step);
  EXPECT_FALSE(isMostOfItsPlane(*volume, *grown.labels, step));
  EXPECT_FALSE(reachesTheDarkest(*volume, step));
  EXPECT_EQ(source->reads, reads);
}

}  // namespace
}  // namespace velum::growth
