// Both themes can be read.
#include <gtest/gtest.h>

#include <cmath>

#include "gui/kit/Theme.h"

namespace velum::gui {
namespace {

/// Relative luminance and contrast as WCAG 2 defines them.
double luminance(const QColor& color) {
  auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}
double contrast(const QColor& a, const QColor& b) {
  double light = luminance(a), dark = luminance(b);
  return (std::max(light, dark) + 0.05) / (std::min(light, dark) + 0.05);
}

struct Pair {
  const char *front, *ground;
  double least;
};

TEST(Theme, TextStandsOutFromItsGround) {
  constexpr double kText = 4.5, kSign = 3.0;  // WCAG 2.1 AA: 1.4.3 and 1.4.11
  const Pair pairs[] = {{"text", "ground", kText},        {"text", "panel", kText},
                        {"text", "popup", kText},         {"text", "tip", kText},
                        {"text", "button", kText},        {"text", "buttonHover", kText},
                        {"text", "hover", kText},         {"text", "edge", kText},
                        {"text", "errorFill", kText},     {"text", "noteFill", kText},
                        {"text", "emptyTop", kText},      {"text", "emptyBottom", kText},
                        {"soft", "ground", kText},        {"soft", "panel", kText},
                        {"muted", "panel", kText},        {"muted", "ground", kText},
                        {"muted", "popup", kText},        {"muted", "emptyTop", kText},
                        {"muted", "emptyBottom", kText},  {"muted", "noteFill", kText},
                        {"onChosen", "chosen", kText},    {"onChosen", "main", kText},
                        {"onChosen", "mainHover", kText}, {"alarm", "panel", kText},
                        {"alarm", "ground", kText},       {"accent", "panel", kText},
                        {"accent", "ground", kText},      {"accent", "popup", kText},
                        {"accent", "emptyBottom", kSign}, {"control", "panel", kSign},
                        {"control", "ground", kSign},     {"faint", "ground", kText},
                        {"faint", "panel", kText},        {"faint", "popup", kText},
                        {"faint", "buttonOff", kText},    {"text", "buttonOff", kText},
                        {"soft", "errorFill", kText},     {"text", "tip", kText}};
  for (auto kind : {ThemeKind::Dark, ThemeKind::Light})
    for (const Pair& pair : pairs) {
      QColor front = themeColor(kind, pair.front), ground = themeColor(kind, pair.ground);
      ASSERT_TRUE(front.isValid() && ground.isValid()) << pair.front << " " << pair.ground;
      EXPECT_GE(contrast(front, ground), pair.least)
          << pair.front << " on " << pair.ground << (kind == ThemeKind::Dark ? ", dark" : ", light");
    }
}

TEST(Theme, NamesMeanTheSameInBoth) {
  EXPECT_FALSE(themeColor(ThemeKind::Dark, "no such colour").isValid());
  EXPECT_LT(luminance(themeColor(ThemeKind::Dark, "panel")), 0.1);
  EXPECT_GT(luminance(themeColor(ThemeKind::Light, "panel")), 0.8);
}

}  // namespace
}  // namespace velum::gui
