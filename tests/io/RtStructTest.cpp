// Structure sets of radiotherapy: contours by hand, filled where they say.
#include <cmath>

#include "DicomParts.h"
#include "TestFiles.h"

namespace velum::io {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

struct Line {
  std::vector<glm::dvec3> points;
  const char* type = "CLOSED_PLANAR";
};

struct Roi {
  int number;
  std::string name, color;
  std::vector<Line> lines;
};

gdcm::SmartPointer<gdcm::SequenceOfItems> newSequence() {
  auto sequence = gdcm::SequenceOfItems::New();
  sequence->SetLengthToUndefined();
  return sequence;
}

void add(gdcm::SequenceOfItems& sequence, const DataSet& set) {
  gdcm::Item item;
  item.SetNestedDataSet(set);
  item.SetVLToUndefined();
  sequence.AddItem(item);
}

DataSet contourOf(const Line& line) {
  DataSet set;
  std::string numbers;
  for (glm::dvec3 p : line.points)
    numbers += (numbers.empty() ? "" : "\\") + fmt::format("{:.4f}\\{:.4f}\\{:.4f}", p.x, p.y, p.z);
  putText(set, Tag(0x3006, 0x0042), VR::CS, line.type);
  putText(set, Tag(0x3006, 0x0050), VR::DS, numbers);
  return set;
}

bool writeRtStruct(const std::filesystem::path& path, const std::vector<Roi>& rois, const std::string& ofSeries = "") {
  DataSet set;
  auto names = newSequence(), contours = newSequence();
  for (const Roi& roi : rois) {
    DataSet name, region;
    putText(name, Tag(0x3006, 0x0022), VR::IS, std::to_string(roi.number));
    putText(name, Tag(0x3006, 0x0026), VR::LO, roi.name);
    add(*names, name);
    putText(region, Tag(0x3006, 0x002a), VR::IS, roi.color);
    putText(region, Tag(0x3006, 0x0084), VR::IS, std::to_string(roi.number));
    auto lines = newSequence();
    for (const Line& line : roi.lines) add(*lines, contourOf(line));
    putSequence(region, Tag(0x3006, 0x0040), lines);
    add(*contours, region);
  }
  putText(set, Tag(0x0008, 0x0016), VR::UI, "1.2.840.10008.5.1.4.1.1.481.3");
  putText(set, Tag(0x0008, 0x0018), VR::UI, "1.2.3.77.1");
  putText(set, Tag(0x0008, 0x0060), VR::CS, "RTSTRUCT");
  putText(set, Tag(0x0020, 0x000e), VR::UI, "1.2.3.77");
  putText(set, Tag(0x3006, 0x0002), VR::SH, "Plan 1");
  putSequence(set, Tag(0x3006, 0x0020), names);
  putSequence(set, Tag(0x3006, 0x0039), contours);
  if (!ofSeries.empty()) {
    DataSet series, study, frame;
    putText(series, Tag(0x0020, 0x000e), VR::UI, ofSeries);
    putSequence(study, Tag(0x3006, 0x0014), sequenceWith(series));
    putSequence(frame, Tag(0x3006, 0x0012), sequenceWith(study));
    putSequence(set, Tag(0x3006, 0x0010), sequenceWith(frame));
  }
  gdcm::Writer writer;
  writer.GetFile().SetDataSet(set);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetFileName(path.c_str());
  return writer.Write();
}

/// A circle across z.
Line circle(glm::dvec3 middle, double radius) {
  Line line;
  for (int i = 0; i < 90; ++i) {
    double angle = 2.0 * M_PI * i / 90;
    line.points.push_back(middle + radius * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
  }
  return line;
}

std::uint16_t idAt(const LabelVolume& labels, glm::dvec3 world) {
  glm::dvec3 voxel(glm::inverse(labels.worldFromVoxel()) * glm::dvec4(world, 1.0));
  return labels.at(glm::ivec3(glm::round(voxel)));
}

double volumeOf(const LabelVolume& labels, std::uint16_t id) {
  double count = 0;
  for (int z = 0; z < labels.dims().z; ++z)
    for (int y = 0; y < labels.dims().y; ++y)
      for (int x = 0; x < labels.dims().x; ++x) count += labels.at({x, y, z}) == id;
  return count * std::abs(glm::determinant(glm::dmat3(labels.worldFromVoxel())));
}

TEST(RtStruct, ContoursAreFilledWhereTheyLieWithNamesAndColours) {
  TempFolder folder;
  Roi ball{4, "Tumour", "255\\0\\0", {}};
  constexpr double kRadius = 30.0, kStep = 3.0;
  for (int i = -9; i <= 9; ++i)
    ball.lines.push_back(
        circle(glm::dvec3(10, -20, 100 + i * kStep), std::sqrt(kRadius * kRadius - i * i * kStep * kStep)));
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", {ball}));
  EXPECT_TRUE(looksLikeLabels(folder / "plan.dcm"));
  LabelVolume labels = readLabelsOf(folder / "plan.dcm");
  EXPECT_EQ(labels.name, "Plan 1");
  ASSERT_EQ(labels.table.size(), 1u);
  EXPECT_EQ(labels.table[0].name, "Tumour");
  EXPECT_EQ(labels.table[0].color, glm::vec3(1, 0, 0));
  EXPECT_EQ(idAt(labels, {10, -20, 100}), 4);
  EXPECT_EQ(idAt(labels, {10 + 29, -20, 100}), 4);
  EXPECT_EQ(idAt(labels, {10 + 31, -20, 100}), 0);
  double wanted = 4.0 / 3.0 * M_PI * kRadius * kRadius * kRadius;
  EXPECT_NEAR(volumeOf(labels, 4), wanted, 0.02 * wanted);
  EXPECT_TRUE(labels.warnings.empty());
}

TEST(RtStruct, RegionsOfAnyNumbersAreRegionsOfTheirOwn) {
  TempFolder folder;
  std::vector<Roi> rois;
  int place = 0;
  for (int number : {0, 1, 70000, -3, 90000, 2}) {
    Roi roi{number, fmt::format("region {}", number), "", {}};
    for (double z : {0.0, 2.0, 4.0}) roi.lines.push_back(circle({60.0 * place, 0, z}, 20));
    rois.push_back(roi);
    ++place;
  }
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", rois));
  LabelVolume labels = readLabelsOf(folder / "plan.dcm");
  ASSERT_EQ(labels.table.size(), rois.size());
  for (std::size_t i = 0; i < rois.size(); ++i) {
    std::uint16_t id = idAt(labels, {60.0 * double(i), 0, 2});
    auto row = std::find_if(labels.table.begin(), labels.table.end(), [id](auto& label) { return label.id == id; });
    ASSERT_NE(row, labels.table.end()) << rois[i].name;
    EXPECT_EQ(row->name, rois[i].name);
  }
  EXPECT_EQ(idAt(labels, {60, 0, 2}), 1) << "a number that can be an id is one";
  EXPECT_EQ(idAt(labels, {300, 0, 2}), 2);
}

TEST(RtStruct, AContourInAnotherIsAHoleAndSmallRegionsLieOverLargeOnes) {
  TempFolder folder;
  Roi body{1, "Body", "", {}}, ring{2, "Ring", "", {}};
  for (double z : {0.0, 2.0, 4.0}) {
    body.lines.push_back(circle({0, 0, z}, 50));
    ring.lines.push_back(circle({0, 0, z}, 20));
    ring.lines.push_back(circle({0, 0, z}, 10));
  }
  // The small one first in the file: its place there does not matter.
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", {ring, body}));
  LabelVolume labels = readLabelsOf(folder / "plan.dcm");
  EXPECT_EQ(idAt(labels, {15, 0, 2}), 2);
  EXPECT_EQ(idAt(labels, {5, 0, 2}), 1) << "the hole is the body's";
  EXPECT_EQ(idAt(labels, {40, 0, 2}), 1);
  ASSERT_EQ(labels.warnings.size(), 1u);
  EXPECT_NE(labels.warnings[0].find("smaller one"), std::string::npos);
}

TEST(RtStruct, ARegionOnEverySecondPlaneIsWholeAndPointsAreLeftOut) {
  TempFolder folder;
  Roi fine{1, "Fine", "", {}}, coarse{2, "Coarse", "", {}}, marker{3, "Marker", "", {}};
  for (int i = 0; i < 9; ++i) fine.lines.push_back(circle({-40, 0, 2.0 * i}, 8));
  for (int i = 0; i < 9; i += 2) coarse.lines.push_back(circle({40, 0, 2.0 * i}, 8));
  marker.lines.push_back({{{0, 0, 4}}, "POINT"});
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", {fine, coarse, marker}));
  LabelVolume labels = readLabelsOf(folder / "plan.dcm");
  for (int i = 0; i < 9; ++i) EXPECT_EQ(idAt(labels, {40, 0, 2.0 * i}), 2) << i;
  ASSERT_EQ(labels.warnings.size(), 1u);
  EXPECT_NE(labels.warnings[0].find("1 point or open line"), std::string::npos);
}

TEST(RtStruct, PlanesAcrossAnotherAxisKeepTheirPlace) {
  TempFolder folder;
  Roi roi{7, "Sagittal", "", {}};
  for (double x : {0.0, 4.0, 8.0}) {
    Line line = circle({0, 0, 0}, 12);
    for (glm::dvec3& p : line.points) p = {x, p.x + 100, p.y - 50};
    roi.lines.push_back(line);
  }
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", {roi}));
  LabelVolume labels = readLabelsOf(folder / "plan.dcm");
  EXPECT_EQ(idAt(labels, {4, 100, -50}), 7);
  EXPECT_EQ(idAt(labels, {4, 110, -50}), 7);
  EXPECT_EQ(idAt(labels, {4, 114, -50}), 0);
}

TEST(RtStruct, IsOfferedWithItsSeries) {
  TempFolder folder;
  DataSet ct;
  DicomImage image{ct, "1.2.840.10008.5.1.4.1.1.2", "CT"};
  image.pixels = std::string(16, '\0');
  ASSERT_TRUE(writeDicom(folder / "ct.dcm", image));
  ASSERT_TRUE(writeRtStruct(folder / "plan.dcm", {{1, "Body", "", {circle({0, 0, 0}, 5)}}}, image.series));
  Progress progress;
  auto all = listSeries(folder.path(), progress);
  ASSERT_EQ(all.size(), 2u);
  bool isFirst = all[0].isSegmentation;
  const SeriesInfo& plan = isFirst ? all[0] : all[1];
  EXPECT_TRUE(plan.isSegmentation);
  EXPECT_EQ(plan.referencedSeries, image.series);
  EXPECT_EQ(plan.description, "Plan 1");
  // Beside it the images are still a volume.
  EXPECT_EQ(read(folder.path()).dims, glm::ivec3(4, 2, 1));
}

TEST(RtStruct, AFolderThatHoldsItAloneOpens) {
  TempFolder folder;
  Line square{{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}}}, above{{{0, 0, 2}, {8, 0, 2}, {8, 8, 2}, {0, 8, 2}}};
  ASSERT_TRUE(writeRtStruct(folder / "set.dcm", {{1, "target", "255\\0\\0", {square, above}}}));
  LabelVolume labels = readLabelsOf(folder.path());
  ASSERT_EQ(labels.table.size(), 1u);
  EXPECT_EQ(labels.table[0].name, "target");
}

TEST(RtStruct, WhatHasNoContoursIsRefused) {
  TempFolder folder;
  ASSERT_TRUE(writeRtStruct(folder / "empty.dcm", {}));
  EXPECT_THROW(readLabelsOf(folder / "empty.dcm"), InputError);
  EXPECT_THROW(read(folder / "empty.dcm"), InputError);
}

}  // namespace
}  // namespace velum::io
