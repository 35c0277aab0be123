#include "render/section/SectionImage.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "cutShapes.h"
#include "makeVolume.h"
#include "render/FrameSetup.h"
#include "render/kept/RowCuts.h"
#include "render/upload/CutSheets.h"
#include "scene/Presets.h"
#include "sheetShapes.h"

namespace velum::render {

namespace {

using scene::SectionKind;
constexpr SectionKind kKinds[] = {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal};
constexpr glm::ivec2 kView(90, 70);

scene::Scene sceneOf(Volume volume) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene::placeSections(scene);
  return scene;
}

/// One value of the volume at a place in voxels, the plain way.
double plainSample(const Volume& v, glm::dvec3 at, bool interpolate, int channel = 0, int frame = 0) {
  auto value = [&](glm::dvec3 p) {
    return valueAt(v, glm::clamp(glm::ivec3(p), glm::ivec3(0), v.dims - 1), channel, frame);
  };
  if (!interpolate) return value(glm::floor(at + 0.5));
  glm::dvec3 low = glm::floor(at), f = at - low;
  double sum = 0;
  for (int c = 0; c < 8; ++c) {
    glm::dvec3 o(c & 1, c >> 1 & 1, c >> 2), w = glm::mix(1.0 - f, f, o);
    sum += w.x * w.y * w.z * value(low + o);
  }
  return sum;
}

glm::dvec3 voxelUnder(const glm::dmat4& worldFromVoxel, const scene::SectionPlane& plane, int x, int y) {
  return glm::dvec3(glm::inverse(worldFromVoxel) *
                    glm::dvec4(scene::worldFromSectionPixel(plane, {x + 0.5, y + 0.5}), 1.0));
}

glm::ivec3 rgbOf(const SectionImage& image, int x, int y) {
  auto p = image.pixels[std::size_t(y) * std::size_t(image.size.x) + std::size_t(x)];
  return {int(p >> 16 & 255), int(p >> 8 & 255), int(p & 255)};
}

/// Compares the inside of the data with the plain loop. @return pixels compared
int expectPlain(const scene::Scene& scene, SectionKind kind, int channel = 0) {
  const Volume& v = *scene.volume.data;
  auto plane = scene::makeSectionPlane(scene, kind, glm::dvec2(kView));
  SectionImage image = drawSection(scene, kind, kView);
  glm::dvec2 window = scene::effectiveWindow(scene.volume);
  int compared = 0, wrong = 0;
  for (int y = 0; y < kView.y; ++y)
    for (int x = 0; x < kView.x; ++x) {
      glm::dvec3 at = voxelUnder(v.worldFromVoxel, plane, x, y);
      glm::dvec3 edge = glm::min(at + 0.5, glm::dvec3(v.dims) - 0.5 - at);
      // Rounding may put a pixel on the box's side, or between two voxels, on either.
      if (glm::any(glm::lessThan(edge, glm::dvec3(1e-6)))) continue;
      if (!scene.sections.interpolate && glm::any(glm::lessThan(glm::abs(glm::fract(at) - 0.5), glm::dvec3(1e-6))))
        continue;
      double value = plainSample(v, at, scene.sections.interpolate, channel, scene.volume.timeStep);
      int grey = int(std::lround(255 * std::clamp((value - window.x) / window.y + 0.5, 0.0, 1.0)));
      ++compared;
      wrong += std::abs(rgbOf(image, x, y).r - grey) > 1 || rgbOf(image, x, y).g != rgbOf(image, x, y).r;
    }
  EXPECT_EQ(wrong, 0);
  return compared;
}

template <class ValueOf>
Volume grid(SampleType type, ValueOf valueOf, double turn = 0.0) {
  glm::ivec3 dims(24, 20, 16);
  return makeVolume(dims, type, valueOf, centredFrame(dims, {1.0, 1.5, -2.0}, turn, {30, -20, 500}), 0.5, -3.0);
}

}  // namespace

TEST(SectionImage, EqualsThePlainLoopForEveryTypeAndTurn) {
  auto noise = [](glm::ivec3 v) { return 40 * hashNoise(v) - 3; };
  for (auto type : {SampleType::UInt8, SampleType::Int8, SampleType::UInt16, SampleType::Int16, SampleType::UInt32,
                    SampleType::Int32, SampleType::Float32, SampleType::Float64})
    for (double turn : {0.0, 0.4})
      for (bool interpolate : {true, false}) {
        scene::Scene scene = sceneOf(grid(type, noise, turn));
        scene.sections.interpolate = interpolate;
        scene::setWindow(scene.volume, 12, 30);
        scene.sections.crosshair += glm::dvec3(0.3, 0.4, -0.7);
        for (auto kind : kKinds) EXPECT_GT(expectPlain(scene, kind), 1000);
      }
}

TEST(SectionImage, EqualsThePlainLoopWhereItIsZoomedAndTurned) {
  scene::Scene scene = sceneOf(grid(SampleType::Int16, [](glm::ivec3 v) { return 40 * hashNoise(v); }));
  scene::turnSections(scene, SectionKind::Sagittal, 0.35);
  for (auto kind : kKinds) {
    scene::zoomSection(scene, kind, glm::dvec2(kView), {20, 30}, 0.3);
    EXPECT_GT(expectPlain(scene, kind), 1000);
  }
}

TEST(SectionImage, ShowsTheChosenFrameAndChannel) {
  Volume v;
  v.dims = {8, 8, 8};
  v.channels = 2;
  v.timeSteps = 3;
  v.type = SampleType::UInt8;
  v.voxels.resize(timeStepBytes(v) * 3);
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = std::byte((i * 37 + i / 1024 * 11) % 251);
  computeRange(v);
  scene::Scene scene = sceneOf(std::move(v));
  scene.volume.timeStep = 2;
  scene.volume.channel = 1;
  EXPECT_GT(expectPlain(scene, SectionKind::Axial, 1), 1000);
}

TEST(SectionImage, MixedChannelsAddTheirColoursByTheirWindows) {
  Volume v;
  v.dims = {6, 6, 6};
  v.channels = 2;
  v.type = SampleType::UInt16;
  v.voxels.resize(timeStepBytes(v));
  auto* samples = reinterpret_cast<std::uint16_t*>(v.voxels.data());
  for (std::size_t i = 0; i < voxelCount(v); ++i) samples[2 * i] = 100, samples[2 * i + 1] = 1000;
  computeRange(v);
  scene::Scene scene = sceneOf(std::move(v));
  scene.volume.channels = {{"a", true, {1, 0, 0}, {}, 100, 200}, {"b", true, {0, 0.5f, 1}, {}, 900, 400}};
  auto middle = [&] { return rgbOf(drawSection(scene, SectionKind::Axial, kView), kView.x / 2, kView.y / 2); };
  EXPECT_EQ(middle(), glm::ivec3(128, 96, 191));  // half of red; three quarters of the blue
  scene.volume.channels[0].visible = false;
  EXPECT_EQ(middle(), glm::ivec3(0, 96, 191));
  EXPECT_EQ(probe(scene, scene.sections.crosshair).values, (std::vector<double>{100, 1000}));
}

TEST(SectionImage, ColoursAreShownAsTheyAre) {
  Volume v;
  v.dims = {6, 6, 6};
  v.channels = 3;
  v.isColor = true;
  v.voxels.resize(timeStepBytes(v));
  for (std::size_t i = 0; i < v.voxels.size(); ++i) v.voxels[i] = std::byte(i % 3 == 0 ? 200 : i % 3 == 1 ? 50 : 7);
  computeRange(v);
  scene::Scene scene = sceneOf(std::move(v));
  EXPECT_EQ(rgbOf(drawSection(scene, SectionKind::Coronal, kView), 45, 35), glm::ivec3(200, 50, 7));
}

TEST(SectionImage, OutsideTheDataIsTheBackground) {
  scene::Scene scene = sceneOf(grid(SampleType::UInt8, [](glm::ivec3) { return 5; }));
  scene.background.top = scene.background.bottom = {1, 0, 0};
  EXPECT_EQ(drawSection(scene, SectionKind::Axial, kView).pixels[0], 0xffff0000u);
  scene.background.transparent = true;
  EXPECT_EQ(drawSection(scene, SectionKind::Axial, kView).pixels[0] >> 24, 0u);
  scene.volume.visible = false;
  for (auto pixel : drawSection(scene, SectionKind::Axial, kView).pixels) ASSERT_EQ(pixel >> 24, 0u);
}

TEST(SectionImage, NotANumberIsBlack) {
  scene::Scene scene = sceneOf(grid(SampleType::Float32, [](glm::ivec3) { return std::nan(""); }));
  EXPECT_EQ(rgbOf(drawSection(scene, SectionKind::Axial, kView), 45, 35), glm::ivec3(0));
}

/// A grey cube with a block of structure 1 beside one of structure 2, on a grid of their own.
class SectionLabels : public testing::Test {
 protected:
  void SetUp() override {
    glm::ivec3 dims(24, 20, 16), fine(48, 40, 32);
    mScene = sceneOf(makeVolume(
        dims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(dims, glm::dvec3(2.0))));
    scene::setWindow(mScene.volume, 100, 200);
    auto idOf = [](glm::ivec3 v) { return v.y < 10 || v.y >= 30 || v.x < 10 || v.x >= 38 ? 0 : v.x < 24 ? 1 : 2; };
    mScene.labels.data = Shared<LabelVolume>(makeLabels(fine, idOf, centredFrame(fine)));
    scene::completeStructures(mScene.labels);
    mScene.labels.structures[0].color = {1, 0, 0};
    mScene.labels.structures[1].color = {0, 1, 0};
    mScene.sections.labelOpacity = 0.3;
    mFrame = scene::makeSectionPlane(mScene, SectionKind::Axial, glm::dvec2(kView));
  }
  glm::ivec3 at(glm::dvec3 world) {
    glm::ivec2 p(scene::sectionPixelFromWorld(mFrame, world));
    return rgbOf(drawSection(mScene, mFrame), p.x, p.y);
  }
  /// Half of 255 may be rounded either way.
  void expectColor(glm::dvec3 world, glm::ivec3 wanted) {
    glm::ivec3 off = glm::abs(at(world) - wanted);
    EXPECT_LE(std::max(off.r, std::max(off.g, off.b)), 1) << world.x << ", " << world.y;
  }
  /// probe().inside, of which structure it is not asked: that smooths the labels around each place.
  bool isInData(glm::dvec3 world) {
    scene::Scene data;
    data.volume.data = mScene.volume.data;
    return probe(data, world).inside;
  }
  scene::Scene mScene;
  scene::SectionPlane mFrame;
  const glm::dvec3 kInOne{-7, 0, 0}, kInTwo{7, 0, 0}, kInNone{0, 15, 0};
};

TEST_F(SectionLabels, LieOverTheGreyByWorldPosition) {
  expectColor(kInOne, glm::ivec3(166, 89, 89));  // 128 mixed with three tenths of red
  expectColor(kInTwo, glm::ivec3(89, 166, 89));
  expectColor(kInNone, glm::ivec3(128));
  EXPECT_EQ(probe(mScene, kInOne).structure, 1);
  EXPECT_EQ(probe(mScene, kInNone).structure, 0);
  EXPECT_EQ(probe(mScene, kInNone).values, std::vector<double>{100});
  EXPECT_FALSE(probe(mScene, {1000, 0, 0}).inside);
}

TEST_F(SectionLabels, HiddenOnesAreNotShownAndFaintOnesFaint) {
  mScene.labels.structures[0].visible = false;
  expectColor(kInOne, glm::ivec3(128));
  mScene.labels.structures[1].opacity = 0.5;
  expectColor(kInTwo, glm::ivec3(108, 147, 108));
  mScene.labels.visible = false;
  expectColor(kInTwo, glm::ivec3(128));
}

TEST_F(SectionLabels, AloneTheyFillThePicture) {
  mScene.volume = {};
  expectColor(kInOne, glm::ivec3(255, 0, 0));
  EXPECT_TRUE(probe(mScene, kInOne).inside);
}

TEST_F(SectionLabels, OutlinesAreOnePixelWide) {
  SectionImage image = drawSection(mScene, mFrame);
  int y = int(scene::sectionPixelFromWorld(mFrame, {0, 0, 0}).y);
  std::vector<int> strong;  // more opaque than the areas
  for (int x = 0; x < kView.x; ++x) {
    glm::ivec3 c = rgbOf(image, x, y);
    if (std::max(c.r, c.g) > 180) strong.push_back(x);
  }
  // Where none meets 1, 1 meets 2 (a line each) and 2 meets none.
  ASSERT_EQ(strong.size(), 4u);
  EXPECT_EQ(strong[2], strong[1] + 1);
}

scene::Cut slanted(scene::CutShape shape, bool invert) {
  scene::Cut cut;
  cut.shape = shape;
  cut.invert = invert;
  cut.axis = {0.5, -0.3, 0.6};
  cut.centre = {2, 1, -3};
  cut.size = {22, 16, 25};
  return cut;
}

TEST_F(SectionLabels, CutsDimWhatTheyRemoveAsTheirFunctionSays) {
  mScene.sections.labelOpacity = 0;
  for (auto shape : everyShapeButMembranes())
    for (bool invert : {false, true}) {
      mScene.cuts = {slanted(shape, invert)};
      SectionImage image = drawSection(mScene, mFrame);
      auto data = makeCutData(mScene, {0, 0, 0}, {});
      int dim = 0, kept = 0;
      for (int y = 0; y < kView.y; ++y)
        for (int x = 0; x < kView.x; ++x) {
          glm::dvec3 world = scene::worldFromSectionPixel(mFrame, {x + 0.5, y + 0.5});
          float distance = shared::cutDistance(data[0], glm::vec3(world), {});
          if (!isInData(world) || std::abs(distance) < 1e-3f) continue;
          int wanted = distance < 0 ? 44 : 128;  // kDimmed of 128
          EXPECT_NEAR(rgbOf(image, x, y).r, wanted, 1) << int(shape) << invert << " " << x << " " << y;
          ++(distance < 0 ? dim : kept);
        }
      EXPECT_GT(dim, 20);
      EXPECT_GT(kept, 20);
    }
  mScene.sections.showCuts = false;
  expectColor(kInNone, glm::ivec3(128));
}

TEST(RowCuts, WalksMarkARowAsIntervalsDo) {
  int crossed = 0, off = 0;
  for (auto shape : everyShapeButMembranes()) {
    if (!shared::cutIsConvex(static_cast<int>(shape))) continue;
    for (bool invert : {false, true})
      for (int y = -40; y < 40; ++y) {
        scene::Scene scene;
        scene.cuts = {slanted(shape, invert)};
        auto data = makeCutData(scene, {0, 0, 0}, {});
        RowCuts::Row row{{-40, 0.7f * float(y), 3}, glm::normalize(glm::vec3(1, 0.1f, 0.2f)), 90, 0.9};
        std::vector<char> byInterval(90), byWalk(90);
        RowCuts::markConvex(data[0], row, byInterval);
        RowCuts::markWalked(data[0], row, byWalk);
        for (std::size_t x = 0; x < 90; ++x) off += byInterval[x] != byWalk[x];
        crossed += byWalk.front() != byWalk[45];
      }
  }
  EXPECT_GT(crossed, 100);
  EXPECT_LT(off, 8) << "of 72,000 pixels those on a face";
}

TEST_F(SectionLabels, MembranesDimWhatTheyRemoveAsTheirFunctionSays) {
  mScene.sections.labelOpacity = 0;
  glm::dvec3 spacing = spacingOf(*mScene.volume.data);
  double smallest = std::min({spacing.x, spacing.y, spacing.z});
  for (auto use : {scene::MembraneUse::Clip, scene::MembraneUse::Inlay})
    for (const auto& [name, shape] : allSheets({20, 20}, {22, 18, 14})) {
      scene::Cut cut;
      cut.shape = scene::CutShape::Membrane;
      cut.membrane.emplace();
      cut.axis = {0.5, -0.3, 0.6};
      cut.centre = {2, 1, -3};
      cut.size = {22, 18, 14};
      cut.membrane->shape = shape;
      cut.membrane->use = use;
      mScene.cuts = {cut};
      SectionImage image = drawSection(mScene, mFrame);
      CpuSheets sheets = makeCpuSheets(mScene, {});
      auto data = makeCutData(mScene, {0, 0, 0}, sheets.plans);
      int dim = 0, kept = 0;
      for (int y = 0; y < kView.y; ++y)
        for (int x = 0; x < kView.x; ++x) {
          glm::dvec3 world = scene::worldFromSectionPixel(mFrame, {x + 0.5, y + 0.5});
          auto distanceAt = [&](double lower) {
            glm::vec3 place(world - lower * glm::dvec3(scene::worldFromCut(cut)[2]));
            return shared::cutDistance(data[0], place, sheets.view());
          };
          // What lies within half a voxel of a sheet that clips stays as it is.
          double half = use == scene::MembraneUse::Clip ? 0.5 * smallest : 0.0;
          if (!isInData(world) || std::abs(distanceAt(0)) < 1e-3f || std::abs(distanceAt(half)) < 1e-3f) continue;
          bool isDim = distanceAt(0) < 0 && distanceAt(half) < 0;
          int wanted = isDim ? 44 : 128;  // kDimmed of 128
          EXPECT_NEAR(rgbOf(image, x, y).r, wanted, 1) << name << int(use) << " " << x << " " << y;
          ++(isDim ? dim : kept);
        }
      EXPECT_GT(dim, 20) << name;
      EXPECT_GT(kept, name == "flat" && use == scene::MembraneUse::Inlay ? -1 : 20) << name;
    }
}

TEST_F(SectionLabels, ASectionInTheSheetsOwnPlaneHasNoBands) {
  mScene.sections.labelOpacity = 0;
  glm::dvec3 spacing = spacingOf(*mScene.volume.data);
  double smallest = std::min({spacing.x, spacing.y, spacing.z});
  // Waves of a third of a voxel about the section.
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.axis = mFrame.normal;
  cut.centre = mFrame.centre;
  cut.size = {60, 60, 14};
  cut.membrane->shape.particles = {40, 40};
  for (int i = 0; i < 1600; ++i)
    cut.membrane->shape.places.emplace_back(glm::vec2(i % 40, i / 40) * (60.0f / 39.0f) - 30.0f,
                                            0.33 * smallest * std::sin(0.9 * (i % 40)) * std::cos(0.7 * (i / 40)));
  for (bool invert : {false, true}) {
    cut.invert = invert;
    for (double off : {0.0, 3.0}) {
      cut.centre = mFrame.centre + off * smallest * cut.axis * (invert ? 1.0 : -1.0);
      mScene.cuts = {cut};
      SectionImage image = drawSection(mScene, mFrame);
      int dim = 0, all = 0;
      for (int y = 0; y < kView.y; ++y)
        for (int x = 0; x < kView.x; ++x) {
          if (!isInData(scene::worldFromSectionPixel(mFrame, {x + 0.5, y + 0.5}))) continue;
          dim += rgbOf(image, x, y).r < 100;
          ++all;
        }
      ASSERT_GT(all, 500);
      EXPECT_EQ(dim, off > 0.0 ? all : 0) << "three voxels in front of the sheet all is removed";
    }
  }
}

TEST_F(SectionLabels, ALiveSheetTakesThePlaceOfTheSavedOne) {
  scene::Cut cut;
  cut.id = 1;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.axis = {0.5, -0.3, 0.6};
  cut.size = {22, 18, 14};
  mScene.cuts = {cut};
  auto live = std::make_shared<const membrane::SheetIndex>(
      membrane::makeSheetIndex(domeSheet({20, 20}, cut.size), {20, 20}, cut.size));
  SectionImage flat = drawSection(mScene, mFrame), drawn = drawSection(mScene, mFrame, {{cut.id, live}});
  mScene.cuts[0].membrane->shape = domeSheet({20, 20}, cut.size);
  EXPECT_EQ(drawn.pixels, drawSection(mScene, mFrame).pixels);
  EXPECT_NE(drawn.pixels, flat.pixels);
}

TEST_F(SectionLabels, WhatACutSparesIsNotDimmed) {
  scene::Cut cut;
  cut.axis = {0, 0, 1};
  cut.centre = {0, 0, -100};  // all of it
  cut.spares = {{1}};
  mScene.cuts = {cut};
  mScene.sections.labelOpacity = 0;
  expectColor(kInOne, glm::ivec3(128));
  expectColor(kInTwo, glm::ivec3(44));
  mScene.labels.visible = false;  // as in the 3D picture: no labels, nothing to spare
  expectColor(kInOne, glm::ivec3(44));
}

TEST(SectionImage, CoarserPicturesShowTheSameRectangle) {
  scene::Scene scene = sceneOf(grid(SampleType::UInt8, [](glm::ivec3 v) { return v.x; }));
  auto fine = scene::makeSectionPlane(scene, SectionKind::Axial, {101, 77});
  auto coarse = coarserPlane(fine, 3);
  EXPECT_LT(glm::length(scene::worldFromSectionPixel(fine, {30, 60}) - scene::worldFromSectionPixel(coarse, {10, 20})),
            1e-9);
  EXPECT_EQ(drawSection(scene, coarse).size, glm::ivec2(34, 26));
}

// The law is 25 ms on two idle cores; other work on the machine, and sanitizers, are given a margin.
TEST(SectionImage, AnAxialSectionOf512CubedIsDrawnAtOnce) {
#if defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "under the thread sanitizer nothing is at once";
#endif
  Volume v;
  v.dims = glm::ivec3(512);
  v.type = SampleType::Int16;
  v.voxels.resize(timeStepBytes(v));
  auto* samples = reinterpret_cast<std::int16_t*>(v.voxels.data());
  for (std::size_t i = 0; i < voxelCount(v); ++i) samples[i] = std::int16_t((i * 2654435761u) >> 18);
  v.range = {-8192, 8191};
  scene::Scene scene = sceneOf(std::move(v));
  for (auto kind : kKinds) {
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) {
      scene::scrollSection(scene, kind, i % 2 ? 3 : -2);
      auto start = std::chrono::steady_clock::now();
      drawSection(scene, kind, {1000, 800});
      times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    RecordProperty(std::string("median ms, ") + std::string(enumName(kind)), std::to_string(times[4]));
    std::printf("%s: %.1f ms, best %.1f\n", std::string(enumName(kind)).c_str(), times[4], times[0]);
    EXPECT_LT(times[0], 100.0);
  }
}

}  // namespace velum::render
