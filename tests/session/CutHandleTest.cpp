// Handles of closed shapes: every one of them, in both projections, from several sides.
#include <gtest/gtest.h>

#include "CutScene.h"
#include "scene/Navigate.h"
#include "scene/Project.h"
#include "session/cut/CutTool.h"

namespace velum::session {

namespace {

const glm::dvec2 kCutHandleSize(800, 600);

std::vector<scene::Scene> manyViews() {
  std::vector<scene::Scene> scenes;
  for (auto view : {scene::StandardView::Anterior, scene::StandardView::Oblique, scene::StandardView::Inferior})
    for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
      scene::Scene scene = boxScene(kCutHandleSize);
      scene.camera = scene::frameCamera(scene, view, kCutHandleSize.x / kCutHandleSize.y);
      scene.camera.projection = projection;
      scene.camera = scene::roll(scene::orbit(scene.camera, {0.07, -0.04}), 0.3);
      scenes.push_back(scene);
    }
  return scenes;
}

glm::dvec2 pixelOf(const scene::Scene& scene, glm::dvec3 world) {
  return scene::pixelFromWorld(scene.camera, kCutHandleSize, world).value();
}

bool isResize(CutHandle handle) { return handle >= CutHandle::FaceXMin; }

double frameDifference(const scene::Cut& a, const scene::Cut& b) {
  glm::dmat3 difference = cutFrame(a) - cutFrame(b);
  double most = 0;
  for (int i = 0; i < 3; ++i) most = std::max(most, glm::length(difference[i]));
  return most;
}

}  // namespace

TEST(CutHandle, EveryGripIsFoundWhereItIs) {
  for (const auto& scene : manyViews())
    for (auto shape : everyCutShape()) {
      CutGizmo gizmo = makeCutGizmo(scene, tiltedCut(shape), kCutHandleSize);
      for (const auto& grip : gizmo.grips)
        EXPECT_EQ(handleAt(gizmo, scene.camera, kCutHandleSize, pixelOf(scene, grip.place), 0.5), grip.handle)
            << enumName(shape);
    }
}

TEST(CutHandle, AMembranesReachGrowsToBothSidesOfItsRestPlane) {
  scene::Scene scene = boxScene(kCutHandleSize);
  scene::Cut start = tiltedCut(scene::CutShape::Membrane);
  CutGizmo gizmo = makeCutGizmo(scene, start, kCutHandleSize);
  int found = 0;
  for (const auto& grip : gizmo.grips) {
    if (grip.handle != CutHandle::FaceZMin && grip.handle != CutHandle::FaceZMax) continue;
    ++found;
    EXPECT_NEAR(glm::length(grip.place - start.centre), 0.5 * start.size.z, 1e-9);
    scene::Cut now = withFaceMoved(start, 2, grip.handle == CutHandle::FaceZMax ? 1 : -1, 3.0, 1.0);
    EXPECT_EQ(now.centre, start.centre);
    EXPECT_NEAR(now.size.z, start.size.z + 6.0, 1e-12);
    EXPECT_NE(dragText(scene::lengthFormat(scene), start, now, grip.handle).find("\u00b1"), std::string::npos);
  }
  EXPECT_EQ(found, 2);
  // And is drawn as a box: its twelve edges beside the rest plane.
  scene::Cut box = start;
  box.shape = scene::CutShape::Box;
  EXPECT_EQ(gizmo.edges.size(), 1 + makeCutGizmo(scene, box, kCutHandleSize).edges.size());
}

TEST(CutHandle, AHandleStaysUnderThePointer) {
  int asked = 0;
  for (const auto& scene : manyViews())
    for (auto shape : everyCutShape()) {
      scene::Cut start = tiltedCut(shape);
      CutGizmo gizmo = makeCutGizmo(scene, start, kCutHandleSize);
      for (const auto& grip : gizmo.grips) {
        bool isArrow = grip.handle == CutHandle::Arrow;
        bool isFree = grip.handle == CutHandle::Centre || grip.handle == CutHandle::Square;
        if (!isArrow && !isFree && !isResize(grip.handle)) continue;
        // Along its line where it has one; anywhere where it is free.
        glm::dvec2 from = pixelOf(scene, grip.place);
        ++asked;
        glm::dvec2 to = isFree ? from + glm::dvec2(31, -17) : pixelOf(scene, grip.place + grip.direction * 11.0);
        scene::Cut now = dragCut(start, gizmo, grip.handle, scene.camera, kCutHandleSize, from, to);
        glm::dvec3 place = isResize(grip.handle) ? handlePlace(makeCutGizmo(scene, now, kCutHandleSize), grip.handle)
                                                 : grip.place + (now.centre - start.centre);
        EXPECT_LT(glm::length(pixelOf(scene, place) - to), 0.01)
            << enumName(shape) << " handle " << static_cast<int>(grip.handle);
      }
    }
  EXPECT_GT(asked, 40);
}

TEST(CutHandle, GoingBackGivesTheCutThatWas) {
  for (const auto& scene : manyViews())
    for (auto shape : everyCutShape()) {
      scene::Cut start = tiltedCut(shape);
      CutGizmo gizmo = makeCutGizmo(scene, start, kCutHandleSize);
      for (const auto& grip : gizmo.grips) {
        glm::dvec2 from = pixelOf(scene, grip.place), to = from + glm::dvec2(23, 14);
        scene::Cut moved = dragCut(start, gizmo, grip.handle, scene.camera, kCutHandleSize, from, to);
        EXPECT_NE(moved, start) << enumName(shape) << " handle " << static_cast<int>(grip.handle);
        EXPECT_EQ(dragCut(start, gizmo, grip.handle, scene.camera, kCutHandleSize, from, from), start);
      }
    }
}

TEST(CutHandle, ASecondDragTakesAResizeBack) {
  int asked = 0;
  for (const auto& scene : manyViews())
    for (auto shape : everyCutShape()) {
      scene::Cut start = tiltedCut(shape);
      CutGizmo gizmo = makeCutGizmo(scene, start, kCutHandleSize);
      for (const auto& grip : gizmo.grips) {
        if (!isResize(grip.handle)) continue;
        ++asked;
        glm::dvec2 from = pixelOf(scene, grip.place), to = pixelOf(scene, grip.place + grip.direction * 8.0);
        scene::Cut larger = dragCut(start, gizmo, grip.handle, scene.camera, kCutHandleSize, from, to);
        CutGizmo second = makeCutGizmo(scene, larger, kCutHandleSize);
        scene::Cut back = dragCut(larger, second, grip.handle, scene.camera, kCutHandleSize, to, from);
        EXPECT_LT(glm::length(back.size - start.size), 1e-6) << enumName(shape);
        EXPECT_LT(glm::length(back.centre - start.centre), 1e-6) << enumName(shape);
      }
    }
  EXPECT_GT(asked, 20);
}

TEST(CutHandle, ResizingAFaceLeavesTheOppositeOneWhereItIs) {
  scene::Scene scene = boxScene(kCutHandleSize);
  for (auto shape : {scene::CutShape::Box, scene::CutShape::Cylinder, scene::CutShape::Cone}) {
    scene::Cut start = tiltedCut(shape);
    auto faceMm = [&](const scene::Cut& cut, int axis, int sign) {
      glm::dvec3 out = cutFrame(cut)[axis];
      if (shape == scene::CutShape::Cone) return cut.centre + out * (sign > 0 ? cut.size.z : 0.0);
      return cut.centre + out * (sign * cut.size[axis] * 0.5);
    };
    for (int axis = shape == scene::CutShape::Box ? 0 : 2; axis < 3; ++axis)
      for (int sign : {-1, 1})
        for (double mm : {12.0, -12.0, -1000.0}) {
          scene::Cut now = withFaceMoved(start, axis, sign, mm, 1.0);
          EXPECT_LT(glm::length(faceMm(now, axis, -sign) - faceMm(start, axis, -sign)), 1e-9);
          double moved = glm::dot(faceMm(now, axis, sign) - faceMm(start, axis, sign), cutFrame(start)[axis]) * sign;
          EXPECT_NEAR(moved, std::max(mm, 1.0 - start.size[axis]), 1e-9);
          EXPECT_LT(frameDifference(now, start), 1e-12);
        }
  }
}

TEST(CutHandle, ACornerResizesBothEdgesAndTheOppositeOneStays) {
  int corners = 0;
  for (const auto& scene : manyViews())
    for (bool keepsRatio : {false, true}) {
      scene::Cut start = tiltedCut(scene::CutShape::Membrane);
      CutGizmo gizmo = makeCutGizmo(scene, start, kCutHandleSize);
      auto placeOf = [](const scene::Cut& cut, glm::dvec2 sign) {
        glm::dvec2 out = sign * glm::dvec2(cut.size) * 0.5;
        return glm::dvec3(scene::worldFromCut(cut) * glm::dvec4(out, 0.0, 1.0));
      };
      for (int corner = 0; corner < 4; ++corner) {
        auto handle = static_cast<CutHandle>(static_cast<int>(CutHandle::CornerMinMin) + corner);
        glm::dvec2 from = pixelOf(scene, handlePlace(gizmo, handle)), to = from + glm::dvec2(19, -11);
        CutSnap snap{keepsRatio, glm::dmat3(10.0)};
        scene::Cut now = dragCut(start, gizmo, handle, scene.camera, kCutHandleSize, from, to, snap);
        if (now == start) continue;  // seen edge on: there is no such grip
        ++corners;
        glm::dvec2 sign = cornerSigns(corner);
        EXPECT_LT(glm::length(placeOf(now, -sign) - placeOf(start, -sign)), 1e-9);
        EXPECT_EQ(now.size.z, start.size.z);
        if (keepsRatio)
          EXPECT_NEAR(now.size.x / now.size.y, start.size.x / start.size.y, 1e-9);
        else
          EXPECT_LT(glm::length(pixelOf(scene, placeOf(now, sign)) - to), 0.01) << "it stays under the pointer";
      }
    }
  EXPECT_GT(corners, 30);
}

TEST(CutHandle, ATurnOfABoxIsRigid) {
  // A tilt carries the box's edges along, whatever the frame's own rule makes of the new axis.
  scene::Cut box = tiltedCut(scene::CutShape::Box);
  glm::dvec3 pivot(10, 20, 30), axis = glm::normalize(glm::dvec3(3, -1, 2));
  scene::Cut turned = withTurn(box, pivot, axis, 1.1);
  scene::Cut back = withTurn(turned, pivot, axis, -1.1);
  EXPECT_LT(frameDifference(back, box), 1e-9);
  EXPECT_LT(glm::length(back.centre - box.centre), 1e-9);
  EXPECT_NEAR(glm::length(turned.centre - pivot), glm::length(box.centre - pivot), 1e-9);
  glm::dmat3 relative = cutFrame(turned) * glm::transpose(cutFrame(box));
  EXPECT_LT(glm::length(relative * axis - axis), 1e-9);
}

TEST(CutHandle, TheRingTurnsABoxAboutItsAxisWithThePointer) {
  scene::Scene scene = boxScene(kCutHandleSize);
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, kCutHandleSize.x / kCutHandleSize.y);
  scene::Cut box;
  box.shape = scene::CutShape::Box;
  box.centre = scene.camera.target;
  box.axis = {0, -1, 0};
  CutGizmo gizmo = makeCutGizmo(scene, box, kCutHandleSize);
  glm::dvec2 centre = pixelOf(scene, gizmo.centre);
  double r = gizmo.radius / gizmo.pixel;
  auto onRing = [&](double deg) {
    return centre + r * glm::dvec2(std::cos(glm::radians(deg)), -std::sin(glm::radians(deg)));
  };
  ASSERT_EQ(handleAt(gizmo, scene.camera, kCutHandleSize, onRing(45), 8.0), CutHandle::Ring);
  scene::Cut turned = dragCut(box, gizmo, CutHandle::Ring, scene.camera, kCutHandleSize, onRing(45), onRing(82));
  EXPECT_LT(glm::length(turned.axis - box.axis), 1e-9);
  // Seen from the front, the world's up of the box turns with the pointer, anticlockwise.
  glm::dmat3 relative = cutFrame(turned) * glm::transpose(cutFrame(box));
  glm::dvec3 up = relative * glm::dvec3(0, 0, 1);
  EXPECT_NEAR(glm::degrees(std::atan2(-up.x, up.z)), 37.0, 0.01);
  CutSnap snap = makeCutSnap(scene, true);
  scene::Cut stepped = dragCut(box, gizmo, CutHandle::Ring, scene.camera, kCutHandleSize, onRing(45), onRing(82), snap);
  up = cutFrame(stepped) * glm::transpose(cutFrame(box)) * glm::dvec3(0, 0, 1);
  EXPECT_NEAR(glm::degrees(std::atan2(-up.x, up.z)), 30.0, 1e-6);
}

TEST(CutHandle, TheRingOfTheOthersFollowsThePointer) {
  for (const auto& scene : manyViews()) {
    scene::Cut cut = tiltedCut(scene::CutShape::Cylinder);
    CutGizmo gizmo = makeCutGizmo(scene, cut, kCutHandleSize);
    glm::dvec3 held = ringPoints(gizmo)[9];
    glm::dvec2 from = pixelOf(scene, held), to = from + (pixelOf(scene, gizmo.centre) - from) * 0.3;
    scene::Cut now = dragCut(cut, gizmo, CutHandle::Ring, scene.camera, kCutHandleSize, from, to);
    // The pointer goes to the middle: the axis tilts by the angle between the two places on the ball.
    double tilt = std::acos(glm::dot(glm::normalize(cut.axis), now.axis));
    EXPECT_GT(tilt, 0.01);
    EXPECT_LT(tilt, 1.2);
  }
}

TEST(CutHandle, ShiftKeepsToWholeVoxels) {
  for (const auto& scene : manyViews()) {
    CutSnap snap = makeCutSnap(scene, true);
    scene::Cut box = tiltedCut(scene::CutShape::Box);
    box.axis = {0, 0, 1};
    box.spinDeg = 0;
    CutGizmo gizmo = makeCutGizmo(scene, box, kCutHandleSize);
    for (const auto& grip : gizmo.grips) {
      if (grip.handle >= CutHandle::KnobRight && grip.handle <= CutHandle::Ring) continue;
      if (grip.handle == CutHandle::Square) continue;  // keeps to the gizmo's own axes
      glm::dvec2 from = pixelOf(scene, grip.place);
      scene::Cut now =
          dragCut(box, gizmo, grip.handle, scene.camera, kCutHandleSize, from, from + glm::dvec2(14, 11), snap);
      glm::dvec3 moved = isResize(grip.handle) ? now.size - box.size : now.centre - box.centre;
      for (int i = 0; i < 3; ++i) EXPECT_NEAR(std::remainder(moved[i], 10.0), 0.0, 1e-9);
    }
  }
}

TEST(CutHandle, NumbersSayWhatTheDragDid) {
  scene::Cut start = tiltedCut(scene::CutShape::Box), now = start;
  now.centre += cutFrame(start)[2] * 12.5;
  EXPECT_EQ(dragText({}, start, now, CutHandle::Arrow), "+12.5 mm");
  EXPECT_EQ(dragText({}, start, now, CutHandle::Centre), "12.5 mm");
  now = withFaceMoved(start, 1, 1, 2.0, 1.0);
  EXPECT_EQ(dragText({}, start, now, CutHandle::FaceYMax), "42.0 mm");
  now = withTurn(start, start.centre, cutFrame(start)[2], glm::radians(30.0));
  EXPECT_EQ(dragText({}, start, now, CutHandle::Ring), "30.0\u00b0");
  EXPECT_EQ(std::string(dragLabel(start, CutHandle::Ring)), "Turn cut");
  EXPECT_EQ(std::string(dragLabel(start, CutHandle::KnobTop)), "Tilt cut");
  EXPECT_EQ(std::string(dragLabel(start, CutHandle::Radius)), "Resize cut");
  EXPECT_EQ(std::string(dragLabel(start, CutHandle::Square)), "Move cut");
}

}  // namespace velum::session
