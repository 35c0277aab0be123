#include "TestFiles.h"

#include "io/labels/ReadLabels.h"
#include "makeVolume.h"

namespace velum::io {
namespace {

LabelVolume twoBlocks(glm::ivec3 dims, const glm::dmat4& matrix, std::uint16_t second) {
  LabelVolume labels(dims, matrix);
  std::vector<std::uint16_t> ids(2 * 2 * 2, 3);
  labels.write({0, 0, 0}, {2, 2, 2}, ids);
  std::fill(ids.begin(), ids.end(), second);
  labels.write(dims - 2, {2, 2, 2}, ids);
  labels.table = {{3, "left kidney", {1, 0, 0}, 1}, {second, "vena cava", {0, 0.5f, 1}, 1}};
  return labels;
}

class LabelRoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(LabelRoundTrip, IdsNamesColoursAndWorldSurvive) {
  TempFolder folder;
  for (std::uint16_t second : {std::uint16_t(200), std::uint16_t(40000)}) {
    LabelVolume labels = twoBlocks({40, 35, 70}, obliqueMatrix(true, false), second);
    Progress progress;
    auto path = folder / ("a" + std::string(GetParam()));
    writeLabels(labels, path, progress);
    EXPECT_TRUE(looksLikeLabels(path));
    LabelVolume back = readLabelsOf(path);
    EXPECT_EQ(back.dims(), labels.dims());
    expectSameMatrix(back.worldFromVoxel(), labels.worldFromVoxel(), 5e-5);
    EXPECT_EQ(back.at({1, 1, 1}), 3);
    EXPECT_EQ(back.at({39, 34, 69}), second);
    EXPECT_EQ(back.at({20, 20, 20}), 0);
    ASSERT_EQ(back.table.size(), 2u);
    EXPECT_EQ(back.table[0].name, "left kidney");
    EXPECT_EQ(back.table[1].id, second);
    EXPECT_NEAR(back.table[1].color.g, 0.5f, 1e-6f);
  }
}
INSTANTIATE_TEST_SUITE_P(Formats, LabelRoundTrip, testing::Values(".seg.nrrd", ".nrrd", ".nii", ".nii.gz"),
                         [](const auto& test) {
                           std::string name;
                           for (const char* c = test.param; *c; ++c)
                             if (*c != '.') name += *c;
                           return name;
                         });

TEST(Labels, OnAnotherGridOverlayByWorld) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {20, 20, 20});
  v.worldFromVoxel[3] = glm::dvec4(100, 50, 25, 1);
  write(v, folder / "scan.nrrd");
  glm::dmat4 coarse(2.0);
  coarse[3] = glm::dvec4(104, 54, 29, 1);
  Progress progress;
  writeLabels(twoBlocks({6, 6, 6}, coarse, 9), folder / "labels.nii.gz", progress);
  Volume scan = read(folder / "scan.nrrd");
  LabelVolume labels = readLabelsOf(folder / "labels.nii.gz");
  // Voxel (4,4,4) of the scan is the first of the labels.
  glm::dvec4 voxel = glm::inverse(labels.worldFromVoxel()) * scan.worldFromVoxel * glm::dvec4(4, 4, 4, 1);
  EXPECT_EQ(labels.at(glm::ivec3(glm::round(glm::dvec3(voxel)))), 3);
}

TEST(Labels, FractionsNegativesAndColoursAreRefused) {
  TempFolder folder;
  write(rampVolume(SampleType::Float32, {3, 3, 3}), folder / "f.nrrd");
  write(rampVolume(SampleType::Int8, {8, 8, 8}), folder / "n.nrrd");
  Volume color = rampVolume(SampleType::UInt8, {3, 3, 3}, 3);
  color.isColor = true;
  write(color, folder / "c.nrrd");
  Volume half = rampVolume(SampleType::UInt8, {3, 3, 3});
  half.scale = 0.5;
  write(half, folder / "h.nrrd");
  for (const char* name : {"f.nrrd", "n.nrrd", "c.nrrd", "h.nrrd"})
    EXPECT_THROW(readLabelsOf(folder / name), InputError) << name;
}

TEST(Labels, SlicerLayersWithEqualValuesGetIdsOfTheirOwn) {
  TempFolder folder;
  std::string head =
      "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 2 2 1 1\nspace directions: none (1,0,0) (0,1,0) "
      "(0,0,1)\n"
      "kinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n"
      "Segment0_ID:=a\nSegment0_Name:=A\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
      "Segment1_ID:=b\nSegment1_Name:=B\nSegment1_LabelValue:=1\nSegment1_Layer:=1\n\n";
  writeText(folder / "a.seg.nrrd", head + std::string("\1\0\0\1", 4));
  LabelVolume labels = readLabelsOf(folder / "a.seg.nrrd");
  EXPECT_EQ(labels.at({0, 0, 0}), 1);
  EXPECT_EQ(labels.at({1, 0, 0}), 2);
  ASSERT_EQ(labels.table.size(), 2u);
  EXPECT_EQ(labels.table[1].name, "B");
}

/// A file of two layers of 2 x 2 voxels. @param bytes  the layers' samples, interleaved
LabelVolume readLayers(const std::string& segments, const std::string& bytes) {
  TempFolder folder;
  std::string head =
      "NRRD0004\ntype: uchar\ndimension: 4\nspace: LPS\nsizes: 2 2 2 1\nspace directions: none (1,0,0) (0,1,0) "
      "(0,0,1)\nkinds: list domain domain domain\nencoding: raw\nspace origin: (0,0,0)\n";
  writeText(folder / "a.seg.nrrd", head + segments + "\n" + bytes);
  return readLabelsOf(folder / "a.seg.nrrd");
}

TEST(Labels, OverlapsAndStraysOfLayersAreSaid) {
  LabelVolume labels = readLayers(
      "Segment0_ID:=a\nSegment0_LabelValue:=1\nSegment0_Layer:=0\nSegment1_ID:=b\nSegment1_LabelValue:=2\n"
      "Segment1_Layer:=1\n",
      std::string("\1\2\1\0\0\2\1\7", 8));
  EXPECT_EQ(labels.at({0, 0, 0}), 2);
  EXPECT_EQ(labels.at({1, 1, 0}), 1);
  ASSERT_EQ(labels.warnings.size(), 2u);
  EXPECT_TRUE(labels.warnings[0].starts_with("1 voxel belongs to several segments")) << labels.warnings[0];
  EXPECT_TRUE(labels.warnings[1].starts_with("1 voxel of the layers is of no segment")) << labels.warnings[1];
}

TEST(Labels, NoTwoSegmentsOfLayersGetOneId) {
  // The second segment's place in the list is the first one's value.
  LabelVolume labels = readLayers(
      "Segment0_ID:=a\nSegment0_LabelValue:=2\nSegment0_Layer:=0\nSegment1_ID:=b\nSegment1_LabelValue:=2\n"
      "Segment1_Layer:=1\n",
      std::string("\2\0\0\2\0\0\0\0", 8));
  EXPECT_EQ(labels.at({0, 0, 0}), 2);
  EXPECT_EQ(labels.at({1, 0, 0}), 1);
  ASSERT_EQ(labels.table.size(), 2u);
  ASSERT_EQ(labels.warnings.size(), 1u);
  EXPECT_TRUE(labels.warnings[0].starts_with("1 segment has a number of its own")) << labels.warnings[0];
}

TEST(Labels, LayersWithoutNumbersAreOneASegment) {
  LabelVolume labels = readLayers("Segment0_ID:=a\nSegment1_ID:=b\n", std::string("\1\0\0\1\0\0\0\0", 8));
  EXPECT_EQ(labels.at({0, 0, 0}), 1);
  EXPECT_EQ(labels.at({1, 0, 0}), 2);
}

TEST(LabelTable, KnowsTheThreeKinds) {
  TempFolder folder;
  writeText(folder / "snap.label",
            "# ITK-SnAP\n    0     0    0    0        0  0  0    \"Clear Label\"\n    1   255    0  128        0.5  1  "
            "1    \"Left lung\"\n");
  writeText(folder / "slicer.ctbl", "# Color\n0 background 0 0 0 0\n7 liver 221 130 101 255\n");
  writeText(folder / "mricron.txt", "1 Precentral_L 2001\n2 Precentral_R 2002\n");
  writeText(folder / "freesurfer.lut", "17 Left-Hippocampus 220 216 20 0\n");
  writeText(folder / "none.txt", "The quick brown fox\n");
  auto snap = readLabelTable(folder / "snap.label");
  ASSERT_EQ(snap.size(), 1u);
  EXPECT_EQ(snap[0].name, "Left lung");
  EXPECT_EQ(snap[0].color.r, 1.0f);
  EXPECT_EQ(snap[0].opacity, 0.5f);
  auto slicer = readLabelTable(folder / "slicer.ctbl");
  ASSERT_EQ(slicer.size(), 1u);
  EXPECT_EQ(slicer[0].id, 7);
  EXPECT_EQ(slicer[0].name, "liver");
  auto mricron = readLabelTable(folder / "mricron.txt");
  ASSERT_EQ(mricron.size(), 2u);
  EXPECT_EQ(mricron[1].name, "Precentral_R");
  EXPECT_EQ(readLabelTable(folder / "freesurfer.lut")[0].opacity, 1.0f);
  EXPECT_THROW(readLabelTable(folder / "none.txt"), InputError);
}

TEST(LabelTable, IdsReachFromOneToTheLargestOf16Bits) {
  TempFolder folder;
  writeText(folder / "a.ctbl",
            "0 background 0 0 0 0\n1 first 1 2 3 255\n65535 last 4 5 6 255\n65536 beyond 7 8 9 255\n");
  auto table = readLabelTable(folder / "a.ctbl");
  ASSERT_EQ(table.size(), 2u);
  EXPECT_EQ(table[0].id, 1);
  EXPECT_EQ(table[1].id, 65535);
  EXPECT_EQ(table[1].name, "last");
}

TEST(LooksLikeLabels, OnlyWholeWordsCount) {
  for (const char* name : {"ct_labels.nii.gz", "a.seg.nrrd", "Mask-1.nrrd", "totalseg.nii.gz"})
    EXPECT_TRUE(looksLikeLabels(name)) << name;
  for (const char* name : {"seismic.segy", "segmented.nrrd", "ct.nii.gz"}) EXPECT_FALSE(looksLikeLabels(name)) << name;
}

bool opensAsLabels(const Volume& volume) {
  TempFolder folder;
  write(volume, folder / "scan.nrrd");
  Progress progress;
  scene::Source source;
  source.path = (folder / "scan.nrrd").string();
  return std::holds_alternative<LabelVolume>(readVoxels(source, progress));
}

TEST(LooksLikeLabels, FewWholeNumbersInAreasAreIdsWhateverTheFileIsCalled) {
  glm::ivec3 dims(48, 24, 24);
  auto thirds = [](glm::ivec3 p) { return double(p.x < 4 ? 0 : p.x < 24 ? 1 : p.y < 12 ? 4 : 5); };
  EXPECT_TRUE(opensAsLabels(makeVolume(dims, SampleType::UInt8, thirds)));
  EXPECT_TRUE(opensAsLabels(makeVolume(dims, SampleType::UInt16, thirds)));
}

TEST(LooksLikeLabels, WhatIsMeasuredOrDrawnAsOneShapeIsNone) {
  glm::ivec3 dims(24);
  auto ball = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - 12.0) < 9.0 ? 200.0 : 0.0; };
  EXPECT_FALSE(opensAsLabels(makeVolume(dims, SampleType::UInt8, ball))) << "one number alone";
  EXPECT_FALSE(opensAsLabels(makeVolume(dims, SampleType::UInt8, [](glm::ivec3 p) { return double(p.x + 8 * p.y); })))
      << "a slope";
  EXPECT_FALSE(opensAsLabels(makeVolume(dims, SampleType::UInt8, [](glm::ivec3 p) {
    return std::floor(20.0 + 10.0 * hashNoise(p));
  }))) << "noise of few steps";
  EXPECT_FALSE(opensAsLabels(makeVolume({48, 24, 24}, SampleType::UInt8, [](glm::ivec3 p) {
    return p.x < 16 ? 0.0 : p.x < 32 ? 120.0 : 200.0;
  }))) << "values of a drawing";
  EXPECT_FALSE(opensAsLabels(makeVolume(dims, SampleType::Float32, [](glm::ivec3 p) { return double(p.x / 8); })))
      << "not written as whole numbers";
}

}  // namespace
}  // namespace velum::io
