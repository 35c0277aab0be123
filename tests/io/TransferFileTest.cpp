#include "io/looks/TransferFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"

namespace velum::io {
namespace {

scene::TransferFunction sample() {
  scene::TransferFunction transfer;
  transfer.preset = "ct-bone";
  transfer.colors = {{-100, {0.1f, 0.2f, 0.3f}}, {300.5, {1, 0.5f, 0}}};
  transfer.opacities = {{-50, 0}, {120.25, 0.4}, {120.25, 0.6}, {900, 0.95}};
  transfer.gradientOpacities = {{0, 0.1}, {40, 1}};
  transfer.unitDistance = 2.0;
  return transfer;
}

/// As 3D Slicer's own documentation shows the format.
constexpr const char* kSlicerText =
    "1\n1\n0.9\n0.1\n0.2\n10\n"
    "14 -3024 0 -86.9767 0 45.3791 0.169643 139.919 0.589286 347.907 0.607143 1224.16 0.607143 3071 0.616071\n"
    "4 0 1 255 1\n"
    "28 -3024 0 0 0 -86.9767 0 0.25098 1 45.3791 1 0 0 139.919 1 0.894893 0.894893 347.907 1 1 0.25098 1224.16 1 1 1 "
    "3071 0.827451 0.658824 1\n";

void expectRefused(std::string_view text, TransferKind kind, const std::string& word) {
  try {
    parseTransfer(text, kind);
    ADD_FAILURE() << "taken: " << text.substr(0, 80);
  } catch (const InputError& error) {
    std::string said = error.what();
    EXPECT_NE(said.find(word), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

TEST(TransferFile, OursComesBackAsItWas) {
  TempFolder folder;
  writeTransferFile(sample(), {}, 1.0, folder / "a.velum-transfer.json");
  TransferFile file = readTransferFile(folder / "a.velum-transfer.json");
  EXPECT_EQ(file.transfer, sample());
  EXPECT_FALSE(file.isGradientPerVoxel);
}

TEST(TransferFile, TheNewSlicerFormComesBackButForTheName) {
  TempFolder folder;
  writeTransferFile(sample(), {}, 0.5, folder / "a.VP.json");
  TransferFile file = readTransferFile(folder / "a.VP.json");
  auto wanted = sample();
  wanted.preset.clear();
  for (auto& point : wanted.gradientOpacities) point.value *= 0.5;
  EXPECT_EQ(file.transfer, wanted);
  EXPECT_TRUE(file.isGradientPerVoxel);
}

TEST(TransferFile, TheOldSlicerFormKeepsTheMaterial) {
  TransferFile file =
      parseTransfer(transferText(sample(), TransferKind::SlicerText, {}, 1.0).text, TransferKind::SlicerText);
  EXPECT_EQ(file.transfer.unitDistance, 1.0);
  ASSERT_EQ(file.transfer.opacities.size(), sample().opacities.size());
  for (std::size_t i = 0; i < file.transfer.opacities.size(); ++i) {
    auto ours = sample().opacities[i], theirs = file.transfer.opacities[i];
    EXPECT_NEAR(theirs.value, ours.value, 1e-3);
    // What covers so much in 2 mm covers less in one: the extinction is the same.
    EXPECT_NEAR(-std::log(1 - theirs.opacity) / 1.0, -std::log(1 - ours.opacity) / 2.0, 1e-4);
  }
  EXPECT_EQ(file.transfer.colors.size(), 2u);
  EXPECT_EQ(file.transfer.gradientOpacities, sample().gradientOpacities);
}

TEST(TransferFile, ReadsWhatSlicersDocumentationShows) {
  TransferFile file = parseTransfer(kSlicerText, TransferKind::SlicerText);
  ASSERT_EQ(file.transfer.opacities.size(), 7u);
  EXPECT_EQ(file.transfer.opacities[3], (scene::OpacityPoint{139.919, 0.589286}));
  ASSERT_EQ(file.transfer.colors.size(), 7u);
  EXPECT_EQ(file.transfer.colors[1].value, -86.9767);
  EXPECT_EQ(file.transfer.colors[1].color, glm::vec3(0, 0.25098f, 1));
  EXPECT_TRUE(file.transfer.gradientOpacities.empty());  // one everywhere is none
}

TEST(TransferFile, SlicersStepsAndDenormalsAreRead) {
  std::string text(kSlicerText);
  text.replace(text.find("14 -3024 0"), 10, "14 4.94065645841247e-324 0");
  EXPECT_EQ(parseTransfer(text, TransferKind::SlicerText).transfer.opacities.size(), 7u);
}

TEST(TransferFile, PointsComeOutAscendingAndInRange) {
  auto file =
      parseTransfer(R"({"velumTransfer": 1, "opacities": [{"value": 5, "opacity": 1}, {"value": -5, "opacity": 0}]})",
                    TransferKind::Velum);
  EXPECT_EQ(file.transfer.opacities[0].value, -5);
  std::string text(kSlicerText);
  text.replace(text.find("0.616071"), 8, "1.700000");
  EXPECT_EQ(parseTransfer(text, TransferKind::SlicerText).transfer.opacities.back().opacity, 1.0);
}

std::string slicerJsonWith(const std::string& component) {
  return R"({"@schema": "x", "volumeProperties": [{"components": [)" + component + "]}]}";
}

TEST(TransferFile, BentSegmentsBecomeShortStraightOnes) {
  // A sharp step at three tenths of the way: VTK's midpoint and sharpness.
  auto file =
      parseTransfer(slicerJsonWith(R"({"scalarOpacity": {"points": [{"x": 0, "y": 0.2, "midpoint": 0.3, "sharpness": 1},
                         {"x": 100, "y": 0.8, "midpoint": 0.5, "sharpness": 0}]}})"),
                    TransferKind::SlicerJson);
  const auto& curve = file.transfer.opacities;
  EXPECT_NEAR(scene::opacityAt(curve, 20), 0.2, 1e-9);
  EXPECT_NEAR(scene::opacityAt(curve, 50), 0.8, 1e-9);
  // Without sharpness: half the way at the midpoint, straight on both sides.
  file =
      parseTransfer(slicerJsonWith(R"({"scalarOpacity": {"points": [{"x": 0, "y": 0, "midpoint": 0.25, "sharpness": 0},
                         {"x": 120, "y": 1, "midpoint": 0.5, "sharpness": 0}]}, "scalarOpacityUnitDistance": 0.7})"),
                    TransferKind::SlicerJson);
  EXPECT_NEAR(scene::opacityAt(file.transfer.opacities, 30), 0.5, 1e-9);
  EXPECT_NEAR(scene::opacityAt(file.transfer.opacities, 75), 0.75, 1e-9);
  EXPECT_EQ(file.transfer.unitDistance, 0.7);
}

TEST(TransferFile, DamagedFilesAreRefusedInOneLine) {
  expectRefused("", TransferKind::SlicerText, "9 lines");
  expectRefused("1\n2\n3\n", TransferKind::SlicerText, "has 3");
  std::string text(kSlicerText);
  auto with = [&](const char* from, const char* to) {
    std::string out = text;
    return out.replace(out.find(from), std::string(from).size(), to);
  };
  expectRefused(with("14 -3024", "16 -3024"), TransferKind::SlicerText, "line 7: 16 numbers are announced and 14");
  expectRefused(with("14 -3024", "13 -3024"), TransferKind::SlicerText, "no count");
  expectRefused(with("14 -3024", "1e12 -3024"), TransferKind::SlicerText, "no count");
  expectRefused(with("14 -3024", "14 nan"), TransferKind::SlicerText, "'nan' is not a number");
  expectRefused(with("28 -3024", "28 1e999"), TransferKind::SlicerText, "line 9");
  expectRefused("{", TransferKind::SlicerJson, "JSON");
  expectRefused("{}", TransferKind::SlicerJson, "volumeProperties");
  expectRefused(R"({"volumeProperties": []})", TransferKind::SlicerJson, "empty");
  expectRefused(slicerJsonWith(R"({"scalarOpacity": {"points": 3}})"), TransferKind::SlicerJson, "points");
  expectRefused(slicerJsonWith(R"({"scalarOpacity": {"points": [{"x": "a"}]}})"), TransferKind::SlicerJson, "\"x\"");
  expectRefused(slicerJsonWith("{}"), TransferKind::SlicerJson, "no points of opacity");
  expectRefused(std::string(100000, '['), TransferKind::SlicerJson, "deep");
  expectRefused("[]", TransferKind::Velum, "not a JSON object");
  expectRefused(R"({"velum": 1})", TransferKind::Velum, "velumTransfer");
  expectRefused(R"({"velumTransfer": 99})", TransferKind::Velum, "newer");
  expectRefused(R"({"velumTransfer": 1, "opacities": [{"value": 1, "opacity": 7}]})", TransferKind::Velum,
                "7 is outside");
}

TEST(TransferFile, FilesAreKnownByTheirNames) {
  EXPECT_TRUE(isTransferFile("a/b.vp"));
  EXPECT_TRUE(isTransferFile("B.VP.JSON"));
  EXPECT_TRUE(isTransferFile("x.velum-transfer.json"));
  EXPECT_FALSE(isTransferFile("scene.json"));
  EXPECT_FALSE(isTransferFile("vp"));
  TempFolder folder;
  EXPECT_THROW(readTransferFile(folder / "none.vp"), InputError);
  EXPECT_THROW(readTransferFile(folder / "scene.json"), InputError);
  EXPECT_THROW(writeTransferFile(sample(), {}, 1.0, folder / "none" / "a.vp"), InputError);
  std::ofstream(folder / "large.vp") << std::string(2 << 20, ' ');
  EXPECT_THROW(readTransferFile(folder / "large.vp"), InputError);
}

TEST(TransferFile, ALineThatSlicerWouldCutOffIsNotWritten) {
  auto transfer = sample();
  for (int i = 0; i < 200; ++i) transfer.opacities.push_back({1000.0 + i, 0.123456});
  EXPECT_THROW(transferText(transfer, TransferKind::SlicerText, {}, 1.0), InputError);
  EXPECT_NO_THROW(transferText(transfer, TransferKind::SlicerJson, {}, 1.0));
}

}  // namespace
}  // namespace velum::io
