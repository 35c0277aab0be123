// Pictures whose right answer is a formula.
#include <random>

#include "RenderFixture.h"

namespace velum {
namespace {

class ExactGL : public RenderTest {
 protected:
  /// A block of one value whose opacity is `opacity` a millimetre.
  static scene::Scene fogScene(double opacity, const glm::dmat4& frame, glm::ivec3 dims = {24, 40, 16}) {
    scene::Scene scene = sceneOf(makeVolume(
        dims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }, frame));
    scene.volume.transfer.colors = {{0, {1.0f, 0.5f, 0.25f}}};
    scene.volume.transfer.opacities = {{0, opacity}, {200, opacity}};
    return scene;
  }
};

TEST_F(ExactGL, FogAttenuatesByBeersLaw) {
  glm::ivec2 size(64, 64);
  const glm::dvec3 kSides[] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {-0.5, -1, 0.4}};
  for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective})
    for (const auto& frame :
         {centredFrame({24, 40, 16}), centredFrame({24, 40, 16}, {0.7, 0.5, 2.5}, 0.6, {30, -20, 5})})
      for (glm::dvec3 side : kSides) {
        scene::Scene scene = fogScene(0.02, frame);
        scene.camera.projection = projection;
        scene.camera.target = centreOf(*scene.volume.data);
        scene.camera.height = 30;
        lookAlong(scene, side, 150);
        Image image = draw(scene, size);
        double sigma = -std::log(1.0 - 0.02);
        int inside = 0;
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x) {
            TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
            glm::dvec2 t = boxInterval(*scene.volume.data, ray);
            double d = std::max(0.0, t.y - t.x);
            double expected = 1.0 - std::exp(-sigma * d);
            EXPECT_NEAR(sampleOf(image, {x, y}, "A") * 255.0, expected * 255.0, 1.0)
                << "pixel " << x << ", " << y << ", " << d << " mm";
            inside += d > 1.0;
            if (d > 10.0) {
              EXPECT_NEAR(sampleOf(image, {x, y}, "G"), 0.5, 0.03) << "colour of the fog";
            }
          }
        EXPECT_GT(inside, 200);
      }
}

TEST_F(ExactGL, AirBelowTheFirstPointOfACurveIsClear) {
  // A ramp that begins at the air's own value, and one above it; with a colour there or none.
  glm::ivec3 dims(24);
  for (double first : {-1000.0, 30.0})
    for (bool isShaded : {false, true}) {
      scene::Scene scene = sceneOf(makeVolume(dims, SampleType::Int16, [&](glm::ivec3 p) {
        return glm::length(glm::dvec3(p) - 11.5) < 4.0 ? 500.0 : -1000.0;
      }));
      scene.volume.transfer.opacities = {{first, 0}, {first + 60, 0.9}, {2000, 0.9}};
      scene.lighting.shaded = isShaded;
      Image image = draw(scene, {32, 32});
      EXPECT_GT(sampleOf(image, {16, 16}, "A"), 0.9);
      for (glm::ivec2 corner : {glm::ivec2(4, 16), {16, 4}, {27, 16}, {16, 27}, {8, 8}, {23, 23}})
        EXPECT_EQ(sampleOf(image, corner, "A"), 0.0) << first << ": " << corner.x << ", " << corner.y;
    }
}

TEST_F(ExactGL, OpacityDoesNotDependOnTheStep) {
  scene::Scene scene = fogScene(0.03, centredFrame({24, 40, 16}));
  scene.rayCast.stepVoxels = 0.1;
  Image fine = draw(scene);
  for (double step : {0.37, 1.0, 4.0}) {
    scene.rayCast.stepVoxels = step;
    expectSame(draw(scene), fine, 1.0, "step " + std::to_string(step));
  }
}

TEST_F(ExactGL, UnitDistanceScalesTheFog) {
  scene::Scene scene = fogScene(0.5, centredFrame({24, 40, 16}));
  scene.volume.transfer.unitDistance = 40;
  lookAlong(scene, {0, -1, 0});
  scene.camera.projection = scene::Projection::Orthographic;
  // The block is 40 mm deep: half of what is behind it is covered.
  EXPECT_NEAR(sampleOf(draw(scene, {33, 33}), {16, 16}, "A"), 0.5, 1.01 / 255);
}

TEST_F(ExactGL, HalvingTheStepConverges) {
  scene::Scene scene = sceneOf(makeVolume(
      {32, 32, 32}, SampleType::UInt8,
      [](glm::ivec3 p) { return 120 + 100 * std::sin(p.x * 0.5) * std::cos(p.y * 0.4) * std::sin(p.z * 0.6 + 1); },
      centredFrame({32, 32, 32})));
  scene.volume.transfer.colors = {{0, {0, 0, 1}}, {120, {0, 1, 0}}, {255, {1, 0, 0}}};
  scene.volume.transfer.opacities = {{100, 0}, {180, 0.3}, {200, 0.05}, {255, 0.8}};
  lookAlong(scene, {0.4, -1, 0.3}, 120);
  scene.rayCast.stepVoxels = 0.06;
  Image exact = draw(scene);
  double before = 1e9;
  for (double step : {2.0, 1.0, 0.5, 0.25}) {
    scene.rayCast.stepVoxels = step;
    double error = differenceOf(draw(scene), exact).mean;
    EXPECT_LT(error, before * 0.9 + 0.02) << "step " << step;
    before = error;
  }
  EXPECT_LT(before, 0.5) << "mean difference of a quarter-voxel step";
}

TEST_F(ExactGL, TheMaximumOfAConstantIsTheConstant) {
  scene::Scene scene = fogScene(0.0, centredFrame({24, 40, 16}));
  scene.rayCast.mode = scene::RenderMode::Mip;
  scene.volume.windowLevel = 100;
  scene.volume.windowWidth = 160;  // 20 .. 180: 100 is the middle
  lookAlong(scene, {0.3, -1, 0.5});
  for (double value : {100.0}) {
    Image image = draw(scene, {64, 64}, kAllLayers);
    int inside = 0;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        glm::vec4 color = colorOf(image, {x, y});
        if (color.a == 0) continue;
        ++inside;
        EXPECT_NEAR(color.r * 255, (value - 20) / 160 * 255, 1.0);
        EXPECT_EQ(color.a, 1.0f);
      }
    EXPECT_GT(inside, 300);
  }
}

TEST_F(ExactGL, FineStepsEndFromAfarToo) {
  // Distances that are coarse beside a step.
  scene::Scene scene = sceneOf(makeVolume(
      {25, 60, 25}, SampleType::UInt16, [](glm::ivec3 p) { return p.y > 55 ? 4000.0 : 300 * hashNoise(p); },
      centredFrame({25, 60, 25}, {0.957, 0.957, 0.957})));
  scene.rayCast.stepVoxels = 0.25;
  for (auto mode : {scene::RenderMode::Mip, scene::RenderMode::Iso}) {
    scene.rayCast.mode = mode;
    scene.rayCast.isoValue = 2000;
    lookAlong(scene, {0.02, -1, 0.01}, 2000);
    scene.camera.fieldOfViewDeg = 0.5;  // 17 mm
    Image image = draw(scene, {32, 32});
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) EXPECT_GT(sampleOf(image, {x, y}, "R"), 0.3f) << enumName(mode) << x << ", " << y;
  }
}

TEST_F(ExactGL, TheMaximumIsThatOfTheBrightestVoxel) {
  // Dark noise with one bright voxel a ray can only miss by a step.
  Volume v = makeVolume(
      {25, 25, 25}, SampleType::UInt16,
      [](glm::ivec3 p) { return p == glm::ivec3(12, 5, 12) ? 4000.0 : 300 * hashNoise(p); },
      centredFrame({25, 25, 25}));
  scene::Scene scene = sceneOf(std::move(v));
  scene.rayCast.mode = scene::RenderMode::Mip;
  scene.rayCast.stepVoxels = 0.1;
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 25;
  Image image = draw(scene, {25, 25}, kAllLayers);
  // Steps of a tenth of a voxel meet its middle within 5 % of its height.
  EXPECT_GT(sampleOf(image, {12, 12}, "R"), 0.94f);
  EXPECT_NEAR(vectorOf(image, {12, 12}, "position").y, 5 - 12, 0.06);
  EXPECT_LT(sampleOf(image, {3, 3}, "R"), 0.09f);
}

TEST_F(ExactGL, TheIsosurfaceOfARampIsItsPlane) {
  for (auto type : {SampleType::Float32, SampleType::UInt16}) {
    glm::dmat4 frame = centredFrame({30, 40, 30}, {1, 0.5, 1});
    scene::Scene scene = sceneOf(makeVolume(
        {30, 40, 30}, type, [](glm::ivec3 p) { return 1000.0 * p.y; }, frame));
    scene.rayCast.mode = scene::RenderMode::Iso;
    for (double voxel : {7.0, 12.25, 20.5, 33.9}) {
      scene.rayCast.isoValue = 1000.0 * voxel;
      for (glm::dvec3 side : {glm::dvec3(0, -1, 0), glm::dvec3(0, 1, 0), glm::dvec3(0.3, -1, 0.2)}) {
        lookAlong(scene, side, 100);
        Image image = draw(scene, {48, 48}, kAllLayers);
        double plane = (voxel - 19.5) * 0.5;
        int hits = 0;
        for (int y = 0; y < 48; ++y)
          for (int x = 0; x < 48; ++x) {
            if (sampleOf(image, {x, y}, "A") == 0) continue;
            // Rays that enter through the box's side already behind the surface start at that side, not on the plane.
            glm::vec3 p = vectorOf(image, {x, y}, "position");
            EXPECT_NEAR(p.y, plane, 0.01 * 0.5) << "voxel " << voxel << " pixel " << x << ", " << y;
            EXPECT_GT(std::abs(vectorOf(image, {x, y}, "normal").y), 0.999f);
            ++hits;
          }
        EXPECT_GT(hits, 300);
      }
    }
  }
}

TEST_F(ExactGL, PositionAndDepthLieOnThePixelsRay) {
  for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective}) {
    scene::Scene scene = fogScene(0.5, centredFrame({24, 40, 16}, {1, 1, 1}, 0.4));
    scene.camera.projection = projection;
    scene.camera.height = 60;
    glm::ivec2 size(50, 40);
    Image image = draw(scene, size, kAllLayers);
    int hits = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (sampleOf(image, {x, y}, "A") == 0) {
          EXPECT_TRUE(std::isinf(sampleOf(image, {x, y}, "Z")));
          continue;
        }
        ++hits;
        TestRay ray = rayThrough(scene.camera, size, {x + 0.5, y + 0.5});
        glm::dvec3 p(vectorOf(image, {x, y}, "position"));
        EXPECT_LT(glm::length(glm::cross(p - ray.origin, ray.direction)), 1e-3) << "off its ray, mm";
        if (projection == scene::Projection::Perspective) {
          EXPECT_NEAR(sampleOf(image, {x, y}, "Z"), glm::length(p - scene.camera.eye), 2e-3);
        }
      }
    EXPECT_GT(hits, 200);
  }
}

TEST_F(ExactGL, PickSaysWhatTheLayersSay) {
  scene::Scene scene = sceneOf(makeVolume(
      {20, 20, 20}, SampleType::UInt8, [](glm::ivec3 p) { return 10.0 * p.y; }, centredFrame({20, 20, 20})));
  makeSolid(scene);
  scene.volume.transfer.opacities = {{95, 0}, {100, 0.999}};
  Image image = draw(scene, {40, 40}, kAllLayers);
  render::Pick pick = renderer().pick({20, 20});
  ASSERT_TRUE(pick.hit);
  EXPECT_LT(glm::length(glm::vec3(pick.world) - vectorOf(image, {20, 20}, "position")), 1e-4);
  double voxel = std::floor(pick.world.y + 9.5 + 0.5);  // the nearest
  EXPECT_NEAR(pick.value, 10.0 * voxel, 1e-9);
  EXPECT_NEAR(pick.value, 100.0, 10.01);
  EXPECT_FALSE(renderer().pick({0, 0}).hit);
  EXPECT_FALSE(renderer().pick({-1, 5}).hit);
  EXPECT_FALSE(renderer().pick({40, 40}).hit);
}

TEST_F(ExactGL, PickGivesTheValueOfTheNearestVoxelWhereverTheSurfaceLies) {
  scene::Scene scene = sceneOf(makeVolume(
      {20, 20, 20}, SampleType::UInt8, [](glm::ivec3 p) { return 10.0 * p.y; }, centredFrame({20, 20, 20})));
  makeSolid(scene);
  scene.rayCast.stepVoxels = 0.15;
  int below = 0, above = 0;
  for (double value = 90; value < 120; value += 1.5) {
    scene.volume.transfer.opacities = {{value, 0}, {value + 0.5, 0.9999}};
    draw(scene, {40, 40}, kAllLayers);
    render::Pick pick = renderer().pick({20, 20});
    ASSERT_TRUE(pick.hit);
    double place = pick.world.y + 9.5, nearest = std::round(place);
    if (std::abs(place - nearest) > 0.49) continue;  // as near to the one as to the other
    EXPECT_NEAR(pick.value, 10.0 * nearest, 1e-9) << place;
    ++(nearest > place ? above : below);
  }
  EXPECT_GT(below, 3);
  EXPECT_GT(above, 3);
}

}  // namespace
}  // namespace velum
