// The values that a click on a phantom's bone means, and what grows by them, against the phantom's truth.
#include "session/extrusion/MaterialRange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <random>
#include <set>
#include <string>

#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "io/phantoms/Sample.h"
#include "makeVolume.h"
#include "scene/Presets.h"

namespace velum::session {

namespace {

/// Of flesh in the phantoms, cartilage included; vessels are full of contrast.
constexpr double kSoftHu = 120.0;
/// Spongy bone, between marrow and the shell.
constexpr double kSpongyHu[] = {200.0, 400.0};

struct Bones {
  const char* phantom;
  bool hasFlesh;                   ///< the words are of all that is no bone; else of its bones
  std::vector<std::string> words;  ///< of names in its table
  double leastMean, least;         ///< Dice of what grows from a click with all bone
};

void PrintTo(const Bones& bones, std::ostream* out) { *out << bones.phantom; }

struct PrintName {
  template <class Info>
  std::string operator()(const Info& info) const {
    return info.param.phantom;
  }
};

}  // namespace

class BoneRange : public testing::TestWithParam<Bones> {
 protected:
  void SetUp() override {
    Progress progress;
    io::Sample sample = io::makeSample(GetParam().phantom, 96, progress);
    mTruth = std::move(sample.labels);
    mScene.volume.data = Shared<Volume>(std::move(sample.volume));
    scene::applyPreset(mScene, "ct-bone");
    for (const auto& info : mTruth.table)
      if (isBone(info.name)) mBones.insert(info.id);
    for (glm::ivec3 v(0); v.z < mTruth.dims().z; ++v.z)
      for (v.y = 0; v.y < mTruth.dims().y; ++v.y)
        for (v.x = 0; v.x < mTruth.dims().x; ++v.x)
          if (isBoneAt(v)) {
            ++mBoneCount;
            if (valueOf(v) >= kSpongyHu[0] && valueOf(v) <= kSpongyHu[1]) mSpongy.push_back(v);
          }
  }
  static bool isBone(const std::string& name) {
    const auto& words = GetParam().words;
    bool isNamed =
        std::any_of(words.begin(), words.end(), [&](const auto& word) { return name.find(word) != name.npos; });
    return isNamed != GetParam().hasFlesh;
  }
  bool isBoneAt(glm::ivec3 v) const { return mBones.count(int(mTruth.at(v))) > 0; }
  double valueOf(glm::ivec3 v) const { return valueAt(volume(), v, 0, 0); }
  const Volume& volume() const { return *mScene.volume.data; }
  glm::dvec3 worldOf(glm::ivec3 v) const { return glm::dvec3(volume().worldFromVoxel * glm::dvec4(v, 1.0)); }
  std::vector<glm::ivec3> clicks(std::size_t count) const {
    std::mt19937 random(11);
    std::vector<glm::ivec3> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(mSpongy[random() % mSpongy.size()]);
    return places;
  }
  /// Of what grows from a place by a range with all bone.
  double dice(glm::ivec3 place, const MaterialRange& range) const {
    scene::Growth step;
    step.structure = 1;
    step.seeds = {worldOf(place)};
    step.low = range.low, step.high = range.high;
    Progress progress;
    auto labels = growth::Grower().grow(mScene.volume.data, growth::labelsFor(volume(), {}), step, {}, progress).labels;
    std::size_t grown = 0, both = 0;
    for (glm::ivec3 v(0); v.z < mTruth.dims().z; ++v.z)
      for (v.y = 0; v.y < mTruth.dims().y; ++v.y)
        for (v.x = 0; v.x < mTruth.dims().x; ++v.x)
          if (labels->at(v) == 1) ++grown, both += isBoneAt(v);
    return 2.0 * double(both) / double(grown + mBoneCount);
  }

  scene::Scene mScene;
  LabelVolume mTruth;
  std::set<int> mBones;
  std::vector<glm::ivec3> mSpongy;
  std::size_t mBoneCount = 0;
};

TEST_P(BoneRange, OfSpongyBoneBesideMarrowLiesAboveFlesh) {
  HistogramMemo histograms;
  for (glm::ivec3 place : clicks(150)) {
    auto range = materialRangeAt(mScene.volume, worldOf(place), histograms);
    ASSERT_TRUE(range);
    SCOPED_TRACE(testing::Message() << place.x << " " << place.y << " " << place.z << ": value " << valueOf(place)
                                    << ", " << range->low << " to " << range->high);
    EXPECT_GT(range->low, kSoftHu);
    EXPECT_LE(range->low, valueOf(place));
    EXPECT_GE(range->high, valueOf(place));
  }
}

TEST_P(BoneRange, GrowsToBone) {
  HistogramMemo histograms;
  double sum = 0.0, least = 1.0;
  auto places = clicks(40);
  for (glm::ivec3 place : places) {
    auto range = materialRangeAt(mScene.volume, worldOf(place), histograms);
    ASSERT_TRUE(range);
    double one = dice(place, *range);
    sum += one, least = std::min(least, one);
  }
  double mean = sum / double(places.size());
  std::printf("%s: Dice %.3f, at least %.3f\n", GetParam().phantom, mean, least);
  EXPECT_GT(mean, GetParam().leastMean);
  EXPECT_GT(least, GetParam().least);
}

constexpr const char* kFlesh[] = {"skin", "fat", "muscle", "tendon", "artery", "vein", "cartilage"};
/// A little less than they give. In the hand flesh of a range that ended at -483 HU gave 0.643, at least 0.320. In the
/// torso three of four clicks give 0.512 and the others 0.340, as its bones hang together in two parts. What costs is
/// the curve's foot, 132 HU: kidneys of 160, the heart of 103 with its noise and the blurred rim of flesh around bone
/// are shown from there, and come along. From 170 HU on it would be 0.52; but what the picture shows is what is pulled.
INSTANTIATE_TEST_SUITE_P(Phantoms, BoneRange,
                         testing::Values(Bones{"hand", true, {std::begin(kFlesh), std::end(kFlesh)}, 0.65, 0.64},
                                         Bones{"foot", true, {std::begin(kFlesh), std::end(kFlesh)}, 0.77, 0.77},
                                         Bones{"torso",
                                               false,
                                               {"ribs", "sternum", "vertebrae", "sacrum", "hip bones", "scapulae",
                                                "clavicles", "humeri"},
                                               0.46,
                                               0.33}),
                         PrintName());

/// Marrow in a shell of bone, in air.
TEST(MaterialRange, WhatTheCurveHidesEndsHalfwayToWhatIsBesideIt) {
  constexpr glm::ivec3 kDims(40);
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(kDims, SampleType::Int16, [](glm::ivec3 p) {
    double away = glm::distance(glm::dvec3(p), glm::dvec3(20.0));
    return (away < 5.0 ? -10.0 : away < 8.0 ? 1000.0 : -1000.0) + 20.0 * (hashNoise(p, 1) - 0.5);
  }));
  layer.transfer.opacities = {{130, 0}, {220, 0.25}, {700, 0.95}};
  auto marrow = materialRangeAt(layer, {20, 20, 20});
  ASSERT_TRUE(marrow);
  EXPECT_GT(marrow->low, -120.0);
  EXPECT_LT(marrow->low, -20.0);
  EXPECT_NEAR(marrow->high, 495.0, 60.0) << "though it is brighter than nine tenths of the data";
}

/// Flesh with noise, and a wall of bone through its middle that is hardly thicker than a voxel: blurred, so that few of
/// its voxels have all of its value.
scene::VolumeLayer thinBone() {
  constexpr glm::ivec3 kDims(48);
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(kDims, SampleType::Int16, [](glm::ivec3 p) {
    double away = std::abs(double(p.x) - 24.0 - 3.0 * std::sin(p.y / 7.0)), bone = std::exp(-away * away / 2.4);
    double thickness = 0.6 + 0.4 * std::sin(p.z / 3.0);
    double noise = hashNoise(p, 1) + hashNoise(p, 2) + hashNoise(p, 3) - 1.5;
    return 40.0 + 1500.0 * thickness * bone + 40.0 * noise;
  }));
  layer.transfer.opacities = {{350, 0}, {600, 0.8}, {2000, 1}};
  return layer;
}

TEST(MaterialRange, LacksNothingThatTheCurveShowsWhereWhatLiesBesideIsHidden) {
  scene::VolumeLayer layer = thinBone();
  HistogramMemo histograms;
  int clicks = 0;
  for (int z = 8; z < 44; z += 3)
    for (int y = 4; y < 44; y += 5) {
      glm::ivec3 place(int(std::lround(24.0 + 3.0 * std::sin(y / 7.0))), y, z);
      if (valueAt(*layer.data, place, 0, 0) < 400.0) continue;
      auto range = materialRangeAt(layer, glm::dvec3(place), histograms);
      ASSERT_TRUE(range);
      EXPECT_LE(range->low, 350.0 + 0.01 * 250.0) << "the foot of the curve";
      EXPECT_GT(range->low, 150.0) << "but no flesh";
      EXPECT_GE(range->high, layer.data->range.y);
      ++clicks;
    }
  EXPECT_GT(clicks, 60);
}

TEST(MaterialRange, BeginsAboveWhatIsDarkerAndShownByTheSameSegment) {
  scene::VolumeLayer layer = thinBone();
  layer.transfer.opacities = {{-300, 0}, {-100, 0.8}, {2000, 1}};
  HistogramMemo histograms;
  auto bone = materialRangeAt(layer, {24, 0, 24}, histograms), flesh = materialRangeAt(layer, {8, 24, 24}, histograms);
  ASSERT_TRUE(bone && flesh);
  EXPECT_GT(bone->low, 75.0) << "three of its noise's deviations of 12 above flesh";
  EXPECT_LT(bone->low, 350.0) << "thin bone has few values above";
  EXPECT_LT(flesh->low, 10.0);
  EXPECT_GT(flesh->high, 75.0);
  EXPECT_LT(flesh->high, 350.0) << "bone is another material";
}

/// Two tissues whose noise nearly meets, as grey and white matter, folded, and shown by one ramp.
TEST(MaterialRange, BeginsAboveWhatIsDarkerThoughNoiseNearlyMeets) {
  constexpr glm::ivec3 kDims(48);
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(kDims, SampleType::UInt8, [](glm::ivec3 p) {
    bool isWhite = p.x > 24.0 + 8.0 * std::sin(p.y / 4.0);
    double noise = 2.0 * (hashNoise(p, 1) + hashNoise(p, 2) + hashNoise(p, 3) - 1.5);
    return std::round(isWhite ? 114.0 + 2.5 * noise : 86.0 + 7.0 * noise);
  }));
  layer.transfer.opacities = {{26, 0}, {52, 0.06}, {87, 0.4}, {140, 0.85}};
  auto white = materialRangeAt(layer, {40, 20, 24});
  ASSERT_TRUE(white);
  EXPECT_GT(white->low, 95.0) << "halfway would be 100, where much of the darker one's noise is";
  EXPECT_LT(white->low, 110.0);
}

/// A thin shell in flesh: from each place of its rim that the picture shows, be the voxel there flesh or bone.
TEST(MaterialRange, AtTheRimOfAShellIsThatOfTheShell) {
  constexpr glm::ivec3 kDims(48);
  constexpr double kMiddle = 23.5, kRadius = 15.0, kFoot = 350.0;
  auto valueOf = [](glm::dvec3 p) {
    double away = glm::distance(p, glm::dvec3(kMiddle)) - kRadius;
    return 40.0 + 1200.0 * std::exp(-away * away / 2.0);
  };
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(kDims, SampleType::Int16, [&](glm::ivec3 v) {
    return valueOf(glm::dvec3(v)) + 30.0 * (hashNoise(v, 1) + hashNoise(v, 2) - 1.0);
  }));
  layer.transfer.opacities = {{kFoot, 0}, {600, 0.8}, {2000, 1}};
  const Volume& volume = *layer.data;
  HistogramMemo histograms;
  std::mt19937 random(9);
  int clicks = 0, besideBone = 0;
  while (clicks < 200) {
    // Between two neighbours of which the curve shows one, just where it begins to show.
    glm::ivec3 voxel(1 + int(random() % 46), 1 + int(random() % 46), 1 + int(random() % 46)), other = voxel;
    other[int(random() % 3)] += random() % 2 ? 1 : -1;
    double shown = valueAt(volume, voxel), hidden = valueAt(volume, other);
    if (shown < kFoot + 40.0 || hidden >= kFoot) continue;
    double part = 0.95 * (shown - kFoot - 10.0) / (shown - hidden);
    auto range = materialRangeAt(layer, glm::mix(glm::dvec3(voxel), glm::dvec3(other), part), histograms);
    ASSERT_TRUE(range);
    EXPECT_LE(range->low, kFoot + 5.0) << "part " << part << " from " << shown << " to " << hidden;
    EXPECT_GT(range->low, 100.0);
    EXPECT_GE(range->high, 1100.0) << "part " << part << " from " << shown << " to " << hidden;
    ++clicks;
    besideBone += part > 0.5;
  }
  EXPECT_GT(besideBone, 30) << "whose own voxel is flesh";
}

}  // namespace velum::session
