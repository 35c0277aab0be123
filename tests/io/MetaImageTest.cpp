// MetaImage files as other programs write them, byte by byte.
#include <fmt/format.h>

#include <algorithm>

#include "TestFiles.h"

namespace velum::io {
namespace {

/// Samples in the byte order asked for.
template <class T>
std::string bytesOf(std::initializer_list<double> values, bool bigEndian = false) {
  std::string bytes;
  for (double value : values) {
    T sample = T(value);
    char raw[sizeof(T)];
    std::memcpy(raw, &sample, sizeof(T));
    if (bigEndian) std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

std::string header(const std::string& lines, const std::string& data = "LOCAL") {
  return "ObjectType = Image\nNDims = 3\n" + lines + "ElementDataFile = " + data + "\n";
}
constexpr const char* kSmall = "DimSize = 3 2 1\nElementType = MET_UCHAR\n";

std::string deflated(const std::string& bytes) {
  std::string out(::compressBound(bytes.size()), '\0');
  uLongf size = out.size();
  ::compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  out.resize(size);
  return out;
}

template <class T>
void expectType(const char* name, SampleType type, std::initializer_list<double> values) {
  TempFolder folder;
  for (bool bigEndian : {false, true})
    for (const char* key : {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}) {
      SCOPED_TRACE(fmt::format("{} {} {}", name, key, bigEndian));
      writeText(folder / "a.mha", header(fmt::format("DimSize = {} 1 1\nElementType = {}\n{} = {}\n", values.size(),
                                                     name, key, bigEndian ? "True" : "False")) +
                                      bytesOf<T>(values, bigEndian));
      Volume v = read(folder / "a.mha");
      EXPECT_EQ(v.type, type);
      int x = 0;
      for (double value : values) EXPECT_EQ(valueAt(v, {x++, 0, 0}), value);
    }
}

TEST(MetaImage, EveryTypeInBothByteOrdersKeepsItsEnds) {
  expectType<std::int8_t>("MET_CHAR", SampleType::Int8, {-128, -1, 127});
  expectType<std::uint8_t>("MET_UCHAR", SampleType::UInt8, {0, 200, 255});
  expectType<std::int16_t>("MET_SHORT", SampleType::Int16, {-32768, -2, 32767});
  expectType<std::uint16_t>("MET_USHORT", SampleType::UInt16, {0, 258, 65535});
  expectType<std::int32_t>("MET_INT", SampleType::Int32, {-2147483648.0, 7, 2147483647.0});
  expectType<std::uint32_t>("MET_UINT", SampleType::UInt32, {0, 66051, 4294967295.0});
  expectType<std::int32_t>("MET_LONG", SampleType::Int32, {-2147483648.0, 7, 2147483647.0});
  expectType<float>("MET_FLOAT", SampleType::Float32, {-1.5, 0.25, 1e6});
  expectType<double>("MET_DOUBLE", SampleType::Float64, {-1.1, 1e-300, 1e300});
}

TEST(MetaImage, RowsOfTheMatrixAreTheDirectionsOfTheAxes) {
  TempFolder folder;
  // The first axis runs to the posterior, the second to the right, the third up.
  std::string place = "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementSpacing = 2 3 4\nOffset = 10 20 30\n";
  writeText(folder / "a.mha", header(kSmall + place) + "abcdef");
  Volume v = read(folder / "a.mha");
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0, 2, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[1], glm::dvec4(-3, 0, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(0, 0, 4, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_TRUE(v.isOrientationKnown && v.isSpacingKnown);
  EXPECT_EQ(valueAt(v, {2, 0, 0}), 'c');
  EXPECT_EQ(valueAt(v, {0, 1, 0}), 'd');
}

TEST(MetaImage, DirectionsAreThePatientsWhereAxesAreNamedOrTurned) {
  TempFolder folder;
  for (auto [more, known] : {std::pair("TransformMatrix = 1 0 0 0 1 0 0 0 1\n", false),
                             {"TransformMatrix = 1 0 0 0 1 0 0 0 1\nAnatomicalOrientation = RAI\n", true},
                             {"TransformMatrix = 1 0 0 0 1 0 0 0 1\nAnatomicalOrientation = ???\n", false},
                             {"AnatomicalOrientation = RAI\n", false},
                             {"TransformMatrix = -1 0 0 0 -1 0 0 0 1\n", true}}) {
    writeText(folder / "a.mha", header(kSmall + std::string(more)) + "abcdef");
    EXPECT_EQ(read(folder / "a.mha").isOrientationKnown, known) << more;
  }
}

TEST(MetaImage, EveryNameOfAFieldIsTheSameField) {
  TempFolder folder;
  for (const char* matrix : {"TransformMatrix", "Rotation", "Orientation"})
    for (const char* offset : {"Offset", "Position", "Origin"}) {
      writeText(folder / "a.mha", header(fmt::format("{}{} = 0 1 0 1 0 0 0 0 1\n{} = 1 2 3\nElementSize = 5 6 7\n",
                                                     kSmall, matrix, offset)) +
                                      "abcdef");
      Volume v = read(folder / "a.mha");
      EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0, 5, 0, 0)) << matrix;
      EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(1, 2, 3, 1)) << offset;
    }
}

TEST(MetaImage, LengthsMayBeInOtherUnits) {
  TempFolder folder;
  for (auto [unit, mm] : {std::pair("mm", 1.0), {"um", 1e-3}, {"cm", 10.0}}) {
    writeText(
        folder / "a.mha",
        header(fmt::format("{}DistanceUnits = {}\nElementSpacing = 2 3 4\nOffset = 8 0 0\n", kSmall, unit)) + "abcdef");
    Volume v = read(folder / "a.mha");
    EXPECT_NEAR(spacingOf(v).y, 3 * mm, 1e-12) << unit;
    EXPECT_NEAR(v.worldFromVoxel[3].x, 8 * mm, 1e-12) << unit;
  }
}

TEST(MetaImage, WhatTheHeaderDoesNotSayIsNotKnown) {
  TempFolder folder;
  writeText(folder / "a.mha", header(kSmall) + "abcdef");
  Volume v = read(folder / "a.mha");
  EXPECT_FALSE(v.isSpacingKnown);
  EXPECT_FALSE(v.isOrientationKnown);
  EXPECT_EQ(spacingOf(v), glm::dvec3(1.0));
}

TEST(MetaImage, DataMayLieInFilesBeside) {
  TempFolder folder;
  writeText(folder / "a.raw", "abcdef");
  writeText(folder / "skip.raw", "1234abcdef");
  writeText(folder / "s1", "abc");
  writeText(folder / "s2", "def");
  const std::string rows = "DimSize = 3 1 2\nElementType = MET_UCHAR\n";
  const std::pair<std::string, const char*> kCases[] = {
      {header(kSmall, "a.raw"), "one file"},
      {header(kSmall + std::string("HeaderSize = 4\n"), "skip.raw"), "skipped"},
      {header(kSmall + std::string("HeaderSize = -1\n"), "skip.raw"), "at the end"},
      {header(rows, "LIST") + "s1\ns2\n", "list"},
      {header(rows, "s%d 1 2 1"), "pattern"}};
  for (const auto& [text, what] : kCases) {
    SCOPED_TRACE(what);
    writeText(folder / "a.mhd", text);
    Volume v = read(folder / "a.mhd");
    std::string samples(reinterpret_cast<const char*>(v.voxels.data()), v.voxels.size());
    EXPECT_EQ(samples, "abcdef");
  }
}

TEST(MetaImage, DataMayBeDeflatedOrText) {
  TempFolder folder;
  std::string packed = deflated("abcdef");
  writeText(folder / "a.mha",
            header(fmt::format("{}CompressedData = True\nCompressedDataSize = {}\n", kSmall, packed.size())) + packed);
  EXPECT_EQ(valueAt(read(folder / "a.mha"), {2, 1, 0}), 'f');
  writeText(folder / "a.zraw", packed);
  writeText(folder / "a.mhd", header(kSmall + std::string("CompressedData = True\n"), "a.zraw"));
  EXPECT_EQ(valueAt(read(folder / "a.mhd"), {2, 1, 0}), 'f');
  writeText(folder / "t.mha",
            header("DimSize = 3 2 1\nElementType = MET_SHORT\nBinaryData = False\n") + "1 -2 3\n4 5 -600\n");
  EXPECT_EQ(valueAt(read(folder / "t.mha"), {1, 0, 0}), -2);
  EXPECT_EQ(valueAt(read(folder / "t.mha"), {2, 1, 0}), -600);
  packed.resize(packed.size() / 2);
  writeText(folder / "a.mha", header(kSmall + std::string("CompressedData = True\n")) + packed);
  expectClearError(folder / "a.mha");
}

TEST(MetaImage, AFourthAxisIsTimeAndTwoAreAPlane) {
  TempFolder folder;
  writeText(folder / "a.mha",
            "NDims = 4\nDimSize = 2 1 1 3\nElementType = MET_UCHAR\nElementSpacing = 2 3 4 0.5\nElementDataFile = "
            "LOCAL\nabcdef");
  Volume v = read(folder / "a.mha");
  EXPECT_EQ(v.timeSteps, 3);
  EXPECT_EQ(spacingOf(v), glm::dvec3(2, 3, 4));
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 0, 2), 'f');
  writeText(folder / "a.mha", "NDims = 2\nDimSize = 3 2\nElementType = MET_UCHAR\nElementDataFile = LOCAL\nabcdef");
  EXPECT_EQ(read(folder / "a.mha").dims, glm::ivec3(3, 2, 1));
}

TEST(MetaImage, ChannelsColourSlopeAndModality) {
  TempFolder folder;
  writeText(folder / "a.mha",
            header("DimSize = 2 1 1\nElementType = MET_UCHAR_ARRAY\nElementNumberOfChannels = 3\n") + "abcdef");
  Volume v = read(folder / "a.mha");
  EXPECT_TRUE(v.isColor);
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 2), 'f');
  writeText(folder / "a.mha",
            header(std::string(kSmall) + "ElementToIntensityFunctionSlope = 0.5\nElementToIntensityFunctionOffset = "
                                         "-1024\nModality = MET_MOD_CT\n") +
                "abcdef");
  v = read(folder / "a.mha");
  EXPECT_EQ(valueAt(v, {0, 0, 0}), 0.5 * 'a' - 1024);
  EXPECT_EQ(v.modality, Modality::CT);
  EXPECT_FALSE(v.isColor);
}

TEST(MetaImage, ASweepOfTrackedFramesIsSaidToBeOne) {
  TempFolder folder;
  writeText(folder / "a.igs.mha",
            header(std::string(kSmall) + "ElementSpacing = 1 1 1\nSeq_Frame0000_Timestamp = 0.5\n") + "abcdef");
  auto warnings = read(folder / "a.igs.mha").warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(),
                          [](const auto& words) { return words.find("tracked sweep") != words.npos; }));
}

}  // namespace
}  // namespace velum::io
