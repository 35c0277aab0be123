// The first press on structures of real scans: the values that it means, held against what a person who knows the data
// types, and what the guard says, held against what he would call a leak. One half of the rows was tuned on, the other
// was not; a second list was written when the guard was done.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <thread>

#include "session/Session.h"
#include "session/document/Open.h"
#include "session/extrusion/MaterialRange.h"
#include "session/extrusion/Pull.h"

namespace velum::session {

namespace {

enum class Held { No, AtOnce, OnItsWay };

/// A press on a voxel in the face of a plane, and a drag.
struct Press {
  const char* name;
  const char* file;
  glm::ivec3 voxel;
  int axis;             ///< of the grid, along which it is pulled: 1 to 3, against it below 0
  double voxels;        ///< as far
  glm::dvec2 typedLow;  ///< between these a person's smallest value lies
  double leastHigh;     ///< its largest value is no less
  Held held;            ///< what is right
};

void PrintTo(const Press& press, std::ostream* out) { *out << press.name; }

constexpr char kTorso[] = "ct_torso_contrast_lidc2.mha";

const Press kPresses[] = {
    // Tuned on. The aorta joins the vertebra of a CTA through its wall; a fibre is one of a tree, a cranium of a skull.
    {"vertebra", "ct_abdomen_3mm.nii.gz", {59, 40, 74}, 2, 10, {80, 150}, 700, Held::No},
    {"vertebra of a CTA", "ct_heart_aorta_cta.nii.gz", {44, 105, 17}, -2, 12, {100, 200}, 700, Held::OnItsWay},
    {"fibre", "micro_axons_120.tif", {54, 69, 48}, 3, 40, {1900, 2500}, 20000, Held::No},
    {"cranium of a mouse", "ct_mouse_head.nii.gz", {56, 106, 62}, 3, 30, {5, 20}, 80, Held::No},
    {"skull of 8 bits", "ct_head_pitch_oblique.nii.gz", {64, 167, 14}, 3, 20, {90, 190}, 250, Held::No},
    {"dentine", "ct_tooth_u8.nrrd", {59, 50, 40}, 2, 20, {83, 130}, 165, Held::No},
    {"heart and aorta", "ct_heart_aorta_cta.nii.gz", {64, 46, 68}, -2, 20, {180, 350}, 560, Held::No},
    {"sacrum", "ct_abdomen_3mm.nii.gz", {59, 32, 43}, 2, 8, {80, 150}, 700, Held::No},
    {"vessel of a head", "ct_head_avm_angio.nii.gz", {175, 54, 52}, 3, 40, {20, 180}, 480, Held::No},
    {"lung", kTorso, {75, 110, 60}, 3, 10, {-1, 1}, 1, Held::AtOnce},
    {"white matter", "mr_head_ch2.nii.gz", {40, 90, 100}, 3, 25, {90, 105}, 140, Held::No},
    {"white matter in a fold", "mr_head_ch2.nii.gz", {62, 75, 100}, 3, 25, {90, 110}, 140, Held::No},
    // Not tuned on.
    {"bone of an iguana", "ct_iguana_head.nii.gz", {168, 140, 79}, 3, 25, {84, 115}, 200, Held::No},
    {"enamel", "ct_tooth_u8.nrrd", {52, 15, 117}, 2, 20, {168, 210}, 245, Held::No},
    {"mandible of a mouse", "ct_mouse_head.nii.gz", {84, 112, 27}, -3, 10, {5, 20}, 80, Held::No},
    {"rib", kTorso, {69, 64, 59}, 3, 12, {50, 120}, 255, Held::No},
    {"arch of a vertebra", kTorso, {117, 57, 61}, 3, 8, {50, 120}, 255, Held::No},
    {"aorta of a torso", kTorso, {134, 92, 60}, -3, 12, {50, 115}, 140, Held::No},
    {"insert of an engine", "ct_engine.vti", {109, 147, 60}, 3, 12, {150, 230}, 255, Held::No},
    {"engine block", "ct_engine.vti", {117, 110, 60}, 3, 12, {25, 100}, 145, Held::No},
    {"aneurism", "xa_aneurism.vti", {132, 123, 167}, 3, 40, {20, 90}, 255, Held::No},
    {"embryo", "embryo_mouse.nrrd", {98, 175, 85}, 3, 20, {4, 40}, 150, Held::No},
};

/// What leaks, and what does not, chosen after the guard's constants; no values. The first four were looked at before.
const Press kFurther[] = {
    {"aorta of a CTA", "ct_heart_aorta_cta.nii.gz", {70, 100, 93}, -2, 15, {}, 0, Held::OnItsWay},
    {"cylinder in a head", "ct_head_pitch_oblique.nii.gz", {84, 104, 14}, 3, 20, {}, 0, Held::OnItsWay},
    {"brain with its scalp", "mr_head_ch2.nii.gz", {60, 110, 100}, 3, 25, {}, 0, Held::AtOnce},
    {"brain of a fetus", "mr_fetal_brain_template.nrrd", {60, 70, 60}, 3, 20, {}, 0, Held::No},
    {"marrow of a hip", "ct_abdomen_3mm.nii.gz", {84, 40, 24}, 2, 10, {}, 0, Held::AtOnce},
    {"flesh at a rib", "ct_heart_aorta_cta.nii.gz", {73, 46, 157}, -2, 12, {}, 0, Held::AtOnce},
    {"flesh of an iguana", "ct_iguana_head.nii.gz", {103, 70, 79}, 3, 25, {}, 0, Held::AtOnce},
    {"ground between neurons", "micro_axons_120.tif", {50, 44, 48}, 3, 40, {}, 0, Held::AtOnce},
    {"left atrium", kTorso, {130, 114, 60}, 3, 15, {}, 0, Held::No},
    {"hip bone", "ct_abdomen_3mm.nii.gz", {88, 40, 26}, 2, 10, {}, 0, Held::No},
    {"spleen", "ct_heart_aorta_cta.nii.gz", {88, 105, 14}, -2, 12, {}, 0, Held::No},
    {"cheek of a mouse", "ct_mouse_head.nii.gz", {92, 129, 62}, 3, 20, {}, 0, Held::No},
    {"water of a fetus", "mr_fetal_brain_template.nrrd", {83, 92, 60}, 3, 20, {}, 0, Held::No},
    {"seat of an engine", "ct_engine.vti", {177, 155, 60}, 3, 12, {}, 0, Held::No},
};

std::string nameOf(const testing::TestParamInfo<Press>& info) {
  std::string name;
  for (char c : std::string(info.param.name)) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

}  // namespace

class RealPulls : public testing::TestWithParam<Press> {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("VELUM_TEST_DATA");
    if (!folder) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
    Progress progress;
    scene::Source source;
    source.path = (std::filesystem::path(folder) / "volumes" / GetParam().file).string();
    std::vector<std::string> notes;
    scene::Scene scene = open(source, progress, {}, &notes);
    const Press& press = GetParam();
    const glm::dmat4& worldFromVoxel = scene.volume.data->worldFromVoxel;
    mPlace = glm::dvec3(worldFromVoxel * glm::dvec4(press.voxel, 1.0));
    mAlong = glm::dvec3(worldFromVoxel[std::abs(press.axis) - 1]) * (press.axis < 0 ? -1.0 : 1.0);
    scene::Cut plane;
    plane.centre = mPlace;
    plane.axis = glm::normalize(mAlong);
    mCut = scene::addCut(scene, plane);
    mSession.document().replace(scene);
  }
  void settle() {
    while (!mSession.isSettled()) {
      mSession.collect();
      std::this_thread::yield();
    }
  }
  /// @return what the guard says; the seconds are those of a hand's
  std::optional<Leak> pull(double distance) {
    auto pull = beginPull(mSession.scene(), mCut, mPlace, 0, mSession.histograms());
    EXPECT_TRUE(pull);
    if (!pull) return {};
    mPull = *pull;
    constexpr int kMoves = 12;
    for (int i = 1; i <= kMoves; ++i) {
      mSession.document().edit(
          "Pull", [&](scene::Scene& scene) { pullTo(scene, *pull, distance * i / kMoves); }, true);
      settle();
      if (auto leak = mSession.growth().status().leak) return leak;
    }
    return {};
  }
  /// For eyes: VELUM_SHOTS names a folder.
  void keep() const {
    const char* shots = std::getenv("VELUM_SHOTS");
    if (!shots) return;
    scene::Scene scene = mSession.scene();
    saveScene(scene, std::filesystem::path(shots) / (nameOf({GetParam(), 0}) + ".velum.json"));
  }

  Session mSession;
  Pull mPull;
  glm::dvec3 mPlace{0.0}, mAlong{0.0};
  int mCut = 0;
};

Held heldBy(const std::optional<Leak>& leak) {
  return !leak ? Held::No : leak->times > 0.0 ? Held::OnItsWay : Held::AtOnce;
}

std::string answerOf(const std::optional<Leak>& leak) {
  if (!leak) return "goes on";
  if (leak->times == 0.0) return "is held at once";
  return fmt::format("is held {:.1f} out, {:.1f} times", leak->distance, leak->times);
}

TEST_P(RealPulls, MeanWhatAPersonTypesAndAreHeldWhereTheyLeak) {
  const Press& press = GetParam();
  auto range = materialRangeAt(mSession.scene().volume, mPlace);
  ASSERT_TRUE(range);
  double distance = press.voxels * glm::length(mAlong);
  auto leak = pull(distance);
  keep();
  std::printf("| %s | %.0f to %.0f | %.0f to %.0f | %s |\n", press.name, press.typedLow.x, press.typedLow.y, range->low,
              range->high, answerOf(leak).c_str());
  EXPECT_GE(range->low, press.typedLow.x);
  EXPECT_LE(range->low, press.typedLow.y);
  EXPECT_GE(range->high, press.leastHigh);
  EXPECT_EQ(int(heldBy(leak)), int(press.held));
}

class FurtherPulls : public RealPulls {};

TEST_P(FurtherPulls, AreHeldWhereTheyLeak) {
  auto leak = pull(GetParam().voxels * glm::length(mAlong));
  keep();
  std::printf("| %s | %s |\n", GetParam().name, answerOf(leak).c_str());
  EXPECT_EQ(int(heldBy(leak)), int(GetParam().held));
}

INSTANTIATE_TEST_SUITE_P(Presses, RealPulls, testing::ValuesIn(kPresses), nameOf);
INSTANTIATE_TEST_SUITE_P(Presses, FurtherPulls, testing::ValuesIn(kFurther), nameOf);

}  // namespace velum::session
