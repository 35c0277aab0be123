#include "session/cut/CutEdit.h"

#include <gtest/gtest.h>

#include "CutScene.h"
#include "scene/Scene.h"
#include "shared/cut.h"

namespace velum::session {

namespace {
const glm::dvec2 kSize(800, 600);
}

TEST(CutEdit, AFrameComesBack) {
  for (glm::dvec3 axis : {glm::dvec3(1, 2, -3), glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0)})
    for (double spin : {0.0, 25.0, -170.0}) {
      scene::Cut cut, copy;
      cut.axis = axis;
      cut.spinDeg = spin;
      setCutFrame(copy, cutFrame(cut));
      EXPECT_NEAR(copy.spinDeg, spin, 1e-9);
      EXPECT_LT(glm::length(copy.axis - glm::normalize(axis)), 1e-9);
    }
}

TEST(CutEdit, ANewCutIsAThirdOfTheDataAndOpensWhatTheEyeSees) {
  scene::Scene scene = boxScene(kSize);
  scene::placeSections(scene);
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 edges = bounds.max - bounds.min;
  for (auto view : {scene::StandardView::Anterior, scene::StandardView::Left, scene::StandardView::Oblique}) {
    scene.camera = scene::frameCamera(scene, view, 4.0 / 3.0);
    scene::Cut box = makeCut(scene, scene::CutShape::Box);
    EXPECT_LT(glm::length(box.size - edges / 3.0), 1e-9);
    glm::dvec3 toEye = glm::normalize(scene.camera.eye - scene.camera.target);
    // Some of the box lies outside of the data on the eye's side, some of it inside.
    glm::dvec3 out = (box.centre - scene.camera.target) / edges;
    double furthest = std::max({std::abs(out.x), std::abs(out.y), std::abs(out.z)});
    EXPECT_GT(furthest + 1.0 / 6.0, 0.5);
    EXPECT_LT(furthest - 1.0 / 6.0, 0.5);
    EXPECT_GT(glm::dot(box.centre - scene.camera.target, toEye), 0.0);
    EXPECT_LT(glm::length(glm::normalize(makeCut(scene, scene::CutShape::Cylinder).axis) - toEye), 1e-6);
  }
}

TEST(CutEdit, ANewCutOpensTheSideThatIsSeenHoweverDeepTheDataAre) {
  scene::Scene scene = boxScene(kSize);  // three times as long as wide
  scene::placeSections(scene);
  scene::Bounds bounds = scene::computeBounds(scene);
  for (auto view : {scene::StandardView::Anterior, scene::StandardView::Left, scene::StandardView::Superior}) {
    scene.camera = scene::frameCamera(scene, view, 1.0);
    glm::dvec3 toEye = glm::normalize(scene.camera.eye - scene.camera.target);
    glm::dvec3 side =
        (bounds.min + bounds.max + toEye * glm::dot(glm::abs(toEye), 0.9 * (bounds.max - bounds.min))) * 0.5;
    for (auto shape : everyClosedShape()) {
      scene::Cut cut = makeCut(scene, shape);
      glm::vec3 local(glm::inverse(scene::worldFromCut(cut)) * glm::dvec4(side, 1.0));
      EXPECT_LT(shared::cutShapeDistance(static_cast<int>(shape), glm::vec3(cut.size * 0.5), local), 0.0f)
          << enumName(shape) << " from " << toEye.x << " " << toEye.y << " " << toEye.z;
    }
  }
}

TEST(CutEdit, AirAboutTheDataHidesNoNewCut) {
  scene::Scene scene = boxScene(kSize);
  Volume volume = *scene.volume.data;
  for (int i = 0; i < 6000; ++i) volume.voxels[std::size_t(i)] = std::byte(i / 10 % 20 >= 12 ? 200 : 0);  // y
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.volume.transfer.opacities = {{100, 0}, {150, 0.8}};
  scene::placeSections(scene);
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, 1.0);  // y grows away from the eye
  scene::Cut ball = makeCut(scene, scene::CutShape::Sphere);
  double skin = 115.0;  // the side of the voxels at 120
  EXPECT_LT(ball.centre.y - ball.size.x * 0.5, skin - 1.0);
  EXPECT_GT(ball.centre.y + ball.size.x * 0.5, skin + 10.0);
}

TEST(CutEdit, ANewCutLiesAboutTheCrosshair) {
  scene::Scene scene = boxScene(kSize);
  scene::placeSections(scene);
  scene.sections.crosshair += glm::dvec3(20, -30, 40);
  for (auto shape : everyShapeButMembranes()) EXPECT_EQ(makeCut(scene, shape).centre, scene.sections.crosshair);
}

TEST(CutEdit, ANewPlaneGoesAcrossAnAxisAndTakesTheSideOfTheEye) {
  scene::Scene scene = boxScene(kSize);
  scene::Cut plane = makeCut(scene, scene::CutShape::Plane);
  EXPECT_EQ(plane.axis, nearestAxis(plane.axis));
  EXPECT_GT(glm::dot(plane.axis, scene.camera.eye - plane.centre), 0.0);
}

TEST(CutEdit, ANewCutIsCalledByItsShapeAndANumberThatIsFree) {
  scene::Scene scene = boxScene(kSize);
  scene.cuts.clear();
  EXPECT_EQ(newCutName(scene, scene::CutShape::Plane), "Plane 1");
  scene.cuts.resize(2);
  scene.cuts[0].name = "Plane 2";
  scene.cuts[1].name = "Plane 3";
  EXPECT_EQ(newCutName(scene, scene::CutShape::Plane), "Plane 4") << "the first one was removed";
  EXPECT_EQ(newCutName(scene, scene::CutShape::Sphere), "Sphere 1") << "the first of its shape";
}

TEST(CutEdit, APlaneThroughThreePointsHoldsThemAndTakesTheSideOfTheEye) {
  scene::Scene scene = boxScene(kSize);
  glm::dvec3 a(10, 20, 30), b(80, 40, 60), c(30, 150, 200);
  for (bool other : {false, true}) {
    auto cut = other ? cutThrough(scene, a, c, b) : cutThrough(scene, a, b, c);
    ASSERT_TRUE(cut);
    for (glm::dvec3 p : {a, b, c}) EXPECT_NEAR(glm::dot(p - cut->centre, cut->axis), 0.0, 1e-9);
    EXPECT_GT(glm::dot(cut->axis, scene.camera.eye - scene.camera.target), 0.0);
  }
  EXPECT_FALSE(cutThrough(scene, a, b, a + (b - a) * 0.5));
  EXPECT_FALSE(cutThrough(scene, a, a, b));
}

TEST(CutEdit, AnglesComeBack) {
  for (glm::dvec3 axis : {glm::dvec3(1, 2, -3), glm::dvec3(0, -1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, -1)})
    EXPECT_LT(glm::length(axisFromAngles(anglesFromAxis(axis)) - glm::normalize(axis)), 1e-9);
  EXPECT_EQ(axisFromAngles({0, 0}), glm::dvec3(0, -1, 0));
  EXPECT_EQ(axisFromAngles({90, 0}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(axisFromAngles({0, 90}), glm::dvec3(0, 0, 1));
  EXPECT_EQ(anglesFromAxis({0, 0, 5}).elevationDeg, 90.0);
}

TEST(CutEdit, AligningKeepsThePlaneOverTheMiddleOfTheData) {
  scene::Scene scene = boxScene(kSize);
  scene::Cut plane = tiltedCut(scene::CutShape::Plane);
  plane.invert = true;
  scene::Cut aligned = alignedCut(scene, plane, {-1, 0, 0});
  EXPECT_EQ(aligned.axis, glm::dvec3(-1, 0, 0));
  EXPECT_FALSE(aligned.invert);
  // The point that stays is the foot of the data's middle on the plane that was.
  EXPECT_NEAR(cutPosition(scene, plane).offset,
              glm::dot(aligned.centre - glm::dvec3(45, 95, 145), glm::normalize(plane.axis)), 1e-9);
}

TEST(CutEdit, AnAlignedMembraneIsAsWideAndHighAsTheDataThere) {
  scene::Scene scene = boxScene(kSize);
  scene::Cut cut = tiltedCut(scene::CutShape::Membrane);
  cut.membrane.emplace();
  scene::Bounds bounds = scene::computeBounds(scene);
  glm::dvec3 edges = bounds.max - bounds.min, middle = (bounds.min + bounds.max) * 0.5;
  for (glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    scene::Cut aligned = alignedCut(scene, cut, axis);
    glm::dmat3 frame = cutFrame(aligned);
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(aligned.size[i], glm::dot(glm::abs(frame[i]), edges), 1e-9) << axis.x << axis.y << axis.z;
    // Its middle lies over that of the data.
    glm::dvec3 off = aligned.centre - (cutPosition(scene, aligned).offset * frame[2] + middle);
    EXPECT_LT(glm::length(off), 1e-9);
  }
}

TEST(CutEdit, SparesStayAscendingAndWithoutRepeats) {
  scene::Cut cut;
  cut.spares = {{9}, {3, 2.5}};
  setSpared(cut, 5, true);
  setSpared(cut, 5, true);
  EXPECT_EQ(cut.spares, (std::vector<scene::Spare>{{3, 2.5}, {5}, {9}}));
  EXPECT_FALSE(isSpared(cut, 3)) << "not all of it";
  setSpared(cut, 3, true);
  EXPECT_TRUE(isSpared(cut, 3));
  setSpared(cut, 3, false);
  setSpared(cut, 4, false);
  EXPECT_EQ(cut.spares, (std::vector<scene::Spare>{{5}, {9}}));
  EXPECT_TRUE(isSpared(cut, 9));
  EXPECT_FALSE(isSpared(cut, 3));
}

}  // namespace velum::session
