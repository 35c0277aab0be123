#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "TestFiles.h"
#include "makeVolume.h"

namespace velum::io {
namespace {

constexpr SampleType kAllTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                                    SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};

void expectSame(const Volume& wanted, const Volume& got, double matrixTolerance) {
  EXPECT_EQ(wanted.dims, got.dims);
  EXPECT_EQ(wanted.type, got.type);
  EXPECT_EQ(wanted.channels, got.channels);
  EXPECT_EQ(wanted.timeSteps, got.timeSteps);
  EXPECT_EQ(wanted.isColor, got.isColor);
  EXPECT_TRUE(wanted.voxels == got.voxels) << "voxels differ";
  expectSameMatrix(wanted.worldFromVoxel, got.worldFromVoxel, matrixTolerance);
}

class RoundTrip : public testing::TestWithParam<const char*> {};

// NIfTI-1 holds its matrix in floats: seven digits of 230 mm.
double toleranceOf(const std::string& extension) { return extension == ".nrrd" ? 1e-12 : 5e-5; }

TEST_P(RoundTrip, VoxelsAndWorldSurviveForEveryTypeAndHandedness) {
  TempFolder folder;
  for (SampleType type : kAllTypes)
    for (int shape = 0; shape < 4; ++shape) {
      SCOPED_TRACE(std::string(enumName(type)) + " shape " + std::to_string(shape));
      Volume v = rampVolume(type, {7, 5, 3});
      v.worldFromVoxel = obliqueMatrix(shape & 1, shape & 2);
      auto path = folder / ("a" + std::string(GetParam()));
      write(v, path);
      expectSame(v, read(path), toleranceOf(GetParam()));
    }
}

/// Other programs may go by the quaternion, which is written beside the matrix.
TEST(NiftiWriter, TheQuaternionSaysTheSameAsTheMatrix) {
  TempFolder folder;
  auto path = folder / "a.nii";
  // Such that each of the four parts is the largest once, with turns to either side.
  for (glm::dvec3 axis : {glm::dvec3(1, 0.3, -0.2), {0.2, -1, 0.3}, {-0.3, 0.2, 1}})
    for (double angle : {0.4, -0.7, 2.9, -2.6})
      for (double mirror : {1.0, -1.0}) {
        Volume v = rampVolume(SampleType::Int16, {7, 5, 3});
        glm::dmat4 frame = glm::rotate(glm::translate(glm::dmat4(1.0), {4, -5, 6}), angle, glm::normalize(axis));
        v.worldFromVoxel = glm::scale(frame, {0.5, 0.75, 2.0 * mirror});
        write(v, path);
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(254);
        file.write("\0", 2);  // sform_code: there is none
        file.close();
        expectSameMatrix(v.worldFromVoxel, read(path).worldFromVoxel, 5e-5);
      }
}

TEST_P(RoundTrip, ChannelsAndFramesSurvive) {
  TempFolder folder;
  auto path = folder / ("a" + std::string(GetParam()));
  for (auto [channels, frames] : {std::pair(1, 4), std::pair(2, 1), std::pair(3, 2), std::pair(5, 1)}) {
    Volume v = rampVolume(SampleType::Int16, {4, 5, 6}, channels, frames);
    v.timeStepSeconds = frames > 1 ? 0.25 : 0.0;
    write(v, path);
    Volume back = read(path);
    expectSame(v, back, 1e-5);
    EXPECT_DOUBLE_EQ(back.timeStepSeconds, v.timeStepSeconds);
  }
}

TEST_P(RoundTrip, ColourSurvives) {
  TempFolder folder;
  auto path = folder / ("a" + std::string(GetParam()));
  for (int channels : {3, 4}) {
    Volume v = rampVolume(SampleType::UInt8, {4, 5, 6}, channels);
    v.isColor = true;
    write(v, path);
    expectSame(v, read(path), 1e-5);
  }
}

TEST_P(RoundTrip, ScaleOffsetAndDoubtSurvive) {
  TempFolder folder;
  auto path = folder / ("a" + std::string(GetParam()));
  Volume v = rampVolume(SampleType::UInt16, {4, 5, 6});
  v.scale = 2.5;
  v.offset = -1024;
  v.isOrientationKnown = false;
  v.worldFromVoxel = obliqueMatrix(true, false);
  write(v, path);
  Volume back = read(path);
  expectSame(v, back, 5e-5);
  EXPECT_EQ(back.scale, 2.5);
  EXPECT_EQ(back.offset, -1024);
  EXPECT_FALSE(back.isOrientationKnown);
  EXPECT_EQ(valueAt(back, {1, 2, 3}), valueAt(v, {1, 2, 3}));
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip, testing::Values(".nrrd", ".nii", ".nii.gz"), [](const auto& test) {
  return std::string(test.param) == ".nii.gz" ? "niigz" : std::string(test.param + 1);
});

TEST(WriteVolume, SizesOver32767TakeNifti2) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {40000, 2, 1});
  v.worldFromVoxel = obliqueMatrix(false, true);
  write(v, folder / "long.nii.gz");
  Volume back = read(folder / "long.nii.gz");
  EXPECT_TRUE(back.voxels == v.voxels);
  expectSameMatrix(v.worldFromVoxel, back.worldFromVoxel, 1e-12);
}

TEST(WriteVolume, FailureLeavesTheOldFileAndNoTemporary) {
  TempFolder folder;
  writeText(folder / "a.nrrd", "old");
  Volume v = rampVolume(SampleType::UInt8, {64, 64, 64});
  Progress progress([&](double, const std::string&) { throw Cancelled(); });
  EXPECT_THROW(writeVolume(v, folder / "a.nrrd", progress), Cancelled);
  EXPECT_EQ(std::filesystem::file_size(folder / "a.nrrd"), 3u);
  int files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1);
}

TEST(WriteVolume, UnknownExtensionIsRefused) {
  TempFolder folder;
  EXPECT_THROW(write(rampVolume(SampleType::UInt8, {2, 2, 2}), folder / "a.xyz"), InputError);
}

TEST(ReadVolume, AnatomyHasOnePlaceInEveryFormat) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::Int16, {6, 5, 4});
  v.worldFromVoxel = obliqueMatrix(true, false);
  write(v, folder / "a.nrrd");
  write(v, folder / "a.nii.gz");
  std::string text =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix =";
  glm::dmat3 d = direction(v);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) text += " " + std::to_string(d[c][r]);
  auto origin = v.worldFromVoxel[3];
  text += "\nOffset = " + std::to_string(origin.x) + " " + std::to_string(origin.y) + " " + std::to_string(origin.z);
  text += "\nElementSpacing = 0.7 0.8 2.5\nDimSize = 6 5 4\nElementType = MET_SHORT\nElementDataFile = LOCAL\n";
  text.append(reinterpret_cast<const char*>(v.voxels.data()), v.voxels.size());
  writeText(folder / "a.mha", text);
  for (const char* name : {"a.nrrd", "a.nii.gz", "a.mha"}) {
    SCOPED_TRACE(name);
    Volume back = read(folder / name);
    EXPECT_TRUE(back.voxels == v.voxels);
    expectSameMatrix(v.worldFromVoxel, back.worldFromVoxel, 5e-5);  // six decimals of the text
  }
}

TEST(ReadVolume, ContentWinsOverTheName) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {3, 3, 3});
  write(v, folder / "a.nrrd");
  std::filesystem::rename(folder / "a.nrrd", folder / "a.nii.gz");
  EXPECT_TRUE(read(folder / "a.nii.gz").voxels == v.voxels);
}

TEST(ReadVolume, SpacingOverrideScalesTheColumns) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {3, 3, 3});
  v.worldFromVoxel = obliqueMatrix(false, false);
  write(v, folder / "a.nrrd");
  Progress progress;
  scene::Source source;
  source.path = (folder / "a.nrrd").string();
  source.spacing = {0.0, 4.0, 5.0};
  Volume back = readVolume(source, progress);
  EXPECT_NEAR(spacingOf(back).x, 0.7, 1e-12);
  EXPECT_NEAR(spacingOf(back).y, 4.0, 1e-12);
  EXPECT_NEAR(spacingOf(back).z, 5.0, 1e-12);
  EXPECT_NEAR(glm::dot(direction(back)[1], direction(v)[1]), 1.0, 1e-12);
}

TEST(ReadVolume, CancelStopsTheLoad) {
  TempFolder folder;
  write(rampVolume(SampleType::UInt8, {128, 128, 128}), folder / "a.nrrd");
  Progress progress;
  progress.cancel();
  scene::Source source;
  source.path = (folder / "a.nrrd").string();
  EXPECT_THROW(readVolume(source, progress), Cancelled);
}

TEST(NrrdReader, RasIsTurnedToLps) {
  TempFolder folder;
  writeText(folder / "a.nrrd",
            "NRRD0004\ntype: uchar\ndimension: 3\nspace: RAS\nsizes: 1 1 1\nspace directions: (2,0,0) (0,3,0) (0,0,4)\n"
            "encoding: raw\nspace origin: (10,20,30)\n\nx");
  Volume v = read(folder / "a.nrrd");
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(-2, 0, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[1], glm::dvec4(0, -3, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(-10, -20, 30, 1));
}

TEST(NrrdReader, Int64BecomesInt32WhereItFits) {
  TempFolder folder;
  std::int64_t samples[] = {-5, 70000, 3, 1};
  std::string bytes(reinterpret_cast<const char*>(samples), sizeof samples);
  writeText(folder / "a.nrrd",
            "NRRD0004\ntype: int64\ndimension: 3\nsizes: 2 2 1\nendian: little\nencoding: raw\n\n" + bytes);
  Volume v = read(folder / "a.nrrd");
  EXPECT_EQ(v.type, SampleType::Int32);
  EXPECT_EQ(v.range, glm::dvec2(-5, 70000));
}

TEST(NrrdReader, TextEncodingIsRead) {
  TempFolder folder;
  writeText(folder / "a.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2 1\nencoding: ascii\n\n1 -2\n3 400\n");
  EXPECT_EQ(read(folder / "a.nrrd").range, glm::dvec2(-2, 400));
}

TEST(NrrdReader, ListAndPatternOfFilesAreJoined) {
  TempFolder folder;
  for (int i = 1; i <= 3; ++i) writeText(folder / ("s00" + std::to_string(i)), std::string(4, char(i)));
  std::string head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 3\nencoding: raw\n";
  writeText(folder / "pattern.nhdr", head + "data file: s%03d 1 3 1\n");
  writeText(folder / "list.nhdr", head + "data file: LIST\ns001\ns002\ns003\n");
  for (const char* name : {"pattern.nhdr", "list.nhdr"}) {
    Volume v = read(folder / name);
    EXPECT_EQ(valueAt(v, {1, 1, 0}), 1);
    EXPECT_EQ(valueAt(v, {0, 0, 2}), 3);
  }
}

TEST(MrcReader, CellIsInAngstromAndAxesMayBePermuted) {
  TempFolder folder;
  std::string header(1024, '\0');
  auto put = [&](std::size_t at, auto value) { std::memcpy(header.data() + at, &value, sizeof value); };
  int ints[] = {2, 3, 4, 1, 0, 0, 0, 4, 3, 2};  // columns run along z
  std::memcpy(header.data(), ints, sizeof ints);
  put(40, 8.0f), put(44, 9.0f), put(48, 10.0f);
  put(64, 3), put(68, 2), put(72, 1);
  header.replace(208, 4, "MAP ");
  writeText(folder / "a.mrc", header + std::string(2 * 2 * 3 * 4, '\1'));
  Volume v = read(folder / "a.mrc");
  EXPECT_EQ(v.dims, glm::ivec3(2, 3, 4));
  EXPECT_EQ(v.type, SampleType::Int16);
  EXPECT_EQ(v.lengthUnit, LengthUnit::Angstrom);
  EXPECT_NEAR(v.worldFromVoxel[0].z, 5.0, 1e-6);
  EXPECT_NEAR(v.worldFromVoxel[1].y, 3.0, 1e-6);
  EXPECT_NEAR(v.worldFromVoxel[2].x, 2.0, 1e-6);
}

TEST(LengthUnits, VoxelsOfFewNanometresInMillimetresKeepTheirSize) {
  TempFolder folder;
  Volume tissue = makeVolume(
      {4, 3, 5}, SampleType::UInt8, [](glm::ivec3 p) { return 10 * p.x + p.z; },
      centredFrame({4, 3, 5}, glm::dvec3(4e-6, 4e-6, 30e-6)));
  Progress progress;
  for (const char* name : {"a.nrrd", "a.nii", "a.vti", "a.vdb"}) {
    SCOPED_TRACE(name);
    writeVolume(tissue, folder / name, progress);
    Volume again = read(folder / name);
    glm::dvec3 nanometres = spacingOf(again) * unitsPer(again.lengthUnit, LengthUnit::Angstrom) * 0.1;
    EXPECT_NEAR(nanometres.x, 4.0, 1e-5);
    EXPECT_NEAR(nanometres.z, 30.0, 1e-5);
  }
}

TEST(LengthUnits, AMapKeepsItsSizeInEveryFormat) {
  TempFolder folder;
  Volume map = makeVolume(
      {4, 3, 5}, SampleType::UInt8, [](glm::ivec3 p) { return 10 * p.x + p.z; },
      centredFrame({4, 3, 5}, glm::dvec3(1.5, 2.0, 2.5)));
  map.lengthUnit = LengthUnit::Angstrom;
  Progress progress;
  for (const char* name : {"a.nrrd", "a.nii", "a.vti", "a.vdb"}) {
    SCOPED_TRACE(name);
    writeVolume(map, folder / name, progress);
    Volume again = read(folder / name);
    bool holdsUnits = std::string_view(name) != "a.nii";
    EXPECT_EQ(again.lengthUnit == LengthUnit::Angstrom, holdsUnits);
    glm::dvec3 spacing = spacingOf(again) * unitsPer(again.lengthUnit, LengthUnit::Angstrom);
    EXPECT_NEAR(spacing.x, 1.5, 1e-5);
    EXPECT_NEAR(spacing.z, 2.5, 1e-5);
  }
}

}  // namespace
}  // namespace velum::io
