// MRC maps as other programs write them, byte by byte.
#include <algorithm>
#include <limits>

#include "TestFiles.h"

namespace velum::io {
namespace {

/// A map of 2 x 3 x 4 in one mode, in the byte order asked for.
struct Map {
  bool bigEndian = false;
  std::string bytes = std::string(1024, '\0');

  template <class T>
  void put(std::size_t at, T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (bigEndian) std::reverse(raw, raw + sizeof(T));
    if (bytes.size() < at + sizeof(T)) bytes.resize(at + sizeof(T));
    std::copy(raw, raw + sizeof(T), bytes.begin() + std::ptrdiff_t(at));
  }
  explicit Map(int mode, bool isBigEndian = false) : bigEndian(isBigEndian) {
    int ints[] = {2, 3, 4, mode, 0, 0, 0, 2, 3, 4};
    for (std::size_t i = 0; i < 10; ++i) put(4 * i, std::int32_t(ints[i]));
    float cell[] = {4.0f, 9.0f, 20.0f};
    for (std::size_t i = 0; i < 3; ++i) put(40 + 4 * i, cell[i]);
    for (std::size_t i = 0; i < 3; ++i) put(64 + 4 * i, std::int32_t(i + 1));
    bytes.replace(208, 4, "MAP ");
    bytes[212] = bytes[213] = isBigEndian ? '\x11' : '\x44';
  }
  /// Voxel i, x fastest, holds `first + step * i`.
  template <class T>
  Map& fill(double first, double step) {
    std::size_t at = bytes.size();
    for (int i = 0; i < 24; ++i) put(at + std::size_t(i) * sizeof(T), T(first + step * i));
    return *this;
  }
  Volume read(const std::string& name = "a.mrc") const {
    TempFolder folder;
    writeText(folder / name, bytes);
    return io::read(folder / name);
  }
};

template <class T>
void expectMode(int mode, SampleType type, double first, double step) {
  for (bool bigEndian : {false, true}) {
    SCOPED_TRACE("mode " + std::to_string(mode) + (bigEndian ? ", big endian" : ""));
    Volume v = Map(mode, bigEndian).fill<T>(first, step).read();
    EXPECT_EQ(v.type, type);
    ASSERT_EQ(v.dims, glm::ivec3(2, 3, 4));
    EXPECT_EQ(valueAt(v, {0, 0, 0}), first);
    EXPECT_EQ(valueAt(v, {1, 0, 0}), first + step);
    EXPECT_EQ(valueAt(v, {0, 1, 0}), first + 2 * step);
    EXPECT_EQ(valueAt(v, {1, 2, 3}), first + 23 * step);
  }
}

TEST(Mrc, EveryModeInBothByteOrders) {
  expectMode<std::int8_t>(0, SampleType::Int8, -60, 5);
  expectMode<std::int16_t>(1, SampleType::Int16, -3000, 257);
  expectMode<float>(2, SampleType::Float32, -1.5, 0.25);
  expectMode<std::uint16_t>(6, SampleType::UInt16, 40000, 1001);
}

TEST(Mrc, BytesOfImodAreUnsignedUnlessItSaysNot) {
  for (bool isSigned : {false, true}) {
    Map map(0);
    map.put(152, std::int32_t(1146047817));
    map.put(156, std::int32_t(isSigned ? 1 : 0));
    Volume v = map.fill<std::uint8_t>(200, 1).read();
    EXPECT_EQ(valueAt(v, {0, 0, 0}), isSigned ? -56 : 200);
  }
}

TEST(Mrc, AWrongStampIsOverruledByTheOrderOfTheAxes) {
  Map map(1);
  map.bytes[212] = map.bytes[213] = '\x11';
  EXPECT_EQ(valueAt(map.fill<std::int16_t>(5, 100).read(), {1, 0, 0}), 105);
}

TEST(Mrc, TheExtendedHeaderIsSkippedAndAMapMayBeGzipped) {
  Map map(1);
  map.put(92, std::int32_t(160));
  map.bytes.resize(1024 + 160, '\x7f');
  map.fill<std::int16_t>(-7, 3);
  EXPECT_EQ(valueAt(map.read(), {1, 0, 0}), -4);
  TempFolder folder;
  writeGzip(folder / "a.mrc.gz", map.bytes);
  EXPECT_EQ(valueAt(read(folder / "a.mrc.gz"), {1, 0, 0}), -4);
}

TEST(Mrc, CellOriginAndOrderOfTheAxesGiveThePlace) {
  Map map(1);
  for (std::size_t i = 0; i < 3; ++i) map.put(196 + 4 * i, float(10 * (i + 1)));
  Volume v = Map(map).fill<std::int16_t>(0, 1).read();
  EXPECT_EQ(spacingOf(v), glm::dvec3(2, 3, 5));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_TRUE(v.isSpacingKnown);
  EXPECT_FALSE(v.isOrientationKnown);
  // Columns along y, rows along z, sections along x.
  for (std::size_t i = 0; i < 3; ++i) map.put(64 + 4 * i, std::int32_t((i + 1) % 3 + 1));
  v = map.fill<std::int16_t>(0, 1).read();
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0, 3, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[1], glm::dvec4(0, 0, 5, 0));
  EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(2, 0, 0, 0));
}

TEST(Mrc, AxesThatAreNoneKeepTheirOrder) {
  for (int axis : {0, 4, -1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
    Map map(1);
    for (std::size_t i = 0; i < 3; ++i) map.put(64 + 4 * i, std::int32_t(axis));
    EXPECT_EQ(spacingOf(map.fill<std::int16_t>(0, 1).read()), glm::dvec3(2, 3, 5)) << axis;
  }
}

TEST(Mrc, WithoutACellTheSpacingIsNotKnown) {
  Map map(1);
  map.put(40, 0.0f);
  Volume v = map.fill<std::int16_t>(0, 1).read();
  EXPECT_FALSE(v.isSpacingKnown);
  EXPECT_EQ(spacingOf(v), glm::dvec3(1.0));
}

TEST(Mrc, WhatCannotBeReadIsRefusedInOneLine) {
  TempFolder folder;
  Map complex(4), cut(1), extended(1);
  complex.fill<std::int16_t>(0, 1);
  cut.fill<std::int16_t>(0, 1).bytes.resize(1024 + 47);
  extended.put(92, std::int32_t(-8));
  extended.fill<std::int16_t>(0, 1);
  for (const Map& map : {complex, cut, extended}) {
    writeText(folder / "a.mrc", map.bytes);
    expectClearError(folder / "a.mrc");
  }
}

}  // namespace
}  // namespace velum::io
