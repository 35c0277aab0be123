#include "vector/Paint.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

#include "Drawings.h"
#include "vector/Bounds.h"
#include "vector/Letters.h"

namespace velum::vector {
namespace {

Image painted(const std::vector<Item>& items, int width = 200, int height = 200, double scale = 1.0) {
  Image image = plainImage(width, height);
  paint(items, image, scale);
  return image;
}

double inkOfItems(const std::vector<Item>& items) { return coverOf(painted(items)); }

/// Columns that have some ink: the first one, and the one behind the last.
glm::ivec2 inkOf(const Image& image) {
  glm::ivec2 ink(image.width, 0);
  for (int x = 0; x < image.width; ++x)
    for (int y = 0; y < image.height; ++y)
      if (sampleOf(image, x, y, 0) < 0.99f) ink = {std::min(ink.x, x), std::max(ink.y, x + 1)};
  return ink;
}

TEST(Paint, CoverIsArea) {
  // Cairo takes 15 rows of samples a pixel, and rounds places to 1/256.
  EXPECT_NEAR(inkOfItems({filled({rectangle({10, 20}, {110, 70})})}), 5000.0, 1e-6) << "on pixels it is exact";
  EXPECT_NEAR(inkOfItems({filled({rectangle({10.25, 20.4}, {110.75, 70.8})})}), 100.5 * 50.4, 100.5 * 2.0 / 15.0);
  EXPECT_NEAR(inkOfItems({filled({circle({100, 100}, 60)})}), std::numbers::pi * 3600.0,
              0.002 * std::numbers::pi * 3600.0);
  EXPECT_NEAR(inkOfItems({stroked({circle({100, 100}, 60)}, {kBlack, 4.0})}), std::numbers::pi * 480.0, 5.0);
}

TEST(Paint, OutlinesInOutlinesAreHolesWhicheverWayTheyGo) {
  Outline outer = rectangle({20, 20}, {120, 120}), inner = rectangle({40, 40}, {80, 80}),
          reversed = outlineThrough({{40, 40}, {40, 80}, {80, 80}, {80, 40}}, true);
  EXPECT_NEAR(inkOfItems({filled({outer, inner})}), 10000.0 - 1600.0, 1e-6);
  EXPECT_NEAR(inkOfItems({filled({outer, reversed})}), 10000.0 - 1600.0, 1e-6);
}

TEST(Paint, LettersThatOverlapHaveNoHoles) {
  // A stroke through a letter, behind a shape of the other rule.
  std::vector<Item> letters = {Words{"H\u0336", {100.0, 100.0}, 40.0, Font::Serif}}, both = letters;
  both.insert(both.begin(), filled({circle({20, 20}, 10)}));
  EXPECT_NEAR(inkOfItems(both) - inkOfItems(letters), inkOfItems({both[0]}), 1e-3);
}

TEST(Paint, ClosedLinesAreClosedWhereverTheyEnd) {
  std::vector<glm::dvec2> places = {{10, 10}, {190, 10}, {190, 190}};
  Outline open = outlineThrough(places, false), closed = outlineThrough(places, true);
  open.isClosed = true;
  EXPECT_NEAR(inkOfItems({stroked({open}, {kBlack, 2.0})}), inkOfItems({stroked({closed}, {kBlack, 2.0})}), 1e-3);
}

TEST(Paint, LinesHaveRoundEndsAndDashes) {
  Outline line = outlineThrough({{50, 100}, {150, 100}}, false);
  EXPECT_NEAR(inkOfItems({stroked({line}, {kBlack, 10.0})}), 1000.0 + std::numbers::pi * 25.0, 2.0);
  // 10 strokes of 4 with gaps of 6, each with two half circles.
  Outline shorter = outlineThrough({{50, 100}, {148, 100}}, false);
  EXPECT_NEAR(inkOfItems({stroked({shorter}, {kBlack, 2.0, 1.0, {4.0, 6.0}})}), 10 * (8.0 + std::numbers::pi), 2.0);
  Outline corner = outlineThrough({{50, 50}, {150, 50}, {150, 150}}, false);
  EXPECT_NEAR(sampleOf(painted({stroked({corner}, {kBlack, 20.0})}), 158, 41, 0), 1.0, 1e-6) << "corners are round";
}

TEST(Paint, OpacityMixesOnceForAShape) {
  Image image = painted({filled({rectangle({0, 0}, {100, 100})}, kRed, 0.25)});
  EXPECT_NEAR(sampleOf(image, 50, 50, 0), 1.0, 1e-6);
  EXPECT_NEAR(sampleOf(image, 50, 50, 1), 0.75, 1.0 / 255.0);
  Outline there = outlineThrough({{20, 50}, {180, 50}, {20, 50}}, false);
  image = painted({stroked({there}, {kBlack, 8.0, 0.5})});
  EXPECT_NEAR(sampleOf(image, 100, 50, 0), 0.5, 1.0 / 255.0) << "a line that crosses itself is no darker there";
}

TEST(Paint, TransparentPicturesStayStraight) {
  Image image = plainImage(20, 20, {0.0f, 1.0f, 0.0f}, 0.0f);
  paint(std::vector<Item>{filled({rectangle({0, 0}, {20, 20})}, kRed, 0.5)}, image);
  EXPECT_NEAR(sampleOf(image, 5, 5, 3), 0.5, 1.0 / 255.0);
  EXPECT_NEAR(sampleOf(image, 5, 5, 0), 1.0, 0.01) << "what is behind cannot be seen and does not mix";
  EXPECT_NEAR(sampleOf(image, 5, 5, 1), 0.0, 0.01);
  image = plainImage(20, 20, {0.0f, 1.0f, 0.0f}, 0.5f);
  paint(std::vector<Item>{filled({rectangle({0, 0}, {20, 20})}, kRed, 0.5)}, image);
  EXPECT_NEAR(sampleOf(image, 5, 5, 3), 0.75, 1.0 / 255.0);
  EXPECT_NEAR(sampleOf(image, 5, 5, 0), 0.5 / 0.75, 0.01);
}

TEST(Paint, TextIsAsWideAsItsLettersSay) {
  for (Font font : {Font::Sans, Font::SansBold, Font::Serif, Font::SerifBold})
    for (double em : {11.0, 23.5}) {
      // H stands 0.08 em inside of its place on both sides, so that two of them are found where the text has its ends.
      Letters letters(font, em);
      glm::ivec2 ink = inkOf(painted({Words{"HAVE an iliac H", {20.0, 100.0}, em, font}}, 400));
      Box box = boundsOf(std::vector<Item>{Words{"H", {0.0, 0.0}, em, font}});
      double before = box.low.x, after = letters.width("H") - box.high.x, width = letters.width("HAVE an iliac H");
      EXPECT_NEAR(ink.x, 20.0 + before, 1.01);
      EXPECT_NEAR(ink.y, 20.0 + width - after, 1.01);
    }
}

TEST(Paint, TwiceTheScaleIsTwiceTheSizeOfAllThings) {
  std::vector<Item> items = {Words{"Aorta", {10.0, 30.0}, 20.0, Font::Serif, kBlack, 1.0, Pen{kRed, 3.0, 0.5}},
                             stroked({circle({60, 60}, 20)}, {kBlack, 2.0, 1.0, {5.0, 4.0}}),
                             filled({rectangle({70.5, 10.5}, {90, 20})}, kBlack, 0.5)};
  Image once = painted(items, 100, 100), twice = painted(items, 200, 200, 2.0);
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      float mean = 0.0f;
      for (int i = 0; i < 4; ++i) mean += 0.25f * sampleOf(twice, 2 * x + i % 2, 2 * y + i / 2, 1);
      // Each of the samples is rounded, and each edge to 1/15 of a pixel.
      ASSERT_NEAR(sampleOf(once, x, y, 1), mean, 0.12) << x << " " << y;
    }
}

TEST(Paint, SameItemsHaveTheSamePixelsWherever) {
  auto at = [](glm::dvec2 by) { return Words{"Vena cava", glm::dvec2(20.25, 40.5) + by, 14.0, Font::SansBold}; };
  Image image = painted({at({0, 0})}), moved = painted({at({37, 90})});
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 150; ++x) ASSERT_EQ(sampleOf(image, x, y, 0), sampleOf(moved, x + 37, y + 90, 0));
}

TEST(Paint, APlateKeepsItsPixels) {
  Image noise = plainImage(40, 30, kBlack, 1.0f);
  unsigned random = 7;
  for (float& sample : noise.pixels) sample = float((random = random * 1664525u + 1013904223u) >> 24) / 255.0f;
  for (std::size_t i = 3; i < noise.pixels.size(); i += 4) noise.pixels[i] = i % 3 ? 1.0f : noise.pixels[i];
  Image image = painted({Plate{noise, {5, 8}, {40, 30}}}, 60, 50);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      float alpha = sampleOf(noise, x, y, 3), value = sampleOf(noise, x, y, 1);
      // Products are rounded to bytes.
      ASSERT_NEAR(sampleOf(image, x + 5, y + 8, 1), value * alpha + 1.0f - alpha,
                  alpha == 1.0f ? 1e-6f : 1.01f / 255.0f);
    }
  Image larger = painted({Plate{plainImage(10, 10, kRed), {20.5, 20.5}, {100, 50}}});
  EXPECT_NEAR(coverOf(larger), 0.0, 1e-3);
  EXPECT_EQ(sampleOf(larger, 60, 60, 1), 0.0f);
  EXPECT_NEAR(sampleOf(larger, 20, 40, 1), 0.5, 0.01) << "half of the pixel is covered";
}

TEST(Paint, ARasterIsWhatPaintingDoes) {
  std::vector<Item> items = {stroked({circle({90, 60}, 30)}, {kRed, 3.0}),
                             Words{"Vesica", {70.0, 65.0}, 12.0, Font::Sans, kBlack, 1.0, Pen{kWhite, 2.0}}};
  Raster raster = rasterOf(items, {200, 200});
  Box box = boundsOf(items);
  EXPECT_LE(glm::length(glm::dvec2(raster.corner) - box.low), 2.0);
  EXPECT_LE(glm::length(glm::dvec2(raster.corner + raster.size) - box.high), 2.0);
  Image image = painted(items), own = plainImage(200, 200);
  for (int y = 0; y < raster.size.y; ++y)
    for (int x = 0; x < raster.size.x; ++x)
      for (int c = 0; c < 3; ++c) {
        const std::uint8_t* pixel = &raster.rgba[4 * std::size_t(y * raster.size.x + x)];
        glm::ivec2 at = raster.corner + glm::ivec2(x, y);
        float& value = own.pixels[3 * std::size_t(at.y * 200 + at.x) + std::size_t(c)];
        value = float(pixel[c]) / 255.0f + value * (1.0f - float(pixel[3]) / 255.0f);
      }
  for (std::size_t i = 0; i < own.pixels.size(); ++i) ASSERT_NEAR(own.pixels[i], image.pixels[i], 1e-6);
  EXPECT_EQ(rasterOf(std::vector<Item>{}, {200, 200}).size, glm::ivec2(0));
  EXPECT_EQ(rasterOf(std::vector<Item>{filled({circle({-90, 60}, 30)})}, {200, 200}).size, glm::ivec2(0));
}

TEST(Paint, LargePicturesHaveNoSeams) {
  Image image = plainImage(4200, 40);
  paint(std::vector<Item>{filled({rectangle({0, 10}, {4190, 30})}), Words{"Seam", {4080.0, 8.0}, 10.0}}, image);
  for (int x = 0; x < 4200; ++x) ASSERT_EQ(sampleOf(image, x, 20, 0), x < 4190 ? 0.0f : 1.0f);
  Image near = plainImage(200, 40);
  paint(std::vector<Item>{Words{"Seam", {80.0, 8.0}, 10.0}}, near);
  for (int x = 0; x < 200; ++x) ASSERT_EQ(sampleOf(image, x + 4000, 5, 0), sampleOf(near, x, 5, 0));
}

TEST(Paint, ThreadsPaintAtOnce) {
  const Drawing drawing = plate();
  Image alone = plainImage(400, 300);
  paint(drawing.layers, alone);
  std::vector<Image> images(4, plainImage(400, 300));
  std::vector<std::thread> threads;
  for (Image& image : images) threads.emplace_back([&] { paint(drawing.layers, image); });
  for (std::thread& thread : threads) thread.join();
  for (const Image& image : images) EXPECT_EQ(image.pixels, alone.pixels);
}

TEST(Paint, WhatCannotBeDrawnIsLeftOut) {
  EXPECT_EQ(inkOfItems(undrawable()), 0.0);
  // Dashes that say nothing are none.
  Outline line = outlineThrough({{50, 100}, {150, 100}}, false);
  EXPECT_EQ(inkOfItems({stroked({line}, {kBlack, 10.0, 1.0, {0.0, 0.0}})}),
            inkOfItems({stroked({line}, {kBlack, 10.0})}));
  EXPECT_EQ(inkOfItems({stroked({line}, {kBlack, 10.0, 1.0, {-1.0, 4.0}})}),
            inkOfItems({stroked({line}, {kBlack, 10.0})}));
}

TEST(Paint, ManyLabelsTakeLittleTime) {
  std::vector<Item> items;
  for (int i = 0; i < 40; ++i) {
    glm::dvec2 start(i % 2 ? 40.0 : 1100.0, 20.0 + 17.0 * i);
    items.push_back(stroked({outlineThrough({start, {300.0 + 15.0 * i, 300.0}}, false)}, {kBlack, 1.5}));
    items.push_back(Words{"Musculus longus", start, 14.0, Font::Sans, kBlack, 1.0, Pen{kWhite, 3.0}});
  }
  Image image = plainImage(1280, 720);
  double least = 1e9;
  for (int i = 0; i < 20; ++i) {
    auto begin = std::chrono::steady_clock::now();
    paint(items, image);
    least =
        std::min(least, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  RecordProperty("ms", std::to_string(least));
  if (getenv("T")) printf("%g ms\n", least);
  EXPECT_LT(least, 1000.0) << "10 ms, and twenty times that under a sanitizer";
}

}  // namespace
}  // namespace velum::vector
