#include <gdcmAttribute.h>
#include <gdcmImageWriter.h>
#include <gdcmUIDGenerator.h>
#include <gdcmWriter.h>

#include <tuple>

#include "DicomParts.h"
#include "TestFiles.h"
#include "io/labels/ReadLabels.h"

namespace velum::io {
namespace {

/// One synthetic CT slice.
struct Slice {
  std::string name;
  std::string series = "1.2.3.4";
  glm::dvec3 position{0.0};
  int size = 8;
  std::int16_t value = 0;  ///< All pixels, stored.
  double slope = 1, intercept = -1024;
  std::string photometric = "MONOCHROME2", modality = "CT";
  std::string temporal;            ///< Temporal position identifier.
  bool acrossStack = false;        ///< A scout: sagittal instead of axial.
  std::string thickness, between;  ///< Of slices, and from one to the next, mm.
};

void writeSlice(const TempFolder& folder, const Slice& slice) {
  gdcm::ImageWriter writer;
  gdcm::Image& image = writer.GetImage();
  image.SetNumberOfDimensions(2);
  unsigned int dims[2] = {unsigned(slice.size), 8};
  image.SetDimensions(dims);
  image.SetPixelFormat(gdcm::PixelFormat(1, 16, 12, 11, 0));
  image.SetPhotometricInterpretation(slice.photometric == "MONOCHROME1" ? gdcm::PhotometricInterpretation::MONOCHROME1
                                                                        : gdcm::PhotometricInterpretation::MONOCHROME2);
  image.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::vector<std::uint16_t> pixels(std::size_t(slice.size) * 8, std::uint16_t(slice.value));
  gdcm::DataElement data(gdcm::Tag(0x7fe0, 0x0010));
  data.SetByteValue(reinterpret_cast<const char*>(pixels.data()), std::uint32_t(pixels.size() * 2));
  image.SetDataElement(data);
  image.SetSlope(slice.slope);
  image.SetIntercept(slice.intercept);
  image.SetSpacing(0, 0.5);
  image.SetSpacing(1, 0.75);
  for (unsigned i = 0; i < 3; ++i) image.SetOrigin(i, slice.position[int(i)]);
  double axial[] = {1, 0, 0, 0, 1, 0}, sagittal[] = {0, 1, 0, 0, 0, -1};
  image.SetDirectionCosines(slice.acrossStack ? sagittal : axial);
  gdcm::DataSet& set = writer.GetFile().GetDataSet();
  gdcm::UIDGenerator uids;
  putText(set, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2");
  putText(set, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, uids.Generate());
  putText(set, gdcm::Tag(0x0008, 0x0060), gdcm::VR::CS, slice.modality);
  putText(set, gdcm::Tag(0x0008, 0x103e), gdcm::VR::LO, "series " + slice.series);
  putText(set, gdcm::Tag(0x0020, 0x000e), gdcm::VR::UI, slice.series);
  if (!slice.thickness.empty()) putText(set, gdcm::Tag(0x0018, 0x0050), gdcm::VR::DS, slice.thickness);
  if (!slice.between.empty()) putText(set, gdcm::Tag(0x0018, 0x0088), gdcm::VR::DS, slice.between);
  if (!slice.temporal.empty()) putText(set, gdcm::Tag(0x0020, 0x0100), gdcm::VR::IS, slice.temporal);
  writer.SetFileName((folder / slice.name).c_str());
  ASSERT_TRUE(writer.Write());
}

/// Slices at z = 0, 2.5, 5, ... with value 1024 + 10 z, named against their order.
void writeSeries(const TempFolder& folder, std::initializer_list<int> planes, glm::dvec3 step = {0, 0, 2.5}) {
  for (int plane : planes) {
    Slice s;
    s.name = "s" + std::to_string(plane * 7 % 11) + "_" + std::to_string(plane) + ".dcm";
    s.position = glm::dvec3(10, 20, 30) + step * double(plane);
    s.value = std::int16_t(1024 + 10 * plane);
    writeSlice(folder, s);
  }
}

bool warns(const Volume& v, const std::string& word) {
  for (const std::string& w : v.warnings)
    if (w.find(word) != std::string::npos) return true;
  return false;
}

TEST(Dicom, SlicesAreOrderedByPositionNotByName) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2, 3, 4, 5});
  Volume v = read(folder.path());
  EXPECT_EQ(v.dims, glm::ivec3(8, 8, 6));
  EXPECT_EQ(v.type, SampleType::Int16);
  for (int z = 0; z < 6; ++z) EXPECT_EQ(valueAt(v, {3, 3, z}), 10 * z);
  EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(0, 0, 2.5, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_EQ(v.modality, Modality::CT);
  EXPECT_EQ(v.unit, "HU");
  EXPECT_EQ(v.name, "series 1.2.3.4");
  EXPECT_TRUE(v.warnings.empty()) << v.warnings[0];
}

TEST(Dicom, AnyFileOfTheSeriesGivesTheSameVolume) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2, 3});
  Volume whole = read(folder.path());
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_TRUE(read(entry.path()).voxels == whole.voxels);
}

TEST(Dicom, MissingSliceIsFilledInWithAWarning) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2, 4, 5});
  Volume v = read(folder.path());
  EXPECT_EQ(v.dims.z, 6);
  for (int z = 0; z < 6; ++z) EXPECT_EQ(valueAt(v, {0, 0, z}), 10 * z);
  EXPECT_TRUE(warns(v, "1 missing"));
  ASSERT_EQ(v.gaps.size(), 1u);
  EXPECT_EQ(v.gaps[0][1], 1) << "and where it was stays known";
}

TEST(Dicom, NothingIsMadeUpBetweenSlicesThatAreFarApart) {
  {  // Two parts of a body, 95 mm apart.
    TempFolder folder;
    writeSeries(folder, {0, 1, 2, 40, 41, 42});
    Volume v = read(folder.path());
    ASSERT_EQ(v.dims.z, 43);
    for (int z = 0; z < 43; ++z) EXPECT_EQ(valueAt(v, {0, 0, z}), z <= 2 || z >= 40 ? 10 * z : 0) << z;
    ASSERT_EQ(v.gaps.size(), 1u);
    EXPECT_EQ(v.gaps[0], glm::ivec2(3, 37));
    EXPECT_TRUE(warns(v, "37 left empty")) << v.warnings[0];
    EXPECT_FALSE(warns(v, "linearly"));
    EXPECT_NEAR(glm::dot(glm::dvec3(v.worldFromVoxel * glm::dvec4(0, 0, 42, 1)), glm::dvec3(0, 0, 1)), 30 + 42 * 2.5,
                1e-6)
        << "each slice is where it was";
  }
  {  // A few slices, each far from the next, are no body from the first to the last.
    TempFolder folder;
    writeSeries(folder, {0, 1, 2, 3}, {0, 0, 246});
    Volume v = read(folder.path());
    std::set<double> seen;
    int shown = 0;
    for (int z = 0; z < v.dims.z; ++z) {
      seen.insert(valueAt(v, {1, 0, z}));
      shown += valueAt(v, {1, 0, z}) != v.range.x;
    }
    EXPECT_LE(seen.size(), 4u) << "no value lies between those of the slices";
    EXPECT_LT(shown, v.dims.z / 10);
    EXPECT_NEAR(spacingOf(v).z * (v.dims.z - 1), 3 * 246.0, 1e-6);
    EXPECT_TRUE(warns(v, "246.000")) << v.warnings[0];
  }
}

TEST(Dicom, SlicesThatAreAllButMissingAreRefused) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2, 40000});
  EXPECT_THROW(read(folder.path()), InputError);
}

TEST(Dicom, GantryTiltShearsTheMatrix) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2, 3}, {0, 0.7, 2.5});
  Volume v = read(folder.path());
  EXPECT_NEAR(v.worldFromVoxel[2].y, 0.7, 1e-9);
  EXPECT_NEAR(v.worldFromVoxel[2].z, 2.5, 1e-9);
  EXPECT_TRUE(warns(v, "tilt"));
}

TEST(Dicom, OddSliceIsRefusedByName) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2});
  Slice odd;
  odd.name = "odd.dcm";
  odd.size = 6;
  odd.position = {10, 20, 37.5};
  writeSlice(folder, odd);
  try {
    read(folder.path());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("odd.dcm"), std::string::npos) << error.what();
  }
}

TEST(Dicom, TwoSeriesAreListedAndChosen) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2});
  Slice other;
  other.series = "1.2.3.5";
  other.value = 500;
  for (int z = 0; z < 2; ++z) {
    other.name = "b" + std::to_string(z);
    other.position = {0, 0, double(z)};
    writeSlice(folder, other);
  }
  Progress progress;
  auto series = listSeries(folder.path(), progress);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[0].uid, "1.2.3.4");
  EXPECT_EQ(series[0].imageCount, 3);
  EXPECT_EQ(series[0].size, glm::ivec2(8, 8));
  EXPECT_EQ(series[1].description, "series 1.2.3.5");
  EXPECT_EQ(read(folder.path()).dims.z, 3);
  scene::Source source;
  source.path = folder.path().string();
  source.series = "1.2.3.5";
  EXPECT_EQ(readVolume(source, progress).dims.z, 2);
  EXPECT_EQ(read(folder / "b0").dims.z, 2);
}

/// As a hospital's medium has them: folders in folders, an index, and what is no image.
void writeMedium(const TempFolder& folder) {
  for (auto [sub, series, count] : {std::tuple("PA000001/ST1/SE1", "1.2.3.4", 4), {"PA000001/ST1/SE2", "1.2.3.5", 2}}) {
    std::filesystem::create_directories(folder / sub);
    for (int z = 0; z < count; ++z) {
      Slice slice;
      slice.name = fmt::format("{}/IM{}", sub, z);
      slice.series = series;
      slice.position = {0, 0, 2.5 * z};
      slice.value = std::int16_t(100 * z);
      writeSlice(folder, slice);
    }
  }
  writeText(folder / "PA000001/README.TXT", "viewer");
  gdcm::Writer writer;
  gdcm::DataSet& set = writer.GetFile().GetDataSet();
  putText(set, gdcm::Tag(0x0008, 0x0016), gdcm::VR::UI, "1.2.840.10008.1.3.10");
  putText(set, gdcm::Tag(0x0008, 0x0018), gdcm::VR::UI, "1.2.3.99");
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  writer.SetCheckFileMetaInformation(true);
  writer.SetFileName((folder / "DICOMDIR").c_str());
  ASSERT_TRUE(writer.Write());
}

TEST(Dicom, FoldersBelowAreSearchedAndAnIndexOpensThem) {
  TempFolder folder;
  writeMedium(folder);
  // A viewer's copy of one series, as media have it, is not a second stack of the same images.
  std::filesystem::create_directories(folder / "VIEWER");
  std::filesystem::copy(folder / "PA000001/ST1/SE1", folder / "VIEWER/SE1");
  Progress progress;
  for (const std::filesystem::path& path :
       {folder.path(), std::filesystem::path(folder.path().string() + "/"), folder / "DICOMDIR"}) {
    SCOPED_TRACE(path);
    auto series = listSeries(path, progress);
    ASSERT_EQ(series.size(), 2u);
    EXPECT_EQ(series[0].imageCount, 4);
    EXPECT_EQ(series[1].imageCount, 2);
    EXPECT_EQ(read(path).dims.z, 4);
    scene::Source source;
    source.path = path.string();
    source.series = "1.2.3.5";
    EXPECT_EQ(readVolume(source, progress).dims.z, 2);
    Volume image = readSeriesImage(series[0], progress);
    EXPECT_EQ(image.dims, glm::ivec3(8, 8, 1));
    EXPECT_EQ(valueAt(image, {3, 3, 0}), 200 - 1024) << "the middle one of four";
  }
}

TEST(Dicom, AnImageAloneIsAsThickAsItIsFarFromTheNext) {
  for (auto [thickness, between, wanted] :
       {std::tuple("5", "3", 3.0), std::tuple("5", "", 5.0), std::tuple("", "3", 3.0)}) {
    TempFolder folder;
    Slice slice;
    slice.name = "one.dcm";
    slice.thickness = thickness, slice.between = between;
    writeSlice(folder, slice);
    EXPECT_NEAR(spacingOf(read(folder / "one.dcm")).z, wanted, 1e-9) << thickness << ", " << between;
  }
}

TEST(Dicom, TheSearchOfFoldersCanBeStopped) {
  TempFolder folder;
  writeMedium(folder);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(listSeries(folder.path(), progress), Cancelled);
}

TEST(Dicom, AFileOfAnotherFormatListsNoSeries) {
  TempFolder folder;
  Progress progress;
  writeSeries(folder, {0, 1, 2});
  write(rampVolume(SampleType::UInt8, {4, 4, 4}), folder / "a.nii.gz");
  EXPECT_TRUE(listSeries(folder / "a.nii.gz", progress).empty());
  EXPECT_EQ(listSeries(folder / "s0_0.dcm", progress).size(), 1u);
}

TEST(Dicom, RepeatsAreLeftOutAndTimesBecomeFrames) {
  TempFolder folder;
  writeSeries(folder, {0, 1});
  Slice again;
  again.name = "again";
  again.position = {10, 20, 30};
  writeSlice(folder, again);
  Volume v = read(folder.path());
  EXPECT_EQ(v.dims.z, 2);
  EXPECT_TRUE(warns(v, "repeat"));

  TempFolder times;
  for (int t = 0; t < 3; ++t)
    for (int z = 0; z < 2; ++z) {
      Slice s;
      s.name = std::to_string(9 - t) + std::to_string(z);
      s.position = {0, 0, double(z)};
      s.temporal = std::to_string(t + 1);
      s.value = std::int16_t(1024 + 10 * t + z);
      writeSlice(times, s);
    }
  Volume movie = read(times.path());
  EXPECT_EQ(movie.timeSteps, 3);
  EXPECT_EQ(movie.dims.z, 2);
  for (int t = 0; t < 3; ++t)
    for (int z = 0; z < 2; ++z) EXPECT_EQ(valueAt(movie, {0, 0, z}, 0, t), 10 * t + z);
}

TEST(Dicom, ScoutAcrossTheStackIsLeftOut) {
  TempFolder folder;
  writeSeries(folder, {0, 1, 2});
  Slice scout;
  scout.name = "scout";
  scout.acrossStack = true;
  writeSlice(folder, scout);
  Volume v = read(folder.path());
  EXPECT_EQ(v.dims.z, 3);
  EXPECT_TRUE(warns(v, "orientation"));
}

TEST(Dicom, RescaleOfEachSliceIsApplied) {
  TempFolder folder;
  for (int z = 0; z < 3; ++z) {
    Slice s;
    s.name = std::to_string(z);
    s.position = {0, 0, double(z)};
    s.value = 100;
    s.slope = 0.5 + z;
    s.intercept = 0;
    writeSlice(folder, s);
  }
  Volume v = read(folder.path());
  EXPECT_EQ(v.type, SampleType::Float32);
  for (int z = 0; z < 3; ++z) EXPECT_FLOAT_EQ(float(valueAt(v, {0, 0, z})), float(100 * (0.5 + z)));
}

TEST(Dicom, Monochrome1IsTurnedRound) {
  TempFolder folder;
  for (int z = 0; z < 2; ++z) {
    Slice s;
    s.name = std::to_string(z);
    s.position = {0, 0, double(z)};
    s.value = std::int16_t(z);
    s.intercept = 0;
    s.photometric = "MONOCHROME1";
    s.modality = "CR";  // a CT's values have a meaning
    writeSlice(folder, s);
  }
  Volume v = read(folder.path());
  EXPECT_GT(valueAt(v, {0, 0, 0}), valueAt(v, {0, 0, 1}));
  EXPECT_TRUE(warns(v, "MONOCHROME1"));
}

TEST(Dicom, FramesOfAnEnhancedFileAreOrderedByTheirPlace) {
  TempFolder folder;
  gdcm::DataSet set;
  // The normal is y x -z = -x: the largest x comes first.
  putGroups(set, {10, 30, 20});
  std::string pixels;
  for (std::uint16_t value : {110, 130, 120})
    for (int i = 0; i < 8; ++i) pixels.append(reinterpret_cast<const char*>(&value), 2);
  DicomImage image{set, "1.2.840.10008.5.1.4.1.1.4.1", "MR"};
  image.frames = 3;
  image.stored = 12;
  image.pixels = pixels;
  ASSERT_TRUE(writeDicom(folder / "e.dcm", image));
  Volume v = read(folder / "e.dcm");
  EXPECT_EQ(v.dims, glm::ivec3(4, 2, 3));
  for (int z = 0; z < 3; ++z) EXPECT_EQ(valueAt(v, {1, 1, z}), 30 - 10 * z);
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0, 0.5, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[1], glm::dvec4(0, 0, -0.75, 0));
  EXPECT_EQ(v.worldFromVoxel[2], glm::dvec4(-10, 0, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(30, 5, 6, 1));
  EXPECT_EQ(v.modality, Modality::MR);
}

TEST(Dicom, ALyingLengthAllocatesNothing) {
  TempFolder folder;
  writeSeries(folder, {0});
  std::filesystem::path file = std::filesystem::directory_iterator(folder.path())->path();
  std::string bytes(std::filesystem::file_size(file), '\0');
  std::ifstream(file, std::ios::binary).read(bytes.data(), std::streamsize(bytes.size()));
  auto at = bytes.rfind(std::string("\xe0\x7f\x10\x00OW", 6));
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at + 8, 4, "\xfe\xff\xff\xef", 4);
  writeText(file, bytes);
  expectClearError(file);
}

TEST(Dicom, WithoutAHeaderAFileBeginsAsAllOfThemDo) {
  TempFolder folder;
  writeSeries(folder, {0});
  std::filesystem::path file = std::filesystem::directory_iterator(folder.path())->path();
  std::string bytes = bytesOf(file);
  bytes.erase(0, bytes.find(std::string("\x08\0\x16\0UI", 6)));
  writeText(file, bytes);
  EXPECT_EQ(read(file).dims.z, 1);
  // GDCM takes this for the other byte order, and the length for gigabytes.
  writeText(file, std::string("\x02\x01\0\0UV\0\0\x04\0\0\0abcd", 16) + bytes);
  expectClearError(file);
}

/// GDCM asserts both, and Debian builds it so that this ends the program.
TEST(Dicom, WhatGdcmAsksForHasItsRepresentationOrIsRefused) {
  TempFolder folder;
  auto path = folder / "a.dcm";
  for (auto [group, element, vr, text] : {std::tuple(0x0028, 0x0008, gdcm::VR::AS, "1"),
                                          {0x0028, 0x0030, gdcm::VR::LO, "1\\1"},
                                          {0x0020, 0x0032, gdcm::VR::SH, "0\\0\\0"},
                                          {0x0008, 0x0010, gdcm::VR::SH, "ACR-NEMA 9.0"}}) {
    DicomImage image;
    putPlace(image.set, 0);
    image.pixels = std::string(16, '\1');
    ASSERT_TRUE(writeDicom(path, image));
    EXPECT_EQ(read(path).dims, glm::ivec3(4, 2, 1));
    putText(image.set, gdcm::Tag(std::uint16_t(group), std::uint16_t(element)), vr, text);
    ASSERT_TRUE(writeDicom(path, image));
    expectClearError(path);
  }
}

}  // namespace
}  // namespace velum::io
