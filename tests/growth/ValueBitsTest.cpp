#include "growth/ValueBits.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "RandomGrowing.h"

namespace velum::growth {
namespace {

constexpr SampleType kTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                                 SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};

void expectWhatValuesSay(const Volume& v, double low, double high, int channel, int timeStep) {
  FinestVoxels voxels(v);
  ValueBits values(v, low, high, channel, timeStep);
  std::vector<Word> bits(std::size_t(wordsOf(v.dims.x)), ~Word(0));
  for (int z = 0; z < v.dims.z; ++z)
    for (int y = 0; y < v.dims.y; ++y) {
      values.of(voxels, y, z, {0, int(bits.size())}, bits.data());
      for (int x = 0; x < v.dims.x; ++x) {
        double value = valueAt(v, {x, y, z}, channel, timeStep);
        ASSERT_EQ(bitAt(bits.data(), x), value >= low && value <= high) << value << " in " << low << " to " << high;
      }
      ASSERT_EQ(bits.back() & ~spanBits(wordsOf(v.dims.x) - 1, 0, v.dims.x), 0u) << "nothing behind the row's end";
    }
}

TEST(ValueBits, AreExactlyWhatValuesSay) {
  RandomGrowing random(1);
  for (int i = 0; i < 400; ++i) {
    Volume v;
    v.dims = {random.whole(1, 140), 3, 2};
    v.type = kTypes[i % 8];
    v.channels = random.whole(1, 3);
    v.timeSteps = random.whole(1, 2);
    const double scales[] = {1.0, -1.0, 0.1, 1.0 / 3.0, -2.7, 1e-7, 3e5};
    v.scale = scales[random.whole(0, 6)];
    v.offset = random.whole(0, 1) ? random.number(-1000, 1000) : -1024.0;
    v.voxels.resize(timeStepBytes(v) * std::size_t(v.timeSteps));
    // Any bytes: all whole numbers, and floats of all sizes, infinite ones and NaN among them.
    for (auto& byte : v.voxels) byte = std::byte(random.whole(0, 255));
    int channel = random.whole(0, v.channels - 1), timeStep = random.whole(0, v.timeSteps - 1);
    // Ends that are values of voxels are where rounding would show.
    double a = valueAt(v, random.voxel(v.dims), channel, timeStep);
    double b = valueAt(v, random.voxel(v.dims), channel, timeStep);
    expectWhatValuesSay(v, std::min(a, b), std::max(a, b), channel, timeStep);
    expectWhatValuesSay(v, std::nextafter(std::min(a, b), 1e308), std::max(a, b), channel, timeStep);
    expectWhatValuesSay(v, std::max(a, b), std::min(a, b), channel, timeStep);
    double infinity = std::numeric_limits<double>::infinity();
    expectWhatValuesSay(v, -infinity, infinity, channel, timeStep);
    expectWhatValuesSay(v, a, infinity, channel, timeStep);
  }
}

TEST(RowBits, RunsAreFilledFromAnyOfTheirBits) {
  RandomGrowing random(2);
  for (int i = 0; i < 20000; ++i) {
    auto draw = [&] { return Word(random.whole(0, 0x7fffffff)) << 33 ^ Word(random.whole(0, 0x7fffffff)) << 11; };
    Word open = draw() | draw() | (i % 2 ? draw() : 0), from = open & draw() & draw() & draw();
    bool enters = random.whole(0, 1);
    Word carry = enters, up = fillUp(open, from, carry), both = fillDown(open, up);
    // Bit by bit.
    Word wanted = from | (enters ? open & 1 : 0);
    for (int k = 1; k < 64; ++k) wanted |= (wanted >> (k - 1) & 1) << k & open;
    EXPECT_EQ(carry, wanted >> 63 & open >> 63);
    for (int k = 62; k >= 0; --k) wanted |= (wanted >> (k + 1) & 1) << k & open;
    ASSERT_EQ(both, wanted);
    ASSERT_EQ(countBits(open), std::popcount(open));
  }
}

}  // namespace
}  // namespace velum::growth
