#include "TestFiles.h"

#include "io/labels/ReadLabels.h"

namespace velum::io {
namespace {

struct Case {
  const char* name;
  glm::ivec3 dims;
  SampleType type;
  glm::dvec3 spacing;
  glm::dvec2 range;
  friend void PrintTo(const Case& value, std::ostream* out) { *out << value.name; }
};

// From data/volumes/README.md.
const Case kCases[] = {
    {"ct_torso_contrast_lidc2.mha", {256, 256, 133}, SampleType::UInt8, {1.406, 1.406, 2.5}, {0, 255}},
    {"ct_heart_aorta_cta.nii.gz", {120, 126, 164}, SampleType::Int16, {1.5, 1.5, 1.5}, {-1078, 3343}},
    {"ct_heart_aorta_cta_labels.nii.gz", {120, 126, 164}, SampleType::UInt8, {1.5, 1.5, 1.5}, {0, 10}},
    {"ct_abdomen_3mm.nii.gz", {122, 101, 112}, SampleType::Int32, {3, 3, 3}, {-1207, 3382}},
    {"ct_abdomen_3mm_vertebrae.nii.gz", {122, 101, 112}, SampleType::UInt8, {3, 3, 3}, {0, 33}},
    {"ct_abdomen_3mm_crop.nii.gz", {122, 101, 30}, SampleType::Int16, {3, 3, 3}, {-1100, 1207}},
    {"ct_abdomen_3mm_crop_organs.nii.gz", {122, 101, 30}, SampleType::UInt8, {3, 3, 3}, {0, 117}},
    {"ct_head_pitch_oblique.nii.gz", {175, 248, 58}, SampleType::UInt8, {0.8125, 0.8125, 2.397}, {0, 255}},
    {"ct_head_avm_angio.nii.gz", {256, 242, 154}, SampleType::UInt8, {0.7199, 0.7209, 1}, {0, 563.2}},
    {"ct_iguana_head.nii.gz", {210, 256, 179}, SampleType::UInt8, {0.1018, 0.1018, 0.1018}, {0, 229}},
    {"tooth.nhdr", {103, 94, 161}, SampleType::UInt16, {1, 1, 1}, {0, 1300}},
    {"ct_tooth_u8.nrrd", {103, 94, 161}, SampleType::UInt8, {1, 1, 1}, {0, 255}},
    {"ct_mouse_head.nii.gz", {130, 206, 114}, SampleType::UInt8, {0.1411, 0.1411, 0.1411}, {0, 87}},
    {"ct_mouse_head_labels.nii.gz", {130, 206, 114}, SampleType::UInt8, {0.1411, 0.1411, 0.1411}, {0, 21}},
    {"ct_mouse_head_35um_labels.seg.nrrd", {349, 640, 338}, SampleType::Int16, {0.0353, 0.0353, 0.0353}, {0, 21}},
    {"frogtissue.mhd", {500, 470, 136}, SampleType::UInt8, {1, 1, 1.5}, {0, 29}},
    {"mr_head_ch2.nii.gz", {181, 217, 181}, SampleType::UInt8, {1, 1, 1}, {0, 254}},
    {"mr_head_ch2_aal_labels.nii.gz", {181, 217, 181}, SampleType::UInt8, {1, 1, 1}, {0, 116}},
    {"mr_fetal_brain_template.nrrd", {117, 159, 126}, SampleType::Float32, {0.8594, 0.8594, 0.8594}, {0, 710.68}},
    {"embryo_mouse.nrrd", {256, 256, 256}, SampleType::UInt8, {1, 1, 1}, {0, 197}},
    {"us_spine_phantom_3d.mha", {147, 106, 104}, SampleType::UInt8, {0.5, 0.5, 0.5}, {0, 251}},
    {"us_spine_phantom_sweep.igs.mha", {820, 616, 21}, SampleType::UInt8, {1, 1, 1}, {0, 251}},
};

class RealVolume : public testing::TestWithParam<Case> {};

TEST_P(RealVolume, IsAsItsDescriptionSays) {
  VELUM_NEED_TEST_DATA();
  const Case& c = GetParam();
  Volume v = read(testData() / "volumes" / c.name);
  EXPECT_EQ(v.dims, c.dims);
  EXPECT_EQ(v.type, c.type);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(spacingOf(v)[i], c.spacing[i], 1e-3 * c.spacing[i]);  // four digits are given
  EXPECT_NEAR(v.range.x, c.range.x, 0.05);
  EXPECT_NEAR(v.range.y, c.range.y, 0.05);
}
INSTANTIATE_TEST_SUITE_P(Volumes, RealVolume, testing::ValuesIn(kCases), [](const auto& test) {
  std::string name = test.param.name;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST(RealVolumes, GantryPitchTurnsTheAxes) {
  VELUM_NEED_TEST_DATA();
  Volume v = read(testData() / "volumes/ct_head_pitch_oblique.nii.gz");
  double tilt = glm::degrees(std::acos(std::abs(direction(v)[1].y)));
  EXPECT_NEAR(tilt, 16.0, 1.0);
}

TEST(RealVolumes, RpsAxesReachTheMatrix) {
  VELUM_NEED_TEST_DATA();
  glm::dmat3 d = direction(read(testData() / "volumes/ct_torso_contrast_lidc2.mha"));
  EXPECT_NEAR(d[0].x, 1.0, 1e-12);
  EXPECT_NEAR(d[1].y, -1.0, 1e-12);
  EXPECT_NEAR(d[2].z, -1.0, 1e-12);
}

std::string nameOf(const LabelVolume& labels, int id) {
  for (const LabelInfo& label : labels.table)
    if (label.id == id) return label.name;
  return {};
}

TEST(RealLabels, TotalSegmentatorNamesComeFromTheExtension) {
  VELUM_NEED_TEST_DATA();
  LabelVolume organs = readLabelsOf(testData() / "volumes/ct_abdomen_3mm_crop_organs.nii.gz");
  EXPECT_EQ(organs.idsInUse().size(), 41u);
  EXPECT_EQ(nameOf(organs, 1), "spleen");
  EXPECT_EQ(nameOf(organs, 5), "liver");
  EXPECT_EQ(nameOf(organs, 52), "aorta");
  LabelVolume bones = readLabelsOf(testData() / "volumes/ct_abdomen_3mm_vertebrae.nii.gz");
  EXPECT_EQ(nameOf(bones, 26), "vertebrae_S1");
  EXPECT_TRUE(looksLikeLabels(testData() / "volumes/ct_abdomen_3mm_crop_organs.nii.gz"));
  EXPECT_FALSE(looksLikeLabels(testData() / "volumes/ct_abdomen_3mm_crop.nii.gz"));
}

TEST(RealLabels, AalNamesComeFromTheTableBeside) {
  VELUM_NEED_TEST_DATA();
  LabelVolume labels = readLabelsOf(testData() / "volumes/mr_head_ch2_aal_labels.nii.gz");
  EXPECT_EQ(labels.table.size(), 116u);
  EXPECT_EQ(nameOf(labels, 1), "Precentral_L");
}

TEST(RealLabels, SlicerSegmentsKeepTheirColours) {
  VELUM_NEED_TEST_DATA();
  LabelVolume labels = readLabelsOf(testData() / "volumes/ct_mouse_head_35um_labels.seg.nrrd");
  ASSERT_EQ(labels.table.size(), 5u);
  EXPECT_EQ(labels.table[0].name, "1");
  EXPECT_NEAR(labels.table[0].color.g, 0.682353f, 1e-6f);
}

}  // namespace
}  // namespace velum::io
