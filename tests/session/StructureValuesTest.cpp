#include "session/structure/StructureValues.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/Error.h"
#include "makeVolume.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kStructureValuesDims(50, 45, 40);  // more than a brick, and no multiple of one

std::uint16_t idAt(glm::ivec3 p) { return p.x < 10 ? 0 : p.y < 20 ? 3 : p.z < 35 ? 700 : 9; }

Volume scanOf() {
  Volume v = makeVolume(kStructureValuesDims, SampleType::Int16,
                        [](glm::ivec3 p) { return 1000.0 + p.x * 7 - p.y * 3 + p.z; });
  v.scale = 0.5, v.offset = -300.0;
  return v;
}

TEST(StructureValues, AreThoseOfALoopOverAllVoxels) {
  Volume scan = scanOf();
  LabelVolume labels = makeLabels(kStructureValuesDims, idAt, scan.worldFromVoxel);
  Progress progress;
  auto values = measureValues(labels, scan, 0, 0, progress);
  ASSERT_EQ(values.size(), 3u);
  for (int id : {3, 9, 700}) {
    double count = 0, sum = 0, squares = 0, least = 1e9, most = -1e9;
    for (int z = 0; z < kStructureValuesDims.z; ++z)
      for (int y = 0; y < kStructureValuesDims.y; ++y)
        for (int x = 0; x < kStructureValuesDims.x; ++x) {
          if (idAt({x, y, z}) != id) continue;
          double value = valueAt(scan, {x, y, z});
          ++count, sum += value, squares += value * value;
          least = std::min(least, value), most = std::max(most, value);
        }
    const StructureValues& found = values[id];
    EXPECT_EQ(double(found.voxels), count);
    EXPECT_NEAR(found.mean, sum / count, 1e-9);
    EXPECT_NEAR(found.deviation, std::sqrt(squares / count - sum / count * sum / count), 1e-6);
    EXPECT_EQ(found.least, least);
    EXPECT_EQ(found.most, most);
  }
}

TEST(StructureValues, OfLabelsOnAnotherGridAreThoseOfTheScansVoxels) {
  Volume scan = scanOf();
  scan.worldFromVoxel[3] = glm::dvec4(5, -3, 2, 1);
  // Half as fine along each axis, turned round along x.
  glm::dmat4 coarse = glm::dmat4(2.0);
  coarse[0] = glm::dvec4(-2, 0, 0, 0);
  coarse[3] = glm::dvec4(5 + 48.5, -3 + 0.5, 2 + 0.5, 1);
  auto id = [](glm::ivec3 p) { return std::uint16_t(p.x < 5 ? 4 : 0); };  // the ten voxels of the largest x
  LabelVolume labels = makeLabels({25, 23, 20}, id, coarse);
  Progress progress;
  auto values = measureValues(labels, scan, 0, 0, progress);
  ASSERT_EQ(values.size(), 1u);
  EXPECT_EQ(values[4].voxels, 10u * 45 * 40);
  EXPECT_EQ(values[4].most, valueAt(scan, {49, 0, 39}));
  EXPECT_EQ(values[4].least, valueAt(scan, {40, 44, 0}));
}

TEST(StructureValues, LeaveOutWhatIsNoNumberAndKnowTimeAndChannel) {
  Volume scan;
  scan.dims = {4, 3, 2};
  scan.type = SampleType::Float32;
  scan.channels = 2, scan.timeSteps = 2;
  scan.voxels.resize(timeStepBytes(scan) * 2);
  auto* samples = reinterpret_cast<float*>(scan.voxels.data());
  for (int i = 0; i < 4 * 3 * 2 * 2 * 2; ++i) samples[i] = float(i % 2 * 1000 + i / 48 * 100);
  samples[48] = std::numeric_limits<float>::quiet_NaN();
  samples[50] = std::numeric_limits<float>::infinity();
  LabelVolume labels = makeLabels(
      scan.dims, [](glm::ivec3) { return 1; }, scan.worldFromVoxel);
  Progress progress;
  EXPECT_EQ(measureValues(labels, scan, 1, 0, progress)[1].mean, 1000);
  StructureValues second = measureValues(labels, scan, 0, 1, progress)[1];
  EXPECT_EQ(second.voxels, 22u);
  EXPECT_EQ(second.mean, 100);
  EXPECT_EQ(second.deviation, 0);
}

TEST(StructureValues, StopWhenTheyAreTold) {
  Volume scan = scanOf();
  LabelVolume labels = makeLabels(kStructureValuesDims, idAt, scan.worldFromVoxel);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(measureValues(labels, scan, 0, 0, progress), Cancelled);
}

}  // namespace
}  // namespace velum::session
