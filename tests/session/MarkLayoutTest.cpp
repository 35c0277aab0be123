// Marks as they are drawn: where their lines go, and what stands beside them.
#include "session/lettering/MarkLayout.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "makeVolume.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "session/lettering/Lettering.h"

namespace velum::session {

namespace {

using scene::Mark;
using scene::MarkKind;

constexpr glm::ivec2 kMarkedSize(800, 600);

/// A cube of 40 mm with values that rise along x, seen obliquely.
scene::Scene markedCube(std::vector<Mark> marks) {
  scene::Scene scene;
  Volume volume = makeVolume({40, 40, 40}, SampleType::UInt8, [](glm::ivec3 v) { return 5 * v.x; });
  volume.isSpacingKnown = true;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, 4.0 / 3.0);
  scene.sections.crosshair = {20, 20, 20};
  scene.sections.isPlaced = true;
  for (Mark& mark : marks) scene::addMark(scene.lettering.marks, std::move(mark));
  return scene;
}

/// All points of the lines of a lettering.
std::vector<glm::dvec2> pointsOf(const LaidLettering& laid) {
  std::vector<glm::dvec2> points;
  for (const LetteringBlock& block : laid.blocks)
    for (const vector::Item& item : block.items)
      if (const auto* shape = std::get_if<vector::Shape>(&item))
        for (const vector::Outline& outline : shape->outlines) {
          points.push_back(outline.start);
          for (const vector::Curve& curve : outline.curves) points.push_back(curve.end);
        }
  return points;
}
double nearest(const std::vector<glm::dvec2>& points, glm::dvec2 to) {
  double least = 1e9;
  for (glm::dvec2 point : points) least = std::min(least, glm::distance(point, to));
  return least;
}
std::set<std::string> textsOf(const LaidLettering& laid) {
  std::set<std::string> texts;
  for (const LetteringBlock& block : laid.blocks)
    for (const vector::Item& item : block.items)
      if (const auto* words = std::get_if<vector::Words>(&item)) texts.insert(words->text);
  return texts;
}
LaidLettering laidOf(const scene::Scene& scene) {
  Progress progress;
  return layLettering(scene, kMarkedSize, {{}, measuredMarks(scene, progress), {}});
}

}  // namespace

TEST(MarkLayout, LinesGoThroughThePlacesOfAMarkInBothProjections) {
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic})
    for (const Mark& mark : {Mark{.kind = MarkKind::Distance, .points = {{3, 4, 5}, {30, 33, 20}}},
                             Mark{.kind = MarkKind::Angle, .points = {{3, 4, 5}, {20, 20, 20}, {5, 35, 30}}},
                             Mark{.kind = MarkKind::Path, .points = {{3, 4, 5}, {20, 20, 20}, {5, 35, 30}, {9, 9, 9}}},
                             Mark{.kind = MarkKind::Area, .points = {{3, 4, 5}, {20, 20, 20}, {5, 35, 30}}},
                             Mark{.kind = MarkKind::Arrow, .points = {{3, 4, 5}, {30, 33, 20}}, .text = "there"}}) {
      scene::Scene scene = markedCube({mark});
      scene.camera.projection = projection;
      std::vector<glm::dvec2> points = pointsOf(laidOf(scene));
      for (const glm::dvec3& place : mark.points)
        EXPECT_LT(nearest(points, *scene::pixelFromWorld(scene.camera, kMarkedSize, place)), 1e-6)
            << enumName(mark.kind);
    }
}

TEST(MarkLayout, BesideAMarkStandsWhatItMeasuresAndSays) {
  scene::Scene scene = markedCube({{.kind = MarkKind::Distance, .points = {{5, 5, 5}, {25, 5, 5}}},
                                   {.kind = MarkKind::Label, .points = {{20, 20, 39}}, .text = "a corner"},
                                   {.kind = MarkKind::Distance, .points = {{5, 9, 5}, {5, 39, 5}}, .text = "width"}});
  std::set<std::string> texts = textsOf(laidOf(scene));
  EXPECT_TRUE(texts.contains("20.0 mm"));
  EXPECT_TRUE(texts.contains("a corner"));
  EXPECT_TRUE(texts.contains("width 30.0 mm") || texts.contains("width  30.0 mm")) << *texts.rbegin();
  scene.lettering.marks[0].visible = false;
  EXPECT_FALSE(textsOf(laidOf(scene)).contains("20.0 mm"));
  scene.lettering.marks[1].timeStep = 4;
  EXPECT_FALSE(textsOf(laidOf(scene)).contains("a corner")) << "it is of another time";
}

/// Seen by one who goes through the sections.
TEST(MarkLayout, ASectionShowsMarksThatLieInItAndFadesThemAStepAway) {
  scene::Scene scene = markedCube({{.kind = MarkKind::Distance, .points = {{5, 5, 20}, {25, 5, 20}}}});
  auto opacityAt = [&](double z) {
    scene.sections.crosshair.z = z;
    double most = 0.0;
    for (const LetteringBlock& block : layLettering(scene, scene::SectionKind::Axial, kMarkedSize, {}).blocks)
      most = std::max(most, block.opacity);
    return most;
  };
  EXPECT_DOUBLE_EQ(opacityAt(20.0), 1.0);
  EXPECT_DOUBLE_EQ(opacityAt(20.4), 1.0);
  EXPECT_NEAR(opacityAt(21.0), 0.5, 1e-9);
  EXPECT_EQ(opacityAt(22.0), 0.0);
}

TEST(MarkLayout, AMarkThatGoesThroughASectionIsADotThereAndSaysNothing) {
  scene::Scene scene = markedCube({{.kind = MarkKind::Distance, .points = {{5, 20, 5}, {35, 20, 35}}}});
  scene.sections.crosshair.z = 20;
  LaidLettering through = layLettering(scene, scene::SectionKind::Axial, kMarkedSize, {});
  EXPECT_TRUE(textsOf(through).empty());
  ASSERT_FALSE(through.blocks.empty());
  // The picture says how long it is.
  EXPECT_FALSE(textsOf(laidOf(scene)).empty());
}

TEST(MarkLayout, WordsOfManyMarksCoverNeitherEachOtherNorTheScaleBar) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(2.0, 38.0);
  std::vector<Mark> marks;
  for (int i = 0; i < 40; ++i)
    marks.push_back({.kind = i % 2 ? MarkKind::Label : MarkKind::Distance,
                     .points = {{place(random), place(random), place(random)}},
                     .text = "mark " + std::to_string(i)});
  for (Mark& mark : marks)
    if (mark.kind == MarkKind::Distance) mark.points.emplace_back(place(random), place(random), place(random));
  scene::Scene scene = markedCube(std::move(marks));
  scene.lettering.scaleBar = true;
  LaidLettering laid = laidOf(scene);
  EXPECT_GE(laid.words.size(), 38u);
  for (std::size_t i = 0; i < laid.words.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const PlacedWords &a = laid.words[i], &b = laid.words[j];
      glm::dvec2 overlap = glm::min(a.high, b.high) - glm::max(a.low, b.low);
      EXPECT_FALSE(overlap.x > 1e-6 && overlap.y > 1e-6) << i << " " << j;
    }
}

TEST(MarkLayout, WordsStandWhereAHandHasPutThem) {
  scene::Scene scene = markedCube({{.kind = MarkKind::Label, .points = {{20, 20, 39}}, .text = "here"}});
  scene.lettering.marks[0].wordsAt = glm::dvec2(-0.3, 0.2);
  PlacedWords words = laidOf(scene).words.at(0);
  glm::dvec2 anchor = *scene::pixelFromWorld(scene.camera, kMarkedSize, {20, 20, 39});
  EXPECT_NEAR(glm::distance(0.5 * (words.low + words.high), anchor + glm::dvec2(-180, 120)), 0.0, 1e-9);
}

TEST(MarkLayout, AProfileIsAPlotOfItsValuesWithLeastAndMost) {
  scene::Scene scene = markedCube({{.kind = MarkKind::Profile, .points = {{5, 20, 20}, {35, 20, 20}}}});
  std::set<std::string> texts = textsOf(laidOf(scene));
  EXPECT_TRUE(texts.contains("25")) << "the value at its beginning";
  EXPECT_TRUE(texts.contains("175")) << "and at its end";
  EXPECT_GT(pointsOf(laidOf(scene)).size(), 50u);
}

TEST(MarkLayout, WhateverAFileSaysNothingBreaks) {
  for (std::size_t kind = 0; kind < std::size(EnumNames<MarkKind>::kNames); ++kind)
    for (std::size_t count : {0u, 1u, 2u, 3u, 7u}) {
      scene::Scene scene = markedCube({});
      Mark mark{.id = 1, .kind = MarkKind(kind), .structure = 99, .type = "no.such"};
      mark.points.assign(count, {1e9, -1e9, 20});
      scene.lettering.marks = {mark};
      laidOf(scene);
      mark.points.assign(count, scene.camera.eye);
      scene.lettering.marks = {mark};
      laidOf(scene);
    }
}

}  // namespace velum::session
