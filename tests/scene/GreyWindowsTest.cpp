#include "scene/GreyWindows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/Error.h"
#include "makeVolume.h"
#include "scene/FirstLook.h"
#include "scene/Scene.h"

namespace velum::scene {
namespace {

constexpr int kSize = 40;

double radius(glm::ivec3 v) { return glm::length(glm::dvec3(v) - (kSize - 1) * 0.5) / (0.5 * kSize); }

/// A ball of a tissue in air, with a kernel of another.
Volume ctBall(double tissue, double kernel, double kernelRadius) {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::Int16, [=](glm::ivec3 p) {
    double r = radius(p);
    return (r > 0.9 ? -1000 : r > kernelRadius ? tissue : kernel) + 10 * hashNoise(p);
  });
  v.modality = Modality::CT;
  v.unit = "HU";
  return v;
}

/// A body of uptake 1 in noise about nothing, with a bladder of 80 and a liver of 2.5.
Volume pet(double unit) {
  Volume v = makeVolume({kSize, kSize, kSize}, SampleType::Float32, [=](glm::ivec3 p) {
    double r = radius(p), noise = 0.02 * hashNoise(p);
    bool isLiver = r < 0.85 && p.x < 14,
         isBladder = std::abs(p.x - 30) < 2 && std::abs(p.y - 20) < 2 && std::abs(p.z - 20) < 2;
    return unit * (noise + (r > 0.9 ? 0.0 : isBladder ? 80.0 : isLiver ? 2.5 : 1.0));
  });
  v.modality = Modality::PET;
  return v;
}

glm::dvec2 windowNamed(std::string_view name) {
  for (const GreyWindow& window : greyWindows())
    if (window.name == name) return {window.level, window.width};
  return glm::dvec2(0.0);
}

TEST(GreyWindows, HaveNamesOfTheirOwnAndSayTheirUnit) {
  std::set<std::string_view> names;
  for (const GreyWindow& window : greyWindows()) {
    EXPECT_TRUE(names.insert(window.name).second) << window.name;
    EXPECT_FALSE(window.title.empty() || window.unit.empty()) << window.name;
    EXPECT_GT(window.width, 0.0) << window.name;
  }
  for (const char* name : {"abdomen", "lung", "bone", "brain", "soft-tissue", "angio"})
    EXPECT_TRUE(names.contains(name));
}

TEST(GreyWindows, OfferThoseOfTheVolumesUnit) {
  Volume ct = ctBall(50, 50, 0), uptake = pet(1.0), activity = pet(1e4);
  uptake.unit = "SUVbw", activity.unit = "Bq/ml";
  for (const GreyWindow& window : greyWindowsFor(ct)) EXPECT_EQ(window.unit, "HU");
  for (const GreyWindow& window : greyWindowsFor(uptake)) EXPECT_EQ(window.unit, "SUVbw");
  EXPECT_GE(greyWindowsFor(ct).size(), 6u);
  EXPECT_GE(greyWindowsFor(uptake).size(), 3u);
  EXPECT_EQ(greyWindowsFor(ct).size() + greyWindowsFor(uptake).size(), greyWindows().size());
  EXPECT_TRUE(greyWindowsFor(activity).empty());
}

TEST(GreyWindows, ValuesOfACtGiveTheirUnitAway) {
  Volume ct = ctBall(50, 1200, 0.3);
  ct.unit.clear();
  EXPECT_EQ(valueUnit(ct), "HU");
  ct.modality = Modality::Unknown;
  EXPECT_EQ(valueUnit(ct), "HU");
  ct.modality = Modality::MR;
  EXPECT_EQ(valueUnit(ct), "");
  EXPECT_EQ(valueUnit(pet(1.0)), "");
}

TEST(GreyWindows, OfOtherValuesAreRefusedInWords) {
  VolumeLayer layer;
  Volume uptake = pet(1.0);
  uptake.unit = "SUVbw";
  layer.data = Shared<Volume>(std::move(uptake));
  applyGreyWindow(layer, "suv-10");
  EXPECT_EQ(effectiveWindow(layer), glm::dvec2(5, 10));
  try {
    applyGreyWindow(layer, "lung");
    FAIL() << "a window in HU over uptake";
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("HU"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("SUVbw"), std::string::npos) << error.what();
  }
  try {
    applyGreyWindow(layer, "spleen");
    FAIL();
  } catch (const ArgumentError& error) {
    EXPECT_NE(std::string(error.what()).find("abdomen"), std::string::npos) << error.what();
  }
  EXPECT_EQ(effectiveWindow(layer), glm::dvec2(5, 10));
}

TEST(GreyWindows, TheFirstOfACtIsOfWhatFillsIt) {
  EXPECT_EQ(firstWindow(ctBall(45, 700, 0.25)), windowNamed("abdomen"));
  EXPECT_EQ(firstWindow(ctBall(45, 420, 0.6)), windowNamed("angio")) << "contrast medium";
  EXPECT_EQ(firstWindow(ctBall(45, 1300, 0.6)), windowNamed("abdomen")) << "a skull is no contrast medium";
  EXPECT_EQ(firstWindow(ctBall(900, 1500, 0.5)), windowNamed("bone")) << "a bone without its flesh";
}

TEST(GreyWindows, SpongyBoneAroundDenseBoneIsNoContrastMedium) {
  Volume ct = makeVolume({kSize, kSize, kSize}, SampleType::Int16, [](glm::ivec3 p) {
    double r = radius(p);
    return r > 0.9 ? -1000.0 : r > 0.65 ? 45.0 : r > 0.45 ? 420.0 : 1000.0;
  });
  ct.modality = Modality::CT;
  ct.unit = "HU";
  EXPECT_EQ(firstWindow(ct), windowNamed("abdomen"));
}

TEST(GreyWindows, TheFirstOfAPetIsOfTheBodyNotOfItsBladder) {
  for (double unit : {1.0, 5e3}) {
    glm::dvec2 window = firstWindow(pet(unit));
    EXPECT_EQ(window.x, 0.5 * window.y) << "it begins at nothing";
    EXPECT_GE(window.y, 2.0 * unit) << "the liver is not all white";
    EXPECT_LE(window.y, 5.0 * unit) << "the body is not all black";
  }
}

TEST(GreyWindows, NewDataIsSeenByIt) {
  Scene scene;
  scene.volume.data = Shared<Volume>(ctBall(45, 700, 0.25));
  applyFirstLook(scene);
  EXPECT_EQ(effectiveWindow(scene.volume), windowNamed("abdomen"));
  EXPECT_EQ(scene.volume.transfer.preset, "ct-bone") << "the 3D view keeps its look";
}

}  // namespace
}  // namespace velum::scene
