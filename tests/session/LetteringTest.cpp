// What is written over pictures: legend and scale bar, as values and as pixels.
#include "session/lettering/Lettering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "core/Text.h"
#include "lettered.h"
#include "makeModel.h"
#include "makeVolume.h"
#include "scene/Project.h"
#include "scene/Scene.h"
#include "scene/SectionPlane.h"
#include "session/command/Command.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/command/ModelCommands.h"
#include "session/model/CountFiles.h"
#include "session/model/LegendLacks.h"
#include "session/model/ModelEdit.h"
#include "vector/Letters.h"

namespace velum::session {

namespace {

/// A picture with nothing in it.
Image blank(glm::ivec2 size, glm::vec3 ground) {
  Image image{size.x, size.y, {"R", "G", "B"}, {}};
  for (int i = 0; i < size.x * size.y; ++i) image.pixels.insert(image.pixels.end(), {ground.r, ground.g, ground.b});
  return image;
}

Image letteredPicture(const scene::Scene& scene, glm::ivec2 size) {
  Image image = blank(size, scene.background.top);
  layOver(letteringBlocks(scene, size, {kPixels, {}}), image);
  return image;
}

}  // namespace

TEST(Lettering, AScaleBarIsAsLongAsItSaysInBothProjectionsAndAtEverySize) {
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic})
    for (glm::ivec2 size : {glm::ivec2(640, 480), glm::ivec2(3000, 2000), glm::ivec2(500, 900)}) {
      scene::Scene scene = lettered(glm::vec3(1.0f));
      scene.camera.projection = projection;
      auto bar = scaleBarOf(scene, size);
      ASSERT_TRUE(bar);
      glm::dvec3 along = scene::cameraBasis(scene.camera).right * bar->length;
      auto from = scene::pixelFromWorld(scene.camera, size, scene.camera.target - 0.5 * along);
      auto to = scene::pixelFromWorld(scene.camera, size, scene.camera.target + 0.5 * along);
      ASSERT_TRUE(from && to);
      EXPECT_NEAR(glm::distance(*from, *to), bar->pixels, 1e-6 * bar->pixels);
      EXPECT_LT(bar->pixels, 0.25 * size.x);
      EXPECT_GT(bar->pixels, 0.05 * size.x);
      double digit = bar->length / std::pow(10.0, std::floor(std::log10(bar->length) + 1e-9));
      EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9) << digit;
      std::string_view words = bar->text;
      EXPECT_NEAR(*takeNumber(words) * 10.0, bar->length, 1e-9) << bar->text;
      EXPECT_EQ(words, " nm");
    }
}

TEST(Lettering, TheBarThatIsDrawnHasTheLengthOfTheBar) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene.lettering.legend = false;
  glm::ivec2 size(900, 600);
  Image image = letteredPicture(scene, size);
  double widest = 0.0;
  for (int y = 0; y < size.y; ++y) {
    double ink = 0.0;
    for (int x = 0; x < size.x; ++x) ink += 1.0 - double(image.pixels[std::size_t(3 * (y * size.x + x))]);
    widest = std::max(widest, ink / (1.0 - 0.08));
  }
  EXPECT_NEAR(widest, scaleBarOf(scene, size)->pixels, 0.6);
}

TEST(Lettering, AVolumeWhoseVoxelsHaveNoKnownLengthHasNoBar) {
  scene::Scene scene;
  Volume volume = makeVolume({8, 8, 8}, SampleType::UInt8, [](glm::ivec3 v) { return v.x; });
  volume.isSpacingKnown = true;
  scene.volume.data = Shared<Volume>(volume);
  EXPECT_TRUE(scaleBarOf(scene, {640, 480}));
  volume.isSpacingKnown = false;
  scene.volume.data = Shared<Volume>(volume);
  EXPECT_FALSE(scaleBarOf(scene, {640, 480}));
  EXPECT_FALSE(scaleBarOf(scene::Scene(), {640, 480})) << "nothing is open";
}

TEST(Lettering, ASectionsBarIsAsLongAsItSaysInItsPicture) {
  scene::Scene scene;
  scene.unit = LengthUnit::Millimetre;
  Volume volume = makeVolume({64, 48, 40}, SampleType::UInt8, [](glm::ivec3) { return 0; });
  volume.isSpacingKnown = true;
  scene.volume.data = Shared<Volume>(volume);
  scene.background.bottom = glm::vec3(0.0f);
  glm::ivec2 size(600, 400);
  for (auto kind : {scene::SectionKind::Axial, scene::SectionKind::Coronal, scene::SectionKind::Sagittal}) {
    auto bar = scaleBarOf(scene, kind, size);
    ASSERT_TRUE(bar);
    scene::SectionPlane plane = scene::makeSectionPlane(scene, kind, glm::dvec2(size));
    EXPECT_NEAR(bar->pixels * plane.lengthPerPixel, bar->length, 1e-9);
    EXPECT_TRUE(bar->text.ends_with(" mm")) << bar->text;
    EXPECT_TRUE(letteringBlocks(scene, kind, size, {}).empty()) << "nobody asked for it";
    scene.lettering.scaleBar = true;
    Image image = blank(size, glm::vec3(0.0f));
    layOver(letteringBlocks(scene, kind, size, {}), image);
    double widest = 0.0;
    for (int y = 0; y < size.y; ++y) {
      double ink = 0.0, most = 0.0;
      for (int x = 0; x < size.x; ++x) {
        double light = double(image.pixels[std::size_t(3 * (y * size.x + x))]);
        ink += light;
        most = std::max(most, light);
      }
      if (most > 0.7) widest = std::max(widest, ink / most);  // light on dark, and no row at its edge
    }
    EXPECT_NEAR(widest, bar->pixels, 0.6);
    scene.lettering.scaleBar = false;
  }
}

TEST(Lettering, LinksInNamesAreTheirWords) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  Model model = ModelMaker{.types = 1}.make();
  model.types[0].name = "[Spike_protein](https://x)";
  scene.model.data = Shared<Model>(std::move(model));
  EXPECT_EQ(namesOf(scene, {{100}, 1000}), std::vector<std::string>{"Spike protein"});
}

/// The mean of 2 x 2 pixels of a picture of twice the rows is the picture.
TEST(Lettering, APictureOfTwiceTheRowsLooksAlike) {
  scene::Scene scene = lettered(glm::vec3(0.96f, 0.94f, 0.89f));
  Image small = letteredPicture(scene, {1500, 1000}), large = letteredPicture(scene, {3000, 2000});
  double sum = 0.0, ink = 0.0;
  for (int y = 0; y < 1000; ++y)
    for (int x = 0; x < 1500; ++x)
      for (int c = 0; c < 3; ++c) {
        auto at = [&](int dx, int dy) {
          return double(large.pixels[std::size_t(((2 * y + dy) * 3000 + 2 * x + dx) * 3 + c)]);
        };
        double one = small.pixels[std::size_t((y * 1500 + x) * 3 + c)];
        sum += std::abs(one - 0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)));
        ink += std::abs(one - double(scene.background.top[c]));
      }
  EXPECT_GT(ink, 1000.0);
  EXPECT_LT(sum, 0.05 * ink);
}

TEST(Lettering, ItIsDarkOnLightAndLightOnDarkAndItsGlowIsTheGrounds) {
  for (float ground : {0.0f, 0.1f, 0.9f, 1.0f}) {
    scene::Scene scene = lettered(glm::vec3(ground));
    scene.lettering.legend = false;
    Image image = letteredPicture(scene, {900, 600});
    auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    EXPECT_NEAR(ground > 0.5f ? *high : *low, ground, 1.0 / 255.0)
        << "no box, and nothing is " << (ground > 0.5f ? "lighter" : "darker");
    EXPECT_GT(*high - *low, 0.8f);
  }
  scene::Scene scene = lettered(glm::vec3(0.0f));
  scene.finish.paper = scene::Paper::Smooth;
  scene.finish.paperColor = glm::vec3(1.0f);
  for (const LetteringBlock& block : letteringBlocks(scene, {900, 600}, {})) {
    EXPECT_EQ(block.ground, glm::vec3(1.0f)) << "on light paper";
    for (const vector::Item& item : block.items)
      if (const auto* words = std::get_if<vector::Words>(&item)) {
        EXPECT_LT(words->color.r, 0.2f);
      }
  }
}

TEST(Lettering, WhereTheSceneAsksForNoneThereIsNoMark) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene.lettering = {};
  EXPECT_TRUE(letteringBlocks(scene, {600, 400}, {kPixels, {}}).empty());
}

TEST(Lettering, PartsInOneCornerStandBesideEachOtherWithinThePicture) {
  for (auto corner :
       {scene::Corner::TopLeft, scene::Corner::TopRight, scene::Corner::BottomLeft, scene::Corner::BottomRight}) {
    scene::Scene both = lettered(glm::vec3(1.0f)), legend = both, bar = both;
    both.lettering.legendCorner = both.lettering.scaleBarCorner = corner;
    legend.lettering.legendCorner = corner;
    legend.lettering.scaleBar = bar.lettering.legend = false;
    bar.lettering.scaleBarCorner = corner;
    glm::ivec2 size(900, 600);
    auto inkOf = [&](const scene::Scene& scene) {
      double ink = 0.0;
      for (float value : letteredPicture(scene, size).pixels) ink += 1.0 - double(value);
      return ink;
    };
    EXPECT_NEAR(inkOf(both), inkOf(legend) + inkOf(bar), 0.02 * inkOf(both)) << enumName(corner);
    for (const LetteringBlock& block : letteringBlocks(both, size, {kPixels, {}})) {
      vector::Raster raster = rasterOf(block, size);
      EXPECT_TRUE(glm::all(glm::greaterThanEqual(raster.corner, glm::ivec2(0))));
      EXPECT_TRUE(glm::all(glm::lessThanEqual(raster.corner + raster.size, size)));
    }
  }
}

TEST(Lettering, LettersOfTwiceTheSizeAreTwiceAsWideAndLongTextsAreShortenedBetweenLetters) {
  vector::Letters small(vector::Font::Sans, 10.0), large(vector::Font::Sans, 20.0);
  std::string text = "\u03b1-synuclein, \u00b5m \u2013 Gr\u00f6\u00dfe";
  EXPECT_NEAR(large.width(text), 2.0 * small.width(text), 1e-9);
  EXPECT_EQ(small.fitted(text, 1000.0), text);
  for (double most : {12.0, 40.0, 80.0, 100.0}) {
    std::string shorter = small.fitted(text, most);
    EXPECT_LE(small.width(shorter), most) << shorter;
    EXPECT_NE(shorter.find("\u2026"), std::string::npos);
    std::size_t letters = std::size_t(std::count_if(
        shorter.begin(), shorter.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }));
    EXPECT_NEAR(small.width(shorter), large.width(shorter) / 2, 1e-9) << letters;
    EXPECT_EQ(shorter.find("\ufffd"), std::string::npos);
  }
}

TEST(CountFiles, TablesKeepPathsAndHaveTheAuthorsNames) {
  scene::Scene scene = after(lettered(glm::vec3(1.0f)), RenameType{"root.a.type2", "Spike"});
  std::vector<Counts> counts(5, Counts{1, 2, 3});
  std::string csv = countsCsv(countRows(scene.model, counts));
  EXPECT_NE(csv.find("type,root.a.type2,Spike,1,2,3,6\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find("type,root.a.type0,type0,1,2,3,6\n"), std::string::npos) << csv;
}

}  // namespace velum::session
