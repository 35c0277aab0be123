#include "session/look/ShowThis.h"

#include <gtest/gtest.h>

#include "makeVolume.h"
#include "scene/Presets.h"
#include "session/picture/PresetPictures.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kShowThisDims(48, 48, 40);
const glm::dvec3 kLeftMm(-10, 0, 0), kRightMm(10, 0, 0), kBoneMm(0, -14, 0), kAirMm(0, 20, 16);

/// A body of fat with two noisy organs (60 and 130), a bone (900), in air.
double organValue(glm::ivec3 p) {
  glm::dvec3 mm = glm::dvec3(p) - 0.5 * (glm::dvec3(kShowThisDims) - 1.0);
  double noise = 16.0 * (hashNoise(p, 1) + hashNoise(p, 2) + hashNoise(p, 3) + hashNoise(p, 4) - 2.0);
  if (glm::length(mm - kLeftMm) < 7) return 60 + noise;
  if (glm::length(mm - kRightMm) < 7) return 130 + noise;
  if (glm::length(mm - kBoneMm) < 5) return 900 + noise;
  if (glm::length(mm * glm::dvec3(1, 1, 1.1)) < 21) return -100 + noise;
  return -1000 + noise;
}

scene::Scene organs(const char* preset = "ct-muscle") {
  scene::Scene scene;
  Volume v = makeVolume(kShowThisDims, SampleType::Int16, organValue, centredFrame(kShowThisDims));
  v.unit = "HU";
  scene.volume.data = Shared<Volume>(std::move(v));
  scene::applyPreset(scene, preset);
  return scene;
}

double opacityOf(const scene::Scene& scene, double value) {
  return scene::opacityAt(scene.volume.transfer.opacities, value);
}

TEST(MeasureTissue, FindsMedianAndNoise) {
  scene::Scene scene = organs();
  auto tissue = measureTissue(scene.volume, kLeftMm);
  ASSERT_TRUE(tissue);
  EXPECT_NEAR(tissue->value, 60, 6);
  EXPECT_NEAR(tissue->spread, 9.2, 5);  // four uniform numbers of width 16: 16 / sqrt(3)
}

TEST(MeasureTissue, AHistogramIsCountedOnceAVolume) {
  scene::Scene scene = organs(), other = organs();
  HistogramMemo histograms;
  auto tissue = measureTissue(scene.volume, kLeftMm, histograms.of(scene.volume));
  const std::uint64_t* counted = histograms.of(scene.volume).counts.data();
  auto again = measureTissue(scene.volume, kLeftMm, histograms.of(scene.volume));
  auto alone = measureTissue(scene.volume, kLeftMm);
  EXPECT_EQ(histograms.of(scene.volume).counts.data(), counted) << "not counted again";
  ASSERT_TRUE(tissue && again && alone);
  for (const auto& one : {again, alone}) EXPECT_EQ(one->low, tissue->low);
  EXPECT_EQ(histograms.of(scene.volume).counts, valueHistogram(*scene.volume.data, 0, 0).counts);
  other.volume.data = Shared<Volume>(makeVolume(kShowThisDims, SampleType::Int16, [](glm::ivec3 p) { return p.x; }));
  EXPECT_EQ(histograms.of(other.volume).counts, valueHistogram(*other.volume.data, 0, 0).counts);
}

TEST(MeasureTissue, ABorderNearbyDoesNotMix) {
  scene::Scene scene = organs();
  // A voxel inside the organ, against fat.
  auto tissue = measureTissue(scene.volume, kRightMm + glm::dvec3(0, 0, 5.5));
  ASSERT_TRUE(tissue);
  bool isOrgan = std::abs(tissue->value - 130) < 25, isFat = std::abs(tissue->value + 100) < 25;
  EXPECT_TRUE(isOrgan || isFat) << tissue->value;
  EXPECT_LT(tissue->spread, 40);
}

/// A plate of spongy bone between two thin shells, in flesh that is like it: its own values vary by as much.
double plateValue(glm::ivec3 p) {
  double noise = hashNoise(p, 1) + hashNoise(p, 2) + hashNoise(p, 3) + hashNoise(p, 4) - 2.0;
  int away = std::abs(p.z - kShowThisDims.z / 2);
  if (away <= 2) return 300.0 + 110.0 * noise;
  return (away == 3 ? 1000.0 : 110.0) + 12.0 * noise;
}

TEST(MeasureTissue, AThinMaterialIsNotTakenForWhatIsLikeItFartherOff) {
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(makeVolume(kShowThisDims, SampleType::Int16, plateValue));
  for (glm::ivec3 place : {glm::ivec3(20, 20, 20), {24, 22, 20}, {30, 14, 20}, {11, 33, 20}}) {
    auto tissue = measureTissue(layer, glm::dvec3(place));
    ASSERT_TRUE(tissue);
    EXPECT_NEAR(tissue->value, 300.0, 45.0);
    EXPECT_LT(tissue->spread, 110.0);
    EXPECT_EQ(tissue->here, valueAt(*layer.data, place, 0, 0));
  }
}

/// A vessel so thin that more blurred voxels than whole ones belong to it, beside a bone, in noise.
double vesselValue(glm::ivec3 p) {
  glm::dvec3 mm = glm::dvec3(p) - 0.5 * (glm::dvec3(kShowThisDims) - 1.0);
  double noise = 20.0 * (hashNoise(p, 1) + hashNoise(p, 2) - 1.0);
  double vessel = std::clamp(2.6 - glm::length(glm::dvec2(mm.x + 5, mm.y)), 0.0, 1.0);
  double bone = std::clamp(8.0 - glm::length(mm - glm::dvec3(14, 0, 0)), 0.0, 1.0);
  return 40.0 + 360.0 * vessel + 900.0 * bone + noise;
}

TEST(MeasureTissue, AThinVesselIsNotTakenForWhatIsAroundIt) {
  scene::Scene scene;
  scene.volume.data =
      Shared<Volume>(makeVolume(kShowThisDims, SampleType::Int16, vesselValue, centredFrame(kShowThisDims)));
  for (double z : {-9.5, 0.5, 12.5}) {
    auto tissue = measureTissue(scene.volume, {-4.5, 0.5, z});
    ASSERT_TRUE(tissue);
    EXPECT_NEAR(tissue->value, 400, 60);
    ASSERT_TRUE(tissue->low);
    EXPECT_NEAR(*tissue->low, 220, 40) << "halfway to what is around it";
  }
  auto around = measureTissue(scene.volume, {-10.5, 8.5, 0.5});
  ASSERT_TRUE(around);
  EXPECT_NEAR(around->value, 40, 10);
}

TEST(MeasureTissue, NothingOutsideTheVolume) {
  scene::Scene scene = organs();
  EXPECT_FALSE(measureTissue(scene.volume, {100, 0, 0}));
  EXPECT_FALSE(measureTissue({}, {0, 0, 0}));
  scene::Scene before = scene;
  EXPECT_FALSE(showThis(scene, {100, 0, 0}));
  EXPECT_FALSE(hideThis(scene, {100, 0, 0}));
  EXPECT_EQ(scene, before);
}

TEST(ShowThis, TheTissueIsSolidAndAllElseAVeil) {
  scene::Scene scene = organs();
  ASSERT_TRUE(showThis(scene, kLeftMm));
  EXPECT_GT(opacityOf(scene, 60), 0.5);
  for (double other : {130.0, 400.0, 900.0}) {
    EXPECT_LT(opacityOf(scene, other), 0.03) << other;
    EXPECT_GT(opacityOf(scene, other), 0.0) << other;
  }
  EXPECT_EQ(opacityOf(scene, -1000), 0.0);
  EXPECT_LT(scene.volume.transfer.opacities.size(), 16u);  // few enough to be edited by hand
}

TEST(ShowThis, WithAddBothTissuesAreSolid) {
  scene::Scene scene = organs();
  showThis(scene, kLeftMm);
  showThis(scene, kRightMm, true);
  EXPECT_GT(opacityOf(scene, 60), 0.5);
  EXPECT_GT(opacityOf(scene, 130), 0.5);
  EXPECT_LT(opacityOf(scene, 900), 0.03);
  showThis(scene, kBoneMm);
  EXPECT_LT(opacityOf(scene, 60), 0.03);
  EXPECT_GT(opacityOf(scene, 900), 0.5);
}

TEST(ShowThis, DarkTissueGetsABrighterToneAndBrightKeepsItsOwn) {
  auto luminance = [](const scene::Scene& scene, double value) {
    return glm::dot(scene::colorAt(scene.volume.transfer.colors, value), glm::dvec3(0.2126, 0.7152, 0.0722));
  };
  scene::Scene dark = organs("ct-bone"), bright = organs("ct-muscle");
  ASSERT_LT(luminance(dark, 60), 0.3);
  showThis(dark, kLeftMm);
  EXPECT_GT(luminance(dark, 60), 0.4);
  EXPECT_TRUE(std::is_sorted(dark.volume.transfer.colors.begin(), dark.volume.transfer.colors.end(),
                             [](const auto& a, const auto& b) { return a.value < b.value; }));
  auto before = bright.volume.transfer.colors;
  showThis(bright, kBoneMm);
  EXPECT_EQ(bright.volume.transfer.colors, before);
}

TEST(ShowThis, WorksWhereNothingWasVisible) {
  scene::Scene scene = organs();
  scene.volume.transfer.opacities.clear();
  scene.volume.transfer.colors.clear();
  scene.rayCast.mode = scene::RenderMode::Mip;
  ASSERT_TRUE(showThis(scene, kRightMm));
  EXPECT_GT(opacityOf(scene, 130), 0.5);
  EXPECT_EQ(opacityOf(scene, 60), 0.0);
  EXPECT_EQ(scene.rayCast.mode, scene::RenderMode::Volume);
}

TEST(ShowThis, OfMixedChannelsTheCurrentOneChanges) {
  Volume v;
  v.dims = {8, 8, 8};
  v.type = SampleType::UInt8;
  v.channels = 2;
  v.voxels.resize(timeStepBytes(v));
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = std::byte(i % 2 ? 200 : 40);
  computeRange(v);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(v));
  scene::completeChannels(scene.volume);
  scene.volume.channel = 1;
  auto first = scene.volume.channels[0];
  auto tissue = showThis(scene, {4, 4, 4});
  ASSERT_TRUE(tissue);
  EXPECT_EQ(tissue->value, 200);
  EXPECT_EQ(scene.volume.channels[0], first);
  EXPECT_GT(scene::opacityAt(scene.volume.channels[1].transfer.opacities, 200), 0.5);
}

TEST(HideThis, TakesTheTissueAwayAndNothingElse) {
  scene::Scene scene = organs(), before = scene;
  ASSERT_TRUE(hideThis(scene, kRightMm));
  EXPECT_LT(opacityOf(scene, 130), 1e-9);
  for (double other : {20.0, 900.0, -60.0})
    EXPECT_NEAR(opacityOf(scene, other), opacityOf(before, other), 1e-3) << other;
}

TEST(ReduceVolume, KeepsPlaceMeanAndRange) {
  glm::ivec3 dims(70, 41, 23);
  Volume v = makeVolume(
      dims, SampleType::UInt16, [](glm::ivec3 p) { return 3.0 * p.x + p.y + 500; }, centredFrame(dims, {1, 2, 3}, 0.4),
      0.5, -10);
  Progress progress;
  Volume small = reduceVolume(v, 0, 0, 24, progress);
  EXPECT_LE(std::max(small.dims.x, std::max(small.dims.y, small.dims.z)), 24);
  EXPECT_GE(small.dims.z, 8);
  EXPECT_EQ(small.range, v.range);
  // A voxel of the small one lies in the middle of those it stands for.
  glm::ivec3 p(5, 4, 3);
  glm::dvec3 world(small.worldFromVoxel * glm::dvec4(glm::dvec3(p), 1.0));
  glm::dvec3 voxel(glm::inverse(v.worldFromVoxel) * glm::dvec4(world, 1.0));
  EXPECT_NEAR(valueAt(small, p), 3.0 * voxel.x + voxel.y + 500, 0.3);
  EXPECT_LT(glm::length(centreOf(small) - centreOf(v)), 3.5);  // of whole blocks at the far ends
}

TEST(ReduceVolume, TakesOneChannelOfOneTimeStepAndCanBeStopped) {
  Volume v;
  v.dims = {4, 4, 4};
  v.type = SampleType::UInt8;
  v.channels = 2;
  v.timeSteps = 2;
  v.voxels.resize(timeStepBytes(v) * 2);
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = std::byte(10 * (i % 2) + (i >= 128 ? 100 : 0));
  computeRange(v);
  Progress progress;
  EXPECT_EQ(valueAt(reduceVolume(v, 1, 1, 8, progress), {2, 2, 2}), 110);
  EXPECT_EQ(valueAt(reduceVolume(v, 0, 0, 8, progress), {2, 2, 2}), 0);
  progress.cancel();
  EXPECT_THROW(reduceVolume(v, 0, 0, 8, progress), Cancelled);
}

}  // namespace
}  // namespace velum::session
