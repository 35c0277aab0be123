// Captions over pictures: where they stand, how they fade, and what they are made by.
#include "scene/Caption.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/Error.h"
#include "core/Text.h"
#include "lettered.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"
#include "session/command/DocumentCommands.h"
#include "session/command/LetteringCommands.h"
#include "session/document/Document.h"
#include "session/lettering/FreePlaces.h"
#include "session/lettering/Lettering.h"
#include "vector/Letters.h"

namespace velum::session {

namespace {

using scene::Caption;
using scene::CaptionPlace;

constexpr int kPlaces = int(std::size(EnumNames<CaptionPlace>::kNames));

/// How far each block of a lettering covers the pixels of a picture, without its glow.
std::vector<std::vector<std::uint8_t>> partsOf(const std::vector<LetteringBlock>& blocks, glm::ivec2 size) {
  std::vector<std::vector<std::uint8_t>> parts;
  for (const LetteringBlock& block : blocks) {
    std::vector<std::uint8_t>& part = parts.emplace_back(std::size_t(size.x) * std::size_t(size.y));
    vector::Raster raster = rasterOf(block, size);
    for (std::size_t i = 0; 4 * i < raster.rgba.size(); ++i) {
      if (raster.rgba[4 * i + 3] == 0) continue;
      glm::ivec2 at = raster.corner + glm::ivec2(int(i) % raster.size.x, int(i) / raster.size.x);
      bool isInside = glm::all(glm::greaterThanEqual(at, glm::ivec2(0))) && glm::all(glm::lessThan(at, size));
      EXPECT_TRUE(isInside) << at.x << " " << at.y << " is cut off";
      if (!isInside) return parts;
      part[std::size_t(at.y) * std::size_t(size.x) + std::size_t(at.x)] = raster.rgba[4 * i + 3];
    }
  }
  return parts;
}

std::vector<float> pictureOf(const scene::Scene& scene, glm::ivec2 size) {
  Image image{size.x, size.y, {"R", "G", "B"}, std::vector<float>(std::size_t(3 * size.x * size.y), 0.4f)};
  layOver(letteringBlocks(scene, size, {kPixels, {}}), image);
  return image.pixels;
}

}  // namespace

TEST(Captions, NothingCoversAnythingElseAndNothingIsCutOff) {
  const char* texts[] = {
      "Title",
      "A",
      "gypsum \u00c4\u00c5gj",
      "Two\nlines, of which the second is longer",
      "A long sentence that has to be broken, since no picture is as wide as it would be in one line",
      "Donaudampfschifffahrtselektrizit\u00e4tenhauptbetriebswerkbauunterbeamtengesellschaft"};
  std::mt19937 random(7);
  auto pick = [&](int count) { return int(random() % unsigned(count)); };
  for (int trial = 0; trial < 120; ++trial) {
    glm::ivec2 size = std::vector<glm::ivec2>{{1280, 720}, {320, 180}, {500, 900}, {1000, 400}}[std::size_t(pick(4))];
    std::vector<Caption> captions;
    for (int i = 0, count = 1 + pick(4); i < count; ++i)
      captions.push_back({.text = texts[pick(6)], .place = CaptionPlace(pick(kPlaces)), .size = 0.5 * (1 + pick(8))});
    scene::Scene scene = captioned(captions);
    scene.lettering.legend = scene.lettering.scaleBar = scene.lettering.timeStamp = true;
    scene.lettering.legendCorner = scene::Corner(pick(4));
    scene.lettering.scaleBarCorner = scene::Corner(pick(4));
    scene.lettering.timeStampCorner = scene::Corner(pick(4));
    auto parts = partsOf(letteringBlocks(scene, size, {kPixels, {}}), size);
    EXPECT_EQ(parts.size(), 3 + captions.size()) << "trial " << trial << " leaves something out";
    for (std::size_t pixel = 0; pixel < parts[0].size(); ++pixel) {
      int covering = 0;
      for (const auto& part : parts) covering += part[pixel] > 0;
      ASSERT_LE(covering, 1) << "trial " << trial << ", pixel " << int(pixel) % size.x << " " << int(pixel) / size.x;
    }
  }
}

TEST(Captions, EachStandsAtItsPlaceWithEqualMargins) {
  glm::ivec2 size(901, 601);
  for (int place = 0; place < kPlaces; ++place) {
    auto part = partsOf(
        letteringBlocks(captioned({{.text = "HHH\nHHH", .place = CaptionPlace(place), .size = 2}}), size, {}), size)[0];
    glm::ivec2 low = size, high(-1);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x)
        if (part[std::size_t(y * size.x + x)] > 100)
          low = glm::min(low, glm::ivec2(x, y)), high = glm::max(high, glm::ivec2(x, y));
    int margin = int(1.3 * 18 * 0.601);
    for (int axis = 0; axis < 2; ++axis) {
      int before = low[axis], behind = size[axis] - 1 - high[axis], cell = axis == 0 ? place % 3 : place / 3;
      EXPECT_NEAR(cell == 2 ? behind : before, cell == 1 ? behind : margin, 3) << place;
    }
  }
}

TEST(Captions, OfNoOpacityThereIsNoMarkAndOthersStandAsWithoutIt) {
  glm::ivec2 size(640, 360);
  Caption one{.text = "One"}, other{.text = "Other", .color = glm::vec3(1, 0.5f, 0)}, hidden{.text = "Hidden"};
  hidden.opacity = 0.0;
  EXPECT_TRUE(letteringBlocks(captioned({hidden}), size, {}).empty());
  EXPECT_EQ(pictureOf(captioned({one, hidden, other}), size), pictureOf(captioned({one, other}), size));
  Caption blank{.text = " \n "};
  EXPECT_TRUE(letteringBlocks(captioned({blank}), size, {}).empty());
}

TEST(Captions, HalfTheOpacityIsHalfTheWay) {
  glm::ivec2 size(640, 360);
  for (double opacity : {0.25, 0.5, 0.9}) {
    Caption whole{.text = "Half the way", .size = 3}, part = whole;
    part.opacity = opacity;
    auto before = pictureOf(captioned({}), size), all = pictureOf(captioned({whole}), size),
         some = pictureOf(captioned({part}), size);
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_NEAR(some[i], before[i] + opacity * (all[i] - before[i]), 1.5 / 255.0) << i;
  }
}

TEST(Captions, AColourOfItsOwnStandsOnWhatItIsReadOn) {
  Caption white{.text = "White", .color = glm::vec3(1.0f)};
  auto blocks = letteringBlocks(captioned({white}), {640, 360}, {});
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_LT(blocks[0].ground.g, 0.2f) << "the ground is white, too";
  EXPECT_EQ(std::get<vector::Words>(blocks[0].items[0]).color, glm::vec3(1.0f));
  white.color = glm::vec3(0.5f, 0.0f, 0.0f);
  EXPECT_EQ(letteringBlocks(captioned({white}), {640, 360}, {})[0].ground, glm::vec3(1.0f));
}

TEST(Captions, SectionsHaveThem) {
  scene::Scene scene = captioned({{.text = "One"}, {.text = "Two", .place = CaptionPlace::Top}});
  scene.lettering.timeStamp = true;
  EXPECT_EQ(letteringBlocks(scene, scene::SectionKind::Axial, {640, 360}, {}).size(), 3u);
}

/// Against all ways to break a text.
TEST(Captions, LinesAreFewAndThenAsEvenAsWordsLetThemBe) {
  vector::Letters letters(vector::Font::Sans, 20.0);
  std::vector<std::string> words = wordsOf("as even as the words of a sentence let them be");
  std::string text = "as even as the words of a sentence let them be";
  for (double most : {90.0, 130.0, 170.0, 230.0, 300.0, 600.0}) {
    std::size_t fewest = words.size();
    double least = 1e9;
    for (unsigned breaks = 0; breaks < 1u << (words.size() - 1); ++breaks) {
      std::vector<std::string> lines{words[0]};
      for (std::size_t i = 1; i < words.size(); ++i)
        breaks >> (i - 1) & 1 ? lines.push_back(words[i]) : void(lines.back() += " " + words[i]);
      double widest = 0.0;
      for (const auto& line : lines) widest = std::max(widest, letters.width(line));
      if (widest > most || lines.size() > fewest) continue;
      if (lines.size() < fewest) fewest = lines.size(), least = widest;
      least = std::min(least, widest);
    }
    auto lines = letters.lines(text, most);
    EXPECT_EQ(lines.size(), fewest) << most;
    double widest = 0.0;
    std::string joined;
    for (const auto& line : lines) {
      widest = std::max(widest, letters.width(line));
      joined += (joined.empty() ? "" : " ") + line;
    }
    EXPECT_EQ(joined, text);
    EXPECT_LE(widest, lines.size() == 1 ? most : least + 0.01 * most) << most;
  }
  EXPECT_EQ(letters.lines("a\n\nb", 100.0), (std::vector<std::string>{"a", "", "b"}));
}

TEST(Captions, LettersStandAsCloseAsTheFontSaysAndDigitsInColumns) {
  vector::Letters letters(vector::Font::Sans, 40.0);
  EXPECT_LT(letters.width("AV"), letters.width("A") + letters.width("V") - 1.0);
  EXPECT_EQ(letters.width("HH"), 2 * letters.width("H"));
  EXPECT_DOUBLE_EQ(letters.width("11.11"), letters.width("00.00"));
  EXPECT_NEAR(letters.width("AV To"), letters.width("AV") + letters.width(" ") + letters.width("To"), 1e-9);
}

/// Against every place of a grid.
TEST(Captions, ThePlaceThatIsFoundIsTheNearestFreeOne) {
  std::mt19937 random(11);
  auto pick = [&](int from, int to) { return from + int(random() % unsigned(to - from)); };
  for (int trial = 0; trial < 200; ++trial) {
    FreePlaces places(glm::dvec2(60, 40));
    std::vector<std::pair<glm::ivec2, glm::ivec2>> taken;  // low corners, and sizes
    for (int part = 0; part < 5; ++part) {
      glm::ivec2 size(pick(4, 25), pick(3, 12)), wanted(pick(2, 40), pick(2, 30));
      auto isFree = [&](glm::ivec2 at) {
        return glm::all(glm::greaterThanEqual(at, glm::ivec2(2))) &&
               glm::all(glm::lessThanEqual(at + size, glm::ivec2(58, 38))) &&
               std::none_of(taken.begin(), taken.end(), [&](const auto& other) {
                 return glm::all(glm::lessThan(at, other.first + other.second + 1)) &&
                        glm::all(glm::greaterThan(at + size, other.first - 1));
               });
      };
      auto way = [&](glm::dvec2 at) { return std::abs(at.y - wanted.y) + 4.0 * std::abs(at.x - wanted.x); };
      double least = 1e9;
      for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 60; ++x)
          if (isFree({x, y})) least = std::min(least, way({x, y}));
      auto at = places.take(size, wanted, 2.0, 1.0);
      ASSERT_EQ(bool(at), least < 1e9) << trial;
      if (!at) continue;
      EXPECT_TRUE(isFree(*at)) << trial;
      EXPECT_DOUBLE_EQ(way(*at), least) << trial;
      taken.emplace_back(*at, size);
    }
  }
}

TEST(Captions, WhateverATextHoldsAndHoweverSmallThePictureNothingBreaks) {
  std::string control, mixed = "\xff\xfe ok \xe2\x82 \xf0\x9f\x98\x80 \u4f60\u597d";
  for (int i = 1; i < 32; ++i) control += char(i);
  std::string endless(20000, 'x'), sentence;
  for (int i = 0; i < 5000; ++i) sentence += "\u00e4word ";
  for (const std::string& text : {control, mixed, endless, sentence})
    for (glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(8, 8), glm::ivec2(30, 500), glm::ivec2(640, 360)})
      for (double large : {0.2, 1.0, 20.0})
        partsOf(letteringBlocks(captioned({{.text = text, .size = large}, {.text = "x" + text}}), size, {}), size);
}

TEST(Captions, IdsAreUniqueWhateverAFileSays) {
  scene::Scene scene;
  scene.lettering.captions = {{.id = 4, .text = "a"}, {.text = "b"}, {.id = 4, .text = "c"}, {.id = -3, .text = "d"}};
  scene::completeItems(scene);
  std::set<int> ids;
  for (const Caption& caption : scene.lettering.captions) EXPECT_TRUE(caption.id > 0 && ids.insert(caption.id).second);
  EXPECT_EQ(scene.lettering.captions[0].id, 4);
  while (scene.lettering.captions.size() < scene::kMostCaptions)
    EXPECT_TRUE(ids.insert(scene::addCaption(scene.lettering.captions, {.id = 4})).second);
  EXPECT_THROW(scene::addCaption(scene.lettering.captions, {}), ArgumentError);
  EXPECT_THROW(scene::setField(scene, "lettering.captions.+.text", "x"), ArgumentError);
}

TEST(Captions, ASceneKeepsThemAndAnOldOneHasNone) {
  EXPECT_EQ(scene::toJson({}).find("aption"), std::string::npos);
  EXPECT_EQ(scene::toJson({}).find("timeStamp"), std::string::npos);
  scene::Scene scene;
  scene.lettering.timeStamp = true;
  scene.lettering.timeStampCorner = scene::Corner::TopRight;
  scene.lettering.captions = {
      {.id = 2, .text = "Zwei\nZeilen \u00e4 \"x\"", .place = CaptionPlace::Left, .opacity = 0.5},
      {.id = 1, .text = "", .size = 3, .color = glm::vec3(0.25f)}};
  EXPECT_TRUE(scene::fromJson(scene::toJson(scene)).lettering == scene.lettering);
  for (const char* bad : {"size 0.1", "opacity 2", "opacity -1", "place middle", "color 2,0,0", "id -1"}) {
    std::string_view field(bad, std::string_view(bad).find(' '));
    EXPECT_THROW(scene::setField(scene, "lettering.captions[#2]." + std::string(field), bad + field.size() + 1),
                 ArgumentError)
        << bad;
  }
}

TEST(Captions, CommandsAddSetAndRemoveThem) {
  Document document;
  edit(document, parseCall("caption.add place=topLeft size=2 The heart, \"opened\""));
  edit(document, parseCall(R"(caption.add "two\nlines")"));
  const auto& captions = document.scene().lettering.captions;
  EXPECT_EQ(captions,
            (std::vector<Caption>{{.id = 1, .text = "The heart, \"opened\"", .place = CaptionPlace::TopLeft, .size = 2},
                                  {.id = 2, .text = "two\nlines"}}));
  edit(document, parseCall("set lettering.captions[#2].opacity 0.25"));
  edit(document, parseCall("set lettering.captions[1].color 1,0,0"));
  EXPECT_EQ(captions[1].opacity, 0.25);
  EXPECT_EQ(captions[1].color, glm::vec3(1, 0, 0));
  for (const char* text : {"\"quoted\"", "1", "true", "[1]", "a\nb", " a ", ""}) {
    edit(document, SetField{"lettering.captions[#2].text", scene::valueOfText(text)});
    EXPECT_EQ(captions[1].text, text);
  }
  edit(document, parseCall("caption.remove #1"));
  ASSERT_EQ(captions.size(), 1u);
  EXPECT_EQ(captions[0].id, 2);
  EXPECT_THROW(edit(document, parseCall("caption.remove 1")), ArgumentError);
  edit(document, parseCall("caption.remove 2"));
  EXPECT_TRUE(captions.empty());
  document.undo();
  document.undo();
  EXPECT_EQ(captions.size(), 2u);
}

}  // namespace velum::session
