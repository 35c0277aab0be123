// Legacy VTK files with structured points, as many programs write them.
#include <algorithm>

#include "TestFiles.h"

namespace velum::io {
namespace {

constexpr const char* kHead = "# vtk DataFile Version 3.0\na title\n";
constexpr const char* kGrid = "DATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 1\nORIGIN 1 2 3\nSPACING 0.5 1 2\n";

Volume readText(const std::string& text) {
  TempFolder folder;
  writeText(folder / "a.vtk", text);
  return read(folder / "a.vtk");
}
void expectRefused(const std::string& text) {
  SCOPED_TRACE(text);
  TempFolder folder;
  writeText(folder / "a.vtk", text);
  expectClearError(folder / "a.vtk");
}

/// Samples as the format has them: the largest byte first.
template <class T>
std::string bigEndian(std::initializer_list<double> values) {
  std::string bytes;
  for (double value : values) {
    T sample = T(value);
    char raw[sizeof(T)];
    std::memcpy(raw, &sample, sizeof(T));
    std::reverse(raw, raw + sizeof(T));
    bytes.append(raw, sizeof(T));
  }
  return bytes;
}

template <class T>
void expectType(const std::string& name, SampleType type, std::initializer_list<double> values) {
  SCOPED_TRACE(name);
  std::string scalars = kGrid + std::string("POINT_DATA 6\nSCALARS s ") + name + "\nLOOKUP_TABLE default\n";
  Volume binary = readText(std::string(kHead) + "BINARY\n" + scalars + bigEndian<T>(values));
  std::string numbers;
  for (double value : values) numbers += std::to_string(value) + " ";
  Volume text = readText(std::string(kHead) + "ASCII\n" + scalars + numbers);
  for (const Volume* v : {&binary, &text}) {
    EXPECT_EQ(v->type, type);
    int i = 0;
    for (double value : values) {
      EXPECT_EQ(valueAt(*v, {i % 3, i / 3, 0}), value);
      ++i;
    }
  }
}

TEST(VtkLegacy, EveryTypeAsTextAndAsBytes) {
  expectType<std::uint8_t>("unsigned_char", SampleType::UInt8, {0, 1, 127, 128, 254, 255});
  expectType<std::int8_t>("char", SampleType::Int8, {-128, -1, 0, 1, 2, 127});
  expectType<std::uint16_t>("unsigned_short", SampleType::UInt16, {0, 255, 256, 40000, 65534, 65535});
  expectType<std::int16_t>("short", SampleType::Int16, {-32768, -1, 0, 255, 256, 32767});
  expectType<std::int32_t>("int", SampleType::Int32, {-2147483648.0, -1, 0, 65536, 5, 2147483647.0});
  expectType<std::uint32_t>("unsigned_int", SampleType::UInt32, {0, 1, 2, 3, 65536, 4294967295.0});
  expectType<float>("float", SampleType::Float32, {-1.5, 0.25, 0, 1, 2, 1024});
  expectType<double>("double", SampleType::Float64, {-1.5, 0.25, 0, 1, 2, 1024});
  expectType<std::int64_t>("vtktypeint64", SampleType::Float64, {-5000000000.0, 0, 1, 2, 3, 5000000000.0});
}

TEST(VtkLegacy, TheGridHasItsPlace) {
  Volume v = readText(std::string(kHead) + "ASCII\n" + kGrid + "POINT_DATA 6\nSCALARS s char\n1 2 3 4 5 6");
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(spacingOf(v), glm::dvec3(0.5, 1, 2));
  EXPECT_FALSE(v.isOrientationKnown);
  // Before version 2 spacing had another name; keys come in any order, and lines may end as on Windows.
  v = readText(
      "# vtk DataFile Version 1.0\r\ntitle\r\nASCII\r\nDATASET STRUCTURED_POINTS\r\nASPECT_RATIO 2 3 4\r\nORIGIN 5 6 "
      "7\r\n"
      "DIMENSIONS 2 1 1\r\nPOINT_DATA 2\r\nSCALARS s short\r\nLOOKUP_TABLE default\r\n7 -8\r\n");
  EXPECT_EQ(spacingOf(v), glm::dvec3(2, 3, 4));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(5, 6, 7, 1));
  EXPECT_EQ(valueAt(v, {1, 0, 0}), -8);
}

TEST(VtkLegacy, ValuesOfCellsStandInTheMiddleOfTheirCells) {
  Volume v = readText(std::string(kHead) +
                      "ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\nORIGIN 1 2 3\nSPACING 0.5 1 2\nCELL_DATA "
                      "2\nSCALARS s short 1\nLOOKUP_TABLE default\n7 8");
  EXPECT_EQ(v.dims, glm::ivec3(2, 1, 1));
  EXPECT_EQ(valueAt(v, {1, 0, 0}), 8);
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(1.25, 2.5, 4, 1));
  EXPECT_EQ(v.warnings.size(), 1u);
}

TEST(VtkLegacy, ColoursVectorsAndFieldsAreChannels) {
  std::string head = std::string(kHead) +
                     "BINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nORIGIN 0 0 0\nSPACING "
                     "1 1 1\nPOINT_DATA 2\n";
  Volume v = readText(head + "COLOR_SCALARS rgb 3\nabcdef");
  EXPECT_TRUE(v.isColor);
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 2), 'f');
  v = readText(head + "VECTORS flow float\n" + bigEndian<float>({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(v.channels, 3);
  EXPECT_FALSE(v.isColor);
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 1), 5);
  v = readText(head + "FIELD all 1\nrho 2 2 short\n" + bigEndian<std::int16_t>({1, 2, 3, 400}));
  EXPECT_EQ(v.channels, 2);
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 1), 400);
}

TEST(VtkLegacy, WhatItIsNotIsRefusedInOneLine) {
  std::string good =
      std::string(kHead) + "BINARY\n" + kGrid + "POINT_DATA 6\nSCALARS s short 1\nLOOKUP_TABLE default\n";
  expectRefused(good + "1234567890a");  // a byte is missing
  expectRefused(std::string(kHead) + "BINARY\nDATASET POLYDATA\nPOINTS 3 float\n");
  expectRefused(std::string(kHead) + "BASE64\n" + kGrid);
  expectRefused(std::string(kHead) + "BINARY\n" + kGrid + "POINT_DATA 6\n");
  expectRefused(std::string(kHead) + "BINARY\n" + kGrid + "POINT_DATA 6\nSCALARS s bit 1\nLOOKUP_TABLE default\nx");
  expectRefused(std::string(kHead) +
                "BINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 30000 30000 30000\nORIGIN 0 0 0\nSPACING 1 1 "
                "1\nPOINT_DATA 6\nSCALARS s short 1\nLOOKUP_TABLE default\nabc");
  expectRefused(std::string(kHead) +
                "BINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\nORIGIN 0 0 0\nSPACING 0 1 1\nPOINT_DATA "
                "2\nSCALARS s char 1\nLOOKUP_TABLE default\nab");
}

}  // namespace
}  // namespace velum::io
