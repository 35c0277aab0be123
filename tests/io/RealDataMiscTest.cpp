#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/Readers.h"

/// Against the tables in data/volumes/README.md and data/malformed/README.md; skipped where the data is not.
namespace velum::io {
namespace {

using Reader = Volume (*)(const scene::Source&, Progress&);

std::filesystem::path dataFolder() {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  return folder ? folder : "";
}

Volume readWith(Reader reader, const std::filesystem::path& path, scene::RawLayout raw = {}) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  source.raw = raw;
  Volume v = reader(source, progress);
  computeRange(v);
  EXPECT_EQ(v.voxels.size(), timeStepBytes(v) * std::size_t(v.timeSteps));
  EXPECT_NE(glm::determinant(v.worldFromVoxel), 0.0);
  return v;
}

struct Row {
  const char* file;
  Reader reader;
  glm::ivec3 dims;
  SampleType type;
  glm::dvec3 spacing;
  glm::dvec2 range;
  bool isSpacingKnown = true;
  scene::RawLayout raw = {};
  friend void PrintTo(const Row& value, std::ostream* out) { *out << value.file; }
};

class RealData : public testing::TestWithParam<Row> {};

TEST_P(RealData, IsWhatItsTableSays) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  const Row& row = GetParam();
  Volume v = readWith(row.reader, dataFolder() / "volumes" / row.file, row.raw);
  EXPECT_EQ(v.dims, row.dims);
  EXPECT_EQ(v.type, row.type);
  EXPECT_EQ(v.isSpacingKnown, row.isSpacingKnown);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(spacingOf(v)[i], row.spacing[i], 1e-3 * row.spacing[i]) << i;
  EXPECT_NEAR(v.range.x, row.range.x, 0.006);
  EXPECT_NEAR(v.range.y, row.range.y, 0.006);
}

INSTANTIATE_TEST_SUITE_P(
    Table, RealData,
    testing::Values(
        Row{"ct_torso_contrast_lidc2.vti",
            readVti,
            {256, 256, 133},
            SampleType::UInt8,
            {1.40625, 1.40625, 2.5},
            {0, 255}},
        Row{"ct_engine.vti", readVti, {256, 256, 128}, SampleType::UInt8, {1, 1, 1}, {0, 255}},
        Row{"xa_aneurism.vti", readVti, {256, 256, 256}, SampleType::UInt8, {1, 1, 1}, {0, 255}},
        Row{"micro_mousebrain_100um.tiff", readTiff, {108, 77, 135}, SampleType::UInt16, {1, 1, 1}, {0, 65535}, false},
        Row{"micro_mousebrain_100um_hemispheres.tiff",
            readTiff,
            {108, 77, 135},
            SampleType::UInt8,
            {1, 1, 1},
            {0, 2},
            false},
        Row{"micro_lightsheet_brain_10planes.tif",
            readTiff,
            {351, 416, 10},
            SampleType::UInt16,
            {1, 1, 1},
            {46, 60167},
            false},
        Row{"seis_f3_crop.sgy", readSegy, {23, 18, 75}, SampleType::Int16, {25000, 25000, 4000}, {-10239, 10827}},
        // Every fourth line of 12.5 m, and 20 m of depth.
        Row{"seis_volve_velocity.sgy",
            readSegy,
            {18, 52, 226},
            SampleType::Float32,
            {50000, 50000, 20000},
            {1480, 4706.09}},
        Row{"seis_volve_inline.sgy",
            readSegy,
            {1, 202, 1125},
            SampleType::Float32,
            {12500, 12500, 4000},
            {-32.68, 24.36}},
        Row{"tooth.raw",
            readRaw,
            {103, 94, 161},
            SampleType::UInt16,
            {1, 1, 1},
            {0, 1300},
            false,
            {{103, 94, 161}, SampleType::UInt16, 1, true, 0}},
        Row{"raw_mr_brainsmall.den.gz",
            readRaw,
            {128, 128, 84},
            SampleType::UInt8,
            {1, 1, 1},
            {0, 202},
            false,
            {{128, 128, 84}, SampleType::UInt8, 1, false, 62}}),
    [](const auto& row) {
      std::string name = row.param.file;
      for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
      return name;
    });

/// Unpacks a zip with the system's own tool; false where there is none.
bool unzip(const std::filesystem::path& zip, const std::filesystem::path& into) {
  return std::system(("unzip -qo '" + zip.string() + "' -d '" + into.string() + "' 2>/dev/null").c_str()) == 0;
}

TEST(RealFolders, NumberedHeaderlessSlicesAreInNaturalOrder) {
  TempFolder folder;
  if (dataFolder().empty() || !unzip(dataFolder() / "volumes/raw_ct_headsq_slices.zip", folder.path()))
    GTEST_SKIP() << "no data or no unzip";
  Volume v = readWith(readRaw, folder / "headsq", {{64, 64, 93}, SampleType::UInt16, 1, false, 0});
  EXPECT_EQ(v.range, glm::dvec2(0, 3926));
  // Neighbours in a scan are alike; in the order of names quarter.1 would stand beside quarter.10.
  auto jump = [&](int z) {
    double sum = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) sum += std::abs(valueAt(v, {x, y, z}) - valueAt(v, {x, y, z + 1}));
    return sum / 4096;
  };
  for (int z = 1; z < 91; ++z) EXPECT_LT(jump(z), 220.0) << z;
  EXPECT_THROW(readWith(readRaw, folder / "headsq", {{64, 64, 92}, SampleType::UInt16, 1, false, 0}), InputError);
  EXPECT_THROW(readWith(readRaw, folder / "headsq", {{64, 65, 93}, SampleType::UInt16, 1, false, 0}), InputError);
}

TEST(RealFolders, TiffPlanes) {
  TempFolder folder;
  if (dataFolder().empty() || !unzip(dataFolder() / "volumes/micro_mousebrain_tiff_stack.zip", folder.path()))
    GTEST_SKIP() << "no data or no unzip";
  std::filesystem::path planes;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) planes = entry.path();
  Progress progress;
  scene::Source source;
  source.path = planes.string();
  source.spacing = {0.04, 0.04, 0.05};
  Volume v = readVolume(source, progress);
  EXPECT_EQ(v.dims, glm::ivec3(271, 193, 270));
  EXPECT_EQ(v.range, glm::dvec2(0, 14580));
  EXPECT_NEAR(spacingOf(v).z, 0.05, 1e-12);
  EXPECT_TRUE(v.isSpacingKnown);
  EXPECT_TRUE(v.warnings.empty());
}

TEST(RealData, TheSameScanInTwoFormatsHasTheSameSpacing) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  Volume v = readWith(readVti, dataFolder() / "volumes/ct_torso_contrast_lidc2.vti");
  EXPECT_FALSE(v.isOrientationKnown);
}

TEST(RealData, SeismicPointsDown) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  Volume v = readWith(readSegy, dataFolder() / "volumes/seis_volve_velocity.sgy");
  EXPECT_LT(v.worldFromVoxel[2].z, 0.0);
  EXPECT_EQ(v.modality, Modality::Seismic);
  // Faster below 2500 m than at the top.
  EXPECT_LT(valueAt(v, {9, 26, 5}), 2000.0);
  EXPECT_GT(valueAt(v, {9, 26, 135}), 4000.0);
}

TEST(RealData, ACraniumStandsUprightAndLooksForward) {
  std::filesystem::path path = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "invesalius-examples is not installed";
  Volume v = readWith(readInvesalius, path);
  EXPECT_EQ(v.dims, glm::ivec3(256, 256, 108));
  EXPECT_NEAR(spacingOf(v).x, 0.957032, 1e-6);
  EXPECT_NEAR(spacingOf(v).z, 1.5, 1e-9);
  EXPECT_EQ(v.unit, "HU");
  EXPECT_LT(v.range.x, -1000.0);
  EXPECT_GT(v.range.y, 2900.0);
  EXPECT_LT(v.worldFromVoxel[1].y, 0.0);
  // The nose is the most anterior tissue of the lower slices, and bone gets less toward the vertex.
  auto tissueAt = [&](double yLps, int z) {
    auto y = int(std::lround((yLps - v.worldFromVoxel[3].y) / v.worldFromVoxel[1].y));
    int count = 0;
    for (int x = 0; x < 256; ++x) count += valueAt(v, {x, y, z}) > -200;
    return count;
  };
  EXPECT_GT(tissueAt(0.957 * 25, 30), 0);   // 231 of 255: the tip of the nose, anterior
  EXPECT_LT(tissueAt(0.957 * 25, 30), 30);  // and it is narrow
  EXPECT_EQ(tissueAt(0.957 * 25, 80), 0);   // no nose at the forehead
}

struct Bad {
  const char* file;
  Reader reader;
  bool mayOpen;
  scene::RawLayout raw = {};
  friend void PrintTo(const Bad& value, std::ostream* out) { *out << value.file; }
};
class Malformed : public testing::TestWithParam<Bad> {};

TEST_P(Malformed, IsRefusedWithItsNameAndAReason) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  const Bad& bad = GetParam();
  try {
    Volume v = readWith(bad.reader, dataFolder() / "malformed" / bad.file, bad.raw);
    EXPECT_TRUE(bad.mayOpen) << "opened as " << v.dims.x << " x " << v.dims.y << " x " << v.dims.z;
  } catch (const InputError& error) {
    std::string words = error.what();
    EXPECT_NE(words.find(std::filesystem::path(bad.file).filename().string().substr(0, 4)), words.npos) << words;
    EXPECT_EQ(words.find('\n'), words.npos) << words;
    EXPECT_FALSE(bad.mayOpen) << words;
    RecordProperty("message", words);
    std::printf("  %s\n", words.c_str());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Files, Malformed,
    testing::Values(Bad{"vti_truncated.vti", readVti, false}, Bad{"tiff_truncated.tif", readTiff, false},
                    Bad{"tiff_mismatched_dims", readTiff, false}, Bad{"segy_text_header_only.sgy", readSegy, false},
                    Bad{"segy_git_lfs_pointer.sgy", readSegy, false}, Bad{"segy_prestack_offsets.sgy", readSegy, true},
                    Bad{"segy_little_endian.sgy", readSegy, true}, Bad{"segy_1x1.sgy", readSegy, false},
                    Bad{"\xe5\xb0\x8f\xe6\x96\x87\xe4\xbb\xb6.sgy", readSegy, true},
                    Bad{"BallBinary30x30x30.raw", readRaw, true, {{30, 30, 30}, SampleType::Int16, 1, false, 0}},
                    Bad{"BallBinary30x30x30.raw", readRaw, false, {{30, 30, 31}, SampleType::Int16, 1, false, 0}},
                    Bad{"BallBinary30x30x30.raw", readRaw, false}, Bad{"png_named_nii.nii", readVti, false},
                    Bad{"png_named_nii.nii", readVtkLegacy, false}, Bad{"nifti_empty.nii", readSegy, false},
                    Bad{"nifti_empty.nii", readVti, false}, Bad{"nifti_empty.nii", readTiff, false},
                    Bad{"nifti_empty.nii", readVdb, false}, Bad{"nifti_empty.nii", readInvesalius, false},
                    Bad{"nifti_empty.nii", readVtkLegacy, false}, Bad{"png_named_nii.nii", readVdb, false},
                    Bad{"nifti_oblique.nii", readInvesalius, false}, Bad{"nifti_oblique.nii", readSegy, false}));

TEST(Malformed, LittleEndianIsTheSameCube) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  Volume little = readWith(readSegy, dataFolder() / "malformed/segy_little_endian.sgy");
  Volume big = readWith(readSegy, dataFolder() / "malformed/\xe5\xb0\x8f\xe6\x96\x87\xe4\xbb\xb6.sgy");
  EXPECT_EQ(little.dims, glm::ivec3(5, 5, 50));
  EXPECT_TRUE(little.voxels == big.voxels);
  EXPECT_NEAR(valueAt(big, {0, 0, 0}), 1.2, 1e-3);  // value = inline + crossline / 100, as segyio makes it
}

TEST(Malformed, PrestackShowsTheFirstOffset) {
  if (dataFolder().empty()) GTEST_SKIP() << "VELUM_TEST_DATA is not set";
  Volume v = readWith(readSegy, dataFolder() / "malformed/segy_prestack_offsets.sgy");
  EXPECT_EQ(v.dims, glm::ivec3(4, 3, 10));
  EXPECT_FALSE(v.warnings.empty());
}

}  // namespace
}  // namespace velum::io
