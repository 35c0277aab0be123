// Thick slices, cubic between them: no stairs.
#include <fmt/format.h>

#include "RenderFixture.h"

namespace velum {
namespace {

class SmoothGL : public RenderTest {
 protected:
  static constexpr double kRadius = 20.0, kThickness = 5.0;
  static constexpr glm::ivec3 kDims{56, 56, 13};
  static glm::dvec3 centre() { return {27.6, 28.1, 0.5 * kThickness * (kDims.z - 1) + 0.7}; }

  /// A ball in slices five times as thick as voxels are wide, each the mean over its thickness.
  static scene::Scene sceneOfBall() {
    glm::dmat4 m(1.0);
    m[2][2] = kThickness;
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Int16,
        [](glm::ivec3 p) {
          double sum = 0.0;
          constexpr int kParts = 10;
          for (int i = 0; i < kParts; ++i) {
            glm::dvec3 place(p.x, p.y, kThickness * (p.z + (i + 0.5) / kParts - 0.5));
            sum += 0.5 * std::erfc(glm::length(place - centre()) - kRadius);
          }
          return std::round(1000.0 * sum / kParts);
        },
        m));
    scene.rayCast.mode = scene::RenderMode::Iso;
    scene.rayCast.isoValue = 500.0;
    scene.volume.transfer.colors = {{0, {0.9f, 0.8f, 0.7f}}};
    scene.volume.transfer.opacities = {{400, 0}, {600, 0.95}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = centre();
    scene.camera.height = 2.0 * kRadius + 2.0;
    lookAlong(scene, {0.3, -1.0, 0.2}, 150);
    return scene;
  }
  struct Errors {
    double angleDeg = 0, radius = 0;  ///< means; mm
  };
  static Errors errorsOf(const Image& image, glm::dvec3 toEye) {
    Errors errors;
    int count = 0;
    eachShown(
        image,
        [&](glm::ivec2 pixel, glm::vec3 place) {
          glm::dvec3 off = glm::dvec3(place) - centre(), truth = glm::normalize(off);
          if (glm::dot(truth, toEye) < 0.3) return;
          double cosine = glm::dot(truth, glm::normalize(glm::dvec3(vectorOf(image, pixel, "normal"))));
          errors.angleDeg += glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
          errors.radius += std::abs(glm::length(off) - kRadius);
          ++count;
        },
        0.5f);
    EXPECT_GT(count, 500);
    return {errors.angleDeg / std::max(1, count), errors.radius / std::max(1, count)};
  }
};

TEST_F(SmoothGL, ThickSlicesHaveNoStairs) {
  for (auto mode : {scene::RenderMode::Iso, scene::RenderMode::Volume}) {
    scene::Scene scene = sceneOfBall();
    scene.rayCast.mode = mode;
    auto toEye = glm::normalize(scene.camera.eye - scene.camera.target);
    Errors plain = errorsOf(draw(scene, {64, 64}, kAllLayers), toEye);
    scene.volume.smooth = true;
    Errors smooth = errorsOf(draw(scene, {64, 64}, kAllLayers), toEye);
    RecordProperty(std::string(enumName(mode)), fmt::format("{:.2f} {:.2f} deg, {:.2f} {:.2f} mm", plain.angleDeg,
                                                            smooth.angleDeg, plain.radius, smooth.radius));
    EXPECT_LT(smooth.angleDeg, 0.9 * plain.angleDeg) << enumName(mode);
    EXPECT_LT(smooth.angleDeg, 1.0) << enumName(mode);
    EXPECT_LT(smooth.radius, plain.radius) << enumName(mode);
  }
}

/// Between voxels of a plane field there is nothing to be bent.
TEST_F(SmoothGL, ARampLooksTheSame) {
  scene::Scene scene = sceneOf(makeVolume({16, 16, 16}, SampleType::Float32, [](glm::ivec3 p) { return double(p.x); }));
  scene.rayCast.mode = scene::RenderMode::Iso;
  scene.rayCast.isoValue = 7.3;
  lookAlong(scene, {1.0, 0.2, 0.1}, 60);
  auto places = [&] {
    std::vector<float> x;
    Image image = draw(scene, {32, 32}, kAllLayers);
    eachShown(image, [&](glm::ivec2, glm::vec3 place) { x.push_back(place.x); });
    return x;
  };
  for (float x : places()) EXPECT_NEAR(x, 7.3f, 0.02f);
  scene.volume.smooth = true;
  auto smooth = places();
  EXPECT_GT(smooth.size(), 100u);
  for (float x : smooth) EXPECT_NEAR(x, 7.3f, 0.02f);
}

}  // namespace
}  // namespace velum
