// The first press on structures of real scans: the values that it means, held against what a person who knows the data
// types, and what the guard says. One half of the rows was tuned on, the other was not.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <thread>

#include "velum/scene/Presets.h"
#include "velum/session/Session.h"
#include "velum/session/document/Open.h"
#include "velum/session/extrusion/MaterialRange.h"
#include "velum/session/extrusion/Pull.h"

namespace velum::session {

namespace {

enum class Held { No, AtOnce, OnItsWay };

/// A press on a voxel in the face of a plane, and a drag.
struct Press {
  const char* name;
  const char* file;
  const char* preset;  ///< null: the one with which it opens
  glm::ivec3 voxel;
  int axis;             ///< of the grid, along which it is pulled: 1 to 3, against it below 0
  double voxels;        ///< as far
  glm::dvec2 typedLow;  ///< between these a person's smallest value lies
  double leastHigh;     ///< its largest value is no less
  Held held;            ///< What the guard says today. Wrong are three: fibre and cranium are held, the vertebra of a CTA is not.
  bool isTuned;
};

void PrintTo(const Press& press, std::ostream* out) { *out << press.name; }

constexpr double kNone = -1e30;

const Press kPresses[] = {
    // Tuned on.
    {"vertebra", "ct_abdomen_3mm.nii.gz", nullptr, {59, 40, 74}, 2, 10, {80, 150}, 700, Held::No, true},
    {"vertebra of a CTA", "ct_heart_aorta_cta.nii.gz", nullptr, {44, 105, 17}, -2, 12, {100, 200}, 700, Held::No, true},
    // Wrongly: where one of several pieces is pressed, the others join it farther on.
    {"fibre", "micro_axons_120.tif", nullptr, {54, 69, 48}, 3, 40, {1900, 2500}, 20000, Held::OnItsWay, true},
    {"cranium of a mouse", "ct_mouse_head.nii.gz", nullptr, {56, 106, 62}, 3, 30, {5, 20}, 80, Held::OnItsWay, true},
    {"skull of 8 bits", "ct_head_pitch_oblique.nii.gz", nullptr, {64, 167, 14}, 3, 20, {90, 190}, 250, Held::No, true},
    {"dentine", "ct_tooth_u8.nrrd", nullptr, {59, 50, 40}, 2, 20, {83, 130}, 165, Held::No, true},
    {"heart and aorta", "ct_heart_aorta_cta.nii.gz", nullptr, {64, 46, 68}, -2, 20, {180, 350}, 560, Held::No, true},
    // Not tuned on.
    {"sacrum", "ct_abdomen_3mm.nii.gz", nullptr, {59, 32, 43}, 2, 8, {80, 150}, 700, Held::No, false},
    {"vessel of a head", "ct_head_avm_angio.nii.gz", nullptr, {175, 54, 52}, 3, 40, {20, 180}, 480, Held::No, false},
    {"bone of an iguana", "ct_iguana_head.nii.gz", nullptr, {168, 140, 79}, 3, 25, {84, 115}, 200, Held::No, false},
    {"enamel", "ct_tooth_u8.nrrd", nullptr, {52, 15, 117}, 2, 20, {168, 210}, 245, Held::No, false},
    {"mandible of a mouse", "ct_mouse_head.nii.gz", nullptr, {84, 112, 27}, -3, 10, {5, 20}, 80, Held::No, false},
    {"rib", "ct_torso_contrast_lidc2.mha", nullptr, {69, 64, 59}, 3, 12, {50, 120}, 255, Held::No, false},
    {"arch of a vertebra",
     "ct_torso_contrast_lidc2.mha",
     nullptr,
     {117, 57, 61},
     3,
     8,
     {50, 120},
     255,
     Held::No,
     false},
    {"aorta of a torso",
     "ct_torso_contrast_lidc2.mha",
     nullptr,
     {134, 92, 60},
     -3,
     12,
     {50, 115},
     140,
     Held::No,
     false},
    {"lung", "ct_torso_contrast_lidc2.mha", nullptr, {75, 110, 60}, 3, 10, {-1, 1}, 1, Held::AtOnce, false},
    {"insert of an engine", "ct_engine.vti", nullptr, {109, 147, 60}, 3, 12, {150, 230}, 255, Held::No, false},
    {"engine block", "ct_engine.vti", nullptr, {117, 110, 60}, 3, 12, {20, 100}, 145, Held::No, false},
    {"aneurism", "xa_aneurism.vti", nullptr, {132, 123, 167}, 3, 40, {20, 90}, 255, Held::No, false},
    {"embryo", "embryo_mouse.nrrd", nullptr, {98, 175, 85}, 3, 20, {4, 40}, 150, Held::No, false},
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
    if (GetParam().preset) scene::applyPreset(scene, GetParam().preset);
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
      mSession.advance(5.0);
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

TEST_P(RealPulls, MeanWhatAPersonTypesAndAreHeldWhereTheyLeak) {
  const Press& press = GetParam();
  auto range = materialRangeAt(mSession.scene().volume, mPlace);
  ASSERT_TRUE(range);
  auto segment = segmentOf(scene::currentTransfer(mSession.scene().volume),
                           valueAt(*mSession.scene().volume.data, press.voxel), mSession.scene().volume.data->range);
  double distance = press.voxels * glm::length(mAlong);
  auto leak = pull(distance);
  std::size_t voxels = 0;
  const auto& labels = mSession.scene().labels.data;
  if (labels)
    for (glm::ivec3 v(0); v.z < labels->dims().z; ++v.z)
      for (v.y = 0; v.y < labels->dims().y; ++v.y)
        for (v.x = 0; v.x < labels->dims().x; ++v.x) voxels += labels->at(v) == mPull.structure;
  keep();
  std::printf("| %s | %.0f | %.0f to %.0f | %.0f to %.0f | %.0f to %.0f | %zu | %s |\n", press.name,
              valueAt(*mSession.scene().volume.data, press.voxel), press.typedLow.x, press.typedLow.y,
              segment ? segment->low : kNone, segment ? segment->high : kNone, range->low, range->high, voxels,
              !leak ? "goes on"
              : leak->times == 0.0
                  ? "is held at once"
                  : fmt::format("is held {:.1f} out, {:.1f} times", leak->distance, leak->times).c_str());
  EXPECT_GE(range->low, press.typedLow.x);
  EXPECT_LE(range->low, press.typedLow.y);
  EXPECT_GE(range->high, press.leastHigh);
  Held held = !leak ? Held::No : leak->times > 0.0 ? Held::OnItsWay : Held::AtOnce;
  EXPECT_EQ(int(held), int(press.held));
}

INSTANTIATE_TEST_SUITE_P(Presses, RealPulls, testing::ValuesIn(kPresses), nameOf);

}  // namespace velum::session
