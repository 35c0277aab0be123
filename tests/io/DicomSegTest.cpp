#include "DicomParts.h"
#include "TestFiles.h"

namespace velum::io {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

/// A segmentation of frames of 4 x 2 voxels.
DicomImage segmentation(const DataSet& set, const char* type, int bits, int frames, const std::string& pixels) {
  DicomImage image{set, "1.2.840.10008.5.1.4.1.1.66.4", "SEG"};
  putText(image.set, Tag(0x0062, 0x0001), VR::CS, type);
  image.bits = image.stored = bits;
  image.frames = frames;
  image.pixels = pixels;
  return image;
}

bool warns(const LabelVolume& labels, const std::string& word) {
  for (const std::string& w : labels.warnings)
    if (w.find(word) != std::string::npos) return true;
  return false;
}

TEST(DicomSeg, BitsArePackedOverFramesAndSegmentsFindTheirPlanes) {
  TempFolder folder;
  DataSet set;
  putGroups(set, {10, 10, 30}, {1, 2, 2});
  // Frames of eight voxels: the first voxel of each, and the last of the third.
  ASSERT_TRUE(writeDicom(folder / "s.dcm", segmentation(set, "BINARY", 1, 3, std::string("\x01\x02\x81\0", 4))));
  EXPECT_TRUE(looksLikeLabels(folder / "s.dcm"));
  LabelVolume labels = readLabelsOf(folder / "s.dcm");
  EXPECT_EQ(labels.dims(), glm::ivec3(4, 2, 2));
  EXPECT_EQ(labels.at({0, 0, 1}), 1);
  EXPECT_EQ(labels.at({1, 0, 1}), 2);
  EXPECT_EQ(labels.at({0, 0, 0}), 2);
  EXPECT_EQ(labels.at({3, 1, 0}), 2);
  EXPECT_EQ(labels.worldFromVoxel()[3], glm::dvec4(30, 5, 6, 1));
  EXPECT_TRUE(labels.warnings.empty()) << labels.warnings[0];
}

TEST(DicomSeg, NumbersOfALabelMapAreTheSegments) {
  for (int bits : {8, 16}) {
    TempFolder folder;
    DataSet set;
    putGroups(set, {10, 20}, {1, 1});
    std::vector<std::uint16_t> numbers{0, 1, 2, 3, 4, 5, 200, 0, 7, 7, 7, 7, 7, 7, 7, 7};
    std::string pixels =
        bits == 16 ? pixelBytes(numbers) : pixelBytes(std::vector<std::uint8_t>(numbers.begin(), numbers.end()));
    DicomImage image = segmentation(set, "LABELMAP", bits, 2, pixels);
    image.sopClass = "1.2.840.10008.5.1.4.1.1.66.7";
    ASSERT_TRUE(writeDicom(folder / "s.dcm", image));
    LabelVolume labels = readLabelsOf(folder / "s.dcm");
    // The normal is -x, so that the plane at 20 comes first.
    for (int i = 0; i < 8; ++i) EXPECT_EQ(labels.at({i % 4, i / 4, 1}), numbers[std::size_t(i)]);
    EXPECT_EQ(labels.at({0, 0, 0}), 7);
  }
}

TEST(DicomSeg, FractionsAreCutAtHalfAndThatIsSaid) {
  TempFolder folder;
  DataSet set;
  putGroups(set, {10}, {3});
  putShort(set, Tag(0x0062, 0x000e), 200);
  ASSERT_TRUE(
      writeDicom(folder / "s.dcm", segmentation(set, "FRACTIONAL", 8, 1, std::string("\0\x64\x65\xc8\0\0\0\0", 8))));
  LabelVolume labels = readLabelsOf(folder / "s.dcm");
  for (int x = 0; x < 4; ++x) EXPECT_EQ(labels.at({x, 0, 0}), x < 2 ? 0 : 3);
  EXPECT_TRUE(warns(labels, "half"));
}

TEST(DicomSeg, WhatDoesNotFitIsSaid) {
  TempFolder folder;
  DataSet set, uneven;
  putGroups(set, {10, 10, 20}, {1, 1, 1});
  ASSERT_TRUE(writeDicom(folder / "repeat.dcm", segmentation(set, "BINARY", 1, 3, std::string("\x01\x02\x81\0", 4))));
  EXPECT_TRUE(warns(readLabelsOf(folder / "repeat.dcm"), "repeat"));
  putGroups(uneven, {10, 12, 15}, {1, 1, 1});
  ASSERT_TRUE(
      writeDicom(folder / "uneven.dcm", segmentation(uneven, "BINARY", 1, 3, std::string("\x01\x02\x81\0", 4))));
  EXPECT_TRUE(warns(readLabelsOf(folder / "uneven.dcm"), "evenly"));
}

}  // namespace
}  // namespace velum::io
