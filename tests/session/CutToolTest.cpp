#include "session/cut/CutTool.h"

#include <gtest/gtest.h>

#include "cutShapes.h"
#include "scene/Navigate.h"
#include "scene/Project.h"
#include "shared/cut.h"

namespace velum::session {

namespace {

const glm::dvec2 kCutToolSize(800, 600);

/// A scene that is a box of 100 x 200 x 300 mm, seen from an oblique side.
scene::Scene boundedScene() {
  scene::Scene scene;
  Volume volume;
  volume.dims = {10, 20, 30};
  for (int i = 0; i < 3; ++i) volume.worldFromVoxel[i][i] = 10.0;
  volume.voxels.resize(6000);
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, kCutToolSize.x / kCutToolSize.y);
  return scene;
}

glm::dvec2 pixelOf(const scene::Scene& scene, const CutGizmo& gizmo, CutHandle handle) {
  return scene::pixelFromWorld(scene.camera, kCutToolSize, handlePlace(gizmo, handle)).value();
}

}  // namespace

TEST(CutTool, OutlineLiesInThePlaneAndInTheBox) {
  scene::Scene scene = boundedScene();
  scene::Cut cut;
  cut.centre = {45, 95, 145};
  cut.axis = {1, 2, -3};
  CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
  ASSERT_GE(gizmo.outline.size(), 3u);
  scene::Bounds bounds = scene::computeBounds(scene);
  for (const auto& p : gizmo.outline) {
    EXPECT_NEAR(glm::dot(p - cut.centre, gizmo.normal), 0.0, 1e-9);
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(p[i], bounds.min[i] - 1e-9);
      EXPECT_LE(p[i], bounds.max[i] + 1e-9);
    }
  }
}

TEST(CutTool, EdgesLieOnTheShape) {
  scene::Scene scene = boundedScene();
  for (auto shape : everyClosedShape()) {
    scene::Cut cut;
    cut.shape = shape;
    cut.centre = {45, 95, 145};
    cut.axis = {1, 2, -3};
    cut.size = {30, 20, 50};
    CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
    EXPECT_TRUE(gizmo.outline.empty());
    ASSERT_GE(gizmo.edges.size(), 3u);
    glm::dmat4 cutFromWorld = glm::inverse(scene::worldFromCut(cut));
    glm::vec3 half = glm::vec3(cut.size) * 0.5f;
    for (const auto& edge : gizmo.edges)
      for (const auto& p : edge) {
        glm::vec3 local(cutFromWorld * glm::dvec4(p, 1.0));
        EXPECT_NEAR(shared::cutShapeDistance(static_cast<int>(shape), half, local), 0.0f, 1e-4f) << enumName(shape);
      }
  }
}

TEST(CutTool, EveryHandleIsFoundWhereItIs) {
  scene::Scene scene = boundedScene();
  scene::Cut cut;
  cut.centre = {45, 95, 145};
  cut.axis = {1, 0, 0};
  CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
  for (auto handle :
       {CutHandle::Arrow, CutHandle::KnobRight, CutHandle::KnobTop, CutHandle::KnobLeft, CutHandle::KnobBottom})
    EXPECT_EQ(handleAt(gizmo, scene.camera, kCutToolSize, pixelOf(scene, gizmo, handle), 4.0), handle);
  EXPECT_EQ(handleAt(gizmo, scene.camera, kCutToolSize, {1, 1}, 4.0), CutHandle::None);
}

TEST(CutTool, ArrowFollowsThePointerAlongTheNormal) {
  scene::Scene scene = boundedScene();
  scene::Cut cut;
  cut.centre = {45, 95, 145};
  cut.axis = {1, 0, 0};
  CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
  glm::dvec3 wanted = gizmo.arrowTip + gizmo.normal * 17.0;
  glm::dvec2 to = scene::pixelFromWorld(scene.camera, kCutToolSize, wanted).value();
  scene::Cut moved =
      dragCut(cut, gizmo, CutHandle::Arrow, scene.camera, kCutToolSize, pixelOf(scene, gizmo, CutHandle::Arrow), to);
  EXPECT_NEAR(glm::length(moved.centre - cut.centre - glm::dvec3(17, 0, 0)), 0.0, 1e-6);
  EXPECT_EQ(moved.axis, cut.axis);
}

TEST(CutTool, ArrowSeenEndOnStillMoves) {
  scene::Scene scene = boundedScene();
  scene::Cut cut = cutFacingCamera(scene);
  CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
  scene::Cut moved = dragCut(cut, gizmo, CutHandle::Arrow, scene.camera, kCutToolSize, {400, 300}, {400, 340});
  EXPECT_GT(glm::dot(moved.centre - cut.centre, gizmo.normal), 1.0);
}

TEST(CutTool, KnobTiltsAboutTheMiddleAndComesBack) {
  scene::Scene scene = boundedScene();
  for (glm::dvec3 axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, 1)}) {
    scene::Cut cut;
    cut.centre = {45, 95, 145};
    cut.axis = axis;
    CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
    for (auto handle : {CutHandle::KnobRight, CutHandle::KnobTop, CutHandle::KnobLeft, CutHandle::KnobBottom}) {
      glm::dvec2 from = pixelOf(scene, gizmo, handle);
      glm::dvec2 centre = scene::pixelFromWorld(scene.camera, kCutToolSize, gizmo.centre).value();
      scene::Cut tilted = dragCut(cut, gizmo, handle, scene.camera, kCutToolSize, from, from + (centre - from) * 0.4);
      EXPECT_NEAR(glm::length(tilted.axis), 1.0, 1e-9);
      EXPECT_EQ(tilted.centre, gizmo.centre);
      EXPECT_EQ(dragCut(cut, gizmo, handle, scene.camera, kCutToolSize, from, from), cut);
    }
  }
}

TEST(CutTool, KnobFollowsThePointer) {
  scene::Scene scene = boundedScene();
  scene::Cut cut = cutFacingCamera(scene);
  CutGizmo gizmo = makeCutGizmo(scene, cut, kCutToolSize);
  glm::dvec2 from = pixelOf(scene, gizmo, CutHandle::KnobRight);
  glm::dvec2 centre = scene::pixelFromWorld(scene.camera, kCutToolSize, gizmo.centre).value();
  glm::dvec2 to = centre + (from - centre) * 0.5;
  scene::Cut tilted = dragCut(cut, gizmo, CutHandle::KnobRight, scene.camera, kCutToolSize, from, to);
  // Half way in on a sphere is 60 degrees; perspective takes a little off it.
  EXPECT_NEAR(glm::degrees(std::acos(glm::dot(tilted.axis, cut.axis))), 60.0, 6.0);
}

TEST(CutTool, OffsetComesBack) {
  scene::Scene scene = boundedScene();
  scene::Cut cut;
  cut.axis = {0, 0, -2};
  EXPECT_NEAR(cutPosition(scene, withOffset(scene, cut, 12.5)).offset, 12.5, 1e-9);
  EXPECT_NEAR(cutPosition(scene, cut).reach, 150.0, 1e-9);
}

TEST(CutTool, NewCutTakesTheHalfBeforeTheMiddle) {
  scene::Scene scene = boundedScene();
  scene::Cut cut = cutFacingCamera(scene);
  EXPECT_GT(glm::dot(cut.axis, scene.camera.eye - cut.centre), 0.0);
  EXPECT_NEAR(cutPosition(scene, cut).offset, 0.0, 1e-9);
}

}  // namespace velum::session
