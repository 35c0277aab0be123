#include "core/Text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/Error.h"
#include "core/SayCount.h"

namespace velum {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Text, WordsStandBetweenBlanks) {
  EXPECT_EQ(trimmed(" \t a b\r\n"), "a b");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_EQ(wordsOf("  one\ttwo\r\nthree"), (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_TRUE(wordsOf(" \n").empty());
}

TEST(Text, ANumberIsTakenFromTheFront) {
  std::string_view text = " 1.5, +2e3mm -7";
  EXPECT_EQ(takeNumber(text), 1.5);
  EXPECT_EQ(text, ", +2e3mm -7");
  EXPECT_FALSE(takeNumber(text));
  EXPECT_EQ(text, ", +2e3mm -7");
  text.remove_prefix(1);
  EXPECT_EQ(takeNumber(text), 2000.0);
  EXPECT_EQ(text, "mm -7");
  text.remove_prefix(2);
  EXPECT_EQ(takeNumber(text), -7.0);
  EXPECT_FALSE(takeNumber(text));
}

TEST(Text, ANumberAndNothingElse) {
  EXPECT_EQ(numberIn(" 0.25 "), 0.25);
  EXPECT_FALSE(numberIn("0,25"));
  EXPECT_FALSE(numberIn("1 2"));
  EXPECT_FALSE(numberIn(""));
  EXPECT_FALSE(numberIn("+-1"));
  EXPECT_TRUE(std::isnan(numberIn("nan").value()));
}

TEST(Text, NumbersBeyondADoubleAreZeroOrInfinite) {
  EXPECT_EQ(numberIn("1e400"), kInfinity);
  EXPECT_EQ(numberIn("-1e400"), -kInfinity);
  EXPECT_EQ(numberIn("4e-400"), 0.0);
  EXPECT_EQ(numberIn("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_EQ(numberIn("1" + std::string(400, '0')), kInfinity);
  EXPECT_EQ(numberIn("1" + std::string(400, '0') + ".5"), kInfinity);
}

TEST(Text, ATidyNumberIsAsPeopleReadIt) {
  EXPECT_EQ(tidyNumber(19860), "19860");
  EXPECT_EQ(tidyNumber(-1024), "-1024");
  EXPECT_EQ(tidyNumber(123.4), "123");
  EXPECT_EQ(tidyNumber(1.5), "1.5");
  EXPECT_EQ(tidyNumber(0.25), "0.25");
  EXPECT_EQ(tidyNumber(0.0), "0");
  EXPECT_EQ(tidyNumber(6.32e-41), "0");
  EXPECT_EQ(tidyNumber(2e9), "2e+09");
}

TEST(Text, CountsAreInGroupsOfThree) {
  EXPECT_EQ(grouped(0, ","), "0");
  EXPECT_EQ(grouped(999, ","), "999");
  EXPECT_EQ(grouped(1000, " "), "1 000");
  EXPECT_EQ(grouped(1234567, ","), "1,234,567");
}

TEST(Text, QuotesInAFieldOfATableAreDoubled) { EXPECT_EQ(csvQuoted("a \"b\", c"), "\"a \"\"b\"\", c\""); }

TEST(Text, PrintableIsOneLineThatNoTerminalObeys) {
  EXPECT_EQ(printable("plain, näive, 體積 🧠"), "plain, näive, 體積 🧠");
  EXPECT_EQ(printable("a\nb\tc\rd"), "a\\nb\\tc\\x0dd");
  EXPECT_EQ(printable("\x1b[31mred\x7f"), "\\x1b[31mred\\x7f");
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("\xc2\x9b"
                      "2J"),
            "\\xc2\\x9b2J")
      << "C1 as UTF-8";
  EXPECT_EQ(printable("\xe9t\xe9"), "\\xe9t\\xe9") << "Latin-1";
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "overlong";
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
  EXPECT_EQ(printable("cut \xe2\x82"), "cut \\xe2\\x82");
}

TEST(Text, AnErrorIsOneLineWhateverItQuotes) {
  EXPECT_STREQ(InputError("a\nb\x1b[2J.nrrd: is damaged").what(), "a\\nb\\x1b[2J.nrrd: is damaged");
}

TEST(Text, OneThingIsToldAsOne) {
  auto said = [](std::size_t count) {
    return sayCount(count, "1 image was left out", "{} images of {} were left out", "a series");
  };
  EXPECT_EQ(said(1), "1 image was left out");
  EXPECT_EQ(said(2), "2 images of a series were left out");
  EXPECT_EQ(said(0), "0 images of a series were left out");
}

}  // namespace
}  // namespace velum
