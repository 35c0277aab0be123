#include <fmt/format.h>

#include <limits>

#include "DicomParts.h"
#include "TestFiles.h"

/// What stored samples mean: Modality LUT, rescale, dose, activity. Expected values are worked out by hand.
namespace velum::io {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::TransferSyntax;
using gdcm::VR;

struct Table {
  std::vector<std::uint16_t> descriptor, data;
  std::string type = "US";
};

void putTable(DataSet& set, const Table& table, bool isSigned) {
  DataSet item;
  putWords(item, Tag(0x0028, 0x3002), isSigned ? VR::SS : VR::US, table.descriptor);
  putText(item, Tag(0x0028, 0x3004), VR::LO, table.type);
  putWords(item, Tag(0x0028, 0x3006), VR::OW, table.data);
  putSequence(set, Tag(0x0028, 0x3000), sequenceWith(item));
}

/// Eight samples through a table.
std::vector<double> throughTable(const std::vector<std::int16_t>& samples, bool isSigned, const Table& table,
                                 TransferSyntax::TSType syntax = TransferSyntax::ExplicitVRLittleEndian) {
  TempFolder folder;
  DicomImage image;
  image.modality = "CR";
  image.syntax = syntax;
  image.isSigned = isSigned;
  image.pixels = pixelBytes(samples);
  putTable(image.set, table, isSigned);
  EXPECT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  std::vector<double> values;
  for (int i = 0; i < 8; ++i) values.push_back(valueAt(v, {i % 4, i / 4, 0}));
  return values;
}

TEST(DicomValues, AModalityLutIsAppliedAndHeldAtBothEnds) {
  Table table{{4, 10, 16}, {100, 5000, 300, 65535}};
  std::vector<double> expected{100, 100, 100, 5000, 300, 65535, 65535, 65535};
  for (auto syntax : {TransferSyntax::ExplicitVRLittleEndian, TransferSyntax::ImplicitVRLittleEndian})
    EXPECT_EQ(throughTable({0, 9, 10, 11, 12, 13, 14, 4000}, false, table, syntax), expected) << int(syntax);
}

TEST(DicomValues, TheFirstSampleOfATableForSignedOnesIsSigned) {
  Table table{{3, std::uint16_t(-2), 16}, {7, 8, 9}};
  for (auto syntax : {TransferSyntax::ExplicitVRLittleEndian, TransferSyntax::ImplicitVRLittleEndian})
    EXPECT_EQ(throughTable({-32768, -3, -2, -1, 0, 1, 2, 32767}, true, table, syntax),
              (std::vector<double>{7, 7, 7, 8, 9, 9, 9, 9}));
  // Of unsigned samples the same bits are 65534.
  EXPECT_EQ(throughTable({0, 1, 2, std::int16_t(-3), std::int16_t(-2), std::int16_t(-1), 5, 6}, false,
                         {{2, 65534, 16}, {7, 8}}),
            (std::vector<double>{7, 7, 7, 7, 7, 8, 7, 7}));
}

TEST(DicomValues, EntriesOfEightBitsComeAByteOrAWordEach) {
  std::vector<double> expected{1, 1, 2, 3, 4, 5, 6, 6};
  std::vector<std::int16_t> samples{0, 1, 2, 3, 4, 5, 6, 7};
  EXPECT_EQ(throughTable(samples, false, {{6, 1, 8}, {0x0201, 0x0403, 0x0605}}), expected);
  EXPECT_EQ(throughTable(samples, false, {{6, 1, 8}, {1, 2, 3, 4, 5, 6}}), expected);
  // An odd number of bytes is padded.
  expected = {1, 1, 2, 3, 4, 5, 5, 5};
  EXPECT_EQ(throughTable(samples, false, {{5, 1, 8}, {0x0201, 0x0403, 0xff05}}), expected);
}

TEST(DicomValues, ATableOfAllSamplesHasADescriptorOfZero) {
  Table table{{0, 0, 16}, {}};
  for (int i = 0; i < 65536; ++i) table.data.push_back(std::uint16_t(65535 - i));
  EXPECT_EQ(throughTable({0, 1, 2, 100, 32767, std::int16_t(-32768), -2, -1}, false, table),
            (std::vector<double>{65535, 65534, 65533, 65435, 32768, 32767, 1, 0}));
}

TEST(DicomValues, ATableWinsOverSlopeAndInterceptAndNamesTheUnit) {
  TempFolder folder;
  DicomImage image;
  image.pixels = pixelBytes<std::int16_t>({0, 1, 0, 1, 0, 1, 0, 1});
  putRescale(image.set, "10", "-1000", "HU");
  putTable(image.set, {{2, 0, 16}, {40, 50}, "MGML"}, false);
  ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(valueAt(v, {0, 0, 0}), 40);
  EXPECT_EQ(valueAt(v, {1, 0, 0}), 50);
  EXPECT_EQ(v.unit, "mg/ml");
}

TEST(DicomValues, EachSliceHasItsOwnTable) {
  TempFolder folder;
  for (std::uint16_t z = 0; z < 3; ++z) {
    DicomImage image;
    image.pixels = pixelBytes(std::vector<std::int16_t>(8, 1));
    putPlace(image.set, z);
    if (z < 2)
      putTable(image.set, {{2, 0, 16}, {0, std::uint16_t(100 + z)}}, false);
    else
      putRescale(image.set, "0.5", "3");
    ASSERT_TRUE(writeDicom(folder / fmt::format("{}.dcm", z), image));
  }
  Volume v = read(folder.path());
  for (int z = 0; z < 3; ++z) EXPECT_EQ(valueAt(v, {2, 1, z}), z < 2 ? 100 + z : 3.5);
}

TEST(DicomValues, ADamagedTableIsRefusedByWhatIsWrong) {
  for (const Table& table : {Table{{4, 0, 16}, {1, 2, 3}}, Table{{4, 0}, {1, 2, 3, 4}}, Table{{2, 0, 99}, {1, 2}}}) {
    try {
      throughTable(std::vector<std::int16_t>(8, 0), false, table);
      FAIL();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("Modality LUT"), std::string::npos) << error.what();
    }
  }
}

/// Slices whose eight samples and scale are random; every value is the sample times the slope plus the intercept.
void expectOwnScales(bool isSigned, int bits, int stored, std::uint32_t seed) {
  TempFolder folder;
  auto next = [&] { return seed = seed * 1664525u + 1013904223u, seed >> 8; };
  std::vector<std::vector<double>> expected;
  for (int z = 0; z < 5; ++z) {
    DicomImage image;
    image.modality = "PT", image.sopClass = "1.2.840.10008.5.1.4.1.1.128";
    image.bits = bits, image.stored = stored, image.isSigned = isSigned;
    double slope = double(1 + next() % 4000) / 1024, intercept = double(int(next() % 2000) - 1000) / 4;
    expected.emplace_back();
    for (int i = 0; i < 8; ++i) {
      std::uint64_t mask = (std::uint64_t(1) << stored) - 1;
      std::uint64_t raw = (std::uint64_t(next()) << 16 ^ next()) & mask;
      image.pixels.append(reinterpret_cast<const char*>(&raw), std::size_t(bits / 8));
      double sample = isSigned && raw >> (stored - 1) ? double(raw) - double(mask) - 1 : double(raw);
      expected.back().push_back(sample * slope + intercept);
    }
    putPlace(image.set, 2.0 * z);
    putRescale(image.set, fmt::format("{}", slope), fmt::format("{}", intercept));
    ASSERT_TRUE(writeDicom(folder / fmt::format("{}.dcm", (z * 3) % 5), image));
  }
  Volume v = read(folder.path());
  ASSERT_EQ(v.dims, glm::ivec3(4, 2, 5));
  for (int z = 0; z < 5; ++z)
    for (int i = 0; i < 8; ++i) {
      double value = expected[std::size_t(z)][std::size_t(i)];
      // Half a step of a float, which has as many digits as 24 bits; what is wider becomes double.
      double tolerance = stored > 24 ? 0 : std::abs(value) * std::numeric_limits<float>::epsilon() / 2;
      EXPECT_NEAR(valueAt(v, {i % 4, i / 4, z}), value, tolerance) << z << " " << i;
    }
}

TEST(DicomValues, EachSliceHasItsOwnSlopeAndIntercept) {
  for (std::uint32_t seed = 1; seed < 5; ++seed)
    for (bool isSigned : {false, true})
      for (auto [bits, stored] : {std::pair(8, 8), {8, 7}, {16, 12}, {16, 16}, {32, 24}, {32, 31}})
        expectOwnScales(isSigned, bits, stored, seed);
}

TEST(DicomValues, UnitsAreThoseOfTheFile) {
  struct Case {
    const char *modality, *type, *unit;
  };
  for (Case c : {Case{"CT", "", "HU"},
                 {"CT", "HU", "HU"},
                 {"CT", "US", "HU"},
                 {"CT", "MGML", "mg/ml"},
                 {"CT", "PCT", "%"},
                 {"MR", "US", ""},
                 {"MR", "", ""},
                 {"MR", "10^-6 mm2/s", "10^-6 mm2/s"}}) {
    TempFolder folder;
    DicomImage image;
    image.modality = c.modality;
    image.pixels = std::string(16, '\1');
    putRescale(image.set, "1", "0", c.type);
    ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
    EXPECT_EQ(read(folder / "a.dcm").unit, c.unit) << c.modality << " " << c.type;
  }
}

TEST(DicomValues, SlicesOfTwoUnitsGiveAVolumeOfNone) {
  TempFolder folder;
  for (int z = 0; z < 2; ++z) {
    DicomImage image;
    image.pixels = std::string(16, '\1');
    putPlace(image.set, z);
    putRescale(image.set, "1", "0", z ? "MGML" : "HU");
    ASSERT_TRUE(writeDicom(folder / fmt::format("{}.dcm", z), image));
  }
  Volume v = read(folder.path());
  EXPECT_EQ(v.unit, "");
  EXPECT_NE(warningWith(v, "HU, mg/ml"), "");
}

TEST(DicomValues, NumbersWithAUnitAreNotTurnedRound) {
  TempFolder folder;
  DicomImage image;
  image.pixels = pixelBytes<std::int16_t>({0, 1000, 0, 0, 0, 0, 0, 0});
  putText(image.set, Tag(0x0028, 0x0004), VR::CS, "MONOCHROME1");
  putRescale(image.set, "1", "-1000", "HU");
  ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(valueAt(v, {0, 0, 0}), -1000);
  EXPECT_EQ(valueAt(v, {1, 0, 0}), 0);
  EXPECT_NE(warningWith(v, "MONOCHROME1"), "");
}

TEST(DicomValues, AScaleThatIsNoneIsSaid) {
  TempFolder folder;
  DicomImage image;
  image.pixels = pixelBytes(std::vector<std::int16_t>(8, 5));
  putRescale(image.set, "0", "0");
  ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(valueAt(v, {0, 0, 0}), 5);
  EXPECT_NE(warningWith(v, "slope of 0"), "");
}

}  // namespace
}  // namespace velum::io
