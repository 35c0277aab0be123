#include <random>

#include "TestFiles.h"

namespace velum::io {
namespace {

struct Case {
  const char* name;
  bool opens;
  friend void PrintTo(const Case& value, std::ostream* out) { *out << value.name; }
};

// What data/malformed/README.md asks for; where it leaves a choice, the one that was made.
constexpr Case kCases[] = {
    {"dicom_bad_vr.dcm", true},
    {"dicom_truncated_pixels.dcm", false},
    {"dicom_no_preamble.dcm", false},
    {"dicom_no_meta_big_endian.dcm", false},
    {"dicom_meta_missing_tsyntax.dcm", false},
    {"dicom_no_meta_group_length.dcm", false},
    {"dicom_j2k_embedded_delimiter.dcm", false},
    {"dicom_j2k_pixelrep_mismatch.dcm", true},
    {"dicom_deflated.dcm", true},
    {"dicom_big_endian_mr.dcm", true},
    {"dicom_implicit_mr.dcm", true},
    {"dicom_rle_mr.dcm", true},
    {"dicom_jpegls_mr.dcm", true},
    {"dicom_j2k_mr.dcm", true},
    {"dicom_un_sequence.dcm", false},
    {"dicom_report_no_pixels.dcm", false},
    {"dicom_rtstruct.dcm", false},
    {"dicom_seg_1bit.dcm", false},
    {"dicom_rgb_odd.dcm", true},
    {"dicom_gzipped.dcm.gz", false},
    {"DICOMDIR", false},
    {"dicom_enhanced_mr_10frames.dcm", true},
    {"dicom_enhanced_mr_j2k_too_short.dcm", false},
    {"dicom_seg_3frames.dcm", false},
    {"dicom_parametric_map_float.dcm", false},
    {"nifti_big_endian.nii", true},
    {"nifti_4d_functional.nii", true},
    {"nifti_oblique.nii", true},
    {"nifti2.nii.gz", true},
    {"nifti_header_only.hdr", false},
    {"analyze75_header_only.hdr", false},
    {"nifti_rgb24.nii.gz", true},
    {"nifti_truncated.nii.gz", false},
    {"nifti_truncated.nii", false},
    {"nifti_huge_dims.nii", false},
    {"nifti_negative_dim.nii", false},
    {"nifti_bad_datatype.nii", false},
    {"nifti_vox_offset_past_end.nii", false},
    {"nifti_bad_magic.nii", false},
    {"nifti_zero_spacing.nii", true},
    {"nifti_singular_sform.nii", true},
    {"nifti_nan_inf.nii.gz", true},
    {"nifti_empty.nii", false},
    {"png_named_nii.nii", false},
    {"nrrd_bz2.nrrd", false},
    {"nrrd_gz_lineskip.nrrd", true},
    {"nrrd_gz_byteskip_minus_one.nrrd", true},
    {"nrrd_byteskip_minus_five.nhdr", false},
    {"nrrd_detached.nhdr", true},
    {"nrrd_1d_ascii.nrrd", false},
    {"nrrd_4d.nrrd", true},
    {"nrrd_sizes_too_big.nrrd", false},
    {"nrrd_unknown_encoding.nrrd", false},
    {"nrrd_missing_datafile.nhdr", false},
    {"nrrd_crlf_header.nrrd", true},
    {"mha_short_data.mha", false},
    {"mha_negative_dims.mha", false},
    {"mha_no_element_data_file.mha", false},
    {"mha_bad_zlib.mha", false},
};

class Malformed : public testing::TestWithParam<Case> {};

TEST_P(Malformed, OpensOrSaysWhyNot) {
  VELUM_NEED_TEST_DATA();
  auto path = testData() / "malformed" / GetParam().name;
  if (!GetParam().opens) return expectClearError(path);
  Volume v;
  ASSERT_NO_THROW(v = read(path));
  EXPECT_EQ(v.voxels.size(), timeStepBytes(v) * std::size_t(v.timeSteps));
  EXPECT_TRUE(std::isfinite(v.range.x) && std::isfinite(v.range.y));
  EXPECT_GT(std::abs(glm::determinant(v.worldFromVoxel)), 0.0);
}
INSTANTIATE_TEST_SUITE_P(Files, Malformed, testing::ValuesIn(kCases), [](const auto& test) {
  std::string name = test.param.name;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST(MalformedValues, AreRight) {
  VELUM_NEED_TEST_DATA();
  auto folder = testData() / "malformed";
  EXPECT_EQ(read(folder / "dicom_j2k_pixelrep_mismatch.dcm").range, glm::dvec2(-2000, 1896));
  // One picture in five codings.
  Volume plain = read(folder / "dicom_implicit_mr.dcm");
  for (const char* name : {"dicom_big_endian_mr.dcm", "dicom_rle_mr.dcm", "dicom_jpegls_mr.dcm", "dicom_j2k_mr.dcm"})
    EXPECT_TRUE(read(folder / name).voxels == plain.voxels) << name;
  EXPECT_EQ(read(folder / "dicom_enhanced_mr_10frames.dcm").dims, glm::ivec3(64, 64, 10));
  EXPECT_EQ(read(folder / "nifti_4d_functional.nii").timeSteps, 20);
  EXPECT_EQ(read(folder / "nifti2.nii.gz").dims, glm::ivec3(32, 20, 12));
  Volume ball = read(folder / "nrrd_detached.nhdr");
  for (const char* name : {"nrrd_gz_lineskip.nrrd", "nrrd_gz_byteskip_minus_one.nrrd", "nrrd_crlf_header.nrrd"})
    EXPECT_TRUE(read(folder / name).voxels == ball.voxels) << name;
  EXPECT_FALSE(read(folder / "nifti_singular_sform.nii").warnings.empty());
  for (const char* name : {"dicom_seg_1bit.dcm", "dicom_seg_3frames.dcm"}) {
    LabelVolume labels = readLabelsOf(folder / name);
    EXPECT_EQ(labels.idsInUse(), std::vector<std::uint16_t>{1}) << name;
    EXPECT_EQ(labels.table.at(0).name, "Liver");
  }
}

std::string nrrd(const std::string& lines) { return "NRRD0004\n" + lines + "\n" + std::string(64, 'x'); }

TEST(Hostile, NrrdHeadersAreRefusedInOneLine) {
  TempFolder folder;
  const std::string good = "type: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n";
  writeText(folder / "a.nrrd", nrrd(good));
  EXPECT_NO_THROW(read(folder / "a.nrrd"));
  const std::string bad[] = {
      "type: uchar\ndimension: 3\nsizes: 4 4 0\nencoding: raw\n",
      "type: uchar\ndimension: 3\nsizes: 4 -4 4\nencoding: raw\n",
      "type: uchar\ndimension: 3\nsizes: 2000000000 2000000000 2000000000\nencoding: raw\n",
      "type: uchar\ndimension: 3\nsizes: 99999999999999999999 4 4\nencoding: raw\n",
      "type: uchar\ndimension: 3\nsizes: 4 4\nencoding: raw\n",
      "type: uchar\ndimension: 400\nsizes: 4 4 4\nencoding: raw\n",
      "type: block\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n",
      "type: short\ndimension: 3\nsizes: 4 4 2\nencoding: raw\n",
      "type: uchar\ndimension: 3\nsizes: 4 4 4\nencoding: gzip\n",
      good + "line skip: -1\n",
      good + "line skip: 100000\n",
      good + "byte skip: 10\n",
      good + "byte skip: 9223372036854775807\n",
      good + "data file: /dev/zero\n",
      good + "data file: ../../../../etc/passwd\n",
      good + "data file: x%s%n 1 4 1\n",
      good + "data file: x%d 0 2000000000 1\n",
      good + "data file: LIST\n",
      good + "no colon here\n",
      "",
  };
  for (const std::string& text : bad) {
    SCOPED_TRACE(text);
    writeText(folder / "a.nrrd", nrrd(text));
    expectClearError(folder / "a.nrrd");
  }
}

TEST(Hostile, MetaImageHeadersAreRefusedInOneLine) {
  TempFolder folder;
  const std::string bad[] = {
      "NDims = 3\nDimSize = 4 4 400000\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
      "NDims = 9\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
      "NDims = 3\nDimSize = 4 4\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_OTHER\nElementDataFile = LOCAL\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementNumberOfChannels = -1\nElementDataFile = LOCAL\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = /dev/zero\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementDataFile = %s%s%s%n 1 4 1\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nHeaderSize = -7\nElementDataFile = a.mha\n",
      "NDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n",
  };
  for (const std::string& text : bad) {
    SCOPED_TRACE(text);
    writeText(folder / "a.mha", "ObjectType = Image\n" + text + std::string(64, 'x'));
    expectClearError(folder / "a.mha");
  }
}

/// Seeded damage to small good files: whatever happens, it is a volume or an InputError.
TEST(Hostile, RandomDamageNeverEscapesAsAnythingElse) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::Int16, {9, 8, 7});
  v.worldFromVoxel = obliqueMatrix(true, true);
  std::mt19937 random(20240);
  for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz"}) {
    write(v, folder / name);
    std::string good(std::filesystem::file_size(folder / name), '\0');
    std::ifstream(folder / name, std::ios::binary).read(good.data(), std::streamsize(good.size()));
    for (int i = 0; i < 400; ++i) {
      std::string bad = good;
      for (unsigned n = 0; n < 1 + i % 4u; ++n) bad[random() % std::min<std::size_t>(bad.size(), 600)] = char(random());
      if (i % 5 == 0) bad.resize(random() % bad.size());
      writeText(folder / name, bad);
      try {
        Volume back = read(folder / name);
        EXPECT_LT(back.voxels.size(), std::size_t(2) << 20) << name;
      } catch (const InputError&) {
      }
    }
  }
}

}  // namespace
}  // namespace velum::io
