// A volume that is streamed looks as it does in memory.
#include <fmt/format.h>

#include <atomic>
#include <glm/gtc/matrix_transform.hpp>

#include "PyramidSource.h"
#include "RenderFixture.h"
#include "render/upload/BlockGradients.h"
#include "render/upload/GradientPlanes.h"
#include "render/upload/GradientTexels.h"
#include "render/upload/LabelBricks.h"

namespace velum {
namespace {

constexpr glm::ivec3 kDims{101, 90, 77};

/// Balls, tubes and a noise that is the same everywhere.
double fieldAt(glm::ivec3 p) {
  double value = 20.0 + (p.x * 31 + p.y * 17 + p.z * 57 + p.x * p.y) % 9;
  for (glm::dvec3 centre : {glm::dvec3(30, 40, 30), glm::dvec3(70, 50, 45), glm::dvec3(50, 20, 60)})
    value += 90.0 * 0.5 * std::erfc((glm::length(glm::dvec3(p) - centre) - 17.0) / 1.5);
  double tube = std::hypot(p.y - 45.0 - 20.0 * std::sin(p.x / 14.0), p.z - 38.0 - 15.0 * std::cos(p.x / 11.0));
  return value + 100.0 * 0.5 * std::erfc((tube - 3.0) / 1.0);
}

class StreamedGL : public RenderTest {
 protected:
  static std::shared_ptr<PyramidSource> makeSource(SampleType type,
                                                   const glm::dmat4& worldFromVoxel = glm::dmat4(1.0)) {
    return std::make_shared<PyramidSource>(makeVolume(
                                               kDims, type, [](glm::ivec3 p) { return fieldAt(p); }, worldFromVoxel),
                                           3, glm::ivec3(24, 40, 16));
  }
  /// @param data  in memory or streamed
  static scene::Scene lookOf(Volume data, scene::RenderMode mode) {
    data.range = {15.0, 260.0};
    scene::Scene scene = sceneOf(std::move(data));
    scene.rayCast.mode = mode;
    scene.rayCast.isoValue = 90.0;
    scene.rayCast.jitter = true;
    scene.volume.transfer.colors = {{40, {0.2f, 0.3f, 0.9f}}, {120, {0.9f, 0.6f, 0.3f}}, {220, {1.0f, 1.0f, 0.9f}}};
    scene.volume.transfer.opacities = {{60, 0}, {80, 0.4}, {130, 0.95}};
    scene.lighting.shaded = true;
    scene.lighting.shadow = scene.lighting.occlusion = 0;
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 120.0;
    lookAlong(scene, {0.5, -1.0, 0.4}, 300);
    return scene;
  }
  /// Compares a streamed scene with the same that has a level in memory, seen by the same camera.
  /// @param sparePixels  so many may differ by more than 1: where shares are interpolated rounding decides now and then
  ///                     on which side of a border a sample lies
  void expectSameAs(const Volume& inMemory, const scene::Scene& streamed, glm::ivec2 size, const std::string& what,
                    double least = 0.05, int sparePixels = 0) {
    scene::Scene whole = streamed;
    Volume volume = inMemory;
    volume.range = streamed.volume.data->range;
    whole.volume.data = Shared<Volume>(std::move(volume));
    Image a = draw(streamed, size, kAllLayers), b = draw(whole, size, kAllLayers);
    EXPECT_GT(coverageOf(b), least) << what;
    int apart = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        glm::vec4 p = colorOf(a, {x, y}), q = colorOf(b, {x, y});
        glm::vec4 d = glm::abs(p * glm::vec4(glm::vec3(p.a), 1.0f) - q * glm::vec4(glm::vec3(q.a), 1.0f)) * 255.0f;
        apart += std::max(std::max(d.x, d.y), std::max(d.z, d.w)) > 1.005f;
      }
    Difference found = differenceOf(a, b);
    EXPECT_LE(apart, sparePixels) << what << ", pixel " << found.where.x << ' ' << found.where.y;
    EXPECT_LE(found.largest, sparePixels > 0 ? 12.0 : 1.005) << what;
  }
};

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

/// Labels as fine as the finest level, in bricks of which some are one structure's alone.
Shared<LabelVolume> labelsOn(const Volume& volume) {
  LabelVolume labels(volume.dims, volume.worldFromVoxel);
  std::vector<std::uint16_t> ids;
  glm::ivec3 p;
  for (p.z = 0; p.z < volume.dims.z; ++p.z)
    for (p.y = 0; p.y < volume.dims.y; ++p.y)
      for (p.x = 0; p.x < volume.dims.x; ++p.x) {
        bool isBall = glm::length(glm::dvec3(p) - glm::dvec3(30, 40, 30)) < 21.0;
        double tube = std::hypot(p.y - 45.0 - 20.0 * std::sin(p.x / 14.0), p.z - 38.0 - 15.0 * std::cos(p.x / 11.0));
        ids.push_back(tube < 4.0 ? 2 : isBall ? 1 : p.x > 66 ? 3 : 0);
      }
  labels.write(glm::ivec3(0), volume.dims, ids);
  return Shared<LabelVolume>(std::move(labels));
}

/// Structures of the finest level: tinted, hidden, spared by a cut, shown as surfaces.
TEST_F(StreamedGL, StructuresAreThoseInMemory) {
  auto source = makeSource(SampleType::UInt8);
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  scene.labels.data = labelsOn(source->level(0));
  scene.labels.structures = {
      {1, "ball", {0.9f, 0.3f, 0.2f}}, {2, "tube", {0.2f, 0.7f, 0.9f}}, {3, "rest", {0.6f, 0.8f, 0.3f}}};
  expectSameAs(source->level(0), scene, {160, 160}, "tinted", 0.05, 3);
  scene.labels.structures[2].visible = false;
  expectSameAs(source->level(0), scene, {160, 160}, "one is hidden", 0.05, 3);
  scene::Cut cut;
  cut.shape = scene::CutShape::Plane;
  cut.centre = scene.camera.target;
  cut.axis = {0.2, -1.0, 0.1};
  cut.spares = {{2}};
  scene.cuts = {cut};
  expectSameAs(source->level(0), scene, {160, 160}, "a tube is spared", 0.05, 3);
  scene.labels.structures[1].showAs = scene::ShowAs::Solid;
  expectSameAs(source->level(0), scene, {160, 160}, "as a surface", 0.05, 3);
}

/// Slots follow edits: what is drawn after one is what is drawn of the edited labels by themselves.
TEST_F(StreamedGL, EditedStructuresAreThoseInMemory) {
  auto source = makeSource(SampleType::UInt8);
  scene::Scene scene = lookOf(streamedVolume(source, 2), scene::RenderMode::Volume);
  scene.labels.data = labelsOn(source->level(0));
  scene.labels.structures = {
      {1, "ball", {0.9f, 0.3f, 0.2f}}, {2, "tube", {0.2f, 0.7f, 0.9f}}, {3, "rest", {0.6f, 0.8f, 0.3f}}};
  draw(scene, {160, 160}, kAllLayers);
  LabelVolume edited = *scene.labels.data;
  std::vector<std::uint16_t> ids(36 * 34 * 20, 1);
  edited.write({40, 20, 30}, {36, 34, 20}, ids);
  std::fill(ids.begin(), ids.end(), 0);
  edited.write({10, 24, 20}, {36, 34, 20}, ids);
  scene.labels.data = Shared<LabelVolume>(std::move(edited));
  expectSameAs(source->level(0), scene, {160, 160}, "edited", 0.05, 3);
}

/// Where borders have no room structures are drawn coarser, and that is said; when there are few again, they are not.
TEST_F(StreamedGL, StructuresWithoutRoomAreDrawnCoarserAndThatIsSaid) {
  glm::ivec3 dims(256);
  auto labelled = [&](int edge) {
    LabelVolume labels(dims, glm::dmat4(1.0));
    std::vector<std::uint16_t> ids;
    glm::ivec3 p;
    for (p.z = 0; p.z < edge; ++p.z)
      for (p.y = 0; p.y < edge; ++p.y)
        for (p.x = 0; p.x < edge; ++p.x) ids.push_back(std::uint16_t((p.x / 10 + p.y / 10 + p.z / 10) % 2));
    labels.write(glm::ivec3(0), glm::ivec3(edge), ids);
    return Shared<LabelVolume>(std::move(labels));
  };
  scene::Scene scene = lookOf(streamedVolume(makeSource(SampleType::UInt8), 2), scene::RenderMode::Volume);
  scene.labels.data = labelled(256);
  gpu::Limits limits = context().limits();
  limits.memoryBytes = std::size_t(400) << 20;  // 256 slots, or a few more
  render::LabelBricks bricks(limits);
  bricks.begin(scene, false);
  while (!bricks.step()) {
  }
  EXPECT_EQ(bricks.labels().dims(), dims / 2);
  EXPECT_NE(bricks.shortfall().find("2 times coarser"), std::string::npos) << bricks.shortfall();
  scene.labels.data = labelled(20);
  bricks.begin(scene, false);
  bricks.begin(scene, false);
  EXPECT_EQ(bricks.labels().dims(), dims);
  EXPECT_EQ(bricks.shortfall(), "");
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
