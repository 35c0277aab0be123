#pragma once
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "core/Image.h"
#include "vector/Drawing.h"

namespace velum::vector {

inline const glm::vec3 kRed{1.0f, 0.0f, 0.0f}, kWhite{1.0f}, kBlack{0.0f};

/// A picture of one colour. @param alpha  below 0: it has none
inline Image plainImage(int width, int height, glm::vec3 color = kWhite, float alpha = -1.0f) {
  Image image{width, height, {"R", "G", "B"}, {}};
  if (alpha >= 0.0f) image.channels.push_back("A");
  for (int i = 0; i < width * height; ++i) {
    image.pixels.insert(image.pixels.end(), {color.r, color.g, color.b});
    if (alpha >= 0.0f) image.pixels.push_back(alpha);
  }
  return image;
}

inline float sampleOf(const Image& image, int x, int y, std::size_t channel) {
  return image.pixels[(std::size_t(y) * std::size_t(image.width) + std::size_t(x)) * image.channels.size() + channel];
}

inline Shape filled(std::vector<Outline> outlines, glm::vec3 color = kBlack, double opacity = 1.0) {
  return {"", std::move(outlines), std::nullopt, Fill{color, opacity}};
}
inline Shape stroked(std::vector<Outline> outlines, Pen pen) { return {"", std::move(outlines), std::move(pen), {}}; }

inline Outline rectangle(glm::dvec2 low, glm::dvec2 high) {
  return outlineThrough({low, {high.x, low.y}, high, {low.x, high.y}}, true);
}

/// How much of a white picture is covered by black, pixels.
inline double coverOf(const Image& image) {
  double cover = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) cover += 1.0 - double(sampleOf(image, x, y, 0));
  return cover;
}

/// Items that cannot be drawn.
inline std::vector<Item> undrawable() {
  const double nan = std::numeric_limits<double>::quiet_NaN(), far = std::numeric_limits<double>::infinity();
  Words pale{"a", {10.0, 10.0}, 9.0, Font::Sans, kBlack, nan};
  return {filled({circle({nan, 0}, 3)}),
          filled({circle({9, 9}, 3)}, {0.0f, float(nan), 0.0f}),
          stroked({circle({10, 10}, 3)}, {kBlack, 0.0}),
          stroked({circle({10, 10}, 3)}, {kBlack, far}),
          Shape{"nothing", {circle({10, 10}, 3)}},
          pale,
          Words{"a", {far, 0.0}},
          Words{"a", {10.0, 10.0}, -1.0},
          Words{"", {10.0, 10.0}},
          Plate{},
          Plate{plainImage(2, 2), {0, 0}, {0, 5}}};
}

/// A contour of 200 curves.
inline Outline wave(int which) {
  Outline outline{{which * 30.123, 500.456}, {}, true};
  for (int i = 0; i < 200; ++i) {
    glm::dvec2 at(which * 30.123 + i * 7.321, 500.456 + (i * 37 + which) % 100 * 13.77);
    outline.curves.push_back({at, at + glm::dvec2(3.317, 9.713), at + glm::dvec2(8.111, 2.222)});
  }
  return outline;
}

/// Text that nobody should write, and that files must hold all the same.
inline const std::string kHostileText = "<\"&'>]]>--> \x01\xff\xc3 (\\)%s{}\xe6\xbc\xa2\xf0\x9f\x98\x80";

/// A plate of 96 x 72 points: a picture, contours, leaders, labels, a legend; 400 x 300 pixels.
inline Drawing plate() {
  Image image = plainImage(400, 300);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 400; ++x)
      for (int c = 0; c < 3; ++c)
        image.pixels[3 * std::size_t(y * 400 + x) + std::size_t(c)] = float((x * (c + 1) + y * 3) % 256) / 255.0f;
  Shape lung = filled({circle({140, 120}, 60), circle({150, 130}, 20)}, {0.2f, 0.5f, 0.9f}, 0.4);
  lung.name = "Lung, left";
  lung.pen = Pen{{0.1f, 0.2f, 0.6f}, 3.0};
  Shape liver =
      stroked({Outline{{220, 200}, {{{260, 120}, {330, 140}, {350, 210}}, {{360, 260}, {250, 290}, {220, 200}}}, true}},
              Pen{kBlack, 2.5, 0.8, {8.0, 6.0}});
  liver.name = "Liver";
  Words words{"Pulmo sinister", {30, 40}, 22.0, Font::Sans, kBlack, 1.0, Pen{kWhite, 5.0}};
  Words serif{"Hepar", {300, 100}, 18.0, Font::SerifBold, {0.5f, 0.0f, 0.0f}, 1.0, Pen{kWhite, 4.0, 0.6}};
  return {{400, 300},
          300.0,
          "Thorax & abdomen",
          {{"picture", {Plate{image, {0, 0}, {400, 300}}}},
           {"contours", {lung, liver}},
           {"leaders", {stroked({outlineThrough({{90, 46}, {120, 90}}, false)}, {kBlack, 1.5})}},
           {"labels", {words, serif, Words{"\u00b5m, \u2192 AVA", {20, 280}, 16.0, Font::Serif}}},
           {"legend",
            {filled({rectangle({300, 260}, {320, 275})}, kRed), Words{"Bold 3.5", {325, 274}, 16.0, Font::SansBold}}}}};
}

}  // namespace velum::vector
