#include "core/Volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace velum {
namespace {

template <class T>
Volume volumeOf(glm::ivec3 dims, SampleType type, const std::vector<T>& samples) {
  Volume v;
  v.dims = dims;
  v.type = type;
  v.voxels.resize(samples.size() * sizeof(T));
  std::memcpy(v.voxels.data(), samples.data(), v.voxels.size());
  return v;
}

TEST(Volume, RangeLeavesOutWhatIsNotFinite) {
  float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  Volume v = volumeOf<float>({2, 3, 1}, SampleType::Float32, {nan, -2.0f, inf, 7.0f, -inf, 0.0f});
  computeRange(v);
  EXPECT_EQ(v.range, glm::dvec2(-2.0, 7.0));
}

TEST(Volume, RangeOfNothingFiniteIsZero) {
  Volume v = volumeOf<float>({1, 1, 1}, SampleType::Float32, {std::numeric_limits<float>::quiet_NaN()});
  computeRange(v);
  EXPECT_EQ(v.range, glm::dvec2(0.0, 0.0));
}

TEST(Volume, ScaleAndOffsetReachValueRangeAndHistogram) {
  Volume v = volumeOf<std::int16_t>({4, 1, 1}, SampleType::Int16, {0, 1, 2, 3});
  v.scale = -2.0;
  v.offset = 10.0;
  computeRange(v);
  EXPECT_EQ(v.range, glm::dvec2(4.0, 10.0));
  EXPECT_EQ(valueAt(v, {3, 0, 0}), 4.0);
  Histogram h = computeHistogram(v, 4);
  EXPECT_EQ(h.counts.front(), 1u);
  EXPECT_EQ(h.counts.back(), 1u);
}

TEST(Volume, QuantileOfAnEvenRampIsItsFraction) {
  std::vector<std::uint16_t> ramp(10000);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = std::uint16_t(i);
  Volume v = volumeOf<std::uint16_t>({100, 100, 1}, SampleType::UInt16, ramp);
  computeRange(v);
  // A bin of the histogram is 2.5 values wide.
  EXPECT_NEAR(quantile(computeHistogram(v), 0.25), 2500.0, 3.0);
  EXPECT_NEAR(quantile(computeHistogram(v), 0.99), 9900.0, 3.0);
}

TEST(Volume, AQuantileIsTheMiddleOfItsBin) {
  Histogram h{{0, 0, 10, 0}, {0.0, 8.0}};
  for (double fraction : {0.1, 0.5, 1.0}) EXPECT_EQ(quantile(h, fraction), 5.0);
}

/// No two edges are the same, and each sample says where it is.
Volume numbered() {
  glm::ivec3 dims(2, 3, 4);
  std::vector<std::int32_t> samples;
  for (int t = 0; t < 3; ++t)
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x)
          for (int channel = 0; channel < 2; ++channel)
            samples.push_back(10000 * t + 1000 * channel + 100 * z + 10 * y + x);
  Volume v = volumeOf<std::int32_t>(dims, SampleType::Int32, samples);
  v.channels = 2;
  v.timeSteps = 3;
  computeRange(v);
  return v;
}

TEST(Volume, AValueIsThatOfItsVoxelChannelAndTimeStep) {
  Volume v = numbered();
  for (int t = 0; t < 3; ++t)
    for (int channel = 0; channel < 2; ++channel)
      for (glm::ivec3 p : {glm::ivec3(0, 0, 0), {1, 0, 0}, {0, 2, 0}, {0, 0, 3}, {1, 2, 3}})
        EXPECT_EQ(valueAt(v, p, channel, t), 10000 * t + 1000 * channel + 100 * p.z + 10 * p.y + p.x);
  EXPECT_EQ(v.range, glm::dvec2(0, 21321));
}

TEST(Volume, AHistogramCountsOneChannelOfOneTimeStep) {
  Volume v = numbered();
  for (int t = 0; t < 3; ++t)
    for (int channel = 0; channel < 2; ++channel) {
      Histogram h = computeHistogram(v, 21322, channel, t);
      std::uint64_t own = 0, all = 0;
      for (std::size_t i = 0; i < h.counts.size(); ++i) {
        all += h.counts[i];
        int value = int(i);
        if (value / 10000 == t && value / 1000 % 10 == channel) own += h.counts[i];
      }
      EXPECT_EQ(all, 24u);
      EXPECT_EQ(own, 24u) << "channel " << channel << " of step " << t;
    }
}

TEST(Volume, CentreAndRadiusAreThoseOfItsBox) {
  Volume v = numbered();
  v.worldFromVoxel = glm::dmat4(0, 5, 0, 0, -7, 0, 0, 0, 0, 0, 11, 0, 100, 200, 300, 1);
  // Voxel centres lie at integers, so that the box begins half a voxel before the first.
  EXPECT_EQ(centreOf(v), glm::dvec3(100 - 7 * 1.0, 200 + 5 * 0.5, 300 + 11 * 1.5));
  EXPECT_NEAR(radiusOf(v), 0.5 * std::hypot(5.0 * 2, 7.0 * 3, 11.0 * 4), 1e-12);
}

}  // namespace
}  // namespace velum
