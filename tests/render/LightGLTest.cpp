// Light: which side it falls on, what stands in its way, and that voxels' sizes do not count.
#include <fmt/format.h>

#include <functional>

#include "RenderFixture.h"
#include "core/Vectors.h"
#include "scene/Project.h"

namespace velum {
namespace {

constexpr glm::ivec3 kLightDims(48, 48, 48);
constexpr double kLightRadius = 16.0;
constexpr glm::ivec2 kLightSize(96, 96);
constexpr glm::vec3 kAlbedo{0.8f, 0.5f, 0.3f};

/// Millimetres, from the middle.
using Depth = std::function<double(glm::dvec3)>;

class LightGL : public RenderTest {
 protected:
  /// A body whose depth below its surface is a function, in a box of 48 mm: values are the depth in tenths of a
  /// millimetre, so that the gradient is 10 a millimetre all around. Orthographic, two pixels a millimetre.
  static scene::Scene bodyOf(const Depth& depthAt, double voxel = 1.0) {
    glm::ivec3 dims(glm::dvec3(kLightDims) / voxel);
    glm::dmat4 frame = centredFrame(dims, glm::dvec3(voxel));
    scene::Scene scene = sceneOf(makeVolume(
        dims, SampleType::Float32,
        [&](glm::ivec3 p) { return 10.0 * std::clamp(depthAt(glm::dvec3(frame * glm::dvec4(p, 1.0))), -6.0, 6.0); },
        frame));
    scene.volume.transfer.colors = {{-100, kAlbedo}};
    scene.volume.transfer.opacities = {{0, 0}, {1, 0.99}};
    scene.volume.transfer.unitDistance = 0.5;
    scene.rayCast.isoValue = 0.0;
    scene.rayCast.stepVoxels = 0.25 / voxel;
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0.0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.height = 48;
    lookAlong(scene, {0, -1, 0});
    return scene;
  }
  static double ballAt(glm::dvec3 p) { return kLightRadius - glm::length(p); }
  static scene::Scene ball() { return bodyOf(ballAt); }

  static double brightness(const Image& image, glm::ivec2 pixel) {
    glm::vec4 color = colorOf(image, pixel);
    return double(color.r + color.g + color.b) / 3.0;
  }
  static glm::dvec3 towardsEye(const scene::Scene& scene) {
    return glm::normalize(scene.camera.eye - scene.camera.target);
  }
  /// From the camera's frame to the world.
  static glm::dvec3 keyOf(const scene::Scene& scene) {
    glm::dvec3 back = towardsEye(scene), right = glm::normalize(glm::cross(scene.camera.up, back));
    glm::dvec3 key = scene.lighting.keyDirection;
    return glm::normalize(key.x * right + key.y * glm::cross(back, right) + key.z * back);
  }
  static void lightFrom(scene::Scene& scene, glm::dvec3 world) {
    glm::dvec3 back = towardsEye(scene), right = glm::normalize(glm::cross(scene.camera.up, back));
    scene.lighting.keyDirection = {glm::dot(world, right), glm::dot(world, glm::cross(back, right)),
                                   glm::dot(world, back)};
  }
  static glm::ivec2 pixelOf(const scene::Scene& scene, glm::dvec3 world) {
    return glm::ivec2(glm::floor(scene::pixelFromWorld(scene.camera, glm::dvec2(kLightSize), world).value()));
  }
};

TEST_F(LightGL, TheSideOfTheKeyLightIsBrighterThanTheFarSide) {
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso})
    for (glm::dvec3 side : {glm::dvec3(0, -1, 0), glm::dvec3(0.8, 0.6, 0.5), glm::dvec3(0, 0, -1)})
      for (glm::dvec2 key : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(-0.6, -0.8)}) {
        scene::Scene scene = ball();
        scene.rayCast.mode = mode;
        scene.lighting.keyDirection = {key, 0.4};
        lookAlong(scene, side);
        Image image = draw(scene, kLightSize);
        // Rows run downwards.
        glm::ivec2 off(glm::dvec2(key.x, -key.y) * 22.0), middle = kLightSize / 2;
        EXPECT_GT(brightness(image, middle + off), brightness(image, middle - off) + 0.2)
            << enumName(mode) << " key " << key.x << ", " << key.y << " seen from " << side.x << ", " << side.y;
      }
}

TEST_F(LightGL, ALitBallIsItsFormula) {
  scene::Scene scene = ball();
  scene.rayCast.mode = scene::RenderMode::Iso;
  scene.lighting.ambient = 0.3;
  scene.lighting.diffuse = 0.6;
  scene.lighting.specular = 0.2;
  scene.lighting.shininess = 12.0;
  for (glm::dvec3 side : {glm::dvec3(0, -1, 0), glm::dvec3(0.8, 0.6, 0.5)}) {
    lookAlong(scene, side);
    glm::dvec3 eye = towardsEye(scene), key = keyOf(scene);
    glm::dvec3 up = glm::normalize(scene.camera.up - glm::dot(scene.camera.up, eye) * eye);
    Image image = draw(scene, kLightSize, kAllLayers);
    int compared = 0;
    eachShown(image, [&](glm::ivec2 pixel, glm::vec3 place) {
      glm::dvec3 normal = glm::normalize(glm::dvec3(place));
      if (glm::dot(normal, eye) < 0.3) return;  // on the rim a pixel's rays differ
      double lambert = std::max(glm::dot(normal, key), 0.0);
      if (lambert < 0.02 && glm::dot(normal, key) > -0.02) return;
      double sky = 0.7 + 0.3 * glm::dot(normal, up);
      double highlight = lambert > 0 ? std::pow(std::max(glm::dot(normal, glm::normalize(key + eye)), 0.0), 12.0) : 0.0;
      for (int c = 0; c < 3; ++c) {
        double wanted = double(kAlbedo[c]) * (0.3 * sky + 0.6 * lambert) + 0.2 * highlight;
        ASSERT_NEAR(colorOf(image, pixel)[c], wanted, 0.015) << "pixel " << pixel.x << ", " << pixel.y;
      }
      ++compared;
    });
    EXPECT_GT(compared, 1500);
  }
}

TEST_F(LightGL, TheHighlightIsWhereTheMirrorSaysItIs) {
  for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective})
    for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso})
      for (glm::dvec3 key : {glm::dvec3(0.7, 0.2, 0.6), glm::dvec3(-0.5, 0.6, 0.7), glm::dvec3(0.1, -0.8, 0.5)}) {
        scene::Scene scene = ball();
        scene.rayCast.mode = mode;
        scene.camera.projection = projection;
        lookAlong(scene, {0.3, -1, 0.4}, 70);
        scene.camera.fieldOfViewDeg = 34;
        scene.lighting.keyDirection = key;
        scene.lighting.ambient = scene.lighting.diffuse = 0.0;
        scene.lighting.specular = 1.0;
        scene.lighting.shininess = 60.0;
        Image image = draw(scene, kLightSize, kAllLayers);
        glm::dvec3 sum(0.0);
        double weight = 0;
        eachShown(image, [&](glm::ivec2 pixel, glm::vec3 place) {
          double w = std::pow(brightness(image, pixel), 4.0);
          sum += w * glm::dvec3(place);
          weight += w;
        });
        ASSERT_GT(weight, 0.1);
        glm::dvec3 normal = glm::normalize(sum / weight), place = kLightRadius * normal;
        glm::dvec3 eye = projection == scene::Projection::Orthographic ? towardsEye(scene)
                                                                       : glm::normalize(scene.camera.eye - place);
        glm::dvec3 mirrored = glm::reflect(-keyOf(scene), normal);
        EXPECT_GT(glm::dot(mirrored, eye), std::cos(glm::radians(4.0)))
            << enumName(projection) << " " << enumName(mode) << " key " << key.x << ", " << key.y;
      }
}

TEST_F(LightGL, TheInsideOfAShellIsLitOnTheSideThatIsSeen) {
  auto shellAt = [](glm::dvec3 p) { return 3.0 - std::abs(glm::length(p) - 16.0); };
  for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Iso}) {
    scene::Scene scene = bodyOf(shellAt);
    scene.rayCast.mode = mode;
    scene.lighting.keyDirection = {0, 0, 1};
    scene.lighting.specular = 0.0;
    double outside = brightness(draw(scene, kLightSize), kLightSize / 2);
    scene::Cut cut;
    cut.axis = {0, -1, 0};  // takes the half before the middle
    scene::addCut(scene, cut);
    Image image = draw(scene, kLightSize, kAllLayers);
    EXPECT_NEAR(vectorOf(image, kLightSize / 2, "position").y, 13.0, 0.6) << enumName(mode);
    EXPECT_NEAR(brightness(image, kLightSize / 2), outside, 0.03) << enumName(mode);
    EXPECT_LT(vectorOf(image, kLightSize / 2, "normal").y, -0.95f) << enumName(mode);
  }
}

TEST_F(LightGL, ASlantingFaceIsLitEvenlyWhetherItIsCutOrGrown) {
  // What stands in steps below it, voxels and the light grid's cells, does not show as rings. Pictures have 255 steps.
  for (glm::dvec3 slant : {glm::dvec3(0, -0.4, 1), glm::dvec3(0.1, 0, 1), glm::dvec3(-0.7, 0.3, 1)})
    for (bool isCut : {true, false}) {
      glm::dvec3 normal = glm::normalize(slant);
      scene::Scene scene = bodyOf([&](glm::dvec3 p) { return isCut ? 6.0 : -glm::dot(p, normal); });
      if (isCut) {
        scene::Cut cut;
        cut.axis = normal;
        scene::addCut(scene, cut);
      }
      lookAlong(scene, normal);
      lightFrom(scene, glm::normalize(normal + glm::dvec3(0.8, 0.3, 0.0)));
      scene.lighting.shadow = 0.6;
      scene.lighting.occlusion = 0.7;
      Image image = draw(scene, kLightSize);
      double least = 1.0, most = 0.0;
      for (int y = -20; y <= 20; ++y)
        for (int x = -20; x <= 20; ++x) {
          double bright = brightness(image, kLightSize / 2 + glm::ivec2(x, y));
          least = std::min(least, bright), most = std::max(most, bright);
        }
      EXPECT_GT(least, 0.3);
      EXPECT_LT(most - least, 0.0095) << (isCut ? "cut " : "grown ") << slant.x << " " << slant.y;
    }
}

TEST_F(LightGL, ACutInFrontOfABodyLeavesItsShading) {
  scene::Scene scene = ball();
  Image whole = draw(scene, kLightSize);
  scene::Cut plane;
  plane.centre = {0, -20, 0};  // four voxels before the ball
  plane.axis = {0, -1, 0};
  scene.cuts = {plane};
  expectSame(draw(scene, kLightSize), whole, 2.0, "a cut through air");
}

/// A floor, lit from straight above, and a ball that hangs over its middle.
class BlockerGL : public LightGL {
 protected:
  static constexpr double kFloor = -14.0, kBall = 8.0, kBallRadius = 6.0;
  static constexpr std::uint16_t kBallId = 5;

  static double floorAt(glm::dvec3 p) { return kFloor - p.z; }
  static double hangingAt(glm::dvec3 p) { return kBallRadius - glm::length(p - glm::dvec3(0, 0, kBall)); }
  static double bothAt(glm::dvec3 p) { return std::max(floorAt(p), hangingAt(p)); }

  static scene::Scene sceneWith(const Depth& depthAt, scene::RenderMode mode, double voxel = 1.5) {
    scene::Scene scene = bodyOf(depthAt, voxel);
    scene.rayCast.mode = mode;
    lookAlong(scene, {0, -1, 1});
    scene.camera.up = {0, 1, 0};
    lightFrom(scene, {0, 0, 1});
    scene.lighting.shadow = 1.0;
    scene.lighting.ambient = 0.1;
    scene.lighting.specular = 0.0;
    return scene;
  }
  /// Floor, and the ball as structure 5.
  static void label(scene::Scene& scene) {
    glm::dmat4 frame = scene.volume.data->worldFromVoxel;
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        scene.volume.data->dims,
        [&](glm::ivec3 p) { return hangingAt(glm::dvec3(frame * glm::dvec4(p, 1.0))) > -2 ? int(kBallId) : 1; },
        frame));
    scene::completeStructures(scene.labels);
    scene.labels.tint = 0.0;
  }
  /// Of the floor under the ball, and beside its shadow.
  struct Floor {
    double below = 0, beside = 0;
  };
  Floor floorOf(const scene::Scene& scene) {
    Image image = draw(scene, kLightSize, kAllLayers);
    glm::ivec2 below = pixelOf(scene, {0, 0, kFloor}), beside = pixelOf(scene, {15, -6, kFloor});
    for (glm::ivec2 pixel : {below, beside}) EXPECT_NEAR(vectorOf(image, pixel, "position").z, kFloor, 1.0);
    return {brightness(image, below), brightness(image, beside)};
  }
  static constexpr scene::RenderMode kModes[] = {scene::RenderMode::Volume, scene::RenderMode::Iso};
};

TEST_F(BlockerGL, WhatStandsInTheLightThrowsAShadowAndNothingElseDoes) {
  for (auto mode : kModes) {
    Floor open = floorOf(sceneWith(floorAt, mode)), blocked = floorOf(sceneWith(bothAt, mode));
    EXPECT_GT(open.below, 0.35) << enumName(mode);
    EXPECT_NEAR(open.below, open.beside, 0.02) << enumName(mode);
    EXPECT_LT(blocked.below, 0.3 * open.below) << enumName(mode);
    EXPECT_NEAR(blocked.beside, open.beside, 0.02) << enumName(mode);
    scene::Scene scene = sceneWith(bothAt, mode);
    lightFrom(scene, {-0.7, 0, 0.7});
    EXPECT_GT(floorOf(scene).below, 0.25) << "light from the side goes by, " << enumName(mode);
    scene.lighting.shadow = 0.5;
    lightFrom(scene, {0, 0, 1});
    EXPECT_NEAR(floorOf(scene).below, 0.5 * (open.below + blocked.below), 0.04) << "half a shadow, " << enumName(mode);
  }
}

TEST_F(BlockerGL, AThinBlockerThrowsItsShadowWholeHoweverFarOff) {
  // A sheet of a millimetre, two cells, 30 mm over a floor that slopes, so that it is met after whole and broken steps.
  // It goes to the end of the data, and light comes in behind that.
  constexpr double kSheet = 21.0, kHalf = 0.5, kEdge = 6.0, kMargin = 2.5, kSheetEnd = 0.5 * kLightDims.x - kMargin;
  auto depthAt = [](glm::dvec3 p) {
    double floor = (-10.0 + 0.3 * p.y - p.z) / std::sqrt(1.09);
    return std::max(floor, std::min(p.x - kEdge, kHalf - std::abs(p.z - kSheet)));
  };
  glm::dvec3 light = glm::normalize(glm::dvec3(0.5, 0.2, 0.84));
  scene::Scene scene = sceneWith(depthAt, scene::RenderMode::Volume, 0.5);
  lightFrom(scene, light);
  Image image = draw(scene, kLightSize, kAllLayers);
  double open = brightness(image, pixelOf(scene, {-20, 0, -10}));
  int shadowed = 0, lit = 0, tooLight = 0, tooDark = 0;
  eachShown(image, [&](glm::ivec2 pixel, glm::vec3 place) {
    glm::dvec3 p(place);
    if (std::abs(depthAt(p)) > 1.0 || p.z > 0.0 || std::max(std::abs(p.x), std::abs(p.y)) > 20.0) return;
    glm::dvec3 under = p + light * ((kSheet - p.z) / light.z);
    if (std::max(under.x, under.y) > kSheetEnd) return;
    double beyond = under.x - kEdge, bright = brightness(image, pixel);
    shadowed += beyond > kMargin, tooLight += beyond > kMargin && bright > 0.4 * open;
    lit += beyond < -kMargin, tooDark += beyond < -kMargin && bright < 0.85 * open;
  });
  EXPECT_GT(shadowed, 300);
  EXPECT_GT(lit, 300);
  EXPECT_EQ(tooLight, 0) << "of " << shadowed << " pixels in the shadow";
  EXPECT_EQ(tooDark, 0) << "of " << lit << " pixels beside it";
}

TEST_F(BlockerGL, AVeilLetsThroughWhatBeersLawSays) {
  // Values below those of air, so that no border of it is solid.
  double sides[] = {12.0, 12.0, 4.0};
  auto isVeil = [&](glm::dvec3 p) {
    p -= glm::dvec3(0, 0, kBall);
    return std::abs(p.x) < sides[0] && std::abs(p.y) < sides[1] && std::abs(p.z) < sides[2];
  };
  scene::Scene scene = sceneWith(floorAt, scene::RenderMode::Volume);
  glm::dmat4 frame = scene.volume.data->worldFromVoxel;
  glm::ivec3 dims = scene.volume.data->dims;
  double thick = 0;
  for (int z = 0; z < dims.z; ++z)
    thick += isVeil(glm::dvec3(frame * glm::dvec4(dims.x / 2, dims.y / 2, z, 1))) ? 1.5 : 0.0;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::Float32,
      [&](glm::ivec3 v) {
        glm::dvec3 p(frame * glm::dvec4(v, 1.0));
        return isVeil(p) ? -120.0 : 10.0 * std::clamp(floorAt(p), -6.0, 6.0);
      },
      frame));
  scene.volume.transfer.unitDistance = 1.0;
  double open = 0;
  for (double opacity : {0.0, 0.03, 0.1, 0.25}) {
    // Half of the value at a border is half of the veil, so that it is as thick as its voxels.
    scene.volume.transfer.opacities = {{-120, opacity}, {-90.1, opacity}, {-90, 0}, {0, 0}, {1, 0.99}};
    double below = floorOf(scene).below;
    if (opacity == 0.0) open = below;
    double ambient = open * 0.1 / (0.1 + scene.lighting.diffuse);  // that a shadow leaves
    double wanted = ambient + (open - ambient) * std::pow(1.0 - opacity, thick);
    EXPECT_NEAR(below, wanted, 0.04 * open) << opacity;
  }
}

TEST_F(BlockerGL, WhatACutSparesThrowsItsShadowAndWhatItTakesThrowsNone) {
  for (auto mode : kModes) {
    scene::Scene scene = sceneWith(bothAt, mode);
    label(scene);
    double blocked = floorOf(scene).below;
    scene::Cut cut;
    cut.centre = {0, 0, kFloor + 4};
    cut.axis = {0, 0, 1};  // takes the ball
    scene::addCut(scene, cut);
    double taken = floorOf(scene).below;
    EXPECT_LT(blocked, 0.3 * taken) << enumName(mode);
    scene.cuts[0].spares = {{kBallId}};
    EXPECT_NEAR(floorOf(scene).below, blocked, 0.03) << enumName(mode);
  }
}

TEST_F(BlockerGL, AHiddenStructureThrowsNoShadow) {
  scene::Scene scene = sceneWith(bothAt, scene::RenderMode::Volume);
  label(scene);
  double blocked = floorOf(scene).below;
  scene.labels.structures[1].opacity = 0.0;
  EXPECT_LT(blocked, 0.3 * floorOf(scene).below);
}

TEST_F(BlockerGL, ASceneOfLabelsAloneHasTheSameShadow) {
  scene::Scene scene = sceneWith(bothAt, scene::RenderMode::Volume);
  glm::dmat4 frame = scene.volume.data->worldFromVoxel;
  auto labelled = [&](const Depth& depthAt) {
    scene::Scene alone = scene;
    alone.volume.data = {};
    alone.labels.data = Shared<LabelVolume>(makeLabels(
        scene.volume.data->dims,
        [&](glm::ivec3 p) { return depthAt(glm::dvec3(frame * glm::dvec4(p, 1.0))) > 0 ? 1 : 0; }, frame));
    scene::completeStructures(alone.labels);
    return floorOf(alone).below;
  };
  EXPECT_LT(labelled(bothAt), 0.3 * labelled(floorAt));
}

TEST_F(BlockerGL, OpennessInFogIsWhatIsLeftOfTheLightFromAround) {
  scene::Scene scene = sceneWith([](glm::dvec3) { return 1.0; }, scene::RenderMode::Volume);
  double extinction = 0.1, reach = 10.0;  // a mm, mm
  scene.volume.transfer.opacities = {{0, 1.0 - std::exp(-extinction)}, {20, 1.0 - std::exp(-extinction)}};
  scene.volume.transfer.unitDistance = 1.0;
  lookAlong(scene, {0, -1, 0});
  scene.lighting.ambient = 1.0;
  scene.lighting.diffuse = scene.lighting.shadow = 0.0;
  scene.lighting.occlusion = 1.0;
  scene.lighting.occlusionRadius = reach / 48.0;
  // The ray through the middle meets fog all over, and from the front what lies before it. Mean over the faces and the
  // corners of a cube, brighter by 1.6, as half of what is around a surface is the surface's own.
  double seen = 0, weights = 0;
  for (double depth = 0.05; depth < 48.0; depth += 0.1) {
    auto through = [&](double fog) { return std::exp(-extinction * std::min(fog, reach)); };
    double mean = (9.0 * through(reach) + through(depth) + 4.0 * through(depth * std::sqrt(3.0))) / 14.0;
    double weight = std::exp(-extinction * depth);
    seen += weight * std::min(1.0, 1.6 * mean);
    weights += weight;
  }
  glm::vec4 color = colorOf(draw(scene, kLightSize), kLightSize / 2);
  // Fog has no normal but the one to the eye: half of the sky.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(color[c], double(kAlbedo[c]) * 0.7 * seen / weights, 0.02);
}

TEST_F(BlockerGL, AHoleIsDarkerThanTheOpenFloorByOcclusion) {
  auto holed = [](glm::dvec3 p) {
    double wall = glm::length(glm::dvec2(p)) - 3.0;  // a hole of 6 mm, 8 mm deep
    return std::min(floorAt(p), std::max(wall, kFloor - 8.0 - p.z));
  };
  for (auto mode : kModes) {
    scene::Scene scene = sceneWith(holed, mode);
    lookAlong(scene, {0, 0, 1});
    lightFrom(scene, {0, 0, 1});
    scene.lighting.shadow = 0.0;
    scene.lighting.occlusion = 1.0;
    scene.lighting.occlusionRadius = 0.12;
    Image image = draw(scene, kLightSize, kAllLayers);
    glm::ivec2 hole = pixelOf(scene, {0, 0, kFloor}), open = pixelOf(scene, {14, 9, kFloor});
    EXPECT_LT(vectorOf(image, hole, "position").z, kFloor - 6.0);
    EXPECT_LT(brightness(image, hole), 0.8 * brightness(image, open)) << enumName(mode);
    scene.lighting.occlusion = 0.0;
    image = draw(scene, kLightSize);
    EXPECT_NEAR(brightness(image, hole), brightness(image, open), 0.03) << enumName(mode);
  }
}

TEST_F(BlockerGL, AWallTakesAsMuchOfTheLightFromAroundFromWhicheverSide) {
  double least = 1.0, most = 0.0, open = 0.0;
  for (glm::dvec2 side : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
    auto walled = [&](glm::dvec3 p) { return std::max(floorAt(p), glm::dot(glm::dvec2(p), side) - 9.0); };
    scene::Scene scene = sceneWith(walled, scene::RenderMode::Volume);
    lookAlong(scene, {0, 0, 1});
    scene.lighting.diffuse = scene.lighting.shadow = 0.0;
    scene.lighting.ambient = scene.lighting.occlusion = 1.0;
    scene.lighting.occlusionRadius = 0.15;
    Image image = draw(scene, kLightSize);
    // Places lie where four pixels meet: one of them alone would be nearer to the wall on one side than on the other.
    auto around = [&](glm::dvec3 place) {
      glm::ivec2 pixel = pixelOf(scene, place + glm::dvec3(1e-6, -1e-6, 0.0));
      double sum = 0.0;
      for (int i = 0; i < 4; ++i) sum += brightness(image, pixel - glm::ivec2(i & 1, i >> 1));
      return 0.25 * sum;
    };
    double beside = around({side * 6.0, kFloor}), away = around({side * -9.0, kFloor});
    EXPECT_LT(beside, 0.9 * away) << side.x << ", " << side.y;
    least = std::min(least, beside), most = std::max(most, beside), open = away;
  }
  EXPECT_LT(most - least, 0.08 * open);
}

TEST_F(BlockerGL, StrengthsOfNothingChangeNothing) {
  auto walled = [](glm::dvec3 p) { return std::max(bothAt(p), p.x - 9.0); };
  for (auto mode : kModes) {
    scene::Scene scene = sceneWith(walled, mode);
    scene.lighting.shadow = scene.lighting.occlusion = 0.0;
    scene.lighting.occlusionRadius = 0.12;
    Image plain = draw(scene, kLightSize);
    scene.lighting.shadow = 1.0;
    Image shadowed = draw(scene, kLightSize);
    scene.lighting.occlusion = 1e-6;
    expectSame(draw(scene, kLightSize), shadowed, 0.1, "occlusion beside shadows");
    scene.lighting.shadow = 0.0;
    expectSame(draw(scene, kLightSize), plain, 0.1, "occlusion alone");
    scene.lighting.occlusion = 1.0;
    Image occluded = draw(scene, kLightSize);
    EXPECT_GT(differenceOf(occluded, plain).largest, 5.0);
    scene.lighting.shadow = 1e-6;
    expectSame(draw(scene, kLightSize), occluded, 0.1, "shadows beside occlusion");
    scene.lighting.occlusion = 0.0;
    expectSame(draw(scene, kLightSize), plain, 0.1, "shadows alone");
  }
}

TEST_F(BlockerGL, VoxelsOfOneAndOfTwoMillimetresAreLitAlike) {
  struct Look {
    scene::RenderMode mode;
    double opacity;  ///< of half a millimetre
  };
  for (auto [mode, opacity] :
       {Look{scene::RenderMode::Volume, 0.99}, {scene::RenderMode::Volume, 0.05}, {scene::RenderMode::Iso, 0.99}})
    for (bool isOccluded : {false, true}) {
      Image images[2];
      for (int i = 0; i < 2; ++i) {
        scene::Scene scene = sceneWith(bothAt, mode, 1.0 + i);
        scene.volume.transfer.opacities = {{0, 0}, {1, opacity}};
        scene.lighting.occlusion = isOccluded ? 1.0 : 0.0;
        scene.lighting.occlusionRadius = 0.1;
        scene.lighting.specular = 0.25;
        lightFrom(scene, {-0.4, -0.3, 1});
        images[i] = draw(scene, kLightSize);
      }
      double sums[2] = {0, 0};
      for (int y = 0; y < kLightSize.y; ++y)
        for (int x = 0; x < kLightSize.x; ++x)
          for (int i = 0; i < 2; ++i) sums[i] += brightness(images[i], {x, y}) * double(colorOf(images[i], {x, y}).a);
      std::string what = fmt::format("{}, opacity {}{}", enumName(mode), opacity, isOccluded ? ", occluded" : "");
      // Where it is translucent normals come from more than its surface.
      EXPECT_NEAR(sums[1] / sums[0], 1.0, opacity < 0.9 ? 0.1 : 0.03) << what;
      EXPECT_LT(differenceOf(images[0], images[1]).mean, 4.0) << what;
    }
}

}  // namespace
}  // namespace velum
