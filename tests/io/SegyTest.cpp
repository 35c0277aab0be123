#include <gtest/gtest.h>

#include "SegyBytes.h"

namespace velum::io {
namespace {

TEST(Segy, EveryFormatAndByteOrderGivesTheSamples) {
  for (bool isLittle : {false, true})
    for (auto [code, factor] : {std::pair{1, 1.0}, {2, 4.0}, {3, 4.0}, {5, 1.0}}) {
      Volume v = readBytes(makeSegy(code, isLittle, cube(5, 4), 9));
      ASSERT_EQ(v.dims, glm::ivec3(5, 4, 9));
      for (int z = 0; z < 9; ++z)
        for (int y = 0; y < 4; ++y)
          for (int x = 0; x < 5; ++x)
            ASSERT_EQ(valueAt(v, {x, y, z}), factor * double(truth({100 + 2 * x, 7 + y, 0, 0}, z))) << code << isLittle;
    }
}

TEST(Segy, SpacingIsThatOfTheMap) {
  Volume v = readBytes(makeSegy(5, false, cube(6, 5), 3));
  EXPECT_TRUE(v.isSpacingKnown);
  EXPECT_FALSE(v.isOrientationKnown);
  EXPECT_NEAR(spacingOf(v).x, 12500, 50);
  EXPECT_NEAR(spacingOf(v).y, 25000, 50);
  EXPECT_NEAR(spacingOf(v).z, 2000, 1e-9);
  EXPECT_LT(v.worldFromVoxel[2].z, 0);
}

TEST(Segy, WithoutCoordinatesSpacingIsUnknown) {
  auto traces = cube(3, 3);
  for (auto& t : traces) t.x = t.y = 0;
  Volume v = readBytes(makeSegy(5, false, traces, 3));
  EXPECT_FALSE(v.isSpacingKnown);
  EXPECT_EQ(spacingOf(v), glm::dvec3(1.0));
}

TEST(Segy, OrderOfTracesDoesNotMatter) {
  auto traces = cube(4, 3);
  Volume a = readBytes(makeSegy(5, false, traces, 5));
  std::reverse(traces.begin(), traces.end());
  Volume b = readBytes(makeSegy(5, false, traces, 5));
  EXPECT_TRUE(a.voxels == b.voxels);
}

TEST(Segy, MissingTracesAreZeroAndTold) {
  auto traces = cube(4, 4);
  traces.erase(traces.begin() + 5);
  Volume v = readBytes(makeSegy(5, false, traces, 4));
  EXPECT_EQ(v.dims, glm::ivec3(4, 4, 4));
  EXPECT_EQ(valueAt(v, {1, 1, 2}), 0.0);
  EXPECT_FALSE(v.warnings.empty());
}

TEST(Segy, WildLineNumbersAllocateNothing) {
  auto traces = cube(4, 4);
  traces[3].inlineNumber = 2147483647;
  traces[7].crosslineNumber = -2147483647;
  EXPECT_THROW(readBytes(makeSegy(5, false, traces, 4)), InputError);
}

TEST(Segy, ATraceCutShortIsLeftOutWithAWarning) {
  std::string bytes = makeSegy(5, false, cube(4, 4), 4);
  bytes.resize(bytes.size() - 3);
  Volume v = readBytes(bytes);
  EXPECT_GE(v.warnings.size(), 2u);
}

/// The value of a field of each trace's header, byte numbers from 1.
void putInTraces(std::string& bytes, int samples, int sampleBytes, std::size_t number, int value, std::size_t size) {
  for (std::size_t at = 3600; at < bytes.size(); at += 240 + std::size_t(samples * sampleBytes)) {
    Writer w{bytes.substr(at, 240)};
    w.put(number - 1, std::uint64_t(std::int64_t(value)), size);
    bytes.replace(at, 240, w.bytes);
  }
}

TEST(Segy, IbmNumbersAreExact) {
  // 1.0 is 16^1 * 1/16; -118.625 is the example of the books; then what a float holds of the least and the most.
  const std::pair<std::uint32_t, float> kNumbers[] = {{0x41100000u, 1.0f},
                                                      {0xC276A000u, -118.625f},
                                                      {0x00000000u, 0.0f},
                                                      {0x40800000u, 0.5f},
                                                      {0x48FFFFFFu, 4294967040.0f}};
  std::string bytes = makeSegy(5, false, {{1, 1, 0, 0}, {1, 2, 0, 0}}, 5);
  bytes[3225] = 1;  // IBM
  for (std::size_t trace = 0; trace < 2; ++trace)
    for (std::size_t i = 0; i < 5; ++i) {
      Writer w{std::string(4, '\0')};
      w.put(0, kNumbers[i].first, 4);
      bytes.replace(3600 + trace * 260 + 240 + 4 * i, 4, w.bytes);
    }
  Volume v = readBytes(bytes);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(valueAt(v, {0, 1, i}), double(kNumbers[i].second)) << i;
}

TEST(Segy, LineNumbersMayStandInTheOldPlaces) {
  // Before 2002 bytes 189 and 193 were nobody's: 9 and 21 had the numbers.
  auto traces = cube(3, 4);
  std::string bytes = makeSegy(5, false, traces, 6);
  putInTraces(bytes, 6, 4, 189, 0, 4);
  putInTraces(bytes, 6, 4, 193, 0, 4);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    Writer w{bytes.substr(3600 + i * 264, 240)};
    w.put(8, std::uint32_t(traces[i].inlineNumber), 4), w.put(20, std::uint32_t(traces[i].crosslineNumber), 4);
    bytes.replace(3600 + i * 264, 240, w.bytes);
  }
  Volume v = readBytes(bytes);
  ASSERT_EQ(v.dims, glm::ivec3(3, 4, 6));
  EXPECT_EQ(valueAt(v, {2, 3, 5}), double(truth({104, 10, 0, 0}, 5)));
}

TEST(Segy, PrestackShowsTheFirstOffset) {
  std::vector<Trace> traces;
  for (Trace t : cube(4, 3))
    for (int offset : {100, 200}) traces.push_back({t.inlineNumber, t.crosslineNumber, t.x, t.y, offset});
  std::string bytes = makeSegy(5, false, traces, 5);
  // The traces of the second offset say something else.
  for (std::size_t i = 1; i < traces.size(); i += 2) bytes.replace(3600 + i * 260 + 240, 20, std::string(20, '\x42'));
  Volume v = readBytes(bytes);
  ASSERT_EQ(v.dims, glm::ivec3(4, 3, 5));
  EXPECT_EQ(valueAt(v, {3, 2, 4}), double(truth({106, 9, 0, 0}, 4)));
  ASSERT_FALSE(v.warnings.empty());
  EXPECT_NE(v.warnings[0].find("prestack"), std::string::npos);
}

TEST(Segy, OneTraceAndOneLineAreVolumesToo) {
  EXPECT_EQ(readBytes(makeSegy(5, false, cube(1, 1), 7)).dims, glm::ivec3(1, 1, 7));
  Volume line = readBytes(makeSegy(5, false, cube(1, 5), 7));
  EXPECT_EQ(line.dims, glm::ivec3(1, 5, 7));
  EXPECT_NEAR(spacingOf(line).y, 25000, 50);
  EXPECT_NEAR(spacingOf(line).x, spacingOf(line).y, 1e-9) << "it has no width of its own";
  EXPECT_NEAR(spacingOf(readBytes(makeSegy(5, false, cube(5, 1), 7))).x, 12500, 50);
}

TEST(Segy, ScalarsFeetAndIntervalsGiveTheSpacing) {
  std::string bytes = makeSegy(5, false, cube(6, 5), 3);
  std::string tenfold = bytes;
  putInTraces(tenfold, 3, 4, 71, 1, 2);  // coordinates are in metres, not in tenths
  EXPECT_NEAR(spacingOf(readBytes(tenfold)).x, 125000, 500);
  putInTraces(tenfold, 3, 4, 71, -100, 2);
  EXPECT_NEAR(spacingOf(readBytes(tenfold)).x, 1250, 5);
  std::string feet = bytes;
  feet[3255] = 2;
  EXPECT_NEAR(spacingOf(readBytes(feet)).x, 12500 * 0.3048, 20);
  EXPECT_NEAR(spacingOf(readBytes(feet)).z, 2000, 1e-9);
  std::string timeless = bytes;
  timeless[3216] = timeless[3217] = 0;
  EXPECT_FALSE(readBytes(timeless).isSpacingKnown);
}

TEST(Segy, ExtendedTextHeadersAndALengthInTheFirstTraceAreMet) {
  std::string bytes = makeSegy(5, false, cube(3, 3), 4);
  std::string extended = bytes.substr(0, 3600) + std::string(2 * 3200, ' ') + bytes.substr(3600);
  extended[3500] = 1;  // revision 1
  extended[3505] = 2;
  EXPECT_EQ(valueAt(readBytes(extended), {2, 2, 3}), double(truth({104, 9, 0, 0}, 3)));
  std::string unsaid = bytes;
  unsaid[3220] = unsaid[3221] = 0;
  putInTraces(unsaid, 4, 4, 115, 4, 2);
  EXPECT_EQ(valueAt(readBytes(unsaid), {2, 2, 3}), double(truth({104, 9, 0, 0}, 3)));
}

TEST(Segy, WhatIsNoSegyIsRefusedInWords) {
  auto expectRefused = [](const std::string& bytes, const char* words) {
    TempFolder folder;
    std::ofstream(folder / "a.sgy", std::ios::binary) << bytes;
    Progress progress;
    scene::Source source;
    source.path = (folder / "a.sgy").string();
    try {
      readSegy(source, progress);
      ADD_FAILURE() << "opened: " << words;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  expectRefused("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "git lfs pull");
  expectRefused(std::string(3200, ' '), "fewer than its headers");
  expectRefused(makeSegy(5, false, {}, 4), "no whole trace");
  std::string bytes = makeSegy(5, false, cube(2, 2), 4);
  bytes[3225] = 4;
  expectRefused(bytes, "sample format 4");
}

}  // namespace
}  // namespace velum::io
