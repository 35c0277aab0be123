#include <fmt/format.h>

#include <tuple>

#include "DicomParts.h"
#include "DicomSeries.h"
#include "TestFiles.h"
#include "makeVolume.h"

/// Radiation dose and activity: scale, unit, places, times. Expected values are worked out by hand.
namespace velum::io {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

const Tag kPosition(0x0020, 0x0032), kOrientation(0x0020, 0x0037), kSpacing(0x0028, 0x0030);

/// A dose of planes of the value 1000 times their number, from 1.
DicomImage doseImage(const std::string& offsets, int planes, const std::string& orientation = "1\\0\\0\\0\\1\\0") {
  DicomImage image;
  image.modality = "RTDOSE", image.sopClass = "1.2.840.10008.5.1.4.1.1.481.2";
  image.bits = image.stored = 32;
  image.frames = planes;
  for (int plane = 1; plane <= planes; ++plane)
    image.pixels += pixelBytes(std::vector<std::uint32_t>(8, std::uint32_t(1000 * plane)));
  putText(image.set, kPosition, VR::DS, "10\\20\\30");
  putText(image.set, kOrientation, VR::DS, orientation);
  putText(image.set, kSpacing, VR::DS, "2\\3");
  putText(image.set, Tag(0x3004, 0x0002), VR::CS, "GY");
  putText(image.set, Tag(0x3004, 0x000e), VR::DS, "0.0025");
  if (!offsets.empty()) putText(image.set, Tag(0x3004, 0x000c), VR::DS, offsets);
  return image;
}

TEST(DicomDose, ItsScalingIsTheScaleAndGrayTheUnit) {
  TempFolder folder;
  ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage("0\\2.5\\5", 3)));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(v.dims, glm::ivec3(4, 2, 3));
  for (int z = 0; z < 3; ++z) EXPECT_DOUBLE_EQ(valueAt(v, {1, 1, z}), 2.5 * (z + 1));
  EXPECT_EQ(v.unit, "Gy");
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(3, 0, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(0, 0, 2.5, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_TRUE(v.isOrientationKnown && v.isSpacingKnown);
  EXPECT_TRUE(v.warnings.empty()) << v.warnings[0];
}

TEST(DicomDose, OffsetsMayBePlacesOfThePatient) {
  for (const char* orientation : {"1\\0\\0\\0\\1\\0", "-1\\0\\0\\0\\-1\\0", "1\\0\\0\\0\\-1\\0"}) {
    TempFolder folder;
    ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage("30\\32.5\\35", 3, orientation)));
    Volume v = read(folder / "a.dcm");
    // Where the rows and columns turn the other way round the last plane comes first; each keeps its place.
    for (int z = 0; z < 3; ++z) {
      double worldZ = (v.worldFromVoxel * glm::dvec4(0, 0, z, 1)).z;
      EXPECT_NEAR(valueAt(v, {1, 1, z}), 2.5 * (1 + (worldZ - 30) / 2.5), 1e-9) << orientation;
    }
    EXPECT_TRUE(v.warnings.empty()) << v.warnings[0];
  }
}

TEST(DicomDose, OffsetsRunAlongTheNormalAndMayFall) {
  TempFolder folder;
  // Sagittal planes: rows along y, columns down z, so that the normal is -x.
  ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage("0\\-4\\-8", 3, "0\\1\\0\\0\\0\\-1")));
  Volume v = read(folder / "a.dcm");
  for (int z = 0; z < 3; ++z) {
    double worldX = (v.worldFromVoxel * glm::dvec4(0, 0, z, 1)).x;
    EXPECT_NEAR(valueAt(v, {1, 1, z}), 2.5 * (1 + (worldX - 10) / 4), 1e-9);
  }
}

TEST(DicomDose, UnevenOffsetsAreResampledAndSaid) {
  TempFolder folder;
  ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage("0\\2\\4\\8", 4)));
  Volume v = read(folder / "a.dcm");
  ASSERT_EQ(v.dims.z, 5);
  EXPECT_NEAR(valueAt(v, {0, 0, 3}), (7.5 + 10) / 2, 1e-9);
  EXPECT_DOUBLE_EQ(valueAt(v, {0, 0, 4}), 10);
  EXPECT_NE(warningWith(v, "resampled"), "");
}

TEST(DicomDose, ASinglePlaneNeedsNoOffset) {
  for (const char* offsets : {"", "0"}) {
    TempFolder folder;
    ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage(offsets, 1)));
    EXPECT_DOUBLE_EQ(valueAt(read(folder / "a.dcm"), {0, 0, 0}), 2.5) << offsets;
  }
}

TEST(DicomDose, OffsetsThatDoNotMatchThePlanesAreRefused) {
  for (const char* offsets : {"0\\2", "0\\2\\4\\6", "0\\x\\2"}) {
    TempFolder folder;
    ASSERT_TRUE(writeDicom(folder / "a.dcm", doseImage(offsets, 3)));
    EXPECT_THROW(read(folder / "a.dcm"), InputError) << offsets;
  }
}

TEST(DicomDose, WhatIsNoGrayIsSaid) {
  TempFolder folder;
  DicomImage image = doseImage("0\\2", 2);
  putText(image.set, Tag(0x3004, 0x0002), VR::CS, "RELATIVE");
  ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(v.unit, "");
  EXPECT_NE(warningWith(v, "relative"), "");
  EXPECT_DOUBLE_EQ(valueAt(v, {0, 0, 0}), 2.5);
}

/// 10 kg, 1000 Bq at 10:00 with a half-life of an hour.
DicomImage petImage() {
  DicomImage image;
  image.modality = "PT", image.sopClass = "1.2.840.10008.5.1.4.1.1.128";
  image.pixels = pixelBytes(std::vector<std::int16_t>(8, 100));
  putPlace(image.set, 0);
  putRescale(image.set, "0.5", "0");
  auto put = [&](int group, int element, VR vr, const char* text) {
    putText(image.set, Tag(std::uint16_t(group), std::uint16_t(element)), vr, text);
  };
  put(0x0054, 0x1001, VR::CS, "BQML");
  put(0x0054, 0x1102, VR::CS, "START");
  put(0x0028, 0x0051, VR::CS, "DECY\\ATTN\\SCAT");
  put(0x0010, 0x1030, VR::DS, "10");
  put(0x0008, 0x0021, VR::DA, "20200301");
  put(0x0008, 0x0022, VR::DA, "20200301");
  put(0x0008, 0x0031, VR::TM, "110000");
  put(0x0008, 0x0032, VR::TM, "111500.00");
  DataSet drug;
  putText(drug, Tag(0x0018, 0x1072), VR::TM, "100000");
  putText(drug, Tag(0x0018, 0x1074), VR::DS, "1000");
  putText(drug, Tag(0x0018, 0x1075), VR::DS, "3600");
  putSequence(image.set, Tag(0x0054, 0x0016), sequenceWith(drug));
  return image;
}

std::string uptakeOf(const DicomImage& image) {
  TempFolder folder;
  EXPECT_TRUE(writeDicom(folder / "a.dcm", image));
  return warningWith(read(folder / "a.dcm"), "SUV");
}

bool saysFactor(const std::string& note, double factor) {
  return note.find(fmt::format("Bq/ml times {:.6g} (", factor)) != std::string::npos;
}

TEST(DicomPet, ValuesAreUptakeAndTheFactorFromActivityIsSaid) {
  TempFolder folder;
  ASSERT_TRUE(writeDicom(folder / "a.dcm", petImage()));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(v.unit, "SUVbw");
  EXPECT_EQ(v.modality, Modality::PET);
  // 50 Bq/ml; one half-life from injection to the series: 10 kg * 1000 g / 500 Bq.
  EXPECT_DOUBLE_EQ(valueAt(v, {0, 0, 0}), 50 * 20);
  EXPECT_DOUBLE_EQ(v.range.y, 50 * 20);
  EXPECT_TRUE(saysFactor(warningWith(v, "SUV"), 20)) << warningWith(v, "SUV");
}

TEST(DicomPet, WithoutWhatUptakeNeedsValuesStayActivity) {
  for (Tag tag : {Tag(0x0010, 0x1030), Tag(0x0054, 0x1102), Tag(0x0008, 0x0031)}) {
    TempFolder folder;
    DicomImage image = petImage();
    putText(image.set, tag, VR::LO, tag == Tag(0x0054, 0x1102) ? "NONE" : tag == Tag(0x0008, 0x0031) ? "093000" : "");
    ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
    Volume v = read(folder / "a.dcm");
    EXPECT_EQ(v.unit, "Bq/ml");
    EXPECT_DOUBLE_EQ(valueAt(v, {0, 0, 0}), 50);
    EXPECT_NE(warningWith(v, "cannot be had"), "");
  }
}

TEST(DicomPet, TimesAreThoseOfTheStandardsPseudoCode) {
  auto with = [](std::initializer_list<std::tuple<Tag, VR, const char*>> elements) {
    DicomImage image = petImage();
    for (auto [tag, vr, text] : elements) putText(image.set, tag, vr, text);
    return uptakeOf(image);
  };
  const Tag seriesTime(0x0008, 0x0031);
  // Corrected to the injection, no time matters.
  EXPECT_TRUE(saysFactor(with({{Tag(0x0054, 0x1102), VR::CS, "ADMIN"}}), 10));
  // A series of later than the acquisition was made over: the acquisition counts, here two half-lives after.
  EXPECT_TRUE(saysFactor(with({{seriesTime, VR::TM, "200000"}, {Tag(0x0008, 0x0032), VR::TM, "120000"}}), 40));
  // GE says when the scan was.
  EXPECT_TRUE(saysFactor(with({{seriesTime, VR::TM, "200000"},
                               {Tag(0x0009, 0x0010), VR::LO, "GEMS_PETD_01"},
                               {Tag(0x0009, 0x100d), VR::DT, "20200301110000.00"}}),
                         20));
  // Or the frame does: acquired at 12:00, its mean rate 3600 s after the start; a short frame's is in its middle.
  std::string note = with({{seriesTime, VR::TM, "200000"},
                           {Tag(0x0008, 0x0032), VR::TM, "115958"},
                           {Tag(0x0054, 0x1300), VR::DS, "3600000"},
                           {Tag(0x0018, 0x1242), VR::IS, "4000"}});
  EXPECT_NE(note.find("60.0 minutes before the scan"), std::string::npos) << note;
  // Past midnight.
  note = with({{Tag(0x0008, 0x0021), VR::DA, "20200302"},
               {Tag(0x0008, 0x0022), VR::DA, "20200302"},
               {seriesTime, VR::TM, "000000"},
               {Tag(0x0008, 0x0032), VR::TM, "0001"}});
  EXPECT_NE(note.find("840.0 minutes before the scan"), std::string::npos) << note;
}

TEST(DicomPet, ASeriesIsUptakePlaneByPlane) {
  TempFolder folder;
  PetDose dose;
  Volume activity = makeVolume(
      {6, 5, 4}, SampleType::Int16, [&](glm::ivec3 p) { return (p.x + 10 * p.z) * dose.activityOfOne(); },
      glm::dmat4(1.0), dose.activityOfOne() / 50);
  ASSERT_TRUE(writePetSeries(activity, folder / "pet", dose));
  Volume v = read(folder / "pet");
  EXPECT_EQ(v.unit, "SUVbw");
  EXPECT_EQ(v.modality, Modality::PET);
  ASSERT_EQ(v.dims, activity.dims);
  for (int z = 0; z < 4; ++z)
    for (int x = 0; x < 6; ++x) EXPECT_NEAR(valueAt(v, {x, 2, z}), x + 10 * z, 0.011) << "in steps of a fiftieth";
  // Nobody knows how heavy: values stay, and it is said why.
  dose.weightKg = 0;
  ASSERT_TRUE(writePetSeries(activity, folder / "unknown", dose));
  v = read(folder / "unknown");
  EXPECT_EQ(v.unit, "Bq/ml");
  EXPECT_NE(warningWith(v, "the patient's weight"), "");
}

TEST(DicomPet, WhatLacksForUptakeIsSaid) {
  DicomImage image = petImage();
  putText(image.set, Tag(0x0010, 0x1030), VR::DS, "");
  EXPECT_NE(uptakeOf(image).find("the patient's weight"), std::string::npos) << uptakeOf(image);
  image = petImage();
  putText(image.set, Tag(0x0054, 0x1102), VR::CS, "NONE");
  EXPECT_NE(uptakeOf(image).find("decay correction"), std::string::npos) << uptakeOf(image);
  image = petImage();
  putText(image.set, Tag(0x0008, 0x0031), VR::TM, "093000");
  EXPECT_NE(uptakeOf(image).find("cannot"), std::string::npos) << uptakeOf(image);
}

TEST(DicomPet, UptakeValuesAreNamedByTheirKind) {
  for (auto [units, kind, unit] : {std::tuple("GML", "", "SUVbw"),
                                   {"GML", "BW", "SUVbw"},
                                   {"GML", "LBM", "SUVlbm"},
                                   {"CM2ML", "BSA", "SUVbsa"},
                                   {"CNTS", "", "counts"},
                                   {"CPS", "", "counts/s"}}) {
    TempFolder folder;
    DicomImage image = petImage();
    putText(image.set, Tag(0x0054, 0x1001), VR::CS, units);
    if (*kind) putText(image.set, Tag(0x0054, 0x1006), VR::CS, kind);
    ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
    Volume v = read(folder / "a.dcm");
    EXPECT_EQ(v.unit, unit);
    EXPECT_TRUE(v.warnings.empty());
  }
}

}  // namespace
}  // namespace velum::io
