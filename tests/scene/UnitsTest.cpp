#include "scene/Units.h"

#include <gtest/gtest.h>

#include "scene/Scene.h"

namespace velum::scene {
namespace {

TEST(Units, LengthsGrowWithTheFactorAndWhatIsPerLengthShrinks) {
  Scene scene;
  scene.camera.eye = {1, -2, 3};
  scene.camera.fieldOfViewDeg = 30;
  scene.volume.transfer.unitDistance = 2;
  scene.volume.transfer.opacities = {{100, 0.5}};
  scene.volume.transfer.gradientOpacities = {{40, 0.5}};
  scene.volume.channels.emplace_back().transfer.gradientOpacities = {{8, 0.5}};
  Cut cut;
  cut.shape = CutShape::Membrane;
  cut.centre = {4, 5, 6};
  cut.size = {10, 20, 30};
  cut.membrane.emplace();
  cut.membrane->field.byGradient = {{60, 1.0}};
  cut.membrane->field.kernels = {{{1, 2, 3}, 7.0, 500.0}};
  addCut(scene, cut);
  scaleLengths(scene, 4.0);
  EXPECT_EQ(scene.camera.eye, glm::dvec3(4, -8, 12));
  EXPECT_EQ(scene.camera.fieldOfViewDeg, 30) << "an angle";
  EXPECT_EQ(scene.volume.transfer.unitDistance, 8);
  EXPECT_EQ(scene.volume.transfer.opacities[0].value, 100) << "a value of the data";
  EXPECT_EQ(scene.volume.transfer.gradientOpacities[0].value, 10) << "value per length";
  EXPECT_EQ(scene.volume.channels[0].transfer.gradientOpacities[0].value, 2);
  EXPECT_EQ(scene.cuts[0].centre, glm::dvec3(16, 20, 24));
  EXPECT_EQ(scene.cuts[0].size, glm::dvec3(40, 80, 120));
  EXPECT_EQ(scene.cuts[0].membrane->field.byGradient[0].value, 15) << "value per length";
  EXPECT_EQ(scene.cuts[0].membrane->field.kernels[0].radius, 28);
  EXPECT_EQ(scene.cuts[0].membrane->field.kernels[0].strength, 500) << "a force";
}

}  // namespace
}  // namespace velum::scene
