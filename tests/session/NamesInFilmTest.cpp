// Names from frame to frame of a film.
#include <gtest/gtest.h>

#include <ctime>
#include <map>

#include "namedScene.h"

namespace velum::session {

namespace {

/// Places on a ball that turns, half of which are seen: names come and go, and their anchors pass each other.
NamedScene turningScene(double angle, scene::NameOrder order, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  glm::ivec2 picture(1280, 720);
  NamedScene out{{}, {glm::dvec2(picture), ellipseSilhouette(picture, {640, 360}, {290, 300}), {}, order, 16.0}};
  for (int i = 0; i < 30; ++i) {
    double z = 2.0 * unit(random) - 1.0, turn = 6.2831853 * unit(random) + angle, radius = std::sqrt(1.0 - z * z);
    double width = 50.0 + 100.0 * unit(random), weight = 100.0 * unit(random), front = radius * std::cos(turn);
    if (front < 0.1) continue;
    glm::dvec2 anchor(640.0 + 285.0 * radius * std::sin(turn), 360.0 + 295.0 * z);
    out.names.push_back({i, {width, 19.0}, anchor, weight * front, {}});
  }
  return out;
}

struct Unrest {
  double mostStep = 0.0;
  int frames = 0, leaps = 0, placed = 0, gone = 0, missing = 0;
};

/// Looks at a frame after another.
void watch(const NamedScene& scene, const std::vector<NamePlace>& before, const std::vector<NamePlace>& now,
           Unrest& unrest) {
  std::map<int, const NamePlace*> were, are;
  for (const NamePlace& place : before) were[place.key] = &place;
  for (const NamePlace& place : now) are[place.key] = &place;
  ++unrest.frames;
  unrest.placed += int(now.size());
  unrest.missing += int(scene.names.size() - now.size());
  for (const NameToPlace& name : scene.names) {
    if (were.count(name.key) > 0 && are.count(name.key) == 0) ++unrest.gone;
    if (were.count(name.key) == 0 || are.count(name.key) == 0) continue;
    const NamePlace &was = *were[name.key], &is = *are[name.key];
    glm::dvec2 step = glm::abs(is.block.low - was.block.low);
    if (is.strength < was.strength || (is.strength < 0.2 && std::max(step.x, step.y) > mostNameStep(16.0))) {
      ++unrest.leaps;
      EXPECT_LT(is.strength, 0.2) << "what leaps begins faintly";
      continue;
    }
    unrest.mostStep = std::max({unrest.mostStep, step.x, step.y});
  }
}

void print(const char* what, const Unrest& unrest) {
  std::printf("%s: %d frames, step %.2f, of %d places %d leaps, %d went, %d had none\n", what, unrest.frames,
              unrest.mostStep, unrest.placed, unrest.leaps, unrest.gone, unrest.missing);
}

}  // namespace

TEST(NamesInFilm, OfATurningBallMoveByBoundedStepsAndSeldomLeap) {
  for (auto order : {scene::NameOrder::Columns, scene::NameOrder::Around}) {
    Unrest unrest;
    for (unsigned seed = 1; seed <= 3; ++seed) {
      std::vector<NamePlace> before =
          placeNames(turningScene(0.0, order, seed).names, turningScene(0.0, order, seed).room);
      for (int frame = 1; frame <= 250; ++frame) {
        NamedScene scene = turningScene(frame * 0.0125, order, seed);
        auto now = placeNames(scene.names, scene.room, &before);
        expectLaws(scene, now);
        watch(scene, before, now, unrest);
        before = now;
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed << " frame " << frame;
      }
    }
    print(order == scene::NameOrder::Columns ? "columns" : "around", unrest);
    EXPECT_LE(unrest.mostStep, mostNameStep(16.0) + 1e-9);
    EXPECT_LT(unrest.leaps, unrest.placed / 100);
    EXPECT_LT(unrest.gone, unrest.placed / 100);
    EXPECT_LT(unrest.missing, unrest.placed / 50);
  }
}

TEST(NamesInFilm, OfAnchorsThatTrembleStandStill) {
  for (auto order : {scene::NameOrder::Columns, scene::NameOrder::Around}) {
    std::mt19937 random(41);
    NamedScene scene = namedScene(random, 20, {0.5, 0.8}, order);
    std::vector<NamePlace> first = placeNames(scene.names, scene.room), before = first;
    for (int frame = 0; frame < 100; ++frame) {
      NamedScene shaken = scene;
      for (NameToPlace& name : shaken.names)
        name.anchor += glm::dvec2(double(random() % 5) - 2.0, double(random() % 5) - 2.0);
      auto now = placeNames(shaken.names, shaken.room, &before);
      ASSERT_EQ(now.size(), first.size());
      for (std::size_t i = 0; i < now.size(); ++i)
        EXPECT_LT(glm::distance(now[i].block.low, first[i].block.low),
                  order == scene::NameOrder::Columns ? 16.0 : 24.0);
      before = now;
    }
  }
}

TEST(NamesInFilm, OfAnchorsThatWalkKeepTheLaws) {
  for (auto order : {scene::NameOrder::Columns, scene::NameOrder::Around}) {
    Unrest unrest;
    for (unsigned seed = 1; seed <= 3; ++seed) {
      std::mt19937 random(seed);
      std::normal_distribution<double> way(0.0, 1.5);
      NamedScene scene = namedScene(random, 24, {0.5, 0.8}, order);
      if (seed == 2) scene.room.taken = {{{10, 10}, {300, 200}}};
      if (seed == 3) scene.names[4].fixed = glm::dvec2(100, 400);
      std::vector<NamePlace> before = placeNames(scene.names, scene.room);
      for (int frame = 0; frame < 200; ++frame) {
        for (NameToPlace& name : scene.names)
          name.anchor = glm::clamp(name.anchor + glm::dvec2(way(random), way(random)), {330, 80}, {950, 640});
        auto now = placeNames(scene.names, scene.room, &before);
        expectLaws(scene, now);
        watch(scene, before, now, unrest);
        before = now;
        if (testing::Test::HasFailure()) FAIL() << "seed " << seed << " frame " << frame;
      }
    }
    print(order == scene::NameOrder::Columns ? "walks, columns" : "walks, around", unrest);
    EXPECT_LE(unrest.mostStep, mostNameStep(16.0) + 1e-9);
    EXPECT_LT(unrest.leaps + unrest.gone, unrest.placed / 50);
    EXPECT_LT(unrest.missing, unrest.placed / 15);
  }
}

TEST(NamesInFilm, ThatStopsComeToRestWhereTheyAreWantedAndGainTheirStrength) {
  std::mt19937 random(43);
  NamedScene scene = namedScene(random, 16, {0.5, 0.8}, scene::NameOrder::Columns);
  std::vector<NamePlace> places;
  for (int frame = 0; frame < 200; ++frame) {
    auto next = placeNames(scene.names, scene.room, &places);
    if (frame == 0) {
      for (const NamePlace& place : next) EXPECT_LT(place.strength, 0.2);
    }
    places = next;
  }
  auto still = placeNames(scene.names, scene.room);
  ASSERT_EQ(places.size(), still.size());
  for (std::size_t i = 0; i < still.size(); ++i) {
    EXPECT_EQ(places[i].strength, 1.0);
    EXPECT_LT(glm::distance(places[i].block.low, still[i].block.low), 16.0);
  }
}

TEST(NamesInFilm, AreTheSameHoweverOftenTheyAreDrawn) {
  auto film = [] {
    std::vector<NamePlace> before = placeNames(turningScene(0, scene::NameOrder::Columns, 5).names,
                                               turningScene(0, scene::NameOrder::Columns, 5).room);
    for (int frame = 1; frame < 40; ++frame) {
      NamedScene scene = turningScene(frame * 0.02, scene::NameOrder::Columns, 5);
      before = placeNames(scene.names, scene.room, &before);
    }
    return before;
  };
  auto a = film(), b = film();
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].key, b[i].key);
    EXPECT_EQ(a[i].block.low, b[i].block.low);
    EXPECT_EQ(a[i].strength, b[i].strength);
  }
}

}  // namespace velum::session
