#include "scene/Presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/Error.h"
#include "makeVolume.h"

namespace velum::scene {
namespace {

double opacityAt(const Scene& scene, double value) {
  const auto& points = scene.volume.transfer.opacities;
  if (value <= points.front().value) return points.front().opacity;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (value <= points[i].value) {
      double f = (value - points[i - 1].value) / (points[i].value - points[i - 1].value);
      return glm::mix(points[i - 1].opacity, points[i].opacity, f);
    }
  return points.back().opacity;
}

double radius(glm::ivec3 v, int n) { return glm::length(glm::dvec3(v) - (n - 1) * 0.5) / (0.5 * n); }

constexpr int kPresetEdge = 40;

/// Air, fat, muscle, contrast and bone in shells, with a lung inside.
Volume ctPhantom() {
  Volume v = makeVolume({kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::Int16, [](glm::ivec3 p) {
    double r = radius(p, kPresetEdge), noise = 10.0 * hashNoise(p);
    return noise + (r > 0.9 ? -1000 : r > 0.8 ? -100 : r > 0.6 ? 50 : r > 0.5 ? 1200 : r > 0.4 ? 350 : -850);
  });
  v.modality = Modality::CT;
  return v;
}

/// A dark background and a bright object of a tenth of the volume; values of any size.
Volume relativePhantom(double dark, double bright) {
  return makeVolume({kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::Float32, [=](glm::ivec3 p) {
    double r = radius(p, kPresetEdge);
    double v = r < 0.35 ? 1.0 : r < 0.6 ? 0.5 : 0.0;
    return dark + (bright - dark) * (v + 0.02 * hashNoise(p));
  });
}

/// Layers of both signs round zero, as a seismic cube has them.
Volume seismicPhantom() {
  return makeVolume({kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::Float32, [](glm::ivec3 p) {
    double wave = std::sin(p.z * 0.9);
    return 3000.0 * wave * wave * wave * (0.5 + 0.5 * hashNoise(p));
  });
}

Volume phantomFor(const Preset& preset, double scale) {
  if (preset.isAbsolute) return ctPhantom();
  if (preset.name == "seismic") return seismicPhantom();
  return relativePhantom(0.03 * scale, scale);
}

struct Shares {
  double seen = 0, dense = 0;
};
Shares sharesOf(const Scene& scene) {
  const Volume& v = *scene.volume.data;
  Shares shares;
  for (int z = 0; z < v.dims.z; ++z)
    for (int y = 0; y < v.dims.y; ++y)
      for (int x = 0; x < v.dims.x; ++x) {
        double opacity = opacityAt(scene, valueAt(v, {x, y, z}));
        shares.seen += opacity > 0.1;
        shares.dense += opacity > 0.5;
      }
  double count = double(voxelCount(v));
  return {shares.seen / count, shares.dense / count};
}

TEST(Presets, NoneIsEmptyOrSolid) {
  for (const Preset& preset : presets())
    for (double scale : {1.0, 255.0, 40000.0}) {
      Scene scene;
      scene.volume.data = Shared<Volume>(phantomFor(preset, scale));
      applyPreset(scene, preset.name);
      Shares shares = sharesOf(scene);
      EXPECT_GT(shares.seen, 0.005) << preset.name << " shows nothing at scale " << scale;
      EXPECT_LT(shares.dense, 0.7) << preset.name << " is a block at scale " << scale;
      EXPECT_GT(scene.volume.transfer.unitDistance, 0.0);
      EXPECT_GT(scene.volume.windowWidth, 0.0) << preset.name;
    }
}

TEST(Presets, TheBackgroundIsClear) {
  for (const Preset& preset : presets()) {
    Scene scene;
    scene.volume.data = Shared<Volume>(phantomFor(preset, 255.0));
    applyPreset(scene, preset.name);
    // Air, the darkest value, or for amplitudes zero: there a thin veil is the look.
    double background = preset.isAbsolute ? -1000.0 : preset.name == "seismic" ? 0.0 : 0.03 * 255.0;
    EXPECT_LE(opacityAt(scene, background), preset.name == "seismic" ? 0.03 : 0.0) << preset.name;
  }
}

TEST(Presets, OpacityIsThatOfAVoxelsLengthWhereValuesAreRelative) {
  for (const Preset& preset : presets()) {
    if (preset.isAbsolute) continue;
    for (double size : {1e-4, 1.0, 30.0}) {
      Scene scene;
      Volume volume = relativePhantom(3, 100);
      volume.worldFromVoxel = centredFrame(volume.dims, {size, 2 * size, 3 * size}, 0.3);
      scene.volume.data = Shared<Volume>(std::move(volume));
      applyPreset(scene, preset.name);
      EXPECT_NEAR(scene.volume.transfer.unitDistance, 2 * size, 1e-9 * size) << preset.name;
    }
  }
}

TEST(Presets, PointsAscendAndAreInRange) {
  for (const Preset& preset : presets()) {
    Scene scene;
    applyPreset(scene, preset.name);
    const auto& transfer = scene.volume.transfer;
    ASSERT_FALSE(transfer.opacities.empty()) << preset.name;
    ASSERT_FALSE(transfer.colors.empty()) << preset.name;
    for (std::size_t i = 1; i < transfer.opacities.size(); ++i)
      EXPECT_LT(transfer.opacities[i - 1].value, transfer.opacities[i].value) << preset.name;
    for (std::size_t i = 1; i < transfer.colors.size(); ++i)
      EXPECT_LT(transfer.colors[i - 1].value, transfer.colors[i].value) << preset.name;
    for (const auto& point : transfer.opacities) EXPECT_TRUE(point.opacity >= 0 && point.opacity <= 1) << preset.name;
    EXPECT_EQ(transfer.preset, preset.name);
  }
}

TEST(Presets, UnderSkinBoneIsWhiteFromWhatIsHalfBoneOn) {
  Scene scene;
  applyPreset(scene, "ct-skin-white-bone");
  auto colorOf = [&](double hounsfield) { return colorAt(scene.volume.transfer.colors, hounsfield); };
  for (double bone : {90.0, 160.0, 250.0, 700.0, 2000.0}) {
    glm::dvec3 color = colorOf(bone);
    EXPECT_GT(color.b, 0.79) << bone << ": ivory, or white";
    EXPECT_LT(color.r - color.b, 0.16) << bone;
  }
  for (double skin : {-500.0, -200.0, -50.0}) EXPECT_GT(colorOf(skin).r - colorOf(skin).b, 0.25) << skin;
  EXPECT_LT(colorOf(30).b, colorOf(250).b - 0.1) << "on a plane bone stands out from what is soft";
  EXPECT_GT(opacityAt(scene, -150), 0.85) << "skin hides what is beneath";
}

TEST(Presets, NamesAreUniqueAndAnUnknownOneListsThem) {
  Scene scene;
  Scene before = scene;
  try {
    applyPreset(scene, "ct-bones");
    FAIL() << "ct-bones is no preset";
  } catch (const ArgumentError& error) {
    std::string message = error.what();
    EXPECT_NE(message.find("ct-bones"), std::string::npos) << message;
    for (const Preset& preset : presets()) EXPECT_NE(message.find(preset.name), std::string::npos) << preset.name;
  }
  EXPECT_TRUE(scene == before);
  for (const Preset& a : presets())
    EXPECT_EQ(std::count_if(presets().begin(), presets().end(), [&](const Preset& b) { return a.name == b.name; }), 1)
        << a.name;
}

TEST(ChoosePreset, ShowsSomethingOfEveryKindOfVolume) {
  std::vector<Volume> volumes;
  for (double scale : {1e-6, 1.0, 255.0, 65535.0, 1e9}) volumes.push_back(relativePhantom(0.0, scale));
  volumes.push_back(relativePhantom(500, 1500));
  volumes.push_back(seismicPhantom());
  volumes.push_back(ctPhantom());
  volumes.push_back(ctPhantom());
  volumes.back().modality = Modality::Unknown;
  // Two values; one bright voxel in a thousand; mostly noise.
  volumes.push_back(makeVolume({kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::UInt8,
                               [](glm::ivec3 p) { return radius(p, kPresetEdge) < 0.5 ? 1.0 : 0.0; }));
  volumes.push_back(makeVolume({kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::UInt8,
                               [](glm::ivec3 p) { return p.x == 20 && p.y == 20 ? 255.0 : 4.0 * hashNoise(p); }));
  for (std::size_t i = 0, own = volumes.size(); i < own; ++i)
    for (int modality = 1; modality < 8 && i < 6; ++modality) {
      volumes.push_back(volumes[i]);
      volumes.back().modality = Modality(modality);
    }
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    Scene scene;
    scene.volume.data = Shared<Volume>(volumes[i]);
    std::string_view name = choosePreset(volumes[i]);
    applyPreset(scene, name);
    Shares shares = sharesOf(scene);
    EXPECT_GT(shares.seen, 0.0002) << "volume " << i << " as " << name << ", range " << volumes[i].range.x << " .. "
                                   << volumes[i].range.y;
    EXPECT_LT(shares.dense, 0.7) << "volume " << i << " as " << name;
  }
}

TEST(ChoosePreset, AConstantVolumeDoesNoHarm) {
  for (double value : {0.0, -1000.0, 5.0}) {
    Scene scene;
    scene.volume.data = Shared<Volume>(makeVolume({8, 8, 8}, SampleType::Int16, [=](glm::ivec3) { return value; }));
    applyPreset(scene, choosePreset(*scene.volume.data));
    for (const auto& point : scene.volume.transfer.opacities) EXPECT_TRUE(std::isfinite(point.value));
  }
}

TEST(Channels, EachHasTheCurveAndTheWindowOfItsOwnValues) {
  auto lookOf = [](double first, double second) {
    auto valueAt = [=](glm::ivec3 p) { return (p.x % 2 ? second : first) * (p.x / 2 + p.y * p.z % 7); };
    Volume v = makeVolume({2 * kPresetEdge, kPresetEdge, kPresetEdge}, SampleType::UInt16, valueAt);
    v.dims.x = kPresetEdge, v.channels = 2;
    computeRange(v);
    VolumeLayer layer;
    layer.data = Shared<Volume>(std::move(v));
    completeChannels(layer);
    return layer;
  };
  VolumeLayer one = lookOf(3, 500), other = lookOf(500, 3);
  ASSERT_EQ(one.channels.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(one.channels[c].transfer.opacities, other.channels[1 - c].transfer.opacities) << c;
    EXPECT_EQ(one.channels[c].windowLevel, other.channels[1 - c].windowLevel) << c;
    EXPECT_EQ(one.channels[c].windowWidth, other.channels[1 - c].windowWidth) << c;
  }
  EXPECT_GT(one.channels[1].windowWidth, 50 * one.channels[0].windowWidth);
}

}  // namespace
}  // namespace velum::scene
