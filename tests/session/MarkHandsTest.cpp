// How marks stand in views, what of them can be taken hold of, and what a drag makes of them.
#include "session/mark/MarkHands.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "session/lettering/Lettering.h"
#include "session/mark/MarkWords.h"
#include "session/measure/Follow.h"

namespace velum::session {
namespace {

using scene::Mark, scene::MarkKind;

/// A section across z at 10, of half a millimetre a pixel, y down on the screen.
scene::SectionPlane planeAt(double z) {
  scene::SectionPlane plane;
  plane.centre = {0, 0, z};
  plane.right = {1, 0, 0}, plane.up = {0, -1, 0}, plane.normal = {0, 0, -1};
  plane.size = {400, 300};
  plane.lengthPerPixel = 0.5;
  return plane;
}

Mark distance(glm::dvec3 a, glm::dvec3 b, int id = 1) {
  return {.id = id, .kind = MarkKind::Distance, .points = {a, b}};
}

TEST(MarkHands, AMarkFadesASectionAwayAndIsWholeWhereItLies) {
  Mark mark = distance({0, 0, 10}, {5, 0, 12});
  auto share = [&](double z) { return markShare(ViewSpace(planeAt(z)), mark, 2.0); };
  EXPECT_EQ(share(10), 1.0);
  EXPECT_EQ(share(11), 1.0) << "it goes through this one";
  EXPECT_EQ(share(13), 1.0) << "half a step away";
  EXPECT_DOUBLE_EQ(share(14), 0.5) << "a step away";
  EXPECT_DOUBLE_EQ(share(8), 0.5);
  EXPECT_EQ(share(15), 0.0);
  EXPECT_DOUBLE_EQ(pointShare(ViewSpace(planeAt(12)), mark, 0, 2.0), 0.5) << "its far end alone";
  EXPECT_EQ(markShare(ViewSpace(scene::Camera(), {400, 300}), mark, 2.0), 1.0) << "the picture shows all";
  Mark ball{.kind = MarkKind::Circle, .points = {{0, 0, 10}, {20, 0, 10}}};
  EXPECT_EQ(markShare(ViewSpace(planeAt(29)), ball, 2.0), 1.0) << "the ball reaches there";
  EXPECT_EQ(markShare(ViewSpace(planeAt(34)), ball, 2.0), 0.0);
}

TEST(MarkHands, ALineThatGoesThroughASectionIsSeenThereNoFartherThanMarksAre) {
  // From 30 before the section to 50 behind it, over 80 to the right: a unit to the right a unit deeper.
  Mark mark = distance({-30, 0, -20}, {50, 0, 60});
  ViewSpace view(planeAt(10));
  EXPECT_TRUE(goesThrough(view, mark, 2.0));
  auto lines = markLines(view, mark, 2.0);
  ASSERT_EQ(lines.size(), 1u);
  ASSERT_EQ(lines[0].size(), 2u);
  auto pixelAt = [&](double x) { return scene::sectionPixelFromWorld(planeAt(10), {x, 0, 10}); };
  EXPECT_NEAR(glm::distance(lines[0][0], pixelAt(-3)), 0.0, 1e-9) << "one step and a half before it";
  EXPECT_NEAR(glm::distance(lines[0][1], pixelAt(3)), 0.0, 1e-9);
  EXPECT_EQ(markLines(ViewSpace(scene::Camera(), {400, 300}), mark, 2.0)[0].size(), 2u) << "the picture shows all";
  scene::Scene scene;
  scene.lettering.marks = {mark};
  auto part = [&](double x) { return markAt(scene, view, pixelAt(x), {.step = 2.0}).part; };
  EXPECT_EQ(part(1), MarkPart::Line);
  EXPECT_EQ(part(40), MarkPart::None) << "what is not drawn is not taken";
  // A path that comes back is there twice; what lies in the section is whole.
  mark.kind = MarkKind::Path;
  mark.points.push_back({80, 0, -20});
  EXPECT_EQ(markLines(view, mark, 2.0).size(), 2u);
  Mark flat = distance({-30, 5, 10}, {50, 5, 12});
  EXPECT_FALSE(goesThrough(view, flat, 2.0));
  EXPECT_EQ(markLines(view, flat, 2.0)[0].front(), *view.pixelFromWorld(flat.points[0]));
  EXPECT_TRUE(markLines(ViewSpace(planeAt(100)), mark, 2.0).empty());
}

TEST(MarkHands, TheNearestPointWithinReachIsTaken) {
  ViewSpace view(planeAt(10));
  scene::Scene scene;
  std::vector<Mark>& marks = scene.lettering.marks;
  marks = {distance({0, 0, 10}, {50, 0, 10}), distance({2, 0, 10}, {0, 40, 10}, 2)};
  auto at = [&](glm::dvec3 world, MarkReach reach = {}) {
    return markAt(scene, view, scene::sectionPixelFromWorld(planeAt(10), world), reach);
  };
  EXPECT_EQ(at({0.5, 0, 10}), (MarkGrip{MarkPart::Point, 1, 0}));
  EXPECT_EQ(at({1.6, 0, 10}), (MarkGrip{MarkPart::Point, 2, 0}));
  EXPECT_EQ(at({1.6, 0, 10}, {.selected = 1}), (MarkGrip{MarkPart::Point, 1, 0})) << "the selected one's first";
  EXPECT_EQ(at({50, 4, 10}), (MarkGrip{MarkPart::Point, 1, 1}));
  EXPECT_EQ(at({50, 6, 10}).part, MarkPart::None) << "out of reach";
  EXPECT_EQ(at({30, 1, 10}), (MarkGrip{MarkPart::Line, 1, 0}));
  EXPECT_EQ(at({30, 3, 10}).part, MarkPart::None);
  marks[1].visible = false;
  EXPECT_EQ(at({1.6, 0, 10}), (MarkGrip{MarkPart::Point, 1, 0}));
  marks[0].timeStep = 3;
  EXPECT_EQ(at({1.6, 0, 10}).part, MarkPart::None) << "it is of another time";
  scene.volume.timeStep = 3;
  EXPECT_EQ(at({1.6, 0, 10}), (MarkGrip{MarkPart::Point, 1, 0}));
  view = ViewSpace(planeAt(13));
  EXPECT_EQ(at({0, 0, 10}).part, MarkPart::None) << "what a section does not show is not taken there";
}

TEST(MarkHands, WordsAreTakenWhereTheyStandAndGoAsFarAsTheHand) {
  ViewSpace view(planeAt(10));
  scene::Scene scene;
  scene.lettering.marks = {distance({0, 0, 10}, {50, 0, 10})};
  auto wordsOf = [&] { return layMarks(scene, view, {}).words.at(0); };
  for (auto wordsAt : {std::optional<glm::dvec2>(), std::optional(glm::dvec2(0.2, -0.1))}) {
    scene.lettering.marks[0].wordsAt = wordsAt;
    PlacedWords words = wordsOf();
    std::vector<PlacedWords> all{words};
    MarkReach reach;
    reach.words = all;
    glm::dvec2 middle = 0.5 * (words.low + words.high);
    EXPECT_EQ(markAt(scene, view, middle, reach), (MarkGrip{MarkPart::Words, 1, 0}));
    EXPECT_EQ(markAt(scene, view, words.low - glm::dvec2(15, 25), reach).part, MarkPart::None);
    scene.lettering.marks[0] = withWordsBy(scene.lettering.marks[0], words, {12, -34}, view);
    PlacedWords after = wordsOf();
    EXPECT_NEAR(glm::distance(0.5 * (after.low + after.high), middle + glm::dvec2(12, -34)), 0.0, 1e-9);
  }
}

TEST(MarkHands, ADraggedPointMovesAloneButACircleGoesWithItsMiddle) {
  ViewSpace view(planeAt(10));
  Mark line = withPointAt(distance({0, 0, 10}, {50, 0, 10}), 1, {7, 8, 10}, view);
  EXPECT_EQ(line.points, (std::vector<glm::dvec3>{{0, 0, 10}, {7, 8, 10}}));
  Mark circle{.kind = MarkKind::Circle, .points = {{0, 0, 10}, {5, 0, 10}}};
  EXPECT_EQ(withPointAt(circle, 0, {1, 2, 10}, view).points[1], glm::dvec3(6, 2, 10));
  EXPECT_EQ(withPointAt(circle, 1, {9, 0, 10}, view).points[0], glm::dvec3(0, 0, 10));
  Mark box{.kind = MarkKind::Box, .points = {{0, 0, 9}, {5, 5, 14}}};
  EXPECT_EQ(withPointAt(box, 1, {8, 9, 10}, view).points[1], glm::dvec3(8, 9, 14)) << "its thickness stays";
  Mark bound = distance({0, 0, 10}, {50, 0, 10});
  bound.pointInstances = {12};
  bound.pointStructures = {0, 3};
  Mark moved = withPointAt(bound, 1, {0, 0, 0}, view);
  EXPECT_EQ(moved.pointInstances, std::vector<int>{12});
  EXPECT_EQ(moved.pointStructures, std::vector<int>()) << "it is no more the structure's middle";
  EXPECT_TRUE(isFollowing(moved));
  EXPECT_EQ(withPointAt(bound, 0, {0, 0, 0}, view).pointInstances, std::vector<int>());
  EXPECT_EQ(withPointAt(bound, 0, {0, 0, 0}, view).pointStructures, (std::vector<int>{0, 3}));
  EXPECT_FALSE(isFollowing(withPointAt(moved, 0, {0, 0, 0}, view))) << "of both points nothing is left";
  EXPECT_EQ(withPointAt(bound, 1, {0, 0, 0}, view, 5).pointInstances, (std::vector<int>{12, 5}));
}

TEST(MarkHands, ABoxDrawnOnASectionIsAStepThick) {
  Mark box = markOfClicks(MarkKind::Box, {{0, 0, 10}, {5, 7, 10}}, ViewSpace(planeAt(10)), 2.0);
  EXPECT_DOUBLE_EQ(std::abs(box.points[0].z - box.points[1].z), 2.0);
  EXPECT_DOUBLE_EQ(box.points[0].z + box.points[1].z, 20.0);
  Mark deep = markOfClicks(MarkKind::Box, {{0, 0, 3}, {5, 7, 10}}, ViewSpace(planeAt(10)), 2.0);
  EXPECT_EQ(deep.points[0].z, 3.0) << "one from two sections is as thick as it was drawn";
}

}  // namespace
}  // namespace velum::session
