// The same frame gives the same bytes, however it is drawn.
#include <bit>
#include <cstdint>
#include <thread>

#include "RenderFixture.h"
#include "gpu/GpuError.h"
#include "makeModel.h"
#include "render/RenderPicture.h"

namespace velum {
namespace {

constexpr glm::ivec3 kRepeatDims(36, 40, 33);

class RepeatGL : public RenderTest {
 protected:
  /// A scene that uses all that can differ: light, jitter, several samples, labels, a cut, a mesh, a background.
  static scene::Scene richScene() {
    scene::Scene scene = sceneOf(makeVolume(
        kRepeatDims, SampleType::Int16,
        [](glm::ivec3 p) {
          double r = glm::length(glm::dvec3(p) - glm::dvec3(18, 20, 16));
          return 900.0 - 60 * r + 150 * hashNoise(p);
        },
        centredFrame(kRepeatDims)));
    scene.lighting.shaded = true;
    scene.rayCast.jitter = true;
    scene.rayCast.samplesPerPixel = 3;
    scene.background.transparent = false;
    scene.volume.transfer.colors = {{0, {0.5f, 0.2f, 0.1f}}, {900, {1, 0.9f, 0.8f}}};
    scene.volume.transfer.opacities = {{150, 0}, {300, 0.2}, {700, 0.9}};
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kRepeatDims, [](glm::ivec3 p) { return p.x > 20   ? 2
                                               : p.z > 20 ? 3
                                                          : 0; }, scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    scene::Cut cut;
    cut.axis = {0.3, -1, 0.4};
    cut.centre = {0, -6, 0};
    cut.spares = {{3}};
    scene.cuts = {cut};
    scene::Surface surface;
    Mesh mesh;
    mesh.positions = {{-15, 2, -15}, {15, 2, -15}, {0, 5, 15}};
    mesh.indices = {0, 1, 2};
    surface.data = Shared<Mesh>(std::move(mesh));
    scene.surfaces = {surface};
    lookAlong(scene, {0.3, -1, 0.25}, 90);
    scene.showBounds = true;
    return scene;
  }
};

TEST_F(RepeatGL, TheSameFrameGivesTheSameBytes) {
  scene::Scene scene = richScene(), other = scene;
  lookAlong(other, {1, 0.2, 0}, 90);
  other.rayCast.mode = scene::RenderMode::Mip;
  Image first = draw(scene, {90, 70}, kAllLayers);
  expectIdentical(draw(scene, {90, 70}, kAllLayers), first, "again");
  draw(other, {33, 44});
  expectIdentical(draw(scene, {90, 70}, kAllLayers), first, "after another frame");
  renderer().clear();
  expectIdentical(draw(scene, {90, 70}, kAllLayers), first, "after clear()");
  render::Renderer fresh(context());
  expectIdentical(drawWith(fresh, scene, {90, 70}, kAllLayers), first, "of another renderer");
}

TEST_F(RepeatGL, SmallPiecesOfWorkGiveTheSameBytes) {
  scene::Scene scene = richScene();
  Image whole = draw(scene, {90, 70}, kAllLayers);
  render::Renderer pieces(context());
  render::Frame frame = frameOf(scene, {90, 70});
  double before = 0;
  int calls = 1;
  for (; !pieces.work(frame, 0.0); ++calls) {
    ASSERT_LT(calls, 100000);
    before = pieces.fractionDone();
    EXPECT_GE(before, 0.0);
    EXPECT_LE(before, 1.0);
    if (calls % 7 == 0) pieces.read();  // a look at the unfinished picture changes nothing
  }
  EXPECT_GT(calls, 8);
  EXPECT_EQ(pieces.fractionDone(), 1.0);
  expectIdentical(pieces.read(kAllLayers), whole, "in pieces");
  EXPECT_EQ(pieces.stats().samples, 3);
}

TEST_F(RepeatGL, APictureInWorkIsTheMeanOfWhatItHas) {
  scene::Scene scene = richScene();
  scene.showBounds = false;
  Image whole = draw(scene, {150, 130});
  render::Renderer pieces(context());
  render::Frame frame = frameOf(scene, {150, 130});
  int looks = 0;
  while (!pieces.work(frame, 0.0)) {
    if (pieces.stats().samples < 1) continue;
    ++looks;
    // One sample and three differ at edges, here and there; a tile that is divided by too few is bright all over.
    Image now = pieces.read();
    double difference = 0;
    for (std::size_t i = 0; i < now.pixels.size(); ++i) difference += std::abs(now.pixels[i] - whole.pixels[i]);
    EXPECT_LT(difference / double(now.pixels.size()), 0.01) << "look " << looks;
  }
  // How many depends on the driver's pace.
  EXPECT_GT(looks, 2);
}

TEST_F(RepeatGL, WindowsTogetherAreTheWholePicture) {
  for (int mode = 0; mode < 3; ++mode)
    for (bool withSurface : {false, true}) {
      scene::Scene scene = richScene();
      scene.rayCast.mode = scene::RenderMode(mode);
      scene.rayCast.isoValue = 400;
      scene.rayCast.samplesPerPixel = 2;
      scene.lighting.shadow = scene.lighting.occlusion = 0;
      scene.background.transparent = mode == 1;
      // The outlines are drawn lines, whose pixels a driver may choose by the window.
      scene.showBounds = false;
      if (!withSurface) scene.surfaces.clear();
      render::Frame frame = frameOf(scene, {101, 75});
      Progress progress;
      Image whole = render::renderPicture(renderer(), frame, {}, 4096, progress);
      Image parts = render::renderPicture(renderer(), frame, {}, 37, progress);
      ASSERT_EQ(parts.width, 101);
      ASSERT_EQ(parts.height, 75);
      // Triangles are set up in window coordinates: their depth may differ in its last bits.
      if (withSurface)
        expectSame(parts, whole, 1.0, "mode " + std::to_string(mode));
      else
        expectIdentical(parts, whole, "mode " + std::to_string(mode));
    }
}

TEST_F(RepeatGL, WindowsTogetherAreTheWholeInEveryLayer) {
  scene::Scene scene = richScene();
  scene.showBounds = false;
  scene.surfaces.clear();
  render::Frame frame = frameOf(scene, {61, 50});
  Progress progress;
  Image whole = render::renderPicture(renderer(), frame, kAllLayers, 4096, progress);
  Image parts = render::renderPicture(renderer(), frame, kAllLayers, 23, progress);
  expectIdentical(parts, whole, "in windows");
}

/// How open a molecule lies is looked for around it, across the windows' edges.
TEST_F(RepeatGL, WindowsOfAModelTogetherAreTheWhole) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker().make());
  scene.rayCast.samplesPerPixel = 2;
  scene.lighting.occlusion = scene.lighting.shadow = 0.8;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.25);
  render::Frame frame = frameOf(scene, {181, 140});
  Progress progress;
  Image whole = render::renderPicture(renderer(), frame, {}, 4096, progress);
  for (int window : {61, 90})
    expectIdentical(render::renderPicture(renderer(), frame, {}, window, progress), whole, "in windows");
}

TEST_F(RepeatGL, EglAndOsMesaDrawTheSame) {
  scene::Scene scene = richScene();
  scene.showBounds = false;
  std::string whyNot;
  // Threads of their own: neither knows of the context of another that is current here.
  auto drawnBy = [&](gpu::ContextKind kind) {
    std::optional<Image> image;
    std::thread([&] {
      try {
        auto own = gpu::Context::create(kind);
        render::Renderer other(*own);
        image = drawWith(other, scene, {80, 80});
      } catch (const gpu::GpuError& error) {
        whyNot = error.what();
      }
    }).join();
    return image;
  };
  std::optional<Image> egl = drawnBy(gpu::ContextKind::Egl), osMesa = drawnBy(gpu::ContextKind::OsMesa);
  if (!egl || !osMesa) GTEST_SKIP() << whyNot;
  expectSame(*osMesa, *egl, 2.0, "EGL and OSMesa");
}

TEST_F(RepeatGL, NoLayerHoldsANumberThatIsNone) {
  scene::Scene scene = richScene();
  for (bool bounds : {false, true}) {
    scene.showBounds = bounds;
    Image image = draw(scene, {90, 70}, kAllLayers);
    int bad = 0;
    for (std::size_t i = 0; i < image.pixels.size() && bad < 3; ++i) {
      bool isDepth = image.channels[i % image.channels.size()] == "Z";
      bool isFine = std::isfinite(image.pixels[i]) || (isDepth && image.pixels[i] > 0);
      EXPECT_TRUE(isFine) << image.channels[i % image.channels.size()] << " of pixel " << i / image.channels.size()
                          << (bounds ? " with outlines" : "");
      bad += !isFine;
    }
  }
}

TEST_F(RepeatGL, MoreSamplesAverageToAboutTheSame) {
  scene::Scene scene = richScene();
  scene.rayCast.samplesPerPixel = 1;
  Image one = draw(scene);
  scene.rayCast.samplesPerPixel = 8;
  Image eight = draw(scene);
  EXPECT_LT(differenceOf(one, eight).mean, 5.0);
  EXPECT_EQ(renderer().stats().samples, 8);
}

TEST_F(RepeatGL, AnEmptySceneIsItsBackground) {
  scene::Scene scene;
  scene.background.top = {1, 0, 0};
  scene.background.bottom = {0, 0, 1};
  scene.rayCast.samplesPerPixel = 1;
  Image image = draw(scene, {16, 64});
  EXPECT_NEAR(sampleOf(image, {8, 0}, "R"), 1.0f, 0.02f);
  EXPECT_NEAR(sampleOf(image, {8, 63}, "B"), 1.0f, 0.02f);
  scene.background.transparent = true;
  EXPECT_EQ(coverageOf(draw(scene)), 0.0);
}

TEST_F(RepeatGL, StrangeFramesDrawSomethingOrNothingButDoNotFail) {
  scene::Scene scene = richScene();
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  scene.rayCast.samplesPerPixel = 1;
  EXPECT_EQ(draw(scene, {1, 1}).pixels.size(), 4u);
  EXPECT_EQ(draw(scene, {300, 1}).width, 300);
  scene.camera.eye = scene.camera.target;
  scene.camera.up = {0, 0, 0};
  EXPECT_NO_THROW(draw(scene));
  scene.camera.fieldOfViewDeg = 150;
  scene.cuts[0].axis = {0, 0, 0};
  scene.cuts[0].size = {0, 0, 0};
  for (int shape = 0; shape < 5; ++shape) {
    scene.cuts[0].shape = scene::CutShape(shape);
    EXPECT_NO_THROW(draw(scene));
  }
  scene.volume.timeStep = 1000000;
  scene.volume.channel = 1000000;
  EXPECT_NO_THROW(draw(scene));
  scene.volume.transfer = {};
  EXPECT_NO_THROW(draw(scene));
}

}  // namespace
}  // namespace velum
