// Where names stand beside a picture.
#include "session/lettering/PlaceNames.h"

#include <gtest/gtest.h>

#include <ctime>

#include "namedScene.h"

namespace velum::session {

namespace {

double leaderLength(const std::vector<NamePlace>& places) {
  double sum = 0.0;
  for (const NamePlace& place : places) sum += glm::distance(place.leader.front(), place.leader.back());
  return sum;
}

}  // namespace

TEST(PlaceNames, NothingCrossesOrCoversAnythingInHundredsOfScenes) {
  std::mt19937 random(11);
  std::size_t wanted = 0, placed = 0;
  for (int round = 0; round < 400; ++round) {
    auto order = round % 2 == 0 ? scene::NameOrder::Columns : scene::NameOrder::Around;
    double share = 0.3 + 0.1 * (round % 9);
    NamedScene scene = namedScene(random, 1 + round % 40, {share * 0.6, share}, order);
    if (round % 3 == 0) scene.room.taken = {{{10, 10}, {200, 150}}, {{1000, 660}, {1270, 710}}};
    if (round % 5 == 0) scene.names[0].fixed = glm::dvec2(300, 300);
    auto places = placeNames(scene.names, scene.room);
    expectLaws(scene, places);
    wanted += scene.names.size();
    placed += places.size();
    if (HasFailure()) FAIL() << "round " << round;
  }
  std::printf("%zu of %zu names placed\n", placed, wanted);
  EXPECT_GT(double(placed), 0.93 * double(wanted));
}

TEST(PlaceNames, TwentyNamesBesideASubjectAllFindRoomInBothOrders) {
  std::mt19937 random(13);
  for (int round = 0; round < 60; ++round) {
    auto order = round % 2 == 0 ? scene::NameOrder::Columns : scene::NameOrder::Around;
    NamedScene scene = namedScene(random, 20, {0.5, 0.8}, order);
    EXPECT_EQ(placeNames(scene.names, scene.room).size(), 20u) << round;
  }
}

TEST(PlaceNames, ColumnsAreFlushAndStandClearOfTheSubjectOnBothSides) {
  std::mt19937 random(17);
  for (int round = 0; round < 40; ++round) {
    NamedScene scene = namedScene(random, 24, {0.5, 0.9}, scene::NameOrder::Columns);
    int left = 0, right = 0;
    for (const NamePlace& place : placeNames(scene.names, scene.room)) {
      bool isLeft = place.block.high.x < 640;
      (isLeft ? left : right) += 1;
      if (isLeft) {
        EXPECT_NEAR(place.block.high.x, 320 - 1.6 * 16, 1.0);
      }
      if (!isLeft) {
        EXPECT_NEAR(place.block.low.x, 960 + 1.6 * 16, 1.0);
      }
    }
    EXPECT_LE(std::abs(left - right), 12);
  }
}

TEST(PlaceNames, WhereTheSubjectFillsThePictureNamesStandOverItAndStillCoverNothing) {
  std::mt19937 random(19);
  std::size_t placed = 0, all = 0;
  double placedWeight = 0.0, allWeight = 0.0;
  for (int round = 0; round < 60; ++round) {
    auto order = round % 2 == 0 ? scene::NameOrder::Columns : scene::NameOrder::Around;
    NamedScene scene = namedScene(random, 20, {1.5, 1.5}, order);
    auto places = placeNames(scene.names, scene.room);
    expectLaws(scene, places);
    placed += places.size();
    all += scene.names.size();
    for (const NamePlace& place : places) placedWeight += nameIn(scene, place.key).weight;
    for (const NameToPlace& name : scene.names) allWeight += name.weight;
  }
  std::printf("%zu of %zu names placed over subjects that fill the picture\n", placed, all);
  EXPECT_GT(placed, all * 9 / 10);
  EXPECT_LT((allWeight - placedWeight) / double(all - placed), 0.8 * placedWeight / double(placed))
      << "what gives way weighs less";
}

TEST(PlaceNames, WhatWeighsLeastIsLeftOutFirst) {
  std::mt19937 random(23);
  for (int round = 0; round < 10; ++round) {
    NamedScene scene = namedScene(random, 60, {0.4, 0.7}, scene::NameOrder::Columns, {1000, 420});
    auto places = placeNames(scene.names, scene.room);
    ASSERT_LT(places.size(), 60u);
    double weights = 0.0, all = 0.0;
    for (const NamePlace& place : places) weights += nameIn(scene, place.key).weight;
    for (const NameToPlace& name : scene.names) all += name.weight;
    EXPECT_GT(weights / double(places.size()), all / 60.0 * 1.15);
    auto heaviest = std::max_element(scene.names.begin(), scene.names.end(),
                                     [](const auto& a, const auto& b) { return a.weight < b.weight; });
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const auto& p) { return p.key == heaviest->key; }));
  }
}

TEST(PlaceNames, LeadersAreNearlyAsShortAsTheShortestOfAllColumns) {
  std::mt19937 random(29);
  double worst = 1.0;
  for (int round = 0; round < 40; ++round) {
    int count = 2 + round % 5;
    NamedScene scene = namedScene(random, count, {0.4, 0.7}, scene::NameOrder::Columns);
    for (NameToPlace& name : scene.names) name.size.y = 120.0;  // so that they are in each other's way
    double ours = leaderLength(placeNames(scene.names, scene.room)), shortest = 1e30;
    // Each name left or right, in each order, at each height of a lattice, as far up as the one above lets it.
    double left = 640 - 256 - 1.6 * 16 + 0.3 * 16, right = 640 + 256 + 1.6 * 16 - 0.3 * 16, gap = 0.3 * 16;
    std::vector<double> heights;
    for (double y = 70; y <= 650; y += 10) heights.push_back(y);
    auto shortestOf = [&](std::vector<std::size_t> side, double x) {
      std::sort(side.begin(), side.end());
      double best = side.empty() ? 0.0 : 1e30;
      do {
        std::vector<double> sums(heights.size(), 0.0);
        for (std::size_t k = 0; k < side.size(); ++k) {
          std::vector<double> next(heights.size(), 1e30);
          for (std::size_t h = 0; h < heights.size(); ++h) {
            double before = k == 0 ? 0.0 : 1e30;
            for (std::size_t g = 0; k > 0 && g < h; ++g)
              if (heights[h] - heights[g] >= 120.0 + gap) before = std::min(before, sums[g]);
            next[h] = before + glm::distance(glm::dvec2(x, heights[h]), scene.names[side[k]].anchor);
          }
          sums = next;
        }
        if (!side.empty()) best = std::min(best, *std::min_element(sums.begin(), sums.end()));
      } while (std::next_permutation(side.begin(), side.end()));
      return best;
    };
    for (unsigned sides = 0; sides < 1u << count; ++sides) {
      std::vector<std::size_t> on[2];
      for (std::size_t i = 0; i < std::size_t(count); ++i) on[sides >> i & 1u].push_back(i);
      shortest = std::min(shortest, shortestOf(on[0], left) + shortestOf(on[1], right));
    }
    worst = std::max(worst, ours / shortest);
    EXPECT_LT(ours, 1.25 * shortest) << round;
  }
  std::printf("leaders at worst %.3f of the shortest\n", worst);
}

TEST(PlaceNames, FewLeadersPassCloselyByTheAnchorOfAnother) {
  std::mt19937 random(47);
  int close = 0, all = 0;
  for (int round = 0; round < 60; ++round) {
    auto order = round % 2 == 0 ? scene::NameOrder::Columns : scene::NameOrder::Around;
    NamedScene scene = namedScene(random, 20, {0.5, 0.8}, order);
    for (const NamePlace& place : placeNames(scene.names, scene.room)) {
      ++all;
      bool isClose = false;
      for (const NameToPlace& name : scene.names)
        for (int i = 0; i <= 300 && name.key != place.key && glm::distance(name.anchor, place.leader.back()) > 11.2;
             ++i)
          isClose |= glm::distance(glm::mix(place.leader.front(), place.leader.back(), i / 300.0), name.anchor) < 5.0;
      close += isClose;
    }
  }
  std::printf("%d of %d leaders pass closely by another's anchor\n", close, all);
  EXPECT_LT(close, all / 40);
}

TEST(PlaceNames, WhatIsFixedByHandStaysAndOthersAvoidIt) {
  std::mt19937 random(31);
  for (int round = 0; round < 30; ++round) {
    NamedScene scene =
        namedScene(random, 16, {0.5, 0.8}, round % 2 ? scene::NameOrder::Columns : scene::NameOrder::Around);
    scene.names[3].fixed = glm::dvec2(150 + 10 * round, 80 + 17 * round);
    scene.names[7].fixed = glm::dvec2(1250, 700);
    auto places = placeNames(scene.names, scene.room);
    expectLaws(scene, places);
    for (int key : {3, 7})
      EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const auto& p) { return p.key == key; }));
  }
}

TEST(PlaceNames, APictureWithoutRoomOrNamesHasNoPlaces) {
  NameRoom room{{40, 30}, {}, {}, scene::NameOrder::Columns, 16.0};
  for (auto order : {scene::NameOrder::Columns, scene::NameOrder::Around}) {
    room.order = order;
    EXPECT_TRUE(placeNames({}, room).empty());
    EXPECT_TRUE(placeNames({{1, {60, 20}, {20, 15}, 1.0, {}}}, room).empty());
    NameRoom large{{600, 400}, {}, {}, order, 16.0};
    EXPECT_TRUE(placeNames({{1, {60, 20}, {-20, 15}, 1.0, {}}}, large).empty()) << "what is not in the picture";
    EXPECT_EQ(placeNames({{1, {60, 20}, {300, 200}, 1.0, {}}}, large).size(), 1u) << "a subject that is not known";
  }
}

TEST(PlaceNames, FortyNamesTakeAFewMilliseconds) {
  std::mt19937 random(37);
  for (auto order : {scene::NameOrder::Columns, scene::NameOrder::Around}) {
    double worst = 0.0, sum = 0.0;
    for (int round = 0; round < 20; ++round) {
      NamedScene scene = namedScene(random, 40, {0.5, 0.9}, order);
      std::clock_t start = std::clock();
      placeNames(scene.names, scene.room);
      double ms = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
      worst = std::max(worst, ms);
      sum += ms;
    }
    std::printf("40 names: %.2f ms, at worst %.2f\n", sum / 20, worst);
    EXPECT_LT(sum / 20, 500.0) << "a generous bound: others may hold the machine";
  }
}

}  // namespace velum::session
