#include "velum/core/Text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

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

}  // namespace
}  // namespace velum
