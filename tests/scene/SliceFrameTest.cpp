#include "velum/scene/SliceFrame.h"

#include <gtest/gtest.h>

#include <numbers>

#include "makeVolume.h"

namespace velum::scene {

namespace {

constexpr SliceKind kKinds[] = {SliceKind::Axial, SliceKind::Coronal, SliceKind::Sagittal};
constexpr glm::dvec2 kSize(320, 200);

Scene sceneOf(glm::ivec3 dims, const glm::dmat4& worldFromVoxel) {
  Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3 v) { return v.x + v.y; }, worldFromVoxel));
  placeSlices(scene);
  return scene;
}

Scene boxScene() { return sceneOf({40, 30, 20}, centredFrame({40, 30, 20}, {1, 2, 3}, 0.0, {100, -50, 20})); }
Scene turnedScene() { return sceneOf({40, 30, 20}, centredFrame({40, 30, 20}, {1, 2, -3}, 0.4, {1e6, 5, 7})); }

bool isInside(const Bounds& b, glm::dvec3 p) {
  return glm::all(glm::greaterThanEqual(p, b.min - 1e-9)) && glm::all(glm::lessThanEqual(p, b.max + 1e-9));
}

}  // namespace

TEST(SliceFrame, PixelsGoToTheWorldAndBack) {
  for (Scene scene : {boxScene(), turnedScene()}) {
    turnSlices(scene, SliceKind::Coronal, 0.3);
    scene.slices.axial.panMm = {12, -7};
    scene.slices.sagittal.heightMm = 33;
    for (SliceKind kind : kKinds) {
      SliceFrame frame = makeSliceFrame(scene, kind, kSize);
      EXPECT_NEAR(glm::determinant(glm::dmat3(frame.right, frame.up, frame.normal)), 1.0, 1e-12);
      for (glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(17.25, 180.5), kSize}) {
        glm::dvec3 world = worldFromSlicePixel(frame, pixel);
        EXPECT_LT(glm::length(slicePixelFromWorld(frame, world) - pixel), 1e-6);
        EXPECT_NEAR(heightOverSlice(frame, world), 0.0, 1e-9);
        // A point before the plane has its foot there.
        EXPECT_LT(glm::length(slicePixelFromWorld(frame, world + frame.normal * 5.0) - pixel), 1e-6);
        EXPECT_NEAR(heightOverSlice(frame, world + frame.normal * 5.0), 5.0, 1e-6);
      }
      EXPECT_NEAR(heightOverSlice(frame, scene.slices.crosshairMm), 0.0, 1e-9);
    }
  }
}

TEST(SliceFrame, ViewsAreRadiological) {
  struct {
    SliceKind kind;
    const char *right, *top;
  } const kSides[] = {{SliceKind::Axial, "L", "A"}, {SliceKind::Coronal, "L", "S"}, {SliceKind::Sagittal, "P", "S"}};
  Scene scene = boxScene();
  for (auto [kind, right, top] : kSides) {
    SliceFrame frame = makeSliceFrame(scene, kind, kSize);
    EXPECT_EQ(patientLetters(frame.right), right);
    EXPECT_EQ(patientLetters(frame.up), top);
    EXPECT_FALSE(isOblique(scene.slices, kind));
  }
}

TEST(SliceFrame, LettersNameTheStrongestPartFirst) {
  EXPECT_EQ(patientLetters({0, -1, 0}), "A");
  EXPECT_EQ(patientLetters({0.3, 0, 0.9}), "SL");
  EXPECT_EQ(patientLetters({-0.6, 0.5, -0.62}), "IRP");
  EXPECT_EQ(patientLetters({0.05, 1, 0}), "P");
  EXPECT_EQ(patientLetters({0, 0, 0}), "");
}

TEST(SliceFrame, AllOfTheDataFitsAtFirst) {
  Scene scene = turnedScene();
  Bounds bounds = computeBounds(scene);
  for (glm::dvec2 size : {glm::dvec2(300, 100), glm::dvec2(100, 300)})
    for (SliceKind kind : kKinds) {
      SliceFrame frame = makeSliceFrame(scene, kind, size);
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        glm::dvec2 pixel = slicePixelFromWorld(frame, glm::mix(bounds.min, bounds.max, share));
        EXPECT_TRUE(glm::all(glm::greaterThan(pixel, glm::dvec2(0))) && glm::all(glm::lessThan(pixel, size)));
      }
    }
}

TEST(SliceFrame, TheCrosshairBeginsOnAVoxelInTheMiddle) {
  for (const Scene& scene : {boxScene(), turnedScene()}) {
    const Volume& v = *scene.volume.data;
    glm::dvec3 voxel(glm::inverse(v.worldFromVoxel) * glm::dvec4(scene.slices.crosshairMm, 1));
    // A grid a thousand kilometres away leaves ten digits behind the point to the inverse's sixteen.
    EXPECT_LT(glm::length(voxel - glm::round(voxel)), 1e-6);
    EXPECT_LE(glm::length(voxel - (glm::dvec3(v.dims) - 1.0) * 0.5), 0.9);
  }
}

TEST(SliceFrame, ScrollingShowsEachPlaneOnceAndStopsAtTheLast) {
  Scene scene = boxScene();
  struct {
    SliceKind kind;
    int planes;
  } const kRows[] = {{SliceKind::Axial, 20}, {SliceKind::Coronal, 30}, {SliceKind::Sagittal, 40}};
  for (auto [kind, planes] : kRows) {
    scrollSlice(scene, kind, -1000);
    auto first = sliceIndex(scene, kind);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->count, planes);
    int way = first->index == 0 ? 1 : -1;
    EXPECT_EQ(first->index, way > 0 ? 0 : planes - 1);
    for (int i = 1; i < planes; ++i) {
      scrollSlice(scene, kind, 1);
      EXPECT_EQ(sliceIndex(scene, kind)->index, first->index + way * i);
      EXPECT_TRUE(isInside(computeBounds(scene), scene.slices.crosshairMm));
    }
    glm::dvec3 last = scene.slices.crosshairMm;
    scrollSlice(scene, kind, 1);
    EXPECT_LT(glm::length(scene.slices.crosshairMm - last), 1e-9);
  }
}

TEST(SliceFrame, TowardsTheViewerIsTheFeetTheFrontAndTheLeft) {
  Scene scene = boxScene();
  glm::dvec3 before = scene.slices.crosshairMm;
  for (SliceKind kind : kKinds) scrollSlice(scene, kind, 1);
  EXPECT_LT(glm::length(scene.slices.crosshairMm - before - glm::dvec3(1, -2, -3)), 1e-9);
}

TEST(SliceFrame, AnObliqueScrollStaysOnItsNormalAndInsideTheData) {
  Scene scene = turnedScene();
  turnSlices(scene, SliceKind::Axial, 0.5);
  SliceFrame frame = makeSliceFrame(scene, SliceKind::Coronal, kSize);
  glm::dvec3 start = scene.slices.crosshairMm;
  EXPECT_FALSE(sliceIndex(scene, SliceKind::Coronal));
  EXPECT_TRUE(isOblique(scene.slices, SliceKind::Coronal));
  for (double steps : {3.0, 1000.0, -5000.0}) {
    scrollSlice(scene, SliceKind::Coronal, steps);
    glm::dvec3 moved = scene.slices.crosshairMm - start;
    EXPECT_LT(glm::length(moved - frame.normal * glm::dot(moved, frame.normal)), 1e-6);
    EXPECT_TRUE(isInside(computeBounds(scene), scene.slices.crosshairMm));
  }
}

TEST(SliceFrame, PlanesOfATiltedGantryAreCountedAlongTheirNormal) {
  glm::dmat4 sheared(1.0);
  sheared[2] = glm::dvec4(0, 1, 2, 0);  // each plane two millimetres higher and one further back
  Scene scene = sceneOf({10, 10, 10}, sheared);
  auto before = sliceIndex(scene, SliceKind::Axial);
  ASSERT_TRUE(before);
  double z = scene.slices.crosshairMm.z;
  scrollSlice(scene, SliceKind::Axial, -1);
  EXPECT_NEAR(scene.slices.crosshairMm.z, z + 2.0, 1e-9);
  EXPECT_EQ(sliceIndex(scene, SliceKind::Axial)->index, before->index + 1);
}

TEST(SliceFrame, ZoomKeepsThePointUnderThePointer) {
  for (Scene scene : {boxScene(), turnedScene()})
    for (SliceKind kind : kKinds)
      for (double factor : {0.5, 0.9, 1.7}) {
        glm::dvec2 pixel(40, 150);
        SliceFrame before = makeSliceFrame(scene, kind, kSize);
        glm::dvec3 held = worldFromSlicePixel(before, pixel);
        zoomSlice(scene, kind, kSize, pixel, factor);
        SliceFrame after = makeSliceFrame(scene, kind, kSize);
        EXPECT_NEAR(after.mmPerPixel, before.mmPerPixel * factor, 1e-9);
        EXPECT_LT(glm::length(slicePixelFromWorld(after, held) - pixel), 1e-5);
      }
}

TEST(SliceFrame, ADragTakesThePictureAlong) {
  Scene scene = boxScene();
  glm::dvec3 held = worldFromSlicePixel(makeSliceFrame(scene, SliceKind::Sagittal, kSize), {100, 100});
  panSlice(scene, SliceKind::Sagittal, kSize, {30, -12});
  glm::dvec2 now = slicePixelFromWorld(makeSliceFrame(scene, SliceKind::Sagittal, kSize), held);
  EXPECT_LT(glm::length(now - glm::dvec2(130, 88)), 1e-9);
}

TEST(SliceFrame, FourQuarterTurnsAreNone) {
  for (SliceKind kind : kKinds) {
    Scene scene = boxScene();
    const Slices before = scene.slices;
    for (int i = 0; i < 4; ++i) {
      turnSlices(scene, kind, std::numbers::pi / 2);
      EXPECT_EQ(sliceOf(scene.slices, kind), sliceOf(before, kind));
    }
    for (SliceKind other : kKinds) {
      EXPECT_LT(glm::length(sliceOf(scene.slices, other).normal - sliceOf(before, other).normal), 1e-12);
      EXPECT_LT(glm::length(sliceOf(scene.slices, other).up - sliceOf(before, other).up), 1e-12);
    }
  }
}

TEST(SliceFrame, TurnedSlicesStayAcrossEachOther) {
  Scene scene = boxScene();
  for (int i = 0; i < 50; ++i) turnSlices(scene, kKinds[i % 3], 0.1 + 0.01 * i);
  const auto& s = scene.slices;
  EXPECT_NEAR(glm::dot(s.axial.normal, s.coronal.normal), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(s.axial.normal, s.sagittal.normal), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(s.coronal.normal, s.sagittal.normal), 0.0, 1e-9);
  resetSlices(scene);
  EXPECT_EQ(scene.slices, boxScene().slices);
}

TEST(SliceFrame, StepsAndMovesKeepTheCrosshairInTheData) {
  Scene scene = boxScene();
  stepCrosshair(scene, SliceKind::Axial, {1, 1});
  EXPECT_LT(glm::length(scene.slices.crosshairMm - boxScene().slices.crosshairMm - glm::dvec3(1, -1, 0)), 1e-9);
  stepCrosshair(scene, SliceKind::Axial, {1e6, 1e6});
  EXPECT_TRUE(isInside(computeBounds(scene), scene.slices.crosshairMm));
  moveCrosshair(scene, {-1e9, 0, 1e9});
  EXPECT_TRUE(isInside(computeBounds(scene), scene.slices.crosshairMm));
}

TEST(SliceFrame, DegenerateDirectionsAndEmptyScenesStillGiveAFrame) {
  Scene scene;
  scene.slices.axial.normal = scene.slices.axial.up = {0, 0, 0};
  scene.slices.coronal.up = scene.slices.coronal.normal;
  for (SliceKind kind : kKinds) {
    SliceFrame frame = makeSliceFrame(scene, kind, {0, 0});
    EXPECT_NEAR(glm::determinant(glm::dmat3(frame.right, frame.up, frame.normal)), 1.0, 1e-12);
    EXPECT_GT(frame.mmPerPixel, 0);
    scrollSlice(scene, kind, 3);
    EXPECT_TRUE(isInside(computeBounds(scene), scene.slices.crosshairMm));
  }
}

TEST(SliceFrame, OnlyWhatASliceShowsChangesItsScene) {
  Scene scene = boxScene(), other = scene;
  other.camera.eyeMm.x += 1;
  other.volume.transfer.unitDistanceMm = 2;
  other.slices.crosshairMm.x += 1;
  EXPECT_EQ(sliceScene(scene), sliceScene(other));
  for (int i = 0; i < 4; ++i) {
    other = scene;
    if (i == 0) setWindow(other.volume, 3, 4);
    if (i == 1) other.cuts.emplace_back();
    if (i == 2) other.slices.interpolate = false;
    if (i == 3) other.labels.structures.push_back({1, "a"});
    EXPECT_NE(sliceScene(scene), sliceScene(other)) << i;
  }
}

}  // namespace velum::scene
