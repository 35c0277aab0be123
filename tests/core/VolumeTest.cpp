#include "velum/core/Volume.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace velum
