#include <algorithm>
#include <array>

#include "io/phantoms/Phantom.h"

namespace velum::io {

namespace {

using namespace phantom;

// A piece of a thigh, from the bone's shaft down to where it gets wide: world LPS in mm, origin in the middle. A lesion
// has eaten through the bone's shell and hardened there, and an artery full of contrast lies on the bone where its
// shell is thin. Where they touch the values are alike, so that only their form, or the truth, can part them.

enum Part : std::uint16_t { kFat = 1, kMuscle, kBone, kArtery, kVein, kLesion };

constexpr float kAir = -1000.0f, kFatHu = -95.0f, kMuscleHu = 60.0f, kCorticalHu = 1250.0f, kVeinHu = 180.0f;
/// What bone, artery and lesion have in common where they touch.
constexpr float kSpongyHu = 380.0f, kArteryHu = 380.0f, kHardHu = 380.0f, kLesionHu = 130.0f;
constexpr float kNoiseHu = 15.0f;
const Box kAll{Vec(-60), Vec(60)};
const Vec kLesionAt(22.0f, -17.0f, -14.0f);

glm::vec2 boneRadii(float z) {
  static constexpr glm::vec2 kWide[] = {{-60, 30}, {-40, 26}, {-15, 19}, {15, 15}, {60, 14}};
  static constexpr glm::vec2 kDeep[] = {{-60, 24}, {-40, 21}, {-15, 17}, {15, 15}, {60, 14}};
  return {curve(kWide, z), curve(kDeep, z)};
}

float boneDistance(Vec p) { return ellipse({p.x, p.y}, {0.0f, 0.0f}, boneRadii(p.z)) + 0.6f * noise(p / 9.0f, 607); }

float lesionDistance(Vec p) {
  float d = ellipsoid(p, kLesionAt, {14.0f, 12.0f, 15.0f});
  d = smoothMin(d, ellipsoid(p, kLesionAt + Vec(7, -9, 9), {8.0f, 7.0f, 8.0f}), 5.0f);
  d = smoothMin(d, ellipsoid(p, kLesionAt + Vec(6, -3, -13), {7.0f, 8.0f, 7.0f}), 5.0f);
  return d + 1.6f * noise(p / 6.0f, 613);
}

/// Runs along the bone, and lies on it from z = 4 to 34.
const std::vector<Segment>& artery() {
  static const std::vector<Segment> kTubes = [] {
    const glm::vec4 path[] = {{-24, -10, 75, 3.6f}, {-20, -8, 45, 3.5f},   {-16.5f, -7, 28, 3.5f}, {-17, -7, 12, 3.5f},
                              {-22, -10, -8, 3.4f}, {-31, -12, -32, 3.3f}, {-38, -8, -75, 3.2f}};
    auto tubes = tube(path);
    const glm::vec4 branch[] = {{-22, -10, -8, 2.2f}, {-14, -25, -14, 2.0f}, {2, -33, -18, 1.8f}, {14, -31, -17, 1.6f}};
    append(tubes, tube(branch));
    return tubes;
  }();
  return kTubes;
}

float arteryDistance(Vec p) {
  float d = 1e6f;
  for (const Segment& s : artery()) d = std::min(d, distance(s, p));
  return d;
}

/// The shell of the bone is thin where the artery lies on it, and gone in the lesion.
float shellMm(Vec p) {
  float thick = 1.6f + 2.6f * smoothStep(-40.0f, 20.0f, p.z);
  float byArtery = smoothStep(1.0f, 7.0f, arteryDistance(p)), byLesion = smoothStep(0.0f, 4.0f, lesionDistance(p));
  return thick * std::min(byArtery, byLesion) - 0.6f * (1.0f - std::min(byArtery, byLesion));
}

Layer layerOf(std::uint16_t label, float value, Distance distance) {
  Layer layer{label, value};
  layer.solids.push_back({kAll, std::move(distance)});
  return layer;
}

std::vector<Layer> buildScene() {
  std::vector<Layer> layers;
  layers.push_back(layerOf(kFat, kFatHu, [](Vec p) { return ellipse({p.x, p.y}, {0.0f, 2.0f}, {55.0f, 52.0f}); }));
  Layer muscle = layerOf(kMuscle, kMuscleHu, [](Vec p) {
    return ellipse({p.x, p.y}, {0.0f, 2.0f}, {48.0f, 45.0f}) + 1.5f * noise(p / 25.0f, 617);
  });
  muscle.texture = [](Vec p) { return 7.0f * noise(p / Vec(5.0f, 5.0f, 18.0f), 619); };
  layers.push_back(std::move(muscle));
  Layer vein{kVein, kVeinHu};
  const glm::vec4 path[] = {{-33, -2, 75, 4.4f}, {-31, -1, 30, 4.4f}, {-35, -2, -5, 4.2f}, {-44, 2, -75, 4.0f}};
  vein.tubes = tube(path);
  layers.push_back(std::move(vein));

  layers.push_back(layerOf(kBone, kCorticalHu, boneDistance));
  Layer spongy = layerOf(kBone, kSpongyHu, [](Vec p) { return boneDistance(p) + shellMm(p); });
  spongy.texture = [](Vec p) { return 70.0f * roughNoise(p / 2.4f, 631); };
  layers.push_back(std::move(spongy));

  Layer blood{kArtery, kArteryHu};
  blood.tubes = artery();
  blood.onto = {kFat, kMuscle, kVein};
  layers.push_back(std::move(blood));

  Layer soft = layerOf(kLesion, kLesionHu, lesionDistance);
  soft.texture = [](Vec p) { return 25.0f * roughNoise(p / 4.0f, 641); };
  layers.push_back(std::move(soft));
  // It hardens towards the bone.
  Layer hard =
      layerOf(kLesion, kHardHu, [](Vec p) { return smoothMax(lesionDistance(p), boneDistance(p) - 4.0f, 2.0f); });
  hard.texture = [](Vec p) { return 70.0f * roughNoise(p / 2.4f, 631); };
  hard.edge = 3.0f;
  hard.onto = {kLesion};
  layers.push_back(std::move(hard));
  return layers;
}

}  // namespace

/// A lesion and an artery that touch bone of the same values, CT in Hounsfield units: for trying what keeps growing
/// from leaking.
Sample makeLesion(int size, Progress& progress) {
  constexpr float kExtentMm = 116.0f;
  Grid grid{glm::ivec3(size), Vec(kExtentMm / float(size))};
  std::vector<Layer> layers = buildScene();
  Description description{"lesion",
                          SampleType::Int16,
                          Modality::CT,
                          "HU",
                          {{kFat, "subcutaneous fat", {0.96f, 0.86f, 0.55f}, 0.1f},
                           {kMuscle, "muscle", {0.70f, 0.28f, 0.24f}, 0.3f},
                           {kBone, "bone", {0.93f, 0.88f, 0.76f}},
                           {kArtery, "artery", {0.85f, 0.14f, 0.12f}},
                           {kVein, "vein", {0.25f, 0.40f, 0.78f}},
                           {kLesion, "lesion", {0.45f, 0.72f, 0.38f}}}};
  return fill(description, grid, progress, [&](const Slice& slice) {
    std::fill(slice.values.begin(), slice.values.end(), kAir);
    paint(slice, layers);
    std::uint64_t first = grid.index(0, 0, slice.z);
    for (std::size_t i = 0; i < slice.values.size(); ++i)
      slice.values[i] = std::max(slice.values[i] + kNoiseHu * gaussian(hash(0x1e51, first + i)), -1024.0f);
  });
}

}  // namespace velum::io
