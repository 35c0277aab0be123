// Where leaders of labels go, so that none points at what is hidden.
#include "session/lettering/SeenPlaces.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "makeVolume.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "session/ViewSpace.h"
#include "session/lettering/Lettering.h"

namespace velum::session {
namespace {

using scene::Mark;
using scene::MarkKind;

constexpr glm::ivec2 kLooked(200, 150);
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// A cube of 40 whose structure 1 is all of it, with a label at a place.
scene::Scene labelled(glm::dvec3 place, int structure) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume({40, 40, 40}, SampleType::UInt8, [](glm::ivec3) { return 100; }));
  scene.labels.data = Shared<LabelVolume>(makeLabels({40, 40, 40}, [](glm::ivec3) { return 1; }));
  scene.labels.structures = {{.id = 1, .name = "cube"}, {.id = 2, .name = "other"}};
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kLooked.x) / kLooked.y);
  scene::addMark(scene.lettering.marks,
                 {.kind = MarkKind::Label, .points = {place}, .structure = structure, .text = "here"});
  return scene;
}

glm::dvec2 pixelOf(const scene::Scene& scene) {
  return *scene::pixelFromWorld(scene.camera, glm::dvec2(kLooked), scene.lettering.marks[0].points[0]);
}

/// What pixels show, made by hand.
struct Seeing {
  std::vector<std::int32_t> structures = std::vector<std::int32_t>(std::size_t(kLooked.x * kLooked.y), -1);
  std::vector<float> distances = std::vector<float>(std::size_t(kLooked.x * kLooked.y), kNothing);
  SeenMap map() const { return {kLooked, structures, {}, 1, {}, distances}; }
  std::int32_t& at(int x, int y) { return structures[std::size_t(y * kLooked.x + x)]; }
};

SeenPlace placeIn(const scene::Scene& scene, const Seeing& seeing) {
  auto places = seenPlaces(scene, seeing.map());
  EXPECT_EQ(places.size(), 1u);
  return places.at(0);
}

bool isDrawn(const scene::Scene& scene, const SeenPlace& place) {
  Seen seen;
  seen.names.places = {place};
  return !layLettering(scene, kLooked, seen).blocks.empty();
}

}  // namespace

TEST(SeenPlaces, ALeaderGoesToTheNearestPixelThatShowsTheStructure) {
  std::mt19937 random(7);
  scene::Scene scene = labelled({20, 20, 20}, 2);
  glm::dvec2 own = pixelOf(scene);
  for (int trial = 0; trial < 12; ++trial) {
    Seeing seeing;
    for (int blob = 0; blob < 5; ++blob) {
      glm::dvec2 middle(random() % 200, random() % 150);
      double radius = 1.0 + double(random() % 15);
      for (int y = 0; y < kLooked.y; ++y)
        for (int x = 0; x < kLooked.x; ++x)
          if (glm::distance(glm::dvec2(x, y), middle) < radius && glm::distance(glm::dvec2(x, y), own) > 12.0)
            seeing.at(x, y) = 2;
    }
    SeenPlace place = placeIn(scene, seeing);
    // Among pixels whose four neighbours show it, too.
    double best = 1e9;
    for (int y = 1; y + 1 < kLooked.y; ++y)
      for (int x = 1; x + 1 < kLooked.x; ++x)
        if (seeing.at(x, y) == 2 && seeing.at(x - 1, y) == 2 && seeing.at(x + 1, y) == 2 && seeing.at(x, y - 1) == 2 &&
            seeing.at(x, y + 1) == 2)
          best = std::min(best, glm::distance(glm::dvec2(x, y) + 0.5, own));
    ASSERT_TRUE(place.at) << trial;
    EXPECT_NEAR(glm::distance(*place.at, own), best, 1e-9) << trial;
    EXPECT_EQ(seeing.at(int(place.at->x), int(place.at->y)), 2);
  }
}

TEST(SeenPlaces, ManyMarksFindWhatEachWouldFindAlone) {
  std::mt19937 random(11);
  Seeing seeing;
  for (int y = 0; y < kLooked.y; ++y)
    for (int x = 0; x < kLooked.x; ++x) seeing.at(x, y) = x / 30 % 2 == y / 40 % 2 ? 1 + x / 30 % 3 : -1;
  scene::Scene scene = labelled({20, 20, 20}, 2);
  std::vector<SeenPlace> alone;
  scene.lettering.marks.clear();
  for (int i = 0; i < 20; ++i) {
    glm::dvec3 place(random() % 40, random() % 40, random() % 40);
    scene::Scene one = labelled(place, int(random() % 4));
    one.lettering.marks[0].id = scene::addMark(scene.lettering.marks, one.lettering.marks[0]);
    alone.push_back(placeIn(one, seeing));
  }
  EXPECT_EQ(seenPlaces(scene, seeing.map()), alone);
}

TEST(SeenPlaces, APlaceThatIsSeenKeepsItsLeader) {
  scene::Scene scene = labelled({20, 0, 20}, 1);
  Seeing seeing;
  std::ranges::fill(seeing.structures, 1);
  SeenPlace place = placeIn(scene, seeing);
  EXPECT_FALSE(place.at);
  EXPECT_EQ(place.share, 1.0);
  EXPECT_TRUE(isDrawn(scene, place));
}

TEST(SeenPlaces, WhatIsNotSeenHasNoLabelAndComesBySteps) {
  scene::Scene scene = labelled({20, 20, 20}, 2);
  Seeing seeing;
  SeenPlace place = placeIn(scene, seeing);
  EXPECT_EQ(place.share, 0.0);
  EXPECT_FALSE(isDrawn(scene, place));
  double before = 0.0;
  for (int i = 0; i < 30; ++i) {
    seeing.at(10 + i % 6, 10 + i / 6) = 2;
    double share = placeIn(scene, seeing).share;
    EXPECT_GE(share, before);
    EXPECT_LT(share - before, 0.6) << "a few pixels more are no leap";
    before = share;
  }
  EXPECT_EQ(before, 1.0);
}

TEST(SeenPlaces, AStructureOutOfThePictureIsPointedAtWhereItIsSeen) {
  scene::Scene scene = labelled({500, 20, 20}, 2);
  Seeing seeing;
  for (int y = 40; y < 60; ++y)
    for (int x = 150; x < 170; ++x) seeing.at(x, y) = 2;
  SeenPlace place = placeIn(scene, seeing);
  ASSERT_TRUE(place.at);
  EXPECT_NEAR(place.at->x, 168.5, 1.1);
  EXPECT_TRUE(isDrawn(scene, place));
}

TEST(SeenPlaces, APlainPlaceIsHiddenByWhatIsBeforeIt) {
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
    scene::Scene scene = labelled({20, 20, 20}, 0);
    scene.camera.projection = projection;
    glm::dvec3 place = scene.lettering.marks[0].points[0];
    glm::dvec3 forward = scene::cameraBasis(scene.camera).forward;
    double away = projection == scene::Projection::Perspective ? glm::distance(place, scene.camera.eye)
                                                               : glm::dot(place - scene.camera.eye, forward);
    Seeing seeing;
    EXPECT_EQ(placeIn(scene, seeing).share, 1.0) << "nothing is before it";
    std::ranges::fill(seeing.distances, float(away - 30.0));
    EXPECT_EQ(placeIn(scene, seeing).share, 0.0);
    EXPECT_FALSE(isDrawn(scene, placeIn(scene, seeing)));
    std::ranges::fill(seeing.distances, float(away - 0.5));
    EXPECT_EQ(placeIn(scene, seeing).share, 1.0) << "it lies on what is seen";
    std::ranges::fill(seeing.distances, float(away + 30.0));
    EXPECT_EQ(placeIn(scene, seeing).share, 1.0);
  }
  EXPECT_EQ(placeIn(labelled({500, 20, 20}, 0), {}).share, 0.0) << "out of the picture";
}

TEST(SeenPlaces, APlainPlaceGoesWithWhatACutRemoves) {
  scene::Scene scene = labelled({20, 10, 20}, 0);
  scene::Cut cut;
  cut.shape = scene::CutShape::Plane;
  cut.centre = {20, 20, 20};
  for (glm::dvec3 axis : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)}) {
    cut.axis = axis;
    scene.cuts = {cut};
    bool isKept = glm::dot(cut.centre - glm::dvec3(20, 10, 20), axis) >= 0.0;
    EXPECT_EQ(placeIn(scene, {}).share, isKept ? 1.0 : 0.0);
  }
}

TEST(SeenPlaces, MeasuresStayAlsoWhereTheyAreHidden) {
  scene::Scene scene = labelled({20, 20, 20}, 0);
  scene.lettering.marks[0] = {.id = 1, .kind = MarkKind::Distance, .points = {{20, 20, 20}, {30, 20, 20}}};
  EXPECT_FALSE(needsSeenPlaces(scene.lettering));
  Seeing seeing;
  std::ranges::fill(seeing.distances, 0.0f);
  EXPECT_TRUE(seenPlaces(scene, seeing.map()).empty());
}

}  // namespace velum::session
