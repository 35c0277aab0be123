// Normals of round things of known shape, in noise: what light, contours and lit spheres work with.
#include <fmt/format.h>

#include <random>

#include "RenderFixture.h"

namespace velum {
namespace {

const glm::dvec3 kToCamera(0.5, -1.0, 0.3);

enum class NormalsForm { Ball, Tube, Plate };
constexpr const char* kNormalsNames[] = {"ball", "tube", "plate"};

/// A thing of a radius in voxels, or of half a thickness, blurred as scanners do.
struct NormalsThing {
  NormalsForm form = NormalsForm::Ball;
  double radius = 1;
  bool isSharp = false;  ///< As sharp as voxels are.
  double boneAt = 0.0;   ///< So far from its surface lies something flat that is five times as bright; 0: nothing.
  glm::ivec3 dims() const { return glm::ivec3(std::min(60, int(2.0 * radius) + 14)); }
  /// Off the lattice, so that no symmetry of it helps.
  glm::dvec3 centre() const { return 0.5 * glm::dvec3(dims() - 1) + glm::dvec3(0.13, 0.31, -0.22); }
  /// Of a tube, or across a plate.
  glm::dvec3 axis() const {
    return glm::normalize(form == NormalsForm::Plate ? glm::dvec3(0.4, -0.86, 0.3) : glm::dvec3(0.4, 0.3, 0.86));
  }
  /// From the middle, the axis or the middle plane.
  glm::dvec3 outwards(glm::dvec3 p) const {
    glm::dvec3 off = p - centre(), along = axis() * glm::dot(off, axis());
    return form == NormalsForm::Ball ? off : form == NormalsForm::Tube ? off - along : along;
  }
  /// Share of a voxel that is inside, by an edge of 0.6 voxels.
  double valueAt(glm::dvec3 p) const {
    double value = shareInside(glm::length(outwards(p)) - radius);
    if (boneAt == 0.0) return value;
    glm::dvec3 side = glm::normalize(glm::cross(axis(), kToCamera));
    return value + 5.0 * shareInside(radius + boneAt - glm::dot(p - centre(), side));
  }
  double shareInside(double distance) const {
    return isSharp ? std::clamp(0.5 - distance, 0.0, 1.0) : 0.5 * std::erfc(distance / (0.6 * std::sqrt(2.0)));
  }
};

class NormalsGL : public RenderTest {
 protected:
  /// @param noise  standard deviation, in shares of the contrast
  static scene::Scene sceneOf(const NormalsThing& thing, double noise) {
    std::mt19937 random(5);
    std::normal_distribution<double> spread(0.0, noise);
    scene::Scene scene = RenderTest::sceneOf(makeVolume(thing.dims(), SampleType::UInt16, [&](glm::ivec3 p) {
      return 1000.0 * std::max(0.0, 2.0 + thing.valueAt(p) + spread(random));
    }));
    // Halfway up: of what is thinner than the blur, of what is left of it.
    double middle = thing.valueAt(thing.centre());
    scene.rayCast.isoValue = 1000.0 * (2.0 + 0.5 * middle);
    scene.volume.transfer.colors = {{0, {0.9f, 0.8f, 0.7f}}};
    scene.volume.transfer.opacities = {{scene.rayCast.isoValue - 60.0, 0}, {scene.rayCast.isoValue + 60.0, 0.95}};
    scene.volume.transfer.unitDistance = 0.1;
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = thing.centre();
    scene.camera.height = 2.0 * thing.radius + 1.0;
    lookAlong(scene, kToCamera, 150);
    return scene;
  }
  /// Degrees between what is drawn and the truth, ascending, where the surface is seen from no flat angle.
  static std::vector<double> errorsOf(const Image& image, const NormalsThing& thing, glm::dvec3 toEye) {
    std::vector<double> errors;
    eachShown(
        image,
        [&](glm::ivec2 pixel, glm::vec3 place) {
          glm::dvec3 off = thing.outwards(place), truth = glm::normalize(off);
          // Lone voxels of noise are none of its surface.
          if (glm::dot(truth, toEye) < 0.3 || std::abs(glm::length(off) - thing.radius) > 1.0) return;
          double cosine = glm::dot(truth, glm::normalize(glm::dvec3(vectorOf(image, pixel, "normal"))));
          errors.push_back(glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0))));
        },
        0.5f);
    std::sort(errors.begin(), errors.end());
    return errors;
  }
};

/// @param unit  voxels in which the volume picture takes 95 % of the light
struct Seen {
  scene::RenderMode mode;
  double unit;
};

TEST_F(NormalsGL, OfBallsAndTubesInNoiseAreWithinFiveDegreesOfTheTruth) {
  for (NormalsForm form : {NormalsForm::Ball, NormalsForm::Tube, NormalsForm::Plate})
    for (double radius : {0.5, 1.0, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0})
      for (Seen seen : {Seen{scene::RenderMode::Iso, 1.0}, Seen{scene::RenderMode::Volume, 0.1},
                        Seen{scene::RenderMode::Volume, 1.0}}) {
        if (form == NormalsForm::Plate ? radius > 2.0 : radius < 1.0) continue;
        // So thin that light comes through: it has no surface.
        if (form == NormalsForm::Ball && radius == 1.0 && seen.mode == scene::RenderMode::Volume && seen.unit == 1.0)
          continue;
        NormalsThing thing{form, radius};
        scene::Scene scene = sceneOf(thing, 0.03);
        scene.rayCast.mode = seen.mode;
        scene.volume.transfer.unitDistance = seen.unit;
        auto toEye = glm::normalize(scene.camera.eye - scene.camera.target);
        auto errors = errorsOf(draw(scene, {48, 48}, kAllLayers), thing, toEye);
        std::string what =
            fmt::format("{} of radius {}, {}, {}", kNormalsNames[int(form)], radius, enumName(seen.mode), seen.unit);
        // The camera's height is twice the radius and a voxel: a thin structure that were lost would be missed here.
        ASSERT_GT(errors.size(), 500u) << what;
        double median = errors[errors.size() / 2];
        // Of a plate one voxel thick there is hardly more than its blur.
        EXPECT_LT(median, radius < 1.0 ? 6.0 : 5.0) << what;
        RecordProperty(what, fmt::format("{:.2f}", median));
      }
}

/// Without noise: rows and slices show as ridges where a filter is narrow. Differences of single rows are off by 3.0
/// degrees in the median here and by 5.2 in the worst twentieth; smoothed across by 1.0 and 1.6; these by half of that.
TEST_F(NormalsGL, ShowNoSliceAsARidge) {
  NormalsThing thing{NormalsForm::Ball, 24.0};
  scene::Scene scene = sceneOf(thing, 0.0);
  for (auto mode : {scene::RenderMode::Iso, scene::RenderMode::Volume}) {
    scene.rayCast.mode = mode;
    auto toEye = glm::normalize(scene.camera.eye - scene.camera.target);
    auto errors = errorsOf(draw(scene, {48, 48}, kAllLayers), thing, toEye);
    ASSERT_GT(errors.size(), 500u);
    EXPECT_LT(errors[errors.size() / 2], 1.0) << enumName(mode);
    EXPECT_LT(errors[errors.size() * 95 / 100], 1.5) << enumName(mode);
  }
}

/// Phantoms, means of finer voxels, slices without gaps: narrow differences of these are off by 1.4 degrees in the
/// median and by 2.3 in the worst twentieth, and the pattern of it looks like wood.
TEST_F(NormalsGL, ShowNoWoodWhereEdgesAreAsSharpAsVoxels) {
  NormalsThing thing{NormalsForm::Ball, 24.0, true};
  scene::Scene scene = sceneOf(thing, 0.0);
  scene.rayCast.mode = scene::RenderMode::Iso;
  auto errors =
      errorsOf(draw(scene, {48, 48}, kAllLayers), thing, glm::normalize(scene.camera.eye - scene.camera.target));
  ASSERT_GT(errors.size(), 500u);
  RecordProperty("degrees", fmt::format("{:.2f} {:.2f}", errors[errors.size() / 2], errors[errors.size() * 95 / 100]));
  EXPECT_LT(errors[errors.size() / 2], 0.9);
  EXPECT_LT(errors[errors.size() * 95 / 100], 1.5);
}

/// A filter that is wide everywhere takes the normal of a thin vessel from the bone beside it: off by 11 degrees in the
/// median here and by 37 in the worst tenth.
TEST_F(NormalsGL, OfAVesselAreNotTakenFromTheBoneBesideIt) {
  for (double radius : {1.0, 1.5, 2.0}) {
    NormalsThing thing{NormalsForm::Tube, radius, false, 3.0};
    scene::Scene scene = sceneOf(thing, 0.03);
    scene.rayCast.mode = scene::RenderMode::Iso;
    auto errors =
        errorsOf(draw(scene, {48, 48}, kAllLayers), thing, glm::normalize(scene.camera.eye - scene.camera.target));
    ASSERT_GT(errors.size(), 500u);
    RecordProperty(fmt::format("radius {}", radius),
                   fmt::format("{:.2f} {:.2f}", errors[errors.size() / 2], errors[errors.size() * 9 / 10]));
    EXPECT_LT(errors[errors.size() / 2], 5.0) << radius;
    EXPECT_LT(errors[errors.size() * 9 / 10], 10.0) << radius;
  }
}

}  // namespace
}  // namespace velum
