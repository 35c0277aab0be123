#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include "Damage.h"
#include "PeakMemory.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/WriteVolume.h"

namespace velum::io {
namespace {

/// What goes around an array of 2 x 3 x 2 values of 16 bits.
struct File {
  std::string root = "byte_order=\"LittleEndian\"";
  std::string image = "Origin=\"1 2 3\" Spacing=\"0.5 0.5 2\"";
  std::string fields;
  std::string array;   ///< Attributes of the array, and what stands in it.
  std::string behind;  ///< Behind the image: appended data.
};

std::string textOf(const File& f) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" " + f.root +
         ">\n<ImageData WholeExtent=\"0 1 0 2 0 1\" " + f.image + ">" + f.fields +
         "<Piece Extent=\"0 1 0 2 0 1\"><PointData Scalars=\"s\"><DataArray type=\"Int16\" Name=\"s\" " + f.array +
         "</DataArray></PointData></Piece></ImageData>" + f.behind + "</VTKFile>\n";
}

Volume readText(const std::string& text) {
  TempFolder folder;
  writeText(folder / "a.vti", text);
  return read(folder / "a.vti");
}

const std::string kNumbers = "format=\"ascii\">0 1 2 3 4 5 6 7 8 9 10 -11";

void expectNumbers(const Volume& v) {
  ASSERT_EQ(v.dims, glm::ivec3(2, 3, 2));
  ASSERT_EQ(v.type, SampleType::Int16);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(valueAt(v, {i % 2, i / 2 % 3, i / 6}), i == 11 ? -11 : i);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    unsigned bits = 0;
    for (std::size_t i = 0; i < 3; ++i) bits = bits << 8 | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0u);
    for (std::size_t i = 0; i < 4; ++i) out += i <= count ? kLetters[bits >> (18 - 6 * i) & 63] : '=';
  }
  return out;
}

std::string word(std::uint64_t value, int bytes, bool isBig) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += char(value >> 8 * (isBig ? bytes - 1 - i : i));
  return out;
}

std::string samples(bool isBig) {
  std::string out;
  for (int i = 0; i < 12; ++i) out += word(std::uint64_t(i == 11 ? -11 : i), 2, isBig);
  return out;
}

std::string deflated(const std::string& bytes) {
  std::string out(::compressBound(bytes.size()), '\0');
  uLongf size = out.size();
  ::compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  out.resize(size);
  return out;
}

TEST(Vti, EveryWayToStoreValuesIsRead) {
  for (bool isBig : {false, true})
    for (int size : {4, 8})
      for (bool isPacked : {false, true}) {
        SCOPED_TRACE(testing::Message() << isBig << size << isPacked);
        File f;
        f.root = std::string("byte_order=\"") + (isBig ? "Big" : "Little") + "Endian\" header_type=\"UInt" +
                 std::to_string(size * 8) + "\"" + (isPacked ? " compressor=\"vtkZLibDataCompressor\"" : "");
        // Two blocks, the second of 4 bytes.
        std::string one = deflated(samples(isBig).substr(0, 20)), two = deflated(samples(isBig).substr(20));
        std::string head = word(24, size, isBig);
        if (isPacked) head = word(2, size, isBig) + word(20, size, isBig) + word(4, size, isBig);
        if (isPacked) head += word(one.size(), size, isBig) + word(two.size(), size, isBig);
        std::string body = isPacked ? one + two : samples(isBig);
        f.array = "format=\"binary\">\n   " + base64(head) + base64(body) + "\n";
        expectNumbers(readText(textOf(f)));
        f.array = "format=\"binary\">\n   " + base64(head).insert(3, "\n") + "\n " + base64(body) + "\n";
        expectNumbers(readText(textOf(f)));
        if (!isPacked) {
          f.array = "format=\"binary\">" + base64(head + body);
          expectNumbers(readText(textOf(f)));
        }
        f.array = "format=\"appended\" offset=\"3\">";
        f.behind = "<AppendedData encoding=\"raw\">\n _<>&" + head + body + "</AppendedData>";
        expectNumbers(readText(textOf(f)));
        f.array = "format=\"appended\" offset=\"4\"/><DataArray>";
        f.behind = "<AppendedData encoding=\"base64\">_AAAA" + base64(head) + base64(body) + "</AppendedData>";
        expectNumbers(readText(textOf(f)));
        f.array = kNumbers;
        expectNumbers(readText(textOf(f)));
      }
}

TEST(Vti, FieldDataThatIsNotOursIsPassedOver) {
  File f;
  f.array = kNumbers;
  for (const char* array :
       {"type=\"Strange\" Name=\"x\" NumberOfTuples=\"1\" format=\"ascii\">1", "type=\"Float64\" Name=\"x\">",
        "type=\"String\" Name=\"x\" NumberOfTuples=\"99999999999\" format=\"ascii\">104 105",
        "type=\"Float64\" Name=\"x\" NumberOfComponents=\"-7\" format=\"appended\" offset=\"9999\">",
        "type=\"\" Name=\"x\" format=\"binary\">!!!!", "Name=\"x\">",
        "type=\"Int8\" Name=\"velum.scale\" format=\"ascii\">3"}) {
    SCOPED_TRACE(array);
    f.fields = std::string("<FieldData><DataArray ") + array + "</DataArray><Array/></FieldData>";
    Volume v = readText(textOf(f));
    expectNumbers(v);
    EXPECT_EQ(v.scale, 1.0);
  }
}

TEST(Vti, DirectionsAreThePatientsWhereTheyTurnSomething) {
  File f;
  f.array = kNumbers;
  for (auto [direction, known] : {std::pair("1 0 0 0 1 0 0 0 1", false), {"-1 0 0 0 -1 0 0 0 1", true}}) {
    f.image = "Origin=\"1 2 3\" Spacing=\"0.5 0.5 2\" Direction=\"" + std::string(direction) + "\"";
    EXPECT_EQ(readText(textOf(f)).isOrientationKnown, known) << direction;
  }
}

TEST(Vti, ADirectionInOnePlaneGivesWayToTheSpacing) {
  File f;
  f.array = kNumbers;
  for (const char* direction : {"1 0 0 0 1 0 0 0 1e-200", "1 1 0 1 1.0000000001 0 0 0 1", "0 0 0 0 0 0 0 0 0",
                                "1 0 0 0 1 0 0 0 nan", "1 0 0 0 1", "x"}) {
    SCOPED_TRACE(direction);
    f.image = "Origin=\"1 2 nan\" Spacing=\"0.5 0.25 2\" Direction=\"" + std::string(direction) + "\"";
    Volume v = readText(textOf(f));
    expectNumbers(v);
    EXPECT_EQ(spacingOf(v), glm::dvec3(0.5, 0.25, 2));
    EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(1, 2, 0, 1));
    EXPECT_FALSE(v.isOrientationKnown);
    EXPECT_FALSE(v.warnings.empty());
  }
  f.image = "Spacing=\"0 nan 1e300\"";
  EXPECT_EQ(spacingOf(readText(textOf(f))), glm::dvec3(1.0));
}

TEST(Vti, PiecesMakeOneImage) {
  auto piece = [](const std::string& extent, const std::string& values) {
    return "<Piece Extent=\"" + extent + "\"><PointData><DataArray type=\"Int16\" Name=\"s\" format=\"ascii\">" +
           values + "</DataArray></PointData></Piece>";
  };
  std::string head = "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 1 0 2 0 1\">",
              tail = "</ImageData></VTKFile>";
  std::string lower = piece("0 1 0 2 0 0", "0 1 2 3 4 5"), upper = piece("0 1 0 2 1 1", "6 7 8 9 10 -11");
  expectNumbers(readText(head + upper + lower + tail));
  EXPECT_THROW(readText(head + lower + tail), InputError);
  EXPECT_THROW(readText(head + lower + piece("0 1 0 2 1 2", "6 7 8 9 10 11 1 1 1 1 1 1") + tail), InputError);
  EXPECT_THROW(readText(head + lower + piece("0 1 0 2 1 1", "6 7 8 9 10") + tail), InputError);
}

TEST(Vti, WhatDoesNotFitIsRefused) {
  File f;
  for (const char* array :
       {"format=\"ascii\">0 1 2 3 4 5 6 7 8 9 10", "format=\"ascii\">0 1 2 3 4 5 x 7 8 9 10 11",
        "format=\"binary\">AAAA", "format=\"binary\">", "format=\"strange\">1", "format=\"appended\" offset=\"0\">",
        "NumberOfComponents=\"0\" format=\"ascii\">1", "NumberOfComponents=\"1e9\" format=\"ascii\">1"}) {
    f.array = array;
    EXPECT_THROW(readText(textOf(f)), InputError) << array;
  }
  f.array = kNumbers;
  std::string good = textOf(f);
  for (auto [what, with] : {std::pair{"Int16", "Int17"},
                            {"Int16", "String"},
                            {"0 1 0 2 0 1", "0 1 0 2 0"},
                            {"0 1 0 2 0 1", "0 1 0 -2 0 1"},
                            {"0 1 0 2 0 1", "0 99999 0 99999 0 99999"},
                            {"ImageData", "PolyData"},
                            {"byte_order", "compressor=\"none\" byte_order"},
                            {"byte_order", "header_type=\"UInt7\" byte_order"},
                            {"</Piece>", "</Pieces>"},
                            {"<?xml", "<!DOCTYPE"},
                            {"Origin=\"", "Origin="}}) {
    std::string bad = good;
    for (std::size_t at = 0; (at = bad.find(what, at)) != bad.npos; at += std::strlen(with))
      bad.replace(at, std::strlen(what), with);
    EXPECT_THROW(readText(bad), InputError) << with;
  }
}

TEST(Vti, DamageIsReadOrRefused) {
  TempFolder folder;
  File text, packed;
  text.array = kNumbers;
  packed.root += " compressor=\"vtkZLibDataCompressor\"";
  packed.fields =
      "<FieldData><DataArray type=\"Float64\" Name=\"velum.scale\" NumberOfTuples=\"1\" "
      "format=\"ascii\">2</DataArray></FieldData>";
  packed.array = "format=\"appended\" offset=\"0\">";
  std::string body = deflated(samples(false));
  packed.behind = "<AppendedData encoding=\"raw\">_" + word(1, 4, false) + word(24, 4, false) + word(0, 4, false) +
                  word(body.size(), 4, false) + body + "</AppendedData>";
  auto growth = peakGrowth([&] {
    for (const File& f : {text, packed})
      expectReadOrRefused(textOf(f), folder / "a.vti", 2000, [&] {
        Volume v = read(folder / "a.vti");
        EXPECT_TRUE(std::isfinite(glm::determinant(v.worldFromVoxel)) && glm::determinant(v.worldFromVoxel) != 0);
      });
  });
  EXPECT_LT(growth, std::size_t(64) << 20);
}

TEST(VtkLegacy, ASpacingThatNoMatrixHoldsIsReplaced) {
  TempFolder folder;
  writeText(folder / "a.vtk",
            "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 1 1\n"
            "SPACING 1e-200 1e-200 2\nPOINT_DATA 2\nSCALARS s short 1\nLOOKUP_TABLE default\n1 2\n");
  Volume v = read(folder / "a.vtk");
  EXPECT_EQ(spacingOf(v), glm::dvec3(1, 1, 2));
  EXPECT_FALSE(v.isSpacingKnown);
}

}  // namespace
}  // namespace velum::io
