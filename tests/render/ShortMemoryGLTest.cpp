// A card without memory: at each place where it is asked for, there is a picture or a line of words, and afterwards all
// is as if nothing had been.
#include "FinishFixture.h"
#include "FocusFixture.h"
#include "MembranesFixture.h"
#include "StreamedFixture.h"
#include "gpu/Gl.h"
#include "shortMemory.h"

namespace velum {
namespace {

using Which = gpu::AllocationFault::Which;

constexpr glm::ivec2 kShortSize{24, 20};

class ShortMemoryGL : public StreamedGL {
 protected:
  /// Everything that a volume in memory may have: labels, a cut that spares, a membrane, a surface, light, finish.
  static scene::Scene volumeScene() {
    constexpr glm::ivec3 kDims(12, 10, 11);  // little to light
    scene::Scene scene = sceneOf(makeVolume(
        kDims, SampleType::Int16, [](glm::ivec3 p) { return 900 - 140 * glm::length(glm::dvec3(p) - 5.0); },
        centredFrame(kDims, glm::dvec3(2.0))));
    scene.volume.transfer.opacities = {{150, 0}, {300, 0.2}, {700, 0.9}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0.7;
    scene.labels.data = Shared<LabelVolume>(makeLabels(
        kDims, [](glm::ivec3 p) { return p.x > 7   ? 2
                                         : p.z > 5 ? 3
                                                   : 0; }, scene.volume.data->worldFromVoxel));
    scene::completeStructures(scene.labels);
    scene::Cut sphere;
    sphere.shape = scene::CutShape::Sphere;
    sphere.centre = {-6, -4, -3};
    sphere.size = {12, 12, 12};
    sphere.spares = {{3}};
    scene::addCut(scene, sphere);
    scene::Cut membrane = membraneOf(domeSheet({9, 9}, {20, 18, 8}), {0, -1, 0}, {20, 18, 8});
    membrane.id = 0;
    scene::addCut(scene, membrane);
    Mesh mesh;
    mesh.positions = {{-9, 3, -8}, {9, 3, -8}, {0, 4, 9}};
    mesh.indices = {0, 1, 2};
    scene::Surface surface;
    surface.data = Shared<Mesh>(std::move(mesh));
    scene.surfaces = {surface};
    scene.finish.contours = scene.finish.litSphere = scene.finish.hatching = 0.6;
    scene.finish.contourWidth = 40;
    scene.finish.paper = scene::Paper::Own;
    scene.finish.ownPaper.data = Shared<Image>(Image{2, 2, {"R", "G", "B"}, std::vector<float>(12, 0.8f)});
    scene.rayCast.samplesPerPixel = 2;
    lookAlong(scene, {0.3, -1, 0.25}, 60);
    return scene;
  }
  static scene::Scene streamedScene() {
    auto source = makeSource(SampleType::UInt8);
    scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
    scene.labels.data = Shared<LabelVolume>(makeLabels(kStreamedDims, [](glm::ivec3 p) {
      return glm::length(glm::dvec3(p) - glm::dvec3(30, 40, 30)) < 21.0 ? 1 : p.x > 66 ? 3 : 0;
    }));
    scene::completeStructures(scene.labels);
    return scene;
  }
  /// What cuts leave of a model, by numbers and in view, with ghosts, light and lines.
  static scene::Scene modelScene() {
    ModelMaker maker;
    maker.instances = 120;
    maker.halfEdge = 90.0f;
    scene::Scene scene;
    scene.unit = LengthUnit::Angstrom;
    scene.model.data = Shared<Model>(maker.make());
    scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 1.25);
    scene.rayCast.samplesPerPixel = 2;
    scene.lighting.shadow = scene.lighting.occlusion = 0.5;
    scene.model.ghosts = scene::Ghosts::Filled;
    scene::Cut cut;
    cut.shape = scene::CutShape::Everywhere;
    cut.model.spares = {{}};
    cut.model.spares[0].type = "root";
    cut.model.spares[0].share = 0.5;
    cut.model.focus.emplace().types = {{"root.a.type0"}};
    scene::addCut(scene, cut);
    scene.finish.contours = 0.5;
    scene.finish.paper = scene::Paper::Rough;
    return scene;
  }
  /// Structures alone, one of them pulled out of a plane.
  static scene::Scene labelScene() {
    constexpr glm::ivec3 kDims(24, 20, 22);
    scene::Scene scene = sceneOf(makeVolume(kDims, SampleType::UInt8, [](glm::ivec3) { return 100.0; }));
    scene.labels.data = Shared<LabelVolume>(makeLabels(kDims, [](glm::ivec3 p) { return (p.x / 8 + p.z / 8) % 3; }));
    scene::completeStructures(scene.labels);
    scene.volume.data = {};
    scene::Cut plane;
    plane.centre = {12, 8, 11};
    plane.axis = {0, -1, 0};
    plane.spares = {{1, 4.0}};
    scene::addCut(scene, plane);
    return scene;
  }
  static render::Frame frameOf(const scene::Scene& scene) {
    render::Frame frame;
    frame.scene = scene;
    frame.pictureSize = kShortSize;
    frame.countsInstances = bool(scene.model.data);
    frame.saysFaces = true;
    return frame;
  }
  Image drawn(const render::Frame& frame, int window = 4096) {
    Progress progress;
    render::Layers layers = kAllLayers;
    layers.type = layers.ghosts = bool(frame.scene.model.data);
    return render::renderPicture(mRenderer, frame, layers, window, progress);
  }
  /// Nothing is on the GPU then but programs, which take long to compile.
  void makeCold() {
    render::Frame other;
    other.pictureSize = kShortSize + ++mColdCount % 2;
    EXPECT_NE(refusalOf(Which::NthOn, 1, [&] { drawn(other); }), "");
  }
  /// At each place, of a renderer that has nothing yet: words or a picture; afterwards the right picture.
  void expectWordsOrPicture(const render::Frame& frame, int window = 4096) {
    Image whole = drawn(frame, window);
    makeCold();
    std::vector<std::string> asked;
    {
      gpu::AllocationFault count;
      drawn(frame, window);
      asked = count.asked();
    }
    for (std::size_t n : firstOfEach(asked)) {
      std::string what = "allocation " + std::to_string(n) + " (" + asked[n - 1] + ")";
      makeCold();
      EXPECT_NE(refusalOf(Which::NthOn, n, [&] { drawn(frame, window); }), "") << what << " and all after it";
      Image image;
      std::string words = refusalOf(Which::NthLate, n, [&] { image = drawn(frame, window); });
      if (words.empty() && mRenderer.stats().reduction.empty()) expectSame(image, whole, 2.0, what);
      // In parts all of it is as coarse as the last part.
      bool isInParts = window < kShortSize.x;
      if (words.empty() && isInParts) expectIdentical(image, drawn(frame, window), what + ", as it stays");
      makeCold();
      expectIdentical(drawn(frame, window), whole, "after " + what);
    }
    RecordProperty("allocations", int(asked.size()));
  }
  /// At each place, of a renderer that holds another picture: that goes, and there is room.
  void expectOthersPlace(const render::Frame& before, const render::Frame& after) {
    makeCold();
    Image whole = drawn(after);
    makeCold();
    drawn(before);
    std::vector<std::string> asked;
    {
      gpu::AllocationFault count;
      drawn(after);
      asked = count.asked();
    }
    for (std::size_t n : firstOfEach(asked)) {
      std::string what = "allocation " + std::to_string(n) + " (" + asked[n - 1] + ") of another picture";
      drawn(before);
      Image image;
      std::string words = refusalOf(Which::Nth, n, [&] { image = drawn(after); });
      // What is read back is no work of a frame, which stands.
      if (words.empty())
        expectIdentical(image, whole, what);
      else
        EXPECT_NE(words.find("for picture ("), std::string::npos) << what << ": " << words;
      expectIdentical(drawn(after), whole, "after " + what);
    }
  }

  render::Renderer mRenderer{context()};

 private:
  int mColdCount = 0;
};

TEST_F(ShortMemoryGL, ARendererThatHasDrawnNothingTakesNone) {
  gpu::AllocationFault count;
  render::Renderer fresh(context());
  EXPECT_EQ(count.asked(), std::vector<std::string>());
}

TEST_F(ShortMemoryGL, AVolumeWithAllThatItMayHave) { expectWordsOrPicture(frameOf(volumeScene())); }
TEST_F(ShortMemoryGL, AVolumeThatIsStreamed) { expectWordsOrPicture(frameOf(streamedScene())); }
TEST_F(ShortMemoryGL, AModelWithAllThatItMayHave) { expectWordsOrPicture(frameOf(modelScene())); }
TEST_F(ShortMemoryGL, StructuresAlone) { expectWordsOrPicture(frameOf(labelScene())); }

TEST_F(ShortMemoryGL, APictureInParts) {
  scene::Scene scene = volumeScene();
  scene.finish = {};
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  scene.surfaces.clear();
  expectWordsOrPicture(frameOf(scene), 14);
}

TEST_F(ShortMemoryGL, APreview) {
  render::Frame frame = frameOf(volumeScene());
  frame.isPreview = true;
  frame.scene.finish = {};
  expectWordsOrPicture(frame);
}

TEST_F(ShortMemoryGL, AnotherPictureGoesFirst) {
  render::Frame volume = frameOf(volumeScene()), larger = volume, model = frameOf(modelScene());
  larger.pictureSize += 9;
  larger.scene.cuts.pop_back();
  larger.scene.labels.structures[0].visible = false;
  expectOthersPlace(volume, larger);
  expectOthersPlace(model, frameOf(labelScene()));
}

/// All that is too large is refused, as by a small card.
TEST_F(ShortMemoryGL, AVolumeGetsCoarserUntilItHasRoom) {
  constexpr glm::ivec3 kDims(96, 96, 96);  // 3.4 MiB as floats, and as much for gradients
  scene::Scene scene = sceneOf(makeVolume(
      kDims, SampleType::Float32, [](glm::ivec3 p) { return 50 + 50 * std::sin(p.x * 0.1) * std::sin(p.y * 0.1); },
      centredFrame(kDims)));
  scene.volume.transfer.opacities = {{60, 0}, {90, 0.5}};
  Image whole = drawWith(mRenderer, scene, kShortSize);
  EXPECT_EQ(mRenderer.stats().reduction, "");
  mRenderer.clear();
  for (std::size_t most : {1u << 20, 1u << 18}) {
    gpu::AllocationFault small(Which::Larger, most);
    Image image = drawWith(mRenderer, scene, kShortSize);
    EXPECT_NE(mRenderer.stats().reduction.find("of its resolution"), std::string::npos) << mRenderer.stats().reduction;
    EXPECT_NEAR(coverageOf(image), coverageOf(whole), 0.1);
  }
  // As long as it is this volume, it stays so: nothing is uploaded again for each picture.
  drawWith(mRenderer, scene, kShortSize + 1);
  EXPECT_NE(mRenderer.stats().reduction, "");
  scene::Scene other = scene;
  other.volume.data = Shared<Volume>(Volume(*scene.volume.data));
  expectIdentical(drawWith(mRenderer, other, kShortSize), whole, "another volume is tried whole");
  EXPECT_EQ(mRenderer.stats().reduction, "");
}

TEST_F(ShortMemoryGL, BricksGetFewerUntilTheyHaveRoom) {
  // Room for all of them takes 59 MiB twice.
  auto source = std::make_shared<PyramidSource>(
      makeVolume({256, 256, 128}, SampleType::UInt8, [](glm::ivec3 p) { return (p.x + p.y + 2 * p.z) % 256; }), 3,
      glm::ivec3(32));
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  scene.camera.height = 300;
  Image whole = drawWith(mRenderer, scene, kShortSize);
  double before = mRenderer.stats().streaming.budgetBytes;
  mRenderer.clear();
  gpu::AllocationFault small(Which::Larger, 40u << 20);
  Image image = drawWith(mRenderer, scene, kShortSize);
  EXPECT_GE(small.failed().size(), 1u);
  EXPECT_LT(mRenderer.stats().streaming.budgetBytes, before);
  expectSame(image, whole, 1.0, "few bricks are seen");
}

/// A small buffer's refusal comes late: the frame is not taken for a picture.
TEST_F(ShortMemoryGL, WhatIsHeardLateIsHeard) {
  scene::Scene scene = labelScene();
  Image whole = drawWith(mRenderer, scene, kShortSize);
  render::Frame frame = frameOf(scene);
  frame.pictureSize += 3;
  auto exhaust = [] {
    gpu::MayRefuse mayRefuse;
    GLuint id = 0;
    gpu::gl().CreateBuffers(1, &id);
    gpu::gl().NamedBufferStorage(id, GLsizeiptr(1) << 60, nullptr, 0);
    gpu::gl().DeleteBuffers(1, &id);
  };
  makeCold();
  std::string words;
  try {
    while (!mRenderer.work(frame, 0.0))
      if (mRenderer.fractionDone() > 0.3) exhaust();
  } catch (const gpu::NoMemory& refusal) {
    words = refusal.what();
  }
  EXPECT_NE(words.find("has run out of memory"), std::string::npos) << words;
  expectIdentical(drawWith(mRenderer, scene, kShortSize), whole, "afterwards");
}

}  // namespace
}  // namespace velum
