// Pins and kernels under the pointer: where they are set, what a drag makes of them.
#include "session/membrane/SheetHands.h"

#include <gtest/gtest.h>

#include "CutScene.h"
#include "session/cut/CutEdit.h"
#include "sheetShapes.h"

namespace velum::session {

namespace {

const glm::dvec2 kSheetHandsSize(500, 400);

struct Hands {
  scene::Scene scene = boxScene(kSheetHandsSize);
  scene::Cut cut = tiltedCut(scene::CutShape::Membrane);
  membrane::SheetIndex sheet;
  Hands() {
    scene::placeSections(scene);
    cut.membrane->shape = wavySheet({30, 30}, cut.size);
    sheet = membrane::makeSheetIndex(cut.membrane->shape, {30, 30}, cut.size);
    addPin(*cut.membrane, {{40, 90, 140}, {0.4, 0.6}});
    addKernel(*cut.membrane, {50, 100, 150}, 20.0, kKernelStrength);
  }
  scene::SectionPlane section(scene::SectionKind kind) const {
    return scene::makeSectionPlane(scene, kind, kSheetHandsSize);
  }
  glm::dvec2 pixelOf(glm::dvec3 world) const {
    return scene::pixelFromWorld(scene.camera, kSheetHandsSize, world).value();
  }
};
constexpr scene::SectionKind kKinds[] = {scene::SectionKind::Axial, scene::SectionKind::Coronal,
                                         scene::SectionKind::Sagittal};

/// How far a point is from the sheet, and from the part of it that it names, mm.
glm::dvec2 offSheet(const Hands& hands, const SheetPoint& point) {
  auto above = [&](double mm) {
    glm::dvec3 local(glm::inverse(scene::worldFromCut(hands.cut)) * glm::dvec4(point.place, 1.0));
    return membrane::isAbove(hands.sheet, glm::vec3(local) + glm::vec3(0, 0, mm));
  };
  glm::dvec3 local(glm::inverse(scene::worldFromCut(hands.cut)) * glm::dvec4(point.place, 1.0));
  double off = 1e-3;
  while (off < 10 && above(-off) == above(off)) off *= 2;
  return {off, glm::length((point.sheet - 0.5) * glm::dvec2(hands.cut.size) - glm::dvec2(local))};
}

}  // namespace

TEST(SheetHands, AClickInAPictureFindsTheSheetUnderThePointer) {
  Hands hands;
  int found = 0;
  for (int y = 50; y < 350; y += 7)
    for (int x = 50; x < 450; x += 7) {
      auto ray = scene::rayFromPixel(hands.scene.camera, kSheetHandsSize, {x, y});
      auto point = sheetOnRay(hands.cut, hands.sheet, ray);
      if (!point) continue;
      ++found;
      EXPECT_LT(glm::length(hands.pixelOf(point->place) - glm::dvec2(x, y)), 1e-6);
      glm::dvec2 off = offSheet(hands, *point);
      EXPECT_LT(off.x, 0.01);
      EXPECT_LT(off.y, 0.05) << "the wavy sheet's particles stand in rows and columns";
    }
  EXPECT_GT(found, 10);
  EXPECT_FALSE(sheetOnRay(hands.cut, hands.sheet, scene::rayFromPixel(hands.scene.camera, kSheetHandsSize, {2, 2})));
}

TEST(SheetHands, AClickOnTheCurveOfASectionFindsTheSheetThere) {
  Hands hands;
  int found = 0;
  for (auto kind : kKinds) {
    auto frame = hands.section(kind);
    for (int y = 5; y < 400; y += 10)
      for (int x = 5; x < 500; x += 10)
        if (auto point = sheetOnSection(hands.cut, hands.sheet, frame, {x, y}, 9.0)) {
          ++found;
          EXPECT_NEAR(scene::heightOverSection(frame, point->place), 0.0, 1e-9);
          EXPECT_LE(glm::length(scene::sectionPixelFromWorld(frame, point->place) - glm::dvec2(x, y)), 9.0);
          EXPECT_LT(offSheet(hands, *point).x, 0.02);
          EXPECT_LT(offSheet(hands, *point).y, 0.05);
        }
  }
  EXPECT_GT(found, 30);
}

TEST(SheetHands, WhatIsThereIsFoundAndADragBackGivesTheMembraneThatWas) {
  Hands hands;
  const auto& start = *hands.cut.membrane;
  for (Hand hand : {Hand{HandKind::Pin, 0}, Hand{HandKind::Kernel, 0}}) {
    glm::dvec3 place = hand.kind == HandKind::Pin ? start.pins[0].place : start.field.kernels[0].centre;
    glm::dvec2 from = hands.pixelOf(place), to = from + glm::dvec2(23, -9);
    EXPECT_EQ(handAt(start, hands.scene.camera, kSheetHandsSize, from, 2.0), hand);
    scene::Membrane now = dragHand(start, hand, hands.scene.camera, kSheetHandsSize, from, to);
    EXPECT_NE(now, start);
    glm::dvec3 moved = hand.kind == HandKind::Pin ? now.pins[0].place : now.field.kernels[0].centre;
    EXPECT_LT(glm::length(hands.pixelOf(moved) - to), 1e-6) << "it stays under the pointer";
    EXPECT_EQ(dragHand(start, hand, hands.scene.camera, kSheetHandsSize, from, from), start);
    // Along the normal alone where that is asked for.
    glm::dvec3 normal = cutFrame(hands.cut)[2];
    scene::Membrane along = dragHand(start, hand, hands.scene.camera, kSheetHandsSize, from, to, normal);
    glm::dvec3 went = (hand.kind == HandKind::Pin ? along.pins[0].place : along.field.kernels[0].centre) - place;
    EXPECT_GT(glm::length(went), 0.1);
    EXPECT_LT(glm::length(glm::cross(went, normal)), 1e-9);
    auto frame = hands.section(scene::SectionKind::Coronal);
    glm::dvec2 onSection = scene::sectionPixelFromWorld(frame, place);
    scene::Membrane inSection = dragHand(start, hand, frame, onSection, onSection + glm::dvec2(7, 5));
    glm::dvec3 slid = hand.kind == HandKind::Pin ? inSection.pins[0].place : inSection.field.kernels[0].centre;
    EXPECT_NEAR(glm::dot(slid - place, frame.normal), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(slid - place), std::hypot(7, 5) * frame.lengthPerPixel, 1e-9);
  }
}

TEST(SheetHands, APinIsAsHighAboveTheFrameAsIsSaid) {
  Hands hands;
  const Hand pin{HandKind::Pin, 0};
  glm::dvec3 normal = cutFrame(hands.cut)[2], before = hands.cut.membrane->pins[0].place;
  for (double mm : {7.5, -3.0, 0.0}) {
    setPinHeight(hands.cut, pin, mm);
    EXPECT_NEAR(pinHeight(hands.cut, pin), mm, 1e-12);
    glm::dvec3 place = hands.cut.membrane->pins[0].place;
    EXPECT_NEAR(glm::dot(place - hands.cut.centre, normal), mm, 1e-12);
    EXPECT_LT(glm::length(glm::cross(place - before, normal)), 1e-12) << "it moves along the normal";
  }
}

TEST(SheetHands, AKernelOnASectionIsTheCircleThatWasDragged) {
  Hands hands;
  for (auto kind : kKinds) {
    auto frame = hands.section(kind);
    glm::dvec2 from(210, 190), to(240, 230);
    scene::Membrane membrane;
    addKernel(membrane, scene::worldFromSectionPixel(frame, from), radiusOfDrag(frame, from, to), -kKernelStrength);
    const auto& kernel = membrane.field.kernels[0];
    EXPECT_EQ(kernel.strength, -kKernelStrength);
    EXPECT_NEAR(kernel.radius, 50.0 * frame.lengthPerPixel, 1e-9);
    auto circle = circleOnSection(frame, kernel);
    ASSERT_TRUE(circle);
    EXPECT_LT(glm::length(circle->middle - from), 1e-9);
    EXPECT_NEAR(circle->radius, 50.0, 1e-9);
    EXPECT_EQ(handAt(membrane, frame, to, 3.0), (Hand{HandKind::Rim, 0}));
    EXPECT_EQ(handAt(membrane, frame, from, 3.0), (Hand{HandKind::Kernel, 0}));
    // Its rim follows the pointer off the middle, too.
    auto beside = frame;
    beside.centre += frame.normal * (0.5 * kernel.radius);
    auto before = circleOnSection(beside, kernel);
    ASSERT_TRUE(before);
    glm::dvec2 rim = before->middle + glm::dvec2(before->radius, 0), out = rim + glm::dvec2(12, 0);
    scene::Membrane larger = dragHand(membrane, {HandKind::Rim, 0}, beside, rim, out);
    EXPECT_NEAR(circleOnSection(beside, larger.field.kernels[0])->radius, before->radius + 12, 1e-9);
    EXPECT_EQ(larger.field.kernels[0].centre, kernel.centre);
    EXPECT_EQ(dragHand(membrane, {HandKind::Rim, 0}, beside, rim, rim), membrane);
    beside.centre += frame.normal * (0.6 * kernel.radius);
    EXPECT_FALSE(circleOnSection(beside, kernel));
  }
}

TEST(SheetHands, TheRimOfAKernelInAPictureFollowsThePointer) {
  Hands hands;
  const auto& start = *hands.cut.membrane;
  const auto& kernel = start.field.kernels[0];
  glm::dvec3 right = scene::cameraBasis(hands.scene.camera).right;
  glm::dvec2 from = hands.pixelOf(kernel.centre + right * 20.0), to = hands.pixelOf(kernel.centre + right * 33.0);
  EXPECT_EQ(handAt(start, hands.scene.camera, kSheetHandsSize, from, 6.0), (Hand{HandKind::Rim, 0}));
  scene::Membrane now = dragHand(start, {HandKind::Rim, 0}, hands.scene.camera, kSheetHandsSize, from, to);
  EXPECT_NEAR(now.field.kernels[0].radius, 33.0, 1e-6);
  EXPECT_NEAR(radiusOfDrag(hands.scene.camera, kSheetHandsSize, kernel.centre, to), 33.0, 1e-6);
}

TEST(SheetHands, RemovingAndTurningTouchOnlyTheOne) {
  Hands hands;
  scene::Membrane membrane = *hands.cut.membrane;
  Hand second = addKernel(membrane, {0, 0, 0}, 5.0, -100.0);
  turnKernel(membrane, second);
  EXPECT_EQ(membrane.field.kernels[1].strength, 100.0);
  EXPECT_EQ(membrane.field.kernels[0].strength, kKernelStrength);
  removeHand(membrane, second);
  EXPECT_EQ(membrane, *hands.cut.membrane);
  removeHand(membrane, second);  // it is gone
  EXPECT_EQ(membrane, *hands.cut.membrane);
  removeHand(membrane, {HandKind::Pin, 0});
  EXPECT_TRUE(membrane.pins.empty());
}

TEST(SheetHands, APinIsOverThePlaceAlongTheNormal) {
  scene::Cut cut = tiltedCut(scene::CutShape::Membrane);
  glm::dmat4 world = scene::worldFromCut(cut);
  auto pin = pinOver(cut, glm::dvec3(world * glm::dvec4(15, -10, 7, 1)));
  ASSERT_TRUE(pin);
  EXPECT_LT(glm::length(pin->sheet - glm::dvec2(0.75, 0.25)), 1e-12);
  EXPECT_FALSE(pinOver(cut, glm::dvec3(world * glm::dvec4(31, 0, 0, 1))));
}

}  // namespace velum::session
