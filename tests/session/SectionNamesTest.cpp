// Names of structures that a section cuts, in pictures, plates and films of sections.
#include "session/lettering/SeenSection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "makeVolume.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "scene/StructureAt.h"
#include "session/film/FilmDrawer.h"
#include "session/lettering/Lettering.h"
#include "session/picture/Picture.h"
#include "session/plate/Plate.h"

namespace velum::session {
namespace {

constexpr glm::ivec2 kSectionSize(300, 250);
constexpr auto kAxial = scene::SectionKind::Axial;

/// Four columns along z; the fourth begins at z = 30.
scene::Scene columns() {
  scene::Scene scene;
  Volume volume = makeVolume({60, 50, 40}, SampleType::UInt8, [](glm::ivec3 v) {
    return glm::all(glm::greaterThan(v, glm::ivec3(5))) && v.x < 55 && v.y < 45 ? 60 + v.x : 0;
  });
  volume.isSpacingKnown = true;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.labels.data = Shared<LabelVolume>(makeLabels({60, 50, 40}, [](glm::ivec3 v) {
    if (v.x / 10 % 2 == 0 || v.y < 10 || v.y >= 40) return 0;
    int id = v.x < 20 ? 1 : v.x < 40 ? 2 : 3;
    return v.y > 25 && id == 2 ? (v.z >= 30 ? 4 : 0) : id;
  }));
  scene.labels.structures = {{.id = 1, .name = "radius"},
                             {.id = 2, .name = "ulna"},
                             {.id = 3, .name = "lunate"},
                             {.id = 4, .name = "capitate"}};
  for (auto& structure : scene.labels.structures) structure.color = glm::vec3(0.2f, 0.6f, 0.9f);
  scene.sections.crosshair = {30, 25, 15};
  scene.sections.isPlaced = true;
  scene.background.top = scene.background.bottom = glm::vec3(0.0f);
  scene.lettering.names = true;
  return scene;
}

struct Named {
  render::SectionImage section;
  LaidLettering laid;
  std::set<std::string> words;
};
Named namedIn(const scene::Scene& scene) {
  Progress progress;
  scene::SectionPlane plane = scene::makeSectionPlane(scene, kAxial, glm::dvec2(kSectionSize));
  Named named{render::drawSection(scene, plane), {}, {}};
  Seen seen = seenInSection(named.section, plane, scene, progress);
  named.laid = layLettering(scene, kAxial, kSectionSize, seen);
  for (const LetteringBlock& block : named.laid.blocks)
    for (const vector::Item& item : block.items)
      if (const auto* words = std::get_if<vector::Words>(&item)) named.words.insert(words->text);
  return named;
}

using Words = std::set<std::string>;

}  // namespace

TEST(SectionNames, APixelsStructureIsThatOfItsPlace) {
  scene::Scene scene = columns();
  scene.labels.structures[0].visible = false;
  scene::SectionPlane plane = scene::makeSectionPlane(scene, kAxial, glm::dvec2(kSectionSize));
  render::SectionImage section = render::drawSection(scene, plane);
  auto field = scene::structureFieldOf(scene);  // is held while places are asked
  int seen = 0;
  for (int y = 3; y < kSectionSize.y; y += 7)
    for (int x = 3; x < kSectionSize.x; x += 7) {
      glm::dvec3 world = scene::worldFromSectionPixel(plane, glm::dvec2(x, y) + 0.5);
      glm::dvec3 voxel = glm::floor(world + 0.5);
      bool isIn = glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0))) &&
                  glm::all(glm::lessThan(voxel, glm::dvec3(60, 50, 40)));
      int wanted = isIn ? scene::structureAt(scene, world).id : 0;
      if (wanted == 1) wanted = 0;  // is hidden
      EXPECT_EQ(section.structures[std::size_t(y * kSectionSize.x + x)], wanted) << x << " " << y;
      seen += wanted > 0;
    }
  EXPECT_GT(seen, 100);
}

TEST(SectionNames, ASectionNamesWhatItCutsAndLeadersEndOnIt) {
  scene::Scene scene = columns();
  Named named = namedIn(scene);
  EXPECT_EQ(named.words, (Words{"radius", "ulna", "lunate"}));
  ASSERT_EQ(named.laid.names.size(), 3u);
  for (const PlacedWords& words : named.laid.words) {
    glm::ivec2 at(words.at);
    EXPECT_EQ(named.section.structures[std::size_t(at.y * kSectionSize.x + at.x)], words.structure);
    EXPECT_TRUE(words.at.x < words.low.x || words.at.x > words.high.x || words.at.y < words.low.y ||
                words.at.y > words.high.y);
  }
  scene.sections.crosshair.z = 35;
  EXPECT_TRUE(namedIn(scene).words.contains("capitate"));
  scene.labels.structures[3].visible = false;
  EXPECT_FALSE(namedIn(scene).words.contains("capitate")) << "it is not shown";
  scene.lettering.named = {"ulna"};
  EXPECT_EQ(namedIn(scene).words, Words{"ulna"});
  scene.lettering.names = false;
  EXPECT_TRUE(namedIn(scene).words.empty());
}

TEST(SectionNames, WhatACutRemovesIsNotNamed) {
  scene::Scene scene = columns();
  scene::Cut cut;
  cut.shape = scene::CutShape::Plane;
  cut.centre = {24, 25, 15};
  cut.axis = {1, 0, 0};
  scene.cuts = {cut};
  Named named = namedIn(scene);
  bool leavesLow = named.words.contains("radius");
  EXPECT_EQ(named.words, leavesLow ? Words({"radius"}) : Words({"ulna", "lunate"}));
  scene.sections.showCuts = false;
  EXPECT_EQ(namedIn(scene).words.size(), 3u) << "a section that shows no cuts shows all";
}

TEST(SectionNames, AMarkWithoutAPlaceIsBesideItsStructure) {
  scene::Scene scene = columns();
  scene.lettering.names = false;
  scene::addMark(scene.lettering.marks, {.kind = scene::MarkKind::Name, .structure = 2});
  scene::addMark(scene.lettering.marks, {.kind = scene::MarkKind::Name, .structure = 4});
  EXPECT_EQ(namedIn(scene).words, Words{"ulna"});
}

TEST(SectionNames, TheMapOfASectionIsThatOfItsPicture) {
  scene::Scene scene = columns();
  for (glm::ivec2 size : {kSectionSize, glm::ivec2(2301, 901)}) {
    scene::SectionPlane plane = scene::makeSectionPlane(scene, kAxial, glm::dvec2(size));
    render::SectionImage section = render::drawSection(scene, plane);
    SectionMap own(section, scene.background.bottom);
    ImageMap wanted(scene, seenOfSection(section, plane, scene.background.bottom));
    EXPECT_EQ(own.map().size, wanted.map().size);
    EXPECT_EQ(own.map().step, wanted.map().step);
    EXPECT_TRUE(std::ranges::equal(own.map().structures, wanted.map().structures));
    EXPECT_TRUE(own.map().types.empty());
  }
}

TEST(SectionNames, NamesGoByWhetherMarksHavePointsNotWhereThoseAre) {
  scene::Scene scene = columns();
  scene::addMark(scene.lettering.marks, {.kind = scene::MarkKind::Name, .points = {{1, 2, 3}}, .structure = 2});
  scene::addMark(scene.lettering.marks, {.kind = scene::MarkKind::Label, .points = {{1, 2, 3}}, .text = "x"});
  const scene::Lettering before = namingOf(scene.lettering);
  for (scene::Mark& mark : scene.lettering.marks) mark.points = {{4, 5, 6}}, mark.wordsAt = glm::dvec2(0.1, 0.2);
  scene.lettering.textSize = 30.0;
  EXPECT_EQ(namingOf(scene.lettering), before);
  scene.lettering.marks[0].points.clear();
  EXPECT_NE(namingOf(scene.lettering), before);
  scene.lettering.marks[0].points = {{1, 2, 3}};
  scene.lettering.marks[0].structure = 3;
  EXPECT_NE(namingOf(scene.lettering), before);
}

TEST(SectionNames, PictureAndPlateHaveThem) {
  scene::Scene scene = columns();
  Progress progress;
  PictureOptions options;
  options.size = kSectionSize;
  Image with = drawSectionPicture(scene, kAxial, options, progress);
  scene.lettering.names = false;
  EXPECT_NE(with.pixels, drawSectionPicture(scene, kAxial, options, progress).pixels);
  scene.lettering.names = true;
  Words words;
  for (const vector::Layer& layer : drawSectionPlate(scene, kAxial, options, progress).layers)
    for (const vector::Item& item : layer.items)
      if (const auto* one = std::get_if<vector::Words>(&item)) words.insert(one->text);
  EXPECT_EQ(words, (Words{"radius", "ulna", "lunate"}));
}

TEST(SectionNames, AFrameOfAFilmOfSectionsIsItsStillPicture) {
  scene::Scene scene = columns();
  scene.lettering.names = false;
  scene::addMark(scene.lettering.marks, {.kind = scene::MarkKind::Circle, .points = {{30, 25, 15}, {38, 25, 15}}});
  scene.timeline.duration = 0.4;
  FilmOutput output;
  output.section = kAxial;
  output.picture.size = kSectionSize;
  FilmDrawer drawer(scene, output, nullptr, nullptr);
  Progress progress;
  Image still = drawSectionPicture(scene, kAxial, output.picture, progress);
  for (int frame : {0, 1, 2}) EXPECT_EQ(drawer.draw(frame, 0.0, progress).image.pixels, still.pixels) << frame;
}

TEST(SectionNames, NamesOfAFilmOfSectionsGoStepByStep) {
  scene::Scene scene = columns();
  scene.timeline.duration = 2.0;
  scene.timeline.tracks = {{"sections.crosshair", true, {{0.0, {"[30,25,10]"}}, {2.0, {"[30,25,28]"}}}}};
  FilmOutput output;
  output.section = kAxial;
  output.picture.size = kSectionSize;
  FilmDrawer drawer(scene, output, nullptr, nullptr), other(scene, output, nullptr, nullptr);
  Progress progress;
  for (int frame : {0, 7}) drawer.draw(frame, 0.0, progress);
  EXPECT_EQ(drawer.draw(20, 0.0, progress).image.pixels, other.draw(20, 0.0, progress).image.pixels)
      << "a frame depends on the film and its number alone";
}

}  // namespace velum::session
