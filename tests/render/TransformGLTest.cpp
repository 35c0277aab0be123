// The picture depends on how camera and data lie to each other, not on where in the world they are.
#include "RenderFixture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kTransformDims(40, 36, 44);

/// A lopsided body in world millimetres that fades out before the border of the grid: 0..220.
double bodyAt(glm::dvec3 p) {
  double a = glm::length(p - glm::dvec3(3, -2, 1)),
         b = glm::length((p - glm::dvec3(-7, 3, 6)) * glm::dvec3(1, 1.5, 0.8));
  return 220.0 * std::max(glm::clamp((11.0 - a) / 5.0, 0.0, 1.0), 0.7 * glm::clamp((8.0 - b) / 4.0, 0.0, 1.0));
}

Volume bodyVolume(glm::ivec3 dims, const glm::dmat4& frame) {
  return makeVolume(
      dims, SampleType::UInt16, [&](glm::ivec3 p) { return 100.0 * bodyAt(glm::dvec3(frame * glm::dvec4(p, 1.0))); },
      frame, 0.5);
}

class TransformGL : public RenderTest {
 protected:
  static scene::Scene bodyScene(Volume volume) {
    scene::Scene scene = sceneOf(std::move(volume));
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;  // their grid costs more than the picture
    scene.volume.transfer.colors = {{0, {0.4f, 0.1f, 0.1f}}, {22000, {1, 0.9f, 0.7f}}};
    scene.volume.transfer.opacities = {{4000, 0}, {9000, 0.5}, {20000, 0.9}};
    scene.volume.transfer.unitDistance = 1;
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.fieldOfViewDeg = 28;
    lookAlong(scene, {0.4, -1, 0.35}, 80);
    return scene;
  }
  static scene::Scene moved(scene::Scene scene, const glm::dmat4& move) {
    Volume v = *scene.volume.data;
    v.worldFromVoxel = move * v.worldFromVoxel;
    scene.volume.data = Shared<Volume>(std::move(v));
    auto at = [&](glm::dvec3 p) { return glm::dvec3(move * glm::dvec4(p, 1.0)); };
    auto along = [&](glm::dvec3 d) { return glm::dvec3(move * glm::dvec4(d, 0.0)); };
    scene.camera.eye = at(scene.camera.eye);
    scene.camera.target = at(scene.camera.target);
    scene.camera.up = along(scene.camera.up);
    for (auto& cut : scene.cuts) {
      cut.centre = at(cut.centre);
      cut.axis = along(cut.axis);
    }
    return scene;
  }
};

TEST_F(TransformGL, TurningDataAndCameraTogetherChangesNothing) {
  scene::Scene scene = bodyScene(bodyVolume(kTransformDims, centredFrame(kTransformDims, {0.8, 1, 0.9})));
  scene.lighting.shadow = scene.lighting.occlusion = 0.6;
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.centre = {3, -12, 3};
  ball.size = glm::dvec3(14);
  scene.cuts = {ball};
  Image image = draw(scene);
  EXPECT_GT(coverageOf(image), 0.1);
  for (double angle : {0.5, 3.1})
    for (glm::dvec3 axis : {glm::dvec3(1, 2, -1)}) {
      glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle, glm::normalize(axis));
      expectSame(draw(moved(scene, turn)), image, 2.0, "angle " + std::to_string(angle));
    }
}

TEST_F(TransformGL, FarFromTheWorldsOriginThePictureIsTheSame) {
  scene::Scene scene = bodyScene(bodyVolume(kTransformDims, centredFrame(kTransformDims)));
  scene::Cut plane;
  plane.centre = {0, -3, 0};
  plane.axis = {0.2, -1, 0.3};
  scene.cuts = {plane};
  Image image = draw(scene);
  for (glm::dvec3 far : {glm::dvec3(1e6, 0, 0), glm::dvec3(-1e6, 1e6, 1e6)})
    expectSame(draw(moved(scene, glm::translate(glm::dmat4(1.0), far))), image, 2.0, "far away");
}

TEST_F(TransformGL, LeftHandedAndRightHandedGridsOfOneBodyLookTheSame) {
  Image image = draw(bodyScene(bodyVolume(kTransformDims, centredFrame(kTransformDims))));
  // On silhouettes a rounded gradient faces the eye or not, and may light a few pixels otherwise. A gradient that is
  // mirrored with its grid would light half of the picture otherwise.
  for (glm::dvec3 spacing :
       {glm::dvec3(-1, 1, 1), glm::dvec3(1, -1, 1), glm::dvec3(1, 1, -1), glm::dvec3(-1, -1, -1)}) {
    Image mirrored = draw(bodyScene(bodyVolume(kTransformDims, centredFrame(kTransformDims, spacing))));
    expectSame(mirrored, image, 10.0, "a mirrored grid");
    EXPECT_LT(differenceOf(mirrored, image).mean, 0.02);
  }
}

TEST_F(TransformGL, AnisotropicVoxelsKeepTheShape) {
  Image image = draw(bodyScene(bodyVolume(kTransformDims, centredFrame(kTransformDims))), {96, 96}, kAllLayers);
  glm::ivec3 dims(80, 36, 22);
  Image other = draw(bodyScene(bodyVolume(dims, centredFrame(dims, {0.5, 1, 2}))), {96, 96}, kAllLayers);
  // Two samplings of one body: where both show something solid, its surface lies within a coarse voxel or so.
  int both = 0, one = 0;
  double distance = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      bool a = sampleOf(image, {x, y}, "A") > 0.9f, b = sampleOf(other, {x, y}, "A") > 0.9f;
      one += a != b;
      if (!a || !b) continue;
      ++both;
      distance += glm::length(vectorOf(image, {x, y}, "position") - vectorOf(other, {x, y}, "position"));
    }
  EXPECT_GT(both, 900);
  EXPECT_LT(one, both / 8);
  EXPECT_LT(distance / both, 0.5);
}

TEST_F(TransformGL, NormalsOfShearedVoxelsPointOutOfTheBody) {
  glm::dmat4 frame = centredFrame(kTransformDims);
  frame[2] += 0.3 * frame[0];
  frame[3] = -glm::dvec4(glm::dvec3(glm::dmat3(frame) * (0.5 * (glm::dvec3(kTransformDims) - 1.0))), -1.0);
  Volume v = makeVolume(
      kTransformDims, SampleType::Float32,
      [&](glm::ivec3 p) { return 100.0 - 5.0 * glm::length(glm::dvec3(frame * glm::dvec4(p, 1.0))); }, frame);
  scene::Scene scene = sceneOf(std::move(v));
  scene.rayCast.mode = scene::RenderMode::Iso;
  scene.rayCast.isoValue = 50;  // a ball of 10 mm
  scene.camera.target = glm::dvec3(0.0);
  lookAlong(scene, {0.3, -1, 0.2}, 80);
  Image image = draw(scene, {64, 64}, kAllLayers);
  int hits = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      if (sampleOf(image, {x, y}, "A") == 0) continue;
      ++hits;
      glm::vec3 p = vectorOf(image, {x, y}, "position");
      EXPECT_NEAR(glm::length(p), 10.0f, 0.1f);
      EXPECT_GT(glm::dot(vectorOf(image, {x, y}, "normal"), glm::normalize(p)), 0.995f);
    }
  EXPECT_GT(hits, 300);
}

}  // namespace
}  // namespace velum
