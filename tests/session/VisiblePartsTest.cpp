// Where in a picture the names of what it shows point to.
#include "session/lettering/VisibleParts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <random>

#include "core/Error.h"

namespace velum::session {

namespace {

/// Disks of keys over each other, and single pixels.
std::vector<std::int32_t> randomMap(glm::ivec2 size, int keys, int disks, std::mt19937& random) {
  std::vector<std::int32_t> map(std::size_t(size.x * size.y), -1);
  auto upTo = [&](int end) { return int(random() % unsigned(end)); };
  for (int i = 0; i < disks; ++i) {
    glm::ivec2 middle(upTo(size.x), upTo(size.y));
    int radius = upTo(std::max(2, size.x / 5)), key = upTo(keys) - 1;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (glm::ivec2 d = glm::ivec2(x, y) - middle; d.x * d.x + d.y * d.y <= radius * radius)
          map[std::size_t(y * size.x + x)] = key;
  }
  return map;
}

/// What a slow and plain search says of the largest piece of a key: its pixels, and how deep each lies.
struct SlowPart {
  std::uint64_t pixels = 0, largest = 0;
  std::vector<std::map<int, int>> pieces;  ///< depths by pixel; thirds of a pixel
};

int slowDepth(const KeyMap& map, glm::ivec2 pixel) {
  auto keyAt = [&](glm::ivec2 p) {
    bool isIn = p.x >= 0 && p.y >= 0 && p.x < map.size.x && p.y < map.size.y;
    return isIn ? map.keys[std::size_t(p.y * map.size.x + p.x)] : -2;
  };
  int least = 1 << 20;
  for (int y = -1; y <= map.size.y; ++y)
    for (int x = -1; x <= map.size.x; ++x) {
      if (keyAt({x, y}) == keyAt(pixel)) continue;
      glm::ivec2 d = glm::abs(glm::ivec2(x, y) - pixel);
      least = std::min(least, 4 * std::min(d.x, d.y) + 3 * (std::max(d.x, d.y) - std::min(d.x, d.y)));
    }
  return least;
}

std::map<std::int32_t, SlowPart> slowParts(const KeyMap& map) {
  std::map<std::int32_t, SlowPart> parts;
  std::vector<bool> isDone(map.keys.size());
  for (std::size_t start = 0; start < map.keys.size(); ++start) {
    if (isDone[start] || map.keys[start] < 0) continue;
    SlowPart& part = parts[map.keys[start]];
    std::map<int, int>& piece = part.pieces.emplace_back();
    std::vector<std::size_t> open{start};
    isDone[start] = true;
    while (!open.empty()) {
      std::size_t i = open.back();
      open.pop_back();
      glm::ivec2 pixel(int(i) % map.size.x, int(i) / map.size.x);
      piece[int(i)] = slowDepth(map, pixel);
      for (int y = std::max(0, pixel.y - 1); y <= std::min(map.size.y - 1, pixel.y + 1); ++y)
        for (int x = std::max(0, pixel.x - 1); x <= std::min(map.size.x - 1, pixel.x + 1); ++x) {
          std::size_t j = std::size_t(y * map.size.x + x);
          if (isDone[j] || map.keys[j] != map.keys[start]) continue;
          isDone[j] = true;
          open.push_back(j);
        }
    }
    part.pixels += piece.size();
    part.largest = std::max<std::uint64_t>(part.largest, piece.size());
  }
  return parts;
}

int mapPixelOf(const KeyMap& map, const VisiblePart& part) {
  glm::ivec2 pixel(glm::floor(part.anchor / double(map.step)));
  return pixel.y * map.size.x + pixel.x;
}

}  // namespace

TEST(VisibleParts, AnAnchorHasItsKeyAndIsAsDeepInTheLargestPieceAsAPlainSearchSays) {
  std::mt19937 random(7);
  for (int round = 0; round < 120; ++round) {
    glm::ivec2 size(1 + int(random() % 30), 1 + int(random() % 24));
    int step = 1 + round % 4;
    std::vector<std::int32_t> keys = randomMap(size, 1 + int(random() % 6), 1 + int(random() % 12), random);
    if (round % 5 == 0)
      for (std::int32_t& key : keys) key = int(random() % 4) - 1;
    KeyMap map{size, keys, step};
    auto slow = slowParts(map);
    auto parts = computeVisibleParts(map);
    ASSERT_EQ(parts.size(), slow.size());
    for (const VisiblePart& part : parts) {
      const SlowPart& should = slow.at(part.key);
      EXPECT_EQ(part.pixels, should.pixels * std::uint64_t(step * step));
      int pixel = mapPixelOf(map, part);
      ASSERT_EQ(keys[std::size_t(pixel)], part.key);
      bool isInLargest = false;
      for (const auto& piece : should.pieces) {
        auto at = piece.find(pixel);
        if (at == piece.end() || piece.size() != should.largest) continue;
        isInLargest = true;
        int deepest = 0;
        for (auto [i, depth] : piece) deepest = std::max(deepest, depth);
        EXPECT_GE(at->second, 0.75 * deepest);
        EXPECT_DOUBLE_EQ(part.depth, at->second * step / 3.0);
      }
      EXPECT_TRUE(isInLargest);
    }
  }
}

TEST(VisibleParts, AnAnchorStaysWhileItIsWellInsideAndThenGoesToTheNearestSuchPlace) {
  glm::ivec2 size(200, 120);
  auto disk = [&](glm::dvec2 middle) {
    std::vector<std::int32_t> keys(std::size_t(size.x * size.y), -1);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (glm::distance(glm::dvec2(x, y), middle) < 30) keys[std::size_t(y * size.x + x)] = 3;
    return keys;
  };
  std::vector<VisiblePart> before;
  int stays = 0;
  for (int frame = 0; frame < 60; ++frame) {
    glm::dvec2 middle(40 + 2 * frame, 60);
    auto keys = disk(middle);
    auto parts = computeVisibleParts({size, keys, 1}, before);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_LE(glm::distance(parts[0].anchor, middle), 19.0);
    if (frame > 0) {
      EXPECT_LE(glm::distance(parts[0].anchor, before[0].anchor), 3.0);
      stays += parts[0].anchor == before[0].anchor;
    }
    before = parts;
  }
  EXPECT_GE(stays, 6);
}

TEST(VisibleParts, ASmallerPieceKeepsTheAnchorUntilItIsClearlySmaller) {
  auto anchorX = [](int left, int right, std::span<const VisiblePart> before) {
    std::vector<std::int32_t> keys(60 * 10, -1);
    for (int y = 0; y < 10; ++y) {
      for (int x = 0; x < left; ++x) keys[std::size_t(y * 60 + x)] = 1;
      for (int x = 30; x < 30 + right; ++x) keys[std::size_t(y * 60 + x)] = 1;
    }
    return computeVisibleParts({{60, 10}, keys, 1}, before);
  };
  auto first = anchorX(20, 16, {});
  EXPECT_LT(first[0].anchor.x, 20);
  EXPECT_LT(anchorX(14, 20, first)[0].anchor.x, 20);
  EXPECT_GT(anchorX(14, 20, {})[0].anchor.x, 30);
  EXPECT_GT(anchorX(8, 20, first)[0].anchor.x, 30);
}

TEST(VisibleParts, ThinThingsHaveTheirAnchorOnThem) {
  glm::ivec2 size(160, 90);
  std::vector<std::int32_t> keys(std::size_t(size.x * size.y), 0);
  for (int x = 0; x < size.x; ++x) keys[std::size_t((20 + x / 3) * size.x + x)] = 5;
  auto parts = computeVisibleParts({size, keys, 2});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(keys[std::size_t(mapPixelOf({size, keys, 2}, parts[1]))], 5);
  EXPECT_NEAR(parts[1].anchor.x, 160, 8) << "the middle of the line, not an end";
}

TEST(VisibleParts, ASilhouetteIsTheFirstAndLastOfEachRow) {
  std::mt19937 random(3);
  glm::ivec2 size(40, 30);
  auto keys = randomMap(size, 3, 5, random);
  for (int x = 0; x < size.x; ++x) keys[std::size_t(4 * size.x + x)] = -1;
  Silhouette silhouette = silhouetteOf({size, keys, 3});
  ASSERT_EQ(silhouette.rows.size(), 30u);
  EXPECT_EQ(silhouette.step, 3);
  EXPECT_GE(silhouette.rows[4].x, silhouette.rows[4].y);
  for (int y = 0; y < size.y; ++y) {
    int left = size.x, right = 0;
    for (int x = 0; x < size.x; ++x)
      if (keys[std::size_t(y * size.x + x)] >= 0) left = std::min(left, x), right = x + 1;
    if (right > 0) {
      EXPECT_EQ(silhouette.rows[std::size_t(y)], glm::dvec2(3 * left, 3 * right));
    }
  }
}

TEST(VisibleParts, AnEmptyMapShowsNothingAndAMapOfAnotherSizeIsRefused) {
  EXPECT_TRUE(computeVisibleParts({{0, 0}, {}, 1}).empty());
  std::vector<std::int32_t> keys(5);
  EXPECT_THROW(computeVisibleParts({{2, 3}, keys, 1}), ArgumentError);
  EXPECT_THROW(silhouetteOf({{5, 1}, keys, 0}), ArgumentError);
}

TEST(VisibleParts, AWholePictureTakesAFewMilliseconds) {
  std::mt19937 random(5);
  glm::ivec2 size(1280, 720);
  auto keys = randomMap(size, 40, 60, random);
  std::clock_t start = std::clock();
  auto parts = computeVisibleParts({size, keys, 1});
  double ms = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
  EXPECT_GT(parts.size(), 20u);
  std::printf("visible parts of 1280x720: %.1f ms\n", ms);
  EXPECT_LT(ms, 400.0) << "a generous bound: others may hold the machine, and builds without optimising are slow";
}

}  // namespace velum::session
