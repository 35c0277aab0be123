// Normals of round things of known shape, in noise: what light, contours and lit spheres work with.
#include <random>

#include "RenderFixture.h"

namespace velum {
namespace {

/// A ball or a tube of a radius in voxels, blurred as scanners do.
struct Round {
  bool isTube = false;
  double radius = 1;
  glm::ivec3 dims() const { return glm::ivec3(std::min(60, int(2.0 * radius) + 14)); }
  /// Off the lattice, so that no symmetry of it helps.
  glm::dvec3 centre() const { return 0.5 * glm::dvec3(dims() - 1) + glm::dvec3(0.13, 0.31, -0.22); }
  glm::dvec3 axis() const { return glm::normalize(glm::dvec3(0.4, 0.3, 0.86)); }
  glm::dvec3 outwards(glm::dvec3 p) const {
    glm::dvec3 off = p - centre();
    return isTube ? off - axis() * glm::dot(off, axis()) : off;
  }
  /// Share of a voxel that is inside, by an edge of 0.6 voxels.
  double valueAt(glm::dvec3 p) const {
    return 0.5 * std::erfc((glm::length(outwards(p)) - radius) / (0.6 * std::sqrt(2.0)));
  }
};

class NormalsGL : public RenderTest {
 protected:
  /// @param noise  standard deviation, in shares of the contrast
  static scene::Scene sceneOfRound(const Round& round, double noise) {
    std::mt19937 random(5);
    std::normal_distribution<double> spread(0.0, noise);
    scene::Scene scene = sceneOf(makeVolume(round.dims(), SampleType::UInt16, [&](glm::ivec3 p) {
      return 1000.0 * std::max(0.0, 2.0 + round.valueAt(p) + spread(random));
    }));
    // Halfway up: of what is thinner than the blur, of what is left of it.
    double middle = round.valueAt(round.centre());
    scene.rayCast.isoValue = 1000.0 * (2.0 + 0.5 * middle);
    scene.volume.transfer.colors = {{0, {0.9f, 0.8f, 0.7f}}};
    scene.volume.transfer.opacities = {{scene.rayCast.isoValue - 60.0, 0}, {scene.rayCast.isoValue + 60.0, 0.95}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = round.centre();
    scene.camera.height = 2.0 * round.radius + 1.0;
    lookAlong(scene, {0.5, -1.0, 0.3}, 150);
    return scene;
  }
  /// Degrees between what is drawn and the truth, ascending, where the surface is seen from no flat angle.
  static std::vector<double> errorsOf(const Image& image, const Round& round, glm::dvec3 toEye) {
    std::vector<double> errors;
    eachShown(
        image,
        [&](glm::ivec2 pixel, glm::vec3 place) {
          glm::dvec3 off = round.outwards(place), truth = glm::normalize(off);
          // Lone voxels of noise are none of its surface.
          if (glm::dot(truth, toEye) < 0.3 || std::abs(glm::length(off) - round.radius) > 1.0) return;
          double cosine = glm::dot(truth, glm::normalize(glm::dvec3(vectorOf(image, pixel, "normal"))));
          errors.push_back(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
        },
        0.5f);
    std::sort(errors.begin(), errors.end());
    return errors;
  }
  static constexpr double kRadii[] = {1, 1.5, 2, 3, 5, 10, 20};
};

TEST_F(NormalsGL, OfBallsAndTubesInNoiseAreWithinFiveDegreesOfTheTruth) {
  for (bool isTube : {false, true})
    for (double radius : kRadii)
      for (auto mode : {scene::RenderMode::Iso, scene::RenderMode::Volume}) {
        Round round{isTube, radius};
        scene::Scene scene = sceneOfRound(round, 0.04);
        scene.rayCast.mode = mode;
        auto toEye = glm::normalize(scene.camera.eye - scene.camera.target);
        auto errors = errorsOf(draw(scene, {48, 48}, kAllLayers), round, toEye);
        std::string what = std::string(isTube ? "tube" : "ball") + " of radius " + std::to_string(radius) + ", " +
                           std::string(enumName(mode));
        // The camera's height is twice the radius and a voxel: a thin structure that were lost would be missed here.
        ASSERT_GT(errors.size(), 500u) << what;
        EXPECT_LT(errors[errors.size() / 2], 5.0) << what;
        // From five voxels on no grain is left that could be seen.
        if (radius >= 5) {
          EXPECT_LT(errors[errors.size() / 2], 2.5) << what;
        }
        RecordProperty(what, std::to_string(errors[errors.size() / 2]));
      }
}

/// Without noise, on a plane that runs flat across the slices: rows and slices show as ridges where a filter is narrow.
TEST_F(NormalsGL, ShowNoSliceAsARidge) {
  Round round{false, 24.0};
  scene::Scene scene = sceneOfRound(round, 0.0);
  for (auto mode : {scene::RenderMode::Iso, scene::RenderMode::Volume}) {
    scene.rayCast.mode = mode;
    auto toEye = glm::normalize(scene.camera.eye - scene.camera.target);
    auto errors = errorsOf(draw(scene, {48, 48}, kAllLayers), round, toEye);
    ASSERT_GT(errors.size(), 500u);
    EXPECT_LT(errors[errors.size() / 2], 1.2) << enumName(mode);
    EXPECT_LT(errors[errors.size() * 95 / 100], 2.0) << enumName(mode);
  }
}

}  // namespace
}  // namespace velum
