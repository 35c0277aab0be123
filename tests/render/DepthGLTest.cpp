// Surfaces and volumes hide each other by depth, and cuts take from both.
#include <cstdlib>

#include "RenderFixture.h"
#include "plateSurface.h"

namespace velum {
namespace {

constexpr glm::ivec3 kDepthDims(48, 48, 40);

class DepthGL : public RenderTest {
 protected:
  /// A ball in front on the left, one behind on the right, and a square between them. Seen from the front.
  static scene::Scene ballsAndSquare() {
    glm::dmat4 frame = centredFrame(kDepthDims);
    scene::Scene scene = sceneOf(makeVolume(
        kDepthDims, SampleType::UInt8,
        [&](glm::ivec3 p) {
          glm::dvec3 world(frame * glm::dvec4(p, 1.0));
          bool front = glm::length(world - glm::dvec3(-11, -13, 0)) < 7.5,
               back = glm::length(world - glm::dvec3(11, 13, 0)) < 7.5;
          return front || back ? 200.0 : 0.0;
        },
        frame));
    scene.volume.transfer.colors = {{0, {1, 0, 0}}};
    scene.volume.transfer.opacities = {{80, 0}, {120, 0.999}};
    scene.volume.transfer.unitDistance = 0.1;
    scene::Surface surface = plateSurface(21, 0);
    surface.color = {0, 1, 0};
    scene.surfaces = {surface};
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 48;
    lookAlong(scene, {0, -1, 0});
    return scene;
  }
  static constexpr glm::ivec2 kSize{96, 96};  // two pixels a millimetre
  static constexpr glm::ivec2 kFront{48 - 22, 48}, kBack{48 + 22, 48}, kSquareOnly{48, 80}, kNothing{2, 2};
  static constexpr double kField = 13.69;  ///< 48 mm at 200 mm, degrees
};

TEST_F(DepthGL, ASurfaceHidesWhatIsBehindAndNotWhatIsInFront) {
  for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective}) {
    scene::Scene scene = ballsAndSquare();
    scene.camera.projection = projection;
    scene.camera.fieldOfViewDeg = kField;
    Image image = draw(scene, kSize, kAllLayers);
    EXPECT_GT(colorOf(image, kFront).r, 0.9f) << "the front ball";
    EXPECT_NEAR(vectorOf(image, kFront, "position").y, -13 - 7.5, 0.8);
    EXPECT_GT(colorOf(image, kBack).g, 0.9f) << "the square hides the ball behind";
    EXPECT_LT(colorOf(image, kBack).r, 0.02f);
    EXPECT_NEAR(vectorOf(image, kBack, "position").y, 0, 2e-3);
    EXPECT_GT(colorOf(image, kSquareOnly).g, 0.9f);
    EXPECT_NEAR(vectorOf(image, kSquareOnly, "position").y, 0, 2e-3);
    EXPECT_GT(-vectorOf(image, kSquareOnly, "normal").y, 0.999f) << "the normal looks to the eye";
    EXPECT_LT(sampleOf(image, kFront, "Z"), sampleOf(image, kBack, "Z"));
    EXPECT_EQ(colorOf(image, kNothing).a, 0.0f);
    EXPECT_TRUE(std::isinf(sampleOf(image, kNothing, "Z")));
    render::Pick pick = renderer().pick(kBack);
    EXPECT_TRUE(pick.hit);
    EXPECT_NEAR(pick.world.y, 0, 2e-3);
    EXPECT_EQ(pick.structure, 0);
  }
}

TEST_F(DepthGL, EverySurfaceIsAnInstanceOfItsOwn) {
  scene::Scene scene = ballsAndSquare();
  scene::Surface hidden = scene.surfaces[0];
  hidden.visible = false;
  scene.surfaces.insert(scene.surfaces.begin(), hidden);
  Image image = draw(scene, kSize, kAllLayers);
  for (auto [pixel, instance] : {std::pair(kFront, 0u), {kBack, 2u}, {kSquareOnly, 2u}}) {
    EXPECT_EQ(sampleOf(image, pixel, "instance"), float(instance));
    EXPECT_EQ(renderer().pick(pixel).instance, instance);
  }
  EXPECT_EQ(sampleOf(image, kNothing, "instance"), -1.0f);
  EXPECT_FALSE(renderer().pick(kNothing).hit);
}

TEST_F(DepthGL, AHiddenSurfaceHidesNothing) {
  scene::Scene scene = ballsAndSquare();
  scene.surfaces[0].visible = false;
  Image image = draw(scene, kSize, kAllLayers);
  EXPECT_GT(colorOf(image, kBack).r, 0.9f);
  EXPECT_NEAR(vectorOf(image, kBack, "position").y, 13 - 7.5, 0.8);
  EXPECT_EQ(colorOf(image, kSquareOnly).a, 0.0f);
}

TEST_F(DepthGL, AVeilInFrontOfASurfaceBlendsWithIt) {
  scene::Scene scene = ballsAndSquare();
  scene.volume.transfer.opacities = {{0, 0.02}, {255, 0.02}};
  scene.volume.transfer.unitDistance = 1.0;
  Image image = draw(scene, kSize, kAllLayers);
  // 24 mm of veil lie before the square.
  double veil = 1.0 - std::pow(0.98, 24.0);
  EXPECT_NEAR(colorOf(image, kSquareOnly).r, veil, 2.0 / 255);
  EXPECT_NEAR(colorOf(image, kSquareOnly).g, 1.0 - veil, 2.0 / 255);
  EXPECT_EQ(colorOf(image, kSquareOnly).a, 1.0f);
  EXPECT_NEAR(vectorOf(image, kSquareOnly, "position").y, 0, 2e-3) << "the square is what makes the ray half opaque";
}

TEST_F(DepthGL, TheMaximumBehindASurfaceDoesNotShow) {
  scene::Scene scene = ballsAndSquare();
  scene.rayCast.mode = scene::RenderMode::Mip;
  Image image = draw(scene, kSize, kAllLayers);
  EXPECT_GT(colorOf(image, kBack).g, 0.9f);
  EXPECT_LT(colorOf(image, kBack).r, 0.1f);
  EXPECT_NEAR(colorOf(image, kFront).r, 1.0f, 0.02f);
  scene.rayCast.mode = scene::RenderMode::Iso;
  scene.rayCast.isoValue = 100;
  image = draw(scene, kSize, kAllLayers);
  EXPECT_GT(colorOf(image, kBack).g, 0.9f);
  EXPECT_LT(vectorOf(image, kFront, "position").y, -19.0f);
}

TEST_F(DepthGL, CutsClipSurfacesToo) {
  scene::Scene scene = ballsAndSquare();
  scene::Cut cut;
  cut.axis = {1, 0, 0};  // removes x > 0
  for (bool invert : {false, true}) {
    cut.invert = invert;
    scene.cuts = {cut};
    Image image = draw(scene, kSize, kAllLayers);
    for (int x = 8; x < 88; ++x) {
      if (x >= 47 && x <= 48) continue;  // the pixels at the cut
      bool removed = (x >= 48) != invert;
      EXPECT_EQ(colorOf(image, {x, 80}).a, removed ? 0.0f : 1.0f) << "column " << x << (invert ? " inverted" : "");
    }
    EXPECT_EQ(colorOf(image, kFront).a > 0, !invert);
  }
}

TEST_F(DepthGL, AnotherMeshInItsPlaceIsDrawn) {
  scene::Scene scene = ballsAndSquare();
  draw(scene, kSize);
  scene.surfaces[0].data = plateSurface(21, -22).data;
  Image image = draw(scene, kSize, kAllLayers);
  EXPECT_NEAR(vectorOf(image, kFront, "position").y, -22, 2e-3);
}

TEST_F(DepthGL, ASurfaceAloneIsSeen) {
  scene::Scene scene = ballsAndSquare();
  scene.volume.data = {};
  for (bool shaded : {false, true}) {
    scene.lighting.shaded = shaded;
    Image image = draw(scene, kSize, kAllLayers);
    EXPECT_EQ(colorOf(image, kFront).a, 1.0f);
    EXPECT_GT(colorOf(image, kFront).g, 0.2f);
    EXPECT_NEAR(vectorOf(image, kFront, "position").y, 0, 2e-3);
  }
}

TEST_F(DepthGL, OutlinesOfCutsAreDrawnBeyondTheVolumesBox) {
  scene::Scene scene = ballsAndSquare();
  scene.surfaces.clear();
  scene.camera.height = 120;
  scene::Cut ball;
  ball.shape = scene::CutShape::Sphere;
  ball.size = glm::dvec3(100);
  scene::addCut(scene, ball);
  scene.showBounds = true;
  Image image = draw(scene, kSize);
  float brightest = 0;
  for (int x = 0; x < 16; ++x) brightest = std::max(brightest, colorOf(image, {x, 48}).a);
  EXPECT_GT(brightest, 0.5f) << "40 of 48 pixels from the middle, where the box ends at 19";
}

TEST_F(DepthGL, AMeshOutsideTheVolumesBoxIsDrawn) {
  scene::Scene scene = ballsAndSquare();
  for (float y : {-60.0f, 60.0f}) {
    scene.surfaces[0].data = plateSurface(21, y).data;
    for (auto projection : {scene::Projection::Orthographic, scene::Projection::Perspective}) {
      scene.camera.projection = projection;
      scene.camera.fieldOfViewDeg = kField;
      Image image = draw(scene, kSize, kAllLayers);
      EXPECT_GT(colorOf(image, {48, 70}).g, 0.9f) << "at depth " << y;
    }
  }
}

TEST_F(DepthGL, ASurfaceMayBeLongerThanTheBlocksOfADriver) {
  // The square once more, in 128 x 128 parts: as a storage block it would have three megabytes.
  constexpr int kParts = 128;
  Mesh fine;
  for (int z = 0; z <= kParts; ++z)
    for (int x = 0; x <= kParts; ++x)
      fine.positions.emplace_back(42.0f * float(x) / kParts - 21.0f, 0.0f, 42.0f * float(z) / kParts - 21.0f);
  auto at = [](int x, int z) { return std::uint32_t(z * (kParts + 1) + x); };
  for (int z = 0; z < kParts; ++z)
    for (int x = 0; x < kParts; ++x)
      for (std::uint32_t index : {at(x, z), at(x + 1, z), at(x + 1, z + 1), at(x, z), at(x + 1, z + 1), at(x, z + 1)})
        fine.indices.push_back(index);
  scene::Scene scene = ballsAndSquare();
  Image coarse = draw(scene, kSize);
  scene.surfaces[0].data = Shared<Mesh>(std::move(fine));
  ::setenv("VELUM_MAX_STORAGE_BLOCK", "65536", 1);
  auto small = gpu::Context::create(gpu::ContextKind::Auto);
  ::unsetenv("VELUM_MAX_STORAGE_BLOCK");
  {
    render::Renderer other(*small);
    expectSame(drawWith(other, scene, kSize), coarse, 1.0);
  }
}

}  // namespace
}  // namespace velum
