#include "session/section/TypedWindow.h"

#include <gtest/gtest.h>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

scene::VolumeLayer layerOf(const char* unit) {
  Volume v = makeVolume({4, 4, 4}, SampleType::Int16, [](glm::ivec3 p) { return p.x * 100.0 - 200.0; });
  v.unit = unit;
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(std::move(v));
  layer.windowLevel = 7, layer.windowWidth = 90;
  return layer;
}

TEST(TypedWindow, NumbersAreWidthAndLevelWhateverPartsThem) {
  auto layer = layerOf("HU");
  for (const char* text : {"400 50", "400,50", "400/50", " 400 ; 50 ", "W 400 L 50", "w400l50", "L 50 W 400",
                           "WW 400 WL 50", "W: 400  L: 50 HU", "width=400 level=50", "400.0 50 hu"})
    EXPECT_EQ(typedWindow(text, layer), std::optional(glm::dvec2(50, 400))) << text;
  EXPECT_EQ(typedWindow("1500 -600", layer), std::optional(glm::dvec2(-600, 1500)));
  EXPECT_EQ(typedWindow("1500 \u2212600", layer), std::optional(glm::dvec2(-600, 1500)));
  EXPECT_EQ(typedWindow("0,5 0,25", layer), std::optional(glm::dvec2(0.25, 0.5))) << "decimal commas";
}

TEST(TypedWindow, WhatIsNotNamedStays) {
  auto layer = layerOf("HU");
  EXPECT_EQ(typedWindow("W 300", layer), std::optional(glm::dvec2(7, 300)));
  EXPECT_EQ(typedWindow("300", layer), std::optional(glm::dvec2(7, 300)));
  EXPECT_EQ(typedWindow("L -20", layer), std::optional(glm::dvec2(-20, 90)));
}

TEST(TypedWindow, ANameIsOneOfTheUnit) {
  EXPECT_EQ(typedWindow("Lung", layerOf("HU")), std::optional(glm::dvec2(-600, 1500)));
  EXPECT_EQ(typedWindow("soft tissue", layerOf("HU")), typedWindow("soft-tissue", layerOf("HU")));
  EXPECT_EQ(typedWindow("lu", layerOf("HU")), std::optional(glm::dvec2(-600, 1500)));
  EXPECT_FALSE(typedWindow("b", layerOf("HU"))) << "bone or brain";
  EXPECT_FALSE(typedWindow("lung", layerOf("SUVbw")));
  EXPECT_EQ(typedWindow("suv-5", layerOf("SUVbw")), std::optional(glm::dvec2(2.5, 5)));
}

TEST(TypedWindow, WhatMeansNoWindowIsNotUnderstood) {
  auto layer = layerOf("HU");
  for (const char* text :
       {"", "  ", "W", "0 50", "-400 50", "400 50 3", "400 fifty", "nan 5", "inf 5", "W 400 W 300", "hu"})
    EXPECT_FALSE(typedWindow(text, layer)) << text;
}

TEST(TypedWindow, WhatStandsInTheCornerMeansItself) {
  for (auto [level, width] : {std::pair(50.0, 400.0), {-600.0, 1500.0}, {0.125, 0.5}, {-0.5, 2.0}}) {
    auto layer = layerOf("HU");
    layer.windowLevel = level, layer.windowWidth = width;
    std::string text = windowText(layer);
    EXPECT_TRUE(text.ends_with(" HU")) << text;
    EXPECT_EQ(typedWindow(text, layer), std::optional(glm::dvec2(level, width))) << text;
  }
}

}  // namespace
}  // namespace velum::session
