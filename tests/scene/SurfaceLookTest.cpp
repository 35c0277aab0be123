#include "scene/SurfaceLook.h"

#include <gtest/gtest.h>

#include "makeVolume.h"
#include "scene/Presets.h"

namespace velum::scene {
namespace {

/// Air, a shell of fat, a ball of tissue, and a ball of bone within, in Hounsfield units; voxels of half a millimetre.
Scene bodyScene(std::string_view preset) {
  constexpr glm::ivec3 kDims(48, 48, 48);
  auto valueOf = [](glm::ivec3 p) {
    double r = glm::length(glm::dvec3(p) - 23.5);
    return r < 6 ? 800.0 : r < 18 ? 45.0 : r < 21 ? -100.0 : -1000.0;
  };
  Scene scene;
  Volume volume = makeVolume(kDims, SampleType::Int16, valueOf, centredFrame(kDims, glm::dvec3(0.5)));
  volume.modality = Modality::CT;
  scene.volume.data = Shared<Volume>(std::move(volume));
  applyPreset(scene, preset);
  return scene;
}

bool isTranslucent(const Scene& scene) {
  return isTranslucent(scene.volume.transfer, computeHistogram(*scene.volume.data, 1024));
}

TEST(SurfaceLook, AVeilOfSkinOverBoneIsTranslucentAndSkinAndBoneAreNot) {
  EXPECT_TRUE(isTranslucent(bodyScene("ct-skin-bone")));
  for (const char* preset : {"ct-skin", "ct-bone", "ct-skin-white-bone"})
    EXPECT_FALSE(isTranslucent(bodyScene(preset))) << preset;
}

TEST(SurfaceLook, WhatWasDenseIsOpaqueWithinAVoxelAndVeilsAreClear) {
  Scene scene = bodyScene("ct-skin-bone");
  auto colors = scene.volume.transfer.colors;
  auto before = scene.volume.transfer.opacities;
  makeSurface(scene);
  const TransferFunction& transfer = scene.volume.transfer;
  EXPECT_FALSE(isTranslucent(scene));
  EXPECT_EQ(transfer.colors, colors);
  EXPECT_DOUBLE_EQ(transfer.unitDistance, 0.5);
  for (double value = -1000; value < 2000; value += 1) {
    double old = opacityAt(before, value), now = opacityAt(transfer.opacities, value);
    if (old <= 0.1) {
      EXPECT_EQ(now, 0.0) << value;
    }
    if (old >= 0.25) {
      EXPECT_NEAR(now, 0.98, 1e-9) << value;
    }
  }
}

TEST(SurfaceLook, OfAHazeTheDenserHalfIsLeft) {
  Scene scene = bodyScene("ct-skin-bone");
  scene.volume.transfer.opacities = {{-1000, 0}, {0, 0.02}, {1000, 0.12}};
  makeSurface(scene);
  EXPECT_EQ(opacityAt(scene.volume.transfer.opacities, 45), 0.0);
  EXPECT_NEAR(opacityAt(scene.volume.transfer.opacities, 800), 0.98, 1e-9);
  scene.volume.transfer.opacities = {{0, 0}};
  makeSurface(scene);
  EXPECT_EQ(scene.volume.transfer.opacities, (std::vector<OpacityPoint>{{0, 0}})) << "of nothing nothing comes";
}

}  // namespace
}  // namespace velum::scene
