#include "scene/SectionPlane.h"

#include <gtest/gtest.h>

#include <numbers>

#include "makeVolume.h"
#include "scene/PatientDirections.h"

namespace velum::scene {

namespace {

constexpr SectionKind kKinds[] = {SectionKind::Axial, SectionKind::Coronal, SectionKind::Sagittal};
constexpr glm::dvec2 kSize(320, 200);

Scene sceneOf(glm::ivec3 dims, const glm::dmat4& worldFromVoxel) {
  Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      dims, SampleType::UInt8, [](glm::ivec3 v) { return v.x + v.y; }, worldFromVoxel));
  placeSections(scene);
  return scene;
}

Scene boxScene() { return sceneOf({40, 30, 20}, centredFrame({40, 30, 20}, {1, 2, 3}, 0.0, {100, -50, 20})); }
Scene turnedScene() { return sceneOf({40, 30, 20}, centredFrame({40, 30, 20}, {1, 2, -3}, 0.4, {1e6, 5, 7})); }

bool isInside(const Bounds& b, glm::dvec3 p) {
  return glm::all(glm::greaterThanEqual(p, b.min - 1e-9)) && glm::all(glm::lessThanEqual(p, b.max + 1e-9));
}

}  // namespace

TEST(SectionPlane, PixelsGoToTheWorldAndBack) {
  for (Scene scene : {boxScene(), turnedScene()}) {
    turnSections(scene, SectionKind::Coronal, 0.3);
    scene.sections.axial.pan = {12, -7};
    scene.sections.sagittal.height = 33;
    for (SectionKind kind : kKinds) {
      SectionPlane plane = makeSectionPlane(scene, kind, kSize);
      EXPECT_NEAR(glm::determinant(glm::dmat3(plane.right, plane.up, plane.normal)), 1.0, 1e-12);
      for (glm::dvec2 pixel : {glm::dvec2(0, 0), glm::dvec2(17.25, 180.5), kSize}) {
        glm::dvec3 world = worldFromSectionPixel(plane, pixel);
        EXPECT_LT(glm::length(sectionPixelFromWorld(plane, world) - pixel), 1e-6);
        EXPECT_NEAR(heightOverSection(plane, world), 0.0, 1e-9);
        // A point before the plane has its foot there.
        EXPECT_LT(glm::length(sectionPixelFromWorld(plane, world + plane.normal * 5.0) - pixel), 1e-6);
        EXPECT_NEAR(heightOverSection(plane, world + plane.normal * 5.0), 5.0, 1e-6);
      }
      EXPECT_NEAR(heightOverSection(plane, scene.sections.crosshair), 0.0, 1e-9);
    }
  }
}

TEST(SectionPlane, ViewsAreRadiological) {
  struct {
    SectionKind kind;
    const char *right, *top;
  } const kSides[] = {
      {SectionKind::Axial, "L", "A"}, {SectionKind::Coronal, "L", "S"}, {SectionKind::Sagittal, "P", "S"}};
  Scene scene = boxScene();
  for (auto [kind, right, top] : kSides) {
    SectionPlane plane = makeSectionPlane(scene, kind, kSize);
    EXPECT_EQ(patientLetters(plane.right), right);
    EXPECT_EQ(patientLetters(plane.up), top);
    EXPECT_FALSE(isOblique(scene.sections, kind));
  }
}

TEST(SectionPlane, DirectionsOfAPatientAreThoseThatAFileHasSaid) {
  Scene scene;
  Volume volume = makeVolume({4, 4, 4}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; });
  for (bool known : {true, false}) {
    volume.isOrientationKnown = known;
    scene.volume.data = Shared<Volume>(volume);
    EXPECT_EQ(hasPatientDirections(scene), known);
  }
  // Labels alone, as a TIFF holds them, and placed about a scanner's middle.
  Scene labels;
  glm::dmat4 plain = glm::dmat4(glm::dmat3(0.5));
  labels.labels.data = Shared<LabelVolume>(makeLabels(
      {4, 4, 4}, [](glm::ivec3 v) { return v.x; }, plain));
  EXPECT_FALSE(hasPatientDirections(labels));
  plain[3] = glm::dvec4(-90, -126, -72, 1);
  labels.labels.data = Shared<LabelVolume>(makeLabels(
      {4, 4, 4}, [](glm::ivec3 v) { return v.x; }, plain));
  EXPECT_TRUE(hasPatientDirections(labels));
  // No format of surfaces has them.
  Scene surface;
  surface.surfaces.emplace_back();
  surface.surfaces[0].data = Shared<Mesh>(Mesh{});
  EXPECT_FALSE(hasPatientDirections(surface));
  surface.model.data = Shared<Model>(Model{});
  EXPECT_FALSE(hasPatientDirections(surface));
}

TEST(SectionPlane, LettersNameTheStrongestPartFirst) {
  EXPECT_EQ(patientLetters({0, -1, 0}), "A");
  EXPECT_EQ(patientLetters({0.3, 0, 0.9}), "SL");
  EXPECT_EQ(patientLetters({-0.6, 0.5, -0.62}), "IRP");
  EXPECT_EQ(patientLetters({0.05, 1, 0}), "P");
  EXPECT_EQ(patientLetters({0, 0, 0}), "");
}

TEST(SectionPlane, AllOfTheDataFitsAtFirst) {
  Scene scene = turnedScene();
  Bounds bounds = computeBounds(scene);
  for (glm::dvec2 size : {glm::dvec2(300, 100), glm::dvec2(100, 300)})
    for (SectionKind kind : kKinds) {
      SectionPlane plane = makeSectionPlane(scene, kind, size);
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 share(corner & 1, corner >> 1 & 1, corner >> 2);
        glm::dvec2 pixel = sectionPixelFromWorld(plane, glm::mix(bounds.min, bounds.max, share));
        EXPECT_TRUE(glm::all(glm::greaterThan(pixel, glm::dvec2(0))) && glm::all(glm::lessThan(pixel, size)));
      }
    }
}

TEST(SectionPlane, TheCrosshairBeginsOnAVoxelInTheMiddle) {
  for (const Scene& scene : {boxScene(), turnedScene()}) {
    const Volume& v = *scene.volume.data;
    glm::dvec3 voxel(glm::inverse(v.worldFromVoxel) * glm::dvec4(scene.sections.crosshair, 1));
    // A grid a thousand kilometres away leaves ten digits behind the point to the inverse's sixteen.
    EXPECT_LT(glm::length(voxel - glm::round(voxel)), 1e-6);
    EXPECT_LE(glm::length(voxel - (glm::dvec3(v.dims) - 1.0) * 0.5), 0.9);
  }
}

TEST(SectionPlane, TheMiddleOfAnOddNumberOfVoxelsIsAVoxelHoweverTheFrameRounds) {
  const glm::ivec3 dims(41, 31, 21);
  for (int i = 0; i < 20; ++i) {
    Scene scene = sceneOf(dims, centredFrame(dims, {0.7, 1.1, 3}, 0.1 * i, {13.0 * i, 5, 7}));
    glm::dvec3 voxel(glm::inverse(scene.volume.data->worldFromVoxel) * glm::dvec4(scene.sections.crosshair, 1));
    EXPECT_LT(glm::length(voxel - glm::dvec3(20, 15, 10)), 1e-6) << i;
  }
}

TEST(SectionPlane, ScrollingShowsEachPlaneOnceAndStopsAtTheLast) {
  Scene scene = boxScene();
  struct {
    SectionKind kind;
    int planes;
  } const kRows[] = {{SectionKind::Axial, 20}, {SectionKind::Coronal, 30}, {SectionKind::Sagittal, 40}};
  for (auto [kind, planes] : kRows) {
    scrollSection(scene, kind, -1000);
    auto first = sectionIndex(scene, kind);
    ASSERT_TRUE(first);
    EXPECT_EQ(first->count, planes);
    int way = first->index == 0 ? 1 : -1;
    EXPECT_EQ(first->index, way > 0 ? 0 : planes - 1);
    for (int i = 1; i < planes; ++i) {
      scrollSection(scene, kind, 1);
      EXPECT_EQ(sectionIndex(scene, kind)->index, first->index + way * i);
      EXPECT_TRUE(isInside(computeBounds(scene), scene.sections.crosshair));
    }
    glm::dvec3 last = scene.sections.crosshair;
    scrollSection(scene, kind, 1);
    EXPECT_LT(glm::length(scene.sections.crosshair - last), 1e-9);
  }
}

TEST(SectionPlane, TowardsTheViewerIsTheFeetTheFrontAndTheLeft) {
  Scene scene = boxScene();
  glm::dvec3 before = scene.sections.crosshair;
  for (SectionKind kind : kKinds) scrollSection(scene, kind, 1);
  EXPECT_LT(glm::length(scene.sections.crosshair - before - glm::dvec3(1, -2, -3)), 1e-9);
}

TEST(SectionPlane, AnObliqueScrollStaysOnItsNormalAndInsideTheData) {
  Scene scene = turnedScene();
  turnSections(scene, SectionKind::Axial, 0.5);
  SectionPlane plane = makeSectionPlane(scene, SectionKind::Coronal, kSize);
  glm::dvec3 start = scene.sections.crosshair;
  EXPECT_FALSE(sectionIndex(scene, SectionKind::Coronal));
  EXPECT_TRUE(isOblique(scene.sections, SectionKind::Coronal));
  for (double steps : {3.0, 1000.0, -5000.0}) {
    scrollSection(scene, SectionKind::Coronal, steps);
    glm::dvec3 moved = scene.sections.crosshair - start;
    EXPECT_LT(glm::length(moved - plane.normal * glm::dot(moved, plane.normal)), 1e-6);
    EXPECT_TRUE(isInside(computeBounds(scene), scene.sections.crosshair));
  }
}

TEST(SectionPlane, PlanesOfATiltedGantryAreCountedAlongTheirNormal) {
  glm::dmat4 sheared(1.0);
  sheared[2] = glm::dvec4(0, 1, 2, 0);  // each plane two millimetres higher and one further back
  Scene scene = sceneOf({10, 10, 10}, sheared);
  auto before = sectionIndex(scene, SectionKind::Axial);
  ASSERT_TRUE(before);
  double z = scene.sections.crosshair.z;
  scrollSection(scene, SectionKind::Axial, -1);
  EXPECT_NEAR(scene.sections.crosshair.z, z + 2.0, 1e-9);
  EXPECT_EQ(sectionIndex(scene, SectionKind::Axial)->index, before->index + 1);
}

TEST(SectionPlane, ZoomKeepsThePointUnderThePointer) {
  for (Scene scene : {boxScene(), turnedScene()})
    for (SectionKind kind : kKinds)
      for (double factor : {0.5, 0.9, 1.7}) {
        glm::dvec2 pixel(40, 150);
        SectionPlane before = makeSectionPlane(scene, kind, kSize);
        glm::dvec3 held = worldFromSectionPixel(before, pixel);
        zoomSection(scene, kind, kSize, pixel, factor);
        SectionPlane after = makeSectionPlane(scene, kind, kSize);
        EXPECT_NEAR(after.lengthPerPixel, before.lengthPerPixel * factor, 1e-9);
        EXPECT_LT(glm::length(sectionPixelFromWorld(after, held) - pixel), 1e-5);
      }
}

TEST(SectionPlane, ADragTakesThePictureAlong) {
  Scene scene = boxScene();
  glm::dvec3 held = worldFromSectionPixel(makeSectionPlane(scene, SectionKind::Sagittal, kSize), {100, 100});
  panSection(scene, SectionKind::Sagittal, kSize, {30, -12});
  glm::dvec2 now = sectionPixelFromWorld(makeSectionPlane(scene, SectionKind::Sagittal, kSize), held);
  EXPECT_LT(glm::length(now - glm::dvec2(130, 88)), 1e-9);
}

TEST(SectionPlane, FourQuarterTurnsAreNone) {
  for (SectionKind kind : kKinds) {
    Scene scene = boxScene();
    const Sections before = scene.sections;
    for (int i = 0; i < 4; ++i) {
      turnSections(scene, kind, std::numbers::pi / 2);
      EXPECT_EQ(sectionOf(scene.sections, kind), sectionOf(before, kind));
    }
    for (SectionKind other : kKinds) {
      EXPECT_LT(glm::length(sectionOf(scene.sections, other).normal - sectionOf(before, other).normal), 1e-12);
      EXPECT_LT(glm::length(sectionOf(scene.sections, other).up - sectionOf(before, other).up), 1e-12);
    }
  }
}

TEST(SectionPlane, TurnedSectionsStayAcrossEachOtherAndUpright) {
  Scene scene = boxScene();
  for (int i = 0; i < 50; ++i) turnSections(scene, kKinds[i % 3], 0.1 + 0.01 * i);
  for (SectionKind kind : kKinds) {
    const Section& section = sectionOf(scene.sections, kind);
    EXPECT_NEAR(glm::dot(section.normal, section.up), 0.0, 1e-9) << "what is up turns along";
  }
  const auto& s = scene.sections;
  EXPECT_NEAR(glm::dot(s.axial.normal, s.coronal.normal), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(s.axial.normal, s.sagittal.normal), 0.0, 1e-9);
  EXPECT_NEAR(glm::dot(s.coronal.normal, s.sagittal.normal), 0.0, 1e-9);
  resetSections(scene);
  EXPECT_EQ(scene.sections, boxScene().sections);
}

TEST(SectionPlane, StepsAndMovesKeepTheCrosshairInTheData) {
  Scene scene = boxScene();
  stepCrosshair(scene, SectionKind::Axial, {1, 1});
  EXPECT_LT(glm::length(scene.sections.crosshair - boxScene().sections.crosshair - glm::dvec3(1, -1, 0)), 1e-9);
  stepCrosshair(scene, SectionKind::Axial, {1e6, 1e6});
  EXPECT_TRUE(isInside(computeBounds(scene), scene.sections.crosshair));
  moveCrosshair(scene, {-1e9, 0, 1e9});
  EXPECT_TRUE(isInside(computeBounds(scene), scene.sections.crosshair));
}

TEST(SectionPlane, DegenerateDirectionsAndEmptyScenesStillGiveAFrame) {
  Scene scene;
  scene.sections.axial.normal = scene.sections.axial.up = {0, 0, 0};
  scene.sections.coronal.up = scene.sections.coronal.normal;
  for (SectionKind kind : kKinds) {
    SectionPlane plane = makeSectionPlane(scene, kind, {0, 0});
    EXPECT_NEAR(glm::determinant(glm::dmat3(plane.right, plane.up, plane.normal)), 1.0, 1e-12);
    EXPECT_GT(plane.lengthPerPixel, 0);
    scrollSection(scene, kind, 3);
    EXPECT_TRUE(isInside(computeBounds(scene), scene.sections.crosshair));
  }
}

TEST(SectionPlane, OnlyWhatASectionShowsChangesItsScene) {
  Scene scene = boxScene(), other = scene;
  other.camera.eye.x += 1;
  other.volume.transfer.unitDistance = 2;
  other.sections.crosshair.x += 1;
  EXPECT_EQ(sectionScene(scene), sectionScene(other));
  for (int i = 0; i < 4; ++i) {
    other = scene;
    if (i == 0) setWindow(other.volume, 3, 4);
    if (i == 1) other.cuts.emplace_back();
    if (i == 2) other.sections.interpolate = false;
    if (i == 3) other.labels.structures.push_back({1, "a"});
    EXPECT_NE(sectionScene(scene), sectionScene(other)) << i;
  }
}

}  // namespace velum::scene
