#include <gdcmReader.h>

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

TEST(DicomSeg, AFolderThatHoldsSegmentsAndNoImagesOpensAsThem) {
  TempFolder folder;
  std::filesystem::create_directories(folder / "study/segments");
  DataSet set, larger;
  putGroups(set, {10}, {3});
  putGroups(larger, {10, 20, 30}, {1, 2, 2});
  ASSERT_TRUE(writeDicom(folder / "study/segments/s.dcm", segmentation(set, "BINARY", 1, 1, std::string("\x81\0", 2))));
  auto open = [&] {
    Progress progress;
    scene::Source source;
    source.path = (folder / "study").string();
    return readVoxels(source, progress);
  };
  auto alone = open();
  ASSERT_TRUE(std::holds_alternative<LabelVolume>(alone));
  EXPECT_EQ(std::get<LabelVolume>(alone).at({0, 0, 0}), 3);
  EXPECT_TRUE(std::get<LabelVolume>(alone).warnings.empty());
  EXPECT_TRUE(looksLikeLabels(folder / "study"));
  EXPECT_EQ(readLabelsOf(folder / "study").at({3, 1, 0}), 3);
  // Of several the largest, and that is said.
  DicomImage second = segmentation(larger, "BINARY", 1, 3, std::string("\x01\x02\x81\0", 4));
  second.series = "1.2.3.77";
  ASSERT_TRUE(writeDicom(folder / "study/other.dcm", second));
  LabelVolume largest = std::get<LabelVolume>(open());
  EXPECT_EQ(largest.dims(), glm::ivec3(4, 2, 3));
  EXPECT_TRUE(warns(largest, "2 files of segments"));
  // Beside images it is of them: the images open.
  DicomImage image;
  image.pixels = pixelBytes(std::vector<std::int16_t>(8, 100));
  image.series = "1.2.3.78";
  putPlace(image.set, 0);
  ASSERT_TRUE(writeDicom(folder / "study/image.dcm", image));
  EXPECT_TRUE(std::holds_alternative<Volume>(open()));
  EXPECT_FALSE(looksLikeLabels(folder / "study"));
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

// What we write ourselves.

/// Three structures in an odd grid; planes of eight voxels and one, so that bits of frames share bytes.
LabelVolume someLabels(const glm::dmat4& matrix, glm::ivec3 dims = {9, 7, 11}) {
  LabelVolume labels(dims, matrix);
  std::vector<std::uint16_t> ids(std::size_t(dims.x * dims.y * dims.z));
  std::uint32_t state = 5;
  for (auto& id : ids) {
    state = state * 1664525u + 1013904223u;
    constexpr std::uint16_t kIds[] = {0, 0, 0, 3, 700, 65535};
    id = kIds[(state >> 16) % 6];
  }
  // An empty plane between others, and at the end.
  auto plane = std::ptrdiff_t(dims.x * dims.y);
  std::fill(ids.begin() + 4 * plane, ids.begin() + 5 * plane, std::uint16_t(0));
  std::fill(ids.end() - plane, ids.end(), std::uint16_t(0));
  labels.write({0, 0, 0}, dims, ids);
  labels.table = {{3, "left kidney", {1, 0, 0}, 1},
                  {700, "Mus\u0301culo \u00e9", {0.2f, 0.5f, 1}, 1},
                  {65535, "bone", {0.9f, 0.85f, 0.7f}, 1}};
  labels.name = "of a test";
  return labels;
}

std::vector<std::string> writeTo(const LabelVolume& labels, const std::filesystem::path& path) {
  Progress progress;
  return writeLabels(labels, path, progress);
}

TEST(DicomSeg, WhatIsWrittenIsReadBackVoxelForVoxelAndInPlace) {
  TempFolder folder;
  for (bool isLeftHanded : {false, true}) {
    LabelVolume labels = someLabels(obliqueMatrix(isLeftHanded, false));
    EXPECT_TRUE(writeTo(labels, folder / "s.dcm").empty());
    EXPECT_TRUE(looksLikeLabels(folder / "s.dcm"));
    LabelVolume back = readLabelsOf(folder / "s.dcm");
    ASSERT_EQ(back.dims(), labels.dims());
    // DICOM counts planes along the normal of rows and columns: a left-handed grid comes back from its other end.
    int top = labels.dims().z - 1;
    auto backOf = [&](glm::ivec3 v) { return isLeftHanded ? glm::ivec3(v.x, v.y, top - v.z) : v; };
    for (int z = 0; z <= top; ++z)
      for (int y = 0; y < labels.dims().y; ++y)
        for (int x = 0; x < labels.dims().x; ++x) {
          glm::ivec3 v(x, y, z);
          ASSERT_EQ(back.at(backOf(v)), labels.at(v)) << x << " " << y << " " << z;
        }
    for (glm::ivec3 v : {glm::ivec3(0), glm::ivec3(8, 6, 10)}) {
      auto off = back.worldFromVoxel() * glm::dvec4(backOf(v), 1) - labels.worldFromVoxel() * glm::dvec4(v, 1);
      EXPECT_LT(glm::length(off), 1e-6) << "decimals of DICOM have 16 characters";
    }
    EXPECT_EQ(back.name, "of a test");
    EXPECT_TRUE(back.warnings.empty()) << back.warnings[0];
  }
}

TEST(DicomSeg, IdsNamesAndColoursSurvive) {
  TempFolder folder;
  LabelVolume labels = someLabels(glm::dmat4(1.0));
  writeTo(labels, folder / "s.dcm");
  LabelVolume back = readLabelsOf(folder / "s.dcm");
  ASSERT_EQ(back.table.size(), labels.table.size());
  for (std::size_t i = 0; i < labels.table.size(); ++i) {
    EXPECT_EQ(back.table[i].id, labels.table[i].id);
    EXPECT_EQ(back.table[i].name, labels.table[i].name);
    // Lab of 16 bits: the darkest channels are the coarsest.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.table[i].color[c], labels.table[i].color[c], 2e-3f);
  }
}

TEST(DicomSeg, SegmentsAreNumberedFromOneForOtherPrograms) {
  TempFolder folder;
  writeTo(someLabels(glm::dmat4(1.0)), folder / "s.dcm");
  gdcm::Reader reader;
  reader.SetFileName((folder / "s.dcm").c_str());
  ASSERT_TRUE(reader.Read());
  auto segments = reader.GetFile().GetDataSet().GetDataElement(Tag(0x0062, 0x0002)).GetValueAsSQ();
  ASSERT_EQ(segments->GetNumberOfItems(), 3u);
  for (std::uint16_t i = 1; i <= 3; ++i) {
    const DataSet& item = segments->GetItem(i).GetNestedDataSet();
    std::uint16_t number = 0;
    std::memcpy(&number, item.GetDataElement(Tag(0x0062, 0x0004)).GetByteValue()->GetPointer(), 2);
    EXPECT_EQ(number, i);
  }
}

TEST(DicomSeg, CodesSayWhatSegmentsAre) {
  // Category and type of DICOM PS3.16: CID 7150 with CID 7166, 7159, 7152 and so on, as other programs write them.
  struct Row {
    const char *name, *category, *type;
  };
  constexpr Row kRows[] = {{"Ulnar artery", "85756007", "51114001"},
                           {"extensor tendons", "85756007", "13024002"},
                           {"costal cartilage", "85756007", "309312004"},
                           {"subcutaneous fat", "85756007", "248300009"},
                           {"heart muscle", "85756007", "71616004"},
                           {"third metacarpal", "85756007", "272673000"},
                           {"ribs left", "85756007", "272673000"},
                           {"hepatic veins", "85756007", "29092000"},
                           {"kidney_left", "123037004", "64033007"},
                           {"aorta", "123037004", "15825003"},
                           {"lesion 2", "49755003", "52988006"},
                           {"gas", "91720002", "74947009"},
                           {"cribriform plate", "123037004", "91723000"},  // no rib
                           {"", "123037004", "91723000"}};
  int count = int(std::size(kRows));
  LabelVolume labels({count, 2, 2}, glm::dmat4(1.0));
  for (int i = 0; i < count; ++i) {
    auto id = std::uint16_t(i + 1);
    labels.write({i, 0, 0}, {1, 1, 1}, std::span(&id, 1));
    labels.table.push_back({id, kRows[i].name});
  }
  TempFolder folder;
  writeTo(labels, folder / "s.dcm");
  gdcm::Reader reader;
  reader.SetFileName((folder / "s.dcm").c_str());
  ASSERT_TRUE(reader.Read());
  auto segments = reader.GetFile().GetDataSet().GetDataElement(Tag(0x0062, 0x0002)).GetValueAsSQ();
  ASSERT_EQ(int(segments->GetNumberOfItems()), count);
  auto textOf = [](const DataSet& set, Tag tag) {
    const gdcm::ByteValue* value = set.GetDataElement(tag).GetByteValue();
    std::string text = value ? std::string(value->GetPointer(), value->GetLength()) : "";
    return text.substr(0, text.find_last_not_of(' ') + 1);
  };
  for (int i = 0; i < count; ++i) {
    const DataSet& segment = segments->GetItem(std::size_t(i + 1)).GetNestedDataSet();
    auto codeOf = [&](Tag sequence) {
      const DataSet& code = segment.GetDataElement(sequence).GetValueAsSQ()->GetItem(1).GetNestedDataSet();
      EXPECT_EQ(textOf(code, Tag(0x0008, 0x0102)), "SCT");
      EXPECT_FALSE(textOf(code, Tag(0x0008, 0x0104)).empty());
      return textOf(code, Tag(0x0008, 0x0100));
    };
    EXPECT_EQ(codeOf(Tag(0x0062, 0x0003)), kRows[i].category) << kRows[i].name;
    EXPECT_EQ(codeOf(Tag(0x0062, 0x000f)), kRows[i].type) << kRows[i].name;
    EXPECT_EQ(textOf(segment, Tag(0x0062, 0x0008)), "SEMIAUTOMATIC");
    EXPECT_EQ(textOf(segment, Tag(0x0062, 0x0009)), "Velum") << "which the type makes necessary";
  }
}

TEST(DicomSeg, WhatDicomCannotHoldIsRefusedOrSaid) {
  TempFolder folder;
  EXPECT_THROW(writeTo(someLabels(obliqueMatrix(false, true)), folder / "s.dcm"), InputError) << "sheared";
  LabelVolume angstrom = someLabels(glm::dmat4(1.0));
  angstrom.setLengthUnit(LengthUnit::Angstrom);
  EXPECT_THROW(writeTo(angstrom, folder / "s.dcm"), InputError);
  EXPECT_THROW(writeTo(LabelVolume({4, 4, 4}, glm::dmat4(1.0)), folder / "s.dcm"), InputError) << "nothing in it";
  EXPECT_FALSE(std::filesystem::exists(folder / "s.dcm"));
  LabelVolume faint = someLabels(glm::dmat4(1.0));
  faint.table[0].opacity = 0.5f;
  faint.table[1].name = std::string(80, 'x') + "\\";
  EXPECT_EQ(writeTo(faint, folder / "s.dcm").size(), 2u);
}

}  // namespace
}  // namespace velum::io
