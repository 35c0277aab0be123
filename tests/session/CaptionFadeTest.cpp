// Captions that fade: where they and the others of their place stand meanwhile.
#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "lettered.h"
#include "session/lettering/Lettering.h"

namespace velum::session {

namespace {

using scene::Caption;
using scene::CaptionPlace;

constexpr glm::ivec2 kFadeSize(640, 360);

}  // namespace

/// A fade in 60 frames: one of three captions goes, comes, or goes while another comes.
TEST(CaptionFades, OthersGlideWhileOneFadesAndNoneJumps) {
  const glm::vec3 colors[] = {{1, 0, 0}, {0, 0.5f, 0}, {0, 0, 1}};
  const double sizes[] = {5.0, 1.5, 2.0};
  // Of each by its colour: where its words begin, unless it has none.
  auto cornersOf = [&](CaptionPlace place, const std::array<double, 3>& opacity) {
    std::vector<Caption> captions;
    for (int i = 0; i < 3; ++i)
      captions.push_back({.text = i == 1 ? "Two\nlines" : "One line",
                          .place = place,
                          .size = sizes[i],
                          .color = colors[i],
                          .opacity = opacity[std::size_t(i)]});
    std::array<std::optional<glm::dvec2>, 3> corners;
    for (const LetteringBlock& block : letteringBlocks(captioned(captions), kFadeSize, {}))
      for (int i = 0; i < 3; ++i)
        if (firstWords(block).color == colors[i]) corners[std::size_t(i)] = firstWords(block).start;
    return corners;
  };
  constexpr int kFrames = 60;
  double largest = sizes[0] * 18.0 * 0.36, most = 0.0;  // em, pixels
  // The room opens three times as fast as the letters: with them go the three gaps and the margin, as they are of the
  // largest letters; a pixel along each axis, since marks begin at whole ones.
  const double kStep = 3.0 / kFrames * largest * (0.72 + 3.0 * 0.6 + 0.35) + 1.5;
  for (CaptionPlace place : {CaptionPlace::TopLeft, CaptionPlace::Centre, CaptionPlace::Bottom})
    for (int fading = 0; fading < 3; ++fading)
      for (int coming : {-1, (fading + 1) % 3, (fading + 2) % 3}) {
        std::array<std::optional<glm::dvec2>, 3> before;
        for (int frame = 0; frame <= kFrames; ++frame) {
          std::array<double, 3> opacity{1.0, 1.0, 1.0};
          opacity[std::size_t(fading)] = 1.0 - double(frame) / kFrames;
          if (coming >= 0) opacity[std::size_t(coming)] = double(frame) / kFrames;
          auto now = cornersOf(place, opacity);
          for (std::size_t i = 0; frame > 0 && i < 3; ++i)
            if (now[i] && before[i]) most = std::max(most, glm::distance(*now[i], *before[i]));
          before = now;
        }
      }
  EXPECT_LE(most, kStep);
  EXPECT_LT(kStep, 0.2 * largest) << "no jump passes";
  EXPECT_GT(most, 2.0) << "they move";
}

TEST(CaptionFades, OneThatFadesAloneStaysWhereItIs) {
  for (int place = 0; place < int(std::size(EnumNames<CaptionPlace>::kNames)); ++place)
    for (double large : {1.0, 6.0}) {
      Caption whole{.text = "Alone\nfor long", .place = CaptionPlace(place), .size = large}, faint = whole;
      auto blocks = letteringBlocks(captioned({whole}), kFadeSize, {});
      for (double opacity : {0.6, 0.3, 0.05}) {
        faint.opacity = opacity;
        EXPECT_EQ(firstWords(letteringBlocks(captioned({faint}), kFadeSize, {}).at(0)).start,
                  firstWords(blocks.at(0)).start)
            << place;
      }
    }
}

}  // namespace velum::session
