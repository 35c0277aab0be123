// Where a model lies that was enlarged and moved beside other data.
#include "InstancesFixture.h"
#include "plateSurface.h"

namespace velum {

TEST_F(InstancesGL, AnEnlargedModelIsDrawnWhereItWasMoved) {
  glm::ivec3 dims(40, 40, 40);
  scene::Scene scene = sceneOf(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3) { return 200.0; }, centredFrame(dims)));
  makeSolid(scene);
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(modelOfAtoms({{1, 0, 0}}, kResidue));
  scene.model.enlargement = 2.0;
  scene.model.offset = {24, 0, 5};
  scene.camera.target = {0, 0, 0};
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 70;
  lookAlong(scene, {0, -1, 0});
  Image image = draw(scene, {140, 140}, kLayers);
  EXPECT_EQ(sampleOf(image, {122, 60}, "instance"), 1.0f) << "its middle, 26 to the side and 5 up";
  EXPECT_NEAR(vectorOf(image, {122, 60}, "position").y, -2.0 * radiusOf(kResidue), 0.2);
  EXPECT_EQ(sampleOf(image, {50, 50}, "instance"), 0.0f) << "the volume";
}

}  // namespace velum
