// A volume that is streamed looks as it does in memory.
#include <fmt/format.h>

#include <atomic>
#include <glm/gtc/matrix_transform.hpp>

#include "StreamedFixture.h"
#include "render/upload/BlockGradients.h"
#include "render/upload/GradientPlanes.h"
#include "render/upload/GradientTexels.h"

namespace velum {
namespace {

TEST_F(StreamedGL, ThePictureIsThatOfTheLevelInMemory) {
  for (auto type : {SampleType::UInt8, SampleType::Int16, SampleType::Float32}) {
    auto source = makeSource(type);
    for (auto mode : {scene::RenderMode::Volume, scene::RenderMode::Mip, scene::RenderMode::Iso}) {
      if (type != SampleType::UInt8 && mode != scene::RenderMode::Volume) continue;  // programs take long to compile
      scene::Scene scene = lookOf(streamedVolume(source, 2), mode);
      auto words = fmt::format("{} {}", enumName(type), enumName(mode));
      expectSameAs(source->level(0), scene, {160, 160}, words + ", finest level");
      expectSameAs(source->level(1), scene, {66, 66}, words + ", middle level");
      expectSameAs(source->level(2), scene, {30, 30}, words + ", coarse level");
    }
  }
}

TEST_F(StreamedGL, CutsAndPlacesAreThoseInMemory) {
  glm::dmat4 turned = glm::dmat4(1.0);
  turned[0] = {0.8, 0.3, 0.1, 0}, turned[1] = {-0.3, 1.1, 0.2, 0}, turned[2] = {0.1, -0.2, 1.4, 0},
  turned[3] = {50, 20, -9, 1};
  for (const glm::dmat4& place : {glm::dmat4(1.0), turned}) {
    auto source = makeSource(SampleType::UInt8, place);
    for (auto shape : {scene::CutShape::Plane, scene::CutShape::Sphere, scene::CutShape::Box})
      for (bool showsData : {false, true}) {
        if (showsData && shape != scene::CutShape::Plane) continue;
        scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
        scene.camera.height = 170.0;
        scene::Cut cut;
        cut.shape = shape;
        cut.centre = scene.camera.target;
        cut.size = glm::dvec3(50.0);
        cut.face = showsData ? scene::CutFace::Section : scene::CutFace::Shaded;
        scene.cuts = {cut};
        expectSameAs(source->level(0), scene, {240, 240},
                     fmt::format("{}{}", enumName(shape), showsData ? " with data" : ""));
      }
  }
}

/// A terabyte: 10,000 voxels along each axis whose values are a formula's, at each level.
class FormulaSource : public VoxelSource {
 public:
  static constexpr int kEdge = 10000;
  FormulaSource() {
    mHead.dims = glm::ivec3(kEdge);
    mHead.type = SampleType::UInt8;
    for (int size = 1; size <= 64; size *= 2) {
      glm::dmat4 place(1.0);
      for (int axis = 0; axis < 3; ++axis) place[axis][axis] = size, place[3][axis] = 0.5 * (size - 1);
      mLevels.push_back({glm::ivec3((kEdge + size - 1) / size), glm::ivec3(64), 1, 1, place});
    }
  }
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress& address, const SampleTarget& target) const override {
    ++reads;
    BrickBox box = boxOf(*this, address);
    double size = 1 << address.level, first = 0.5 * (size - 1);
    for (int z = 0; z < box.size.z; ++z)
      for (int y = 0; y < box.size.y; ++y)
        for (int x = 0; x < box.size.x; ++x) {
          glm::dvec3 p = size * glm::dvec3(box.origin + glm::ivec3(x, y, z)) + first;
          double value = 128.0 + 100.0 * std::sin(p.x / 13.0) * std::sin(p.y / 11.0) * std::sin(p.z / 9.0);
          target.first[x * target.x + y * target.y + z * target.z] = std::byte(std::lround(value));
        }
  }
  mutable std::atomic<int> reads{0};

 private:
  Volume mHead;
};

/// Anywhere in a terabyte the picture is that of the voxels there, and only their bricks are read.
TEST_F(StreamedGL, DeepInATerabyteThePictureIsThatOfItsVoxels) {
  auto source = std::make_shared<FormulaSource>();
  Progress progress;
  int coarsest = int(source->levels().size()) - 1;
  Volume streamed = readLevel(*source, coarsest, progress);
  auto cache = std::make_shared<BrickCache>(source, std::size_t(64) << 20);
  streamed.finer = std::make_shared<FinerLevels>(FinerLevels{cache, coarsest});
  scene::Scene scene = lookOf(std::move(streamed), scene::RenderMode::Volume);
  scene.camera.target = {7003.3, 2111.7, 9034.2};
  scene.camera.height = 60.0;
  lookAlong(scene, {0.5, -1.0, 0.4}, 300);
  scene::Cut cut;
  cut.shape = scene::CutShape::Box;
  cut.centre = scene.camera.target + glm::dvec3(0.13, 0.21, 0.37);  // no edge lies between two pixels
  cut.size = glm::dvec3(40.0);
  cut.invert = true;
  scene.cuts = {cut};
  int before = source->reads;
  Image whole = draw(scene, {120, 120}, kAllLayers);
  EXPECT_LE(source->reads - before, 64);
  glm::ivec3 low = glm::ivec3(scene.camera.target) - 48;
  Volume part = cache->read({0, low, glm::ivec3(96)}, 0, 0);
  part.range = scene.volume.data->range;
  part.worldFromVoxel = glm::translate(glm::dmat4(1.0), glm::dvec3(low));
  part.finer = nullptr;
  scene.volume.data = Shared<Volume>(std::move(part));
  Image there = draw(scene, {120, 120}, kAllLayers);
  EXPECT_GT(coverageOf(there), 0.1);
  EXPECT_NEAR(coverageOf(whole), coverageOf(there), 0.005);
  // Samples begin where the data does, and lie elsewhere.
  EXPECT_LT(differenceOf(whole, there).mean, 1.0);
}

/// Bricks that a sample meets first are waited for, and what lies behind them is drawn again: not all of the picture.
TEST_F(StreamedGL, OnlyWhatNewBricksShowIsDrawnAgain) {
  // A wall, in a corner of which holes are a voxel or two wide: few rays see what is behind.
  auto value = [](glm::ivec3 p) {
    bool isHole = p.x < 70 && p.z < 70 && (p.x + 5 * (p.z / 19)) % 23 < 2 && p.z % 19 < 2;
    return p.y < 24 ? (isHole ? 10.0 : 240.0) : p.y > 90 ? 110.0 + 0.2 * (p.x + p.z) : 10.0;
  };
  auto source =
      std::make_shared<PyramidSource>(makeVolume({200, 200, 200}, SampleType::UInt8, value), 4, glm::ivec3(32));
  for (int samples : {1, 4}) {
    scene::Scene scene = lookOf(streamedVolume(source, 3), scene::RenderMode::Volume);
    scene.rayCast.samplesPerPixel = samples;
    scene.camera.height = 280.0;
    lookAlong(scene, {0.02, -1.0, 0.015}, 900);
    glm::ivec2 size(280, 280);
    renderer().clear();
    Image patched = draw(scene, size, kAllLayers);
    auto cast = double(renderer().stats().pixelsCast);
    EXPECT_GT(coverageOf(patched), 0.05);
    // With all bricks there nothing is drawn twice, and the picture is the same.
    scene.lighting.ambient *= 1.0001;
    Image again = draw(scene, size, kAllLayers);
    auto once = double(renderer().stats().pixelsCast);
    EXPECT_GT(cast, once) << "no brick came late, so that nothing is tried";
    EXPECT_LE(cast, once + 1.5 * once / samples) << samples;  // a fifth of a sample, a few times
    EXPECT_LE(differenceOf(patched, again).largest, 1.005) << samples;
  }
}

/// Farther away, where bricks hold larger voxels, samples are farther apart: leaps meet the same ones, and the picture
/// is that of short steps but for what is smaller than pixels.
TEST_F(StreamedGL, LongerStepsFarAwayShowWhatShortOnesDo) {
  auto source = std::make_shared<PyramidSource>(
      makeVolume({300, 120, 300}, SampleType::UInt8,
                 [](glm::ivec3 p) {
                   double ball = glm::length(glm::dvec3(p.x % 60 - 30, p.y % 60 - 30, p.z % 60 - 30));
                   return 20.0 + 200.0 * 0.5 * std::erfc((ball - 14.0) / 2.0);
                 }),
      4, glm::ivec3(32));
  scene::Scene scene = lookOf(streamedVolume(source, 3), scene::RenderMode::Volume);
  scene.rayCast.jitter = false;
  scene.camera.projection = scene::Projection::Perspective;
  scene.camera.target = {150.0, 60.0, 150.0};
  scene.camera.eye = {-20.0, 61.0, 40.0};
  glm::ivec2 size(160, 120);
  Image leaping = draw(scene, size, kAllLayers);
  EXPECT_GT(coverageOf(leaping), 0.3);
  scene::Scene walking = scene;
  walking.rayCast.skipEmpty = false;
  EXPECT_LE(differenceOf(leaping, draw(walking, size, kAllLayers)).largest, 1.005);
  Volume inMemory = source->level(0);
  inMemory.range = scene.volume.data->range;
  scene.volume.data = Shared<Volume>(std::move(inMemory));
  Image fine = draw(scene, size, kAllLayers);
  EXPECT_GT(differenceOf(leaping, fine).largest, 1.005) << "all steps are short, so that nothing is tried";
  EXPECT_LT(differenceOf(leaping, fine).mean, 1.5);
}

/// What the means of the coarse levels do not show is looked for all the same.
TEST_F(StreamedGL, AThinWireIsFoundThoughNoCoarseLevelShowsIt) {
  auto source =
      std::make_shared<PyramidSource>(makeVolume({100, 100, 100}, SampleType::UInt8,
                                                 [](glm::ivec3 p) { return p.y == 50 && p.z == 41 ? 200.0 : 10.0; }),
                                      4, glm::ivec3(32));
  scene::Scene scene = lookOf(streamedVolume(source, 3), scene::RenderMode::Volume);
  EXPECT_GT(coverageOf(draw(scene, {160, 160}, kAllLayers)), 0.003);
  expectSameAs(source->level(0), scene, {160, 160}, "wire", 0.003);
}

TEST_F(StreamedGL, WhatCannotBeReadIsSeenCoarseAndSaid) {
  auto source = makeSource(SampleType::UInt8);
  source->damaged = true;
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  Image image = draw(scene, {160, 160}, kAllLayers);
  EXPECT_GT(coverageOf(image), 0.1);
  EXPECT_NE(renderer().stats().reduction.find("could not be read"), std::string::npos) << renderer().stats().reduction;
  EXPECT_NE(renderer().stats().reduction.find("brick is damaged"), std::string::npos);
}

/// A preview shows what is there and waits for nothing.
TEST_F(StreamedGL, APreviewReadsNothing) {
  auto source = makeSource(SampleType::UInt8);
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  draw(scene, {160, 160}, kAllLayers);
  int before = source->reads;
  render::Frame frame = frameOf(scene, {160, 160});
  frame.isPreview = true;
  frame.stepFactor = 2.0;
  frame.scene.camera.target.x += 3.0;
  Progress progress;
  renderer().render(frame, progress);
  EXPECT_GT(coverageOf(renderer().read(kAllLayers)), 0.1);
  EXPECT_EQ(source->reads, before);
}

TEST_F(StreamedGL, GradientsOfABlockAreThoseOfTheWhole) {
  for (glm::dvec3 spacing : {glm::dvec3(1.0), glm::dvec3(0.5, 0.5, 1.7)}) {
    Volume volume = makeVolume({31, 26, 29}, SampleType::Int16, [](glm::ivec3 p) { return 10.0 * fieldAt(p + 20); });
    for (int axis = 0; axis < 3; ++axis) volume.worldFromVoxel[axis][axis] = spacing[axis];
    render::VolumeTexels texels;
    texels.volume = Shared<Volume>(volume);
    texels.dims = volume.dims;
    auto differences = render::GradientPlanes(texels, glm::ivec3(1)).planes(0, volume.dims.z);
    auto whole = render::packGradients(differences, volume.dims, 0, volume.dims.z, 3000.0);
    std::vector<float> values;
    for (int z = 0; z < volume.dims.z; ++z)
      for (int y = 0; y < volume.dims.y; ++y)
        for (int x = 0; x < volume.dims.x; ++x) values.push_back(float(valueAt(volume, {x, y, z})));
    auto block = render::blockGradients(values, volume.dims, spacing, {{0, 0, 0}, volume.dims}, 3000.0);
    ASSERT_EQ(block.size(), whole.size());
    int apart = 0;
    for (std::size_t i = 0; i < whole.size(); ++i)
      for (int c = 0; c < 4; ++c) apart = std::max(apart, std::abs(int(block[i][c]) - int(whole[i][c])));
    EXPECT_LE(apart, 1);
    glm::ivec3 reach = render::gradientReach(spacing, volume.dims), low(5, 9, 7), size(11, 6, 9);
    glm::ivec3 from = glm::max(low - reach, glm::ivec3(0)), to = glm::min(low + size + reach, volume.dims);
    std::vector<float> part;
    for (int z = from.z; z < to.z; ++z)
      for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) part.push_back(float(valueAt(volume, {x, y, z})));
    auto ofPart = render::blockGradients(part, to - from, spacing, {low - from, size}, 3000.0);
    auto ofWhole = render::blockGradients(values, volume.dims, spacing, {low, size}, 3000.0);
    EXPECT_TRUE(std::equal(ofPart.begin(), ofPart.end(), ofWhole.begin()));
  }
}

}  // namespace
}  // namespace velum
