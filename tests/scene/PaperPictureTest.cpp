// Pictures of paper that users bring.
#include "scene/PaperPicture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/Error.h"

namespace velum::scene {
namespace {

constexpr float kTurn = 6.2831853f;

Image pictureOf(glm::ivec2 size, const std::function<float(glm::vec2)>& greyAt) {
  Image image{size.x, size.y, {"R", "G", "B"}, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      float grey = greyAt((glm::vec2(float(x), float(y)) + 0.5f) / glm::vec2(size));
      image.pixels.insert(image.pixels.end(), {grey, grey, grey});
    }
  return image;
}

/// Grain, brighter on one side than on the other by so much, across and down.
Image grain(glm::vec2 lean) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> noise(-0.15f, 0.15f);
  return pictureOf({160, 120}, [&](glm::vec2 p) { return 0.6f + noise(random) + glm::dot(lean, p - 0.5f); });
}

TEST(PaperPicture, WavesThatEndAsTheyBeginTile) {
  auto waves = [](float across, float down) {
    return pictureOf({64, 48}, [=](glm::vec2 p) {
      return 0.5f + 0.2f * std::sin(kTurn * across * p.x) + 0.2f * std::sin(kTurn * down * p.y);
    });
  };
  EXPECT_EQ(tilesOf(waves(3.0f, 2.0f)), glm::bvec2(true, true));
  EXPECT_EQ(tilesOf(waves(3.25f, 2.0f)), glm::bvec2(false, true));
  EXPECT_EQ(tilesOf(waves(3.0f, 2.3f)), glm::bvec2(true, false));
  EXPECT_EQ(tilesOf(pictureOf({1, 1}, [](glm::vec2) { return 0.5f; })), glm::bvec2(true, true));
}

TEST(PaperPicture, LightFromOneSideIsASeamThatGrainDoesNotHide) {
  EXPECT_EQ(tilesOf(grain({0, 0})), glm::bvec2(true, true));
  EXPECT_EQ(tilesOf(grain({0.15f, 0})), glm::bvec2(false, true));
  EXPECT_EQ(tilesOf(grain({0, 0.15f})), glm::bvec2(true, false));
}

TEST(PaperPicture, LargeOnesAreMadeSmallerAndOthersStay) {
  Image small = grain({0, 0});
  EXPECT_EQ(fitPaper(small).pixels, small.pixels);
  Image wide{2 * kPaperSize, 30, {"Y"}, std::vector<float>(std::size_t(2 * kPaperSize) * 30, 0.25f)};
  Image fitted = fitPaper(wide);
  EXPECT_EQ(glm::ivec2(fitted.width, fitted.height), glm::ivec2(kPaperSize, 15));
  EXPECT_EQ(fitted.channels.size(), 3u);
  EXPECT_FLOAT_EQ(fitted.pixels[100], 0.25f);
  EXPECT_THROW(fitPaper(Image{}), ArgumentError);
}

}  // namespace
}  // namespace velum::scene
