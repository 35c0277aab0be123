#include "vector/Letters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vector/Unicode.h"

namespace velum::vector {
namespace {

/// Numbers of the fonts' tables hmtx and kern, of 2048 units an em.
TEST(Letters, StandWhereTheFontSays) {
  Letters sans(Font::Sans, 2048.0), bold(Font::SansBold, 2048.0), serif(Font::Serif, 2048.0);
  EXPECT_NEAR(sans.width("A"), 1366.0, 1e-9);
  EXPECT_NEAR(bold.width("A"), 1479.0, 1e-9);
  EXPECT_NEAR(serif.width("A"), 1479.0, 1e-9);
  std::vector<Glyph> glyphs = sans.glyphs("AVA");
  ASSERT_EQ(glyphs.size(), 3u);
  EXPECT_NEAR(glyphs[1].x, 1366.0 - 152.0, 1e-9);
  EXPECT_NEAR(sans.width("11"), 2.0 * 1139.0, 1e-9) << "digits stand in columns, though the font has 11 closer";
}

TEST(Letters, TextOfTwiceTheSizeIsTwiceAsWide) {
  for (Font font : {Font::Sans, Font::SansBold, Font::Serif, Font::SerifBold})
    EXPECT_NEAR(Letters(font, 17.3).width("Vena cava, AVATAR 3.5 µm"),
                17.3 * Letters(font, 1.0).width("Vena cava, AVATAR 3.5 µm"), 1e-9);
}

TEST(Letters, OutlinesEncloseWhatTheyShow) {
  // The H of Liberation Sans is 1409 units high; I is a bar 191 units wide.
  Letters letters(Font::Sans, 2048.0);
  std::vector<Outline> bar = letters.outlines("I", {100.0, 2000.0});
  ASSERT_EQ(bar.size(), 1u);
  double area = 0.0;
  glm::dvec2 from = bar[0].start, low = from, high = from;
  for (const Curve& curve : bar[0].curves) {
    EXPECT_TRUE(isStraight(from, curve));
    area += 0.5 * (from.x * curve.end.y - from.y * curve.end.x);
    from = curve.end;
    low = glm::min(low, from), high = glm::max(high, from);
  }
  EXPECT_NEAR(high.y, 2000.0, 1e-9) << "it stands on the base line";
  EXPECT_NEAR(low.y, 2000.0 - 1409.0, 1e-9);
  EXPECT_NEAR(std::abs(area), 191.0 * 1409.0, 1e-3);
  EXPECT_EQ(letters.outlines("o", {}).size(), 2u);
  EXPECT_TRUE(letters.outlines("  ", {}).empty());
  EXPECT_NEAR(letters.outlines("HI", {}).back().start.x - letters.outlines("I", {}).back().start.x, 1479.0, 1e-9);
}

TEST(Letters, FittedTextFitsAndKeepsItsEnds) {
  Letters letters(Font::Serif, 12.0);
  std::string text = "Musculus sternocleidomastoideus";
  EXPECT_EQ(letters.fitted(text, 1000.0), text);
  std::string shorter = letters.fitted(text, 80.0);
  EXPECT_LE(letters.width(shorter), 80.0);
  EXPECT_EQ(shorter.front(), 'M');
  EXPECT_EQ(shorter.back(), 's');
  for (const std::string& line : letters.lines(text + " and more of it\nnew", 80.0))
    EXPECT_LE(letters.width(line), 80.0);
  EXPECT_EQ(letters.lines("a\nb", 80.0), (std::vector<std::string>{"a", "b"}));
}

TEST(Letters, OfTextThatIsNoneAreDrawnAllTheSame) {
  EXPECT_EQ(cleanText("a\tb\nc"), "a b c");
  EXPECT_EQ(cleanText("µ → 漢 😀"), "µ → 漢 😀");
  const std::string bad = "\xef\xbf\xbd";
  EXPECT_EQ(cleanText(std::string("a\0b\x1b\x7f", 5)), "a" + bad + "b" + bad + bad);
  EXPECT_EQ(cleanText("\xff\xc3"), bad + bad);
  EXPECT_EQ(cleanText("\xc0\x80"), bad + bad) << "longer than it needs";
  EXPECT_EQ(cleanText("\xe0\x82\xb5"), bad + bad + bad) << "longer than it needs";
  EXPECT_EQ(cleanText("\xf0\x82\x82\xac"), bad + bad + bad + bad) << "longer than it needs";
  EXPECT_EQ(cleanText("\xed\xa0\x80"), bad + bad + bad) << "half of a pair";
  EXPECT_EQ(cleanText("\xef\xbf\xbf\xc2\x85"), bad + bad);
  EXPECT_EQ(cleanText("\xf4\x90\x80\x80"), bad + bad + bad + bad) << "beyond the last letter";
  Letters letters(Font::Sans, 10.0);
  EXPECT_EQ(letters.glyphs("漢")[0].index, 0u);
  EXPECT_GT(letters.width("漢"), 0.0);
  EXPECT_FALSE(letters.outlines("漢", {}).empty()) << "a box stands for it";
}

}  // namespace
}  // namespace velum::vector
