#include <algorithm>

#include "TestFiles.h"

/// Where voxels of NRRD files lie, and their values. Headers are text of the test; places are worked out by hand.
namespace velum::io {
namespace {

/// 2 x 3 x 2 samples of a type, the numbers 0, 257, 514, ..., whose bytes differ, in either byte order.
template <class T>
std::string samplesOf(bool isBig) {
  std::string out;
  for (int i = 0; i < 12; ++i) {
    auto value = T(i * 257);
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (isBig) std::reverse(raw, raw + sizeof(T));
    out.append(raw, sizeof(T));
  }
  return out;
}

Volume readNrrdOf(const std::string& fields, const std::string& samples) {
  TempFolder folder;
  writeText(folder / "a.nrrd", "NRRD0004\ndimension: 3\nsizes: 2 3 2\nencoding: raw\n" + fields + "\n" + samples);
  return read(folder / "a.nrrd");
}

glm::dvec3 placeOf(const Volume& v, glm::dvec3 voxel) { return glm::dvec3(v.worldFromVoxel * glm::dvec4(voxel, 1)); }

TEST(NrrdFrame, EverySpaceOfAPatientIsTurnedToLps) {
  // Voxel (1, 2, 1) lies at origin + (1, 2, 3) + 2 * (0, -4, 0.5) + (0.25, 0, 6) in the file's space.
  const glm::dvec3 inFile(100 + 1 + 0.25, 200 + 2 - 8, 300 + 3 + 1 + 6);
  struct Space {
    const char* name;
    glm::dvec3 signs;
  };
  for (const Space& space : {Space{"left-posterior-superior", {1, 1, 1}},
                             {"LPS", {1, 1, 1}},
                             {"right-anterior-superior", {-1, -1, 1}},
                             {"RAS", {-1, -1, 1}},
                             {"left-anterior-superior", {1, -1, 1}},
                             {"LAS", {1, -1, 1}},
                             {"las", {1, -1, 1}}}) {
    SCOPED_TRACE(space.name);
    Volume v = readNrrdOf(std::string("type: uchar\nspace: ") + space.name +
                              "\nspace directions: (1,2,3) (0,-4,0.5) (0.25,0,6)\nspace origin: (100,200,300)\n",
                          samplesOf<std::uint8_t>(false));
    EXPECT_EQ(placeOf(v, {1, 2, 1}), inFile * space.signs);
    EXPECT_EQ(placeOf(v, {0, 0, 0}), glm::dvec3(100, 200, 300) * space.signs);
    EXPECT_TRUE(v.isOrientationKnown);
    EXPECT_TRUE(v.isSpacingKnown);
  }
}

TEST(NrrdFrame, ASpaceOfNoPatientKeepsItsAxesAndSaysSo) {
  for (const char* space : {"space dimension: 3", "space: scanner-xyz", "space: 3D-right-handed"}) {
    Volume v = readNrrdOf(
        std::string("type: uchar\n") + space + "\nspace directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (4,5,6)\n",
        samplesOf<std::uint8_t>(false));
    EXPECT_EQ(placeOf(v, {1, 1, 1}), glm::dvec3(5, 7, 9)) << space;
    EXPECT_FALSE(v.isOrientationKnown) << space;
  }
}

TEST(NrrdFrame, AnAxisWithoutLengthIsStillOneOfSpace) {
  Volume v = readNrrdOf("type: uchar\nspace: LPS\nspace directions: (1,0,0) (0,2,0) (0,0,0)\nspace origin: (4,5,6)\n",
                        samplesOf<std::uint8_t>(false));
  EXPECT_EQ(v.dims, glm::ivec3(2, 3, 2));
  EXPECT_NE(warningWith(v, "the orientation in the file cannot be used"), "");
}

TEST(NrrdFrame, LengthsComeInManyUnits) {
  struct Unit {
    const char* name;
    double mm;
  };
  for (const Unit& unit : {Unit{"mm", 1}, {"m", 1000}, {"cm", 10}, {"um", 1e-3}, {"microns", 1e-3}, {"nm", 1e-6}}) {
    std::string quoted = std::string("\"") + unit.name + "\"";
    Volume v = readNrrdOf("type: uchar\nspace: LPS\nspace units: " + quoted + " " + quoted + " " + quoted +
                              "\nspace directions: (1,0,0) (0,2,0) (0,0,4)\nspace origin: (8,0,0)\n",
                          samplesOf<std::uint8_t>(false));
    EXPECT_EQ(placeOf(v, {1, 1, 1}), glm::dvec3(9, 2, 4) * unit.mm) << unit.name;
  }
}

template <class T>
void expectBothOrders(const char* type) {
  for (bool isBig : {false, true}) {
    Volume v = readNrrdOf(std::string("type: ") + type + "\nendian: " + (isBig ? "big" : "little") + "\n",
                          samplesOf<T>(isBig));
    for (int i = 0; i < 12; ++i)
      EXPECT_EQ(valueAt(v, {i % 2, i / 2 % 3, i / 6}), double(T(i * 257))) << type << " " << isBig;
  }
}

TEST(NrrdFrame, SamplesOfBothByteOrdersAreTheSame) {
  expectBothOrders<std::int16_t>("short");
  expectBothOrders<std::uint16_t>("ushort");
  expectBothOrders<std::int32_t>("int");
  expectBothOrders<std::uint32_t>("uint");
  expectBothOrders<std::int64_t>("longlong");
  expectBothOrders<std::uint64_t>("uint64");
  expectBothOrders<float>("float");
  expectBothOrders<double>("double");
}

TEST(NrrdFrame, AByteSkipOfMinusOneTakesTheLastBytes) {
  TempFolder folder;
  writeText(folder / "a.raw", "whatever stands before" + samplesOf<std::uint16_t>(false));
  for (const char* skip : {"-1", "22"}) {
    writeText(folder / "a.nhdr", std::string("NRRD0004\ndimension: 3\nsizes: 2 3 2\nencoding: raw\ntype: ushort\n") +
                                     "endian: little\nbyte skip: " + skip + "\ndata file: a.raw\n");
    Volume v = read(folder / "a.nhdr");
    for (int i = 0; i < 12; ++i) EXPECT_EQ(valueAt(v, {i % 2, i / 2 % 3, i / 6}), i * 257) << skip;
  }
}

TEST(NrrdFrame, IntegersThatADoubleRoundsAreSaid) {
  std::string samples;
  for (std::int64_t i = 0; i < 12; ++i) {
    std::int64_t value = i == 3 ? (std::int64_t(1) << 53) + 1 : std::int64_t(1) << 53;
    samples.append(reinterpret_cast<const char*>(&value), 8);
  }
  Volume v = readNrrdOf("type: int64\nendian: little\n", samples);
  EXPECT_EQ(v.type, SampleType::Float64);
  EXPECT_NE(warningWith(v, "1 of 12 integers of 64 bits has"), "");
}

}  // namespace
}  // namespace velum::io
