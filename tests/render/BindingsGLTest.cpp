// Each step of a frame finds what it reads, whatever another has left bound: shaders/shared/bindings.h.
#include "MembranesFixture.h"
#include "gpu/Buffer.h"
#include "gpu/Texture.h"
#include "makeModel.h"

namespace velum {
namespace {

/// What any other user of the context may leave bound: something else in every place that OpenGL promises.
struct Poison {
  gpu::Texture flat = gpu::Texture::make2d("poison", gpu::Format::Rgba32f, {2, 2});
  gpu::Texture deep = gpu::Texture::make3d("poison", gpu::Format::Rgba32f, {2, 2, 2});
  gpu::Buffer words{"poison", 16384};
  gpu::Texture line = gpu::Texture::makeOfBuffer("poison", gpu::Format::Rgba32f, words);

  void bind() {
    flat.clear();
    deep.clear();
    words.fill(0x3f000000u);  // a half, or much
    for (unsigned unit = 0; unit < 96; ++unit)
      for (const gpu::Texture* texture : {&flat, &deep, &line}) texture->bindSampler(unit);
    for (unsigned place = 0; place < 8; ++place) {
      words.bindStorage(place);
      words.bindUniform(place);
      flat.bindImage(place, gpu::Access::ReadWrite);
    }
  }
};

class BindingsGL : public MembranesGL {
 protected:
  /// All kinds of passes have something to do, and all kinds of cuts.
  static scene::Scene fullScene() {
    scene::Scene scene = softScene();
    scene.unit = LengthUnit::Angstrom;
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kDims, [](glm::ivec3 p) { return p.x > 20   ? 2
                                         : p.z > 20 ? 3
                                                    : 0; }, scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    ModelMaker maker;
    maker.instances = 150;
    maker.moleculeRadius = 3.0f;
    maker.halfEdge = 24.0f;
    scene.model.data = Shared<Model>(maker.make());
    scene.rayCast.samplesPerPixel = 2;
    scene.background.transparent = false;
    scene.finish.contours = 1.0;
    scene.finish.hatching = 0.5;
    scene.finish.paper = scene::Paper::Laid;
    scene.cuts = {membraneOf(wavySheet(kParticles, kFrame))};
    // So many that a grid says which of them matter where.
    for (int i = 0; i < 12; ++i) {
      scene::Cut ball;
      ball.shape = scene::CutShape::Sphere;
      ball.centre = {6.0 * (i % 4) - 9.0, -12.0, 9.0 * (i / 4) - 9.0};
      ball.size = glm::dvec3(7.0);
      ball.spares = {{3}};
      scene::addCut(scene, ball);
    }
    scene.showBounds = true;
    return scene;
  }
  static scene::Scene focusScene() {
    scene::Scene scene = fullScene();
    scene.model.ghosts = scene::Ghosts::Filled;
    scene::Cut cut;
    cut.shape = scene::CutShape::Box;
    cut.centre = {20, 0, 0};
    cut.size = glm::dvec3(40.0);
    cut.model.spares = {{}};
    cut.model.spares[0].type = "root";
    cut.model.focus.emplace().types = {{"root.a.type0"}};
    cut.model.spares[0].aperture = 0.5;
    scene::addCut(scene, cut);
    return scene;
  }
  /// A frame whose steps are all handed over in one go, and one before each of whose steps others have been at work.
  void expectStepsStandAlone(const scene::Scene& scene, const std::string& what) {
    render::Layers layers = kAllLayers;
    layers.ghosts = layers.type = true;
    render::Frame frame = frameOf(scene, kSize);
    frame.countsInstances = true;
    render::Renderer inOne(context()), apart(context());
    while (!inOne.work(frame, 1e9)) {
    }
    Image whole = inOne.read(layers);
    Poison poison;
    int steps = 1;
    for (poison.bind(); !apart.work(frame, 0.0); ++steps) {
      ASSERT_LT(steps, 100000) << what;
      poison.bind();
    }
    poison.bind();
    EXPECT_GT(steps, 40) << what;
    expectIdentical(apart.read(layers), whole, what);
    auto ofOne = inOne.bits(true), ofApart = apart.bits(true);
    ASSERT_TRUE(ofOne && ofApart) << what;
    EXPECT_EQ(ofOne->removed, ofApart->removed) << what;
    EXPECT_EQ(ofOne->shown, ofApart->shown) << what;
  }
};

TEST_F(BindingsGL, NoStepDependsOnWhatAnotherLeftBound) { expectStepsStandAlone(fullScene(), "all kinds"); }

TEST_F(BindingsGL, NoStepOfAFocusOrOfGhostsDoesEither) { expectStepsStandAlone(focusScene(), "focus, ghosts"); }

TEST_F(BindingsGL, NoStepOfAMaximumDoesEither) {
  scene::Scene scene = fullScene();
  scene.rayCast.mode = scene::RenderMode::Mip;
  expectStepsStandAlone(scene, "mip");
}

}  // namespace
}  // namespace velum
