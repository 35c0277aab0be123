// Which particles pins hold, and where, against a look at all of them.
#include "membrane/forces/Pins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "scene/Scene.h"

namespace velum::membrane {
namespace {

constexpr glm::ivec2 kGrids[] = {{24, 31}, {31, 24}, {3, 50}, {2, 2}};

/// A membrane whose frame is turned in the world and is no square.
scene::Cut membraneBy(scene::KernelRule rule) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.membrane->field.rule = rule;
  cut.centre = {12, -7, 30};
  cut.axis = {0.3, -0.8, 0.5};
  cut.spinDeg = 25;
  cut.size = {60, 90, 40};
  return cut;
}
glm::dvec3 worldFrom(const scene::Cut& cut, glm::dvec3 local) {
  return glm::dvec3(scene::worldFromCut(cut) * glm::dvec4(local, 1.0));
}
/// Rows and columns over the rest plane; uneven where a number says how much.
std::vector<glm::vec3> placesOf(const scene::Cut& cut, glm::ivec2 n, double uneven = 0.0) {
  auto along = [&](int i, int count) {
    double share = double(i) / (count - 1);
    return share + uneven * share * (1.0 - share) - 0.5;
  };
  std::vector<glm::vec3> places;
  for (int y = 0; y < n.y; ++y)
    for (int x = 0; x < n.x; ++x) places.emplace_back(along(x, n.x) * cut.size.x, along(y, n.y) * cut.size.y, 0.0);
  return places;
}

TEST(Pins, ByThePapersRuleAPinHoldsTheParticleNearestToItsPlaceOnTheSheet) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1), height(-18, 18);
  scene::Cut cut = membraneBy(scene::KernelRule::Paper);
  for (glm::ivec2 n : kGrids) {
    auto places = placesOf(cut, n);
    for (int i = 0; i < 200; ++i) {
      glm::dvec2 share(unit(random), unit(random));
      glm::dvec3 to(0.7 * (share.x - 0.5) * cut.size.x, 0.6 * (share.y - 0.5) * cut.size.y, height(random));
      cut.membrane->pins = {{share, worldFrom(cut, to)}};
      auto held = heldByPins(cut, n, places);
      ASSERT_EQ(held.size(), 1u);
      glm::vec2 place((share - 0.5) * glm::dvec2(cut.size));
      // Meshes are no squares: what is nearest is so along rows and along columns.
      glm::vec2 pitch = glm::vec2(cut.size) / glm::vec2(n - 1);
      auto away = [&](glm::vec3 p) { return glm::length((glm::vec2(p) - place) / pitch); };
      float nearest = 1e9f;
      for (glm::vec3 p : places) nearest = std::min(nearest, away(p));
      EXPECT_NEAR(away(places.at(std::size_t(held[0].particle))), nearest, 1e-4f) << n.x << " x " << n.y;
      EXPECT_LT(glm::length(glm::dvec3(held[0].place) - to), 1e-4) << "held where the pin is";
    }
  }
}

TEST(Pins, BesideTheSheetOneHoldsTheParticleOnItsRim) {
  scene::Cut cut = membraneBy(scene::KernelRule::Paper);
  glm::ivec2 n(24, 31);
  cut.membrane->pins = {{{-0.2, 1.4}, cut.centre}};
  EXPECT_EQ(heldByPins(cut, n, placesOf(cut, n)).at(0).particle, 30 * 24);
}

TEST(Pins, ByTheSidedRuleTheMeshOverWhichAPinStandsIsHeldAtItsHeight) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-0.49, 0.49), height(-18, 18);
  scene::Cut cut = membraneBy(scene::KernelRule::Sided);
  for (glm::ivec2 n : kGrids)
    for (double uneven : {0.0, 0.6}) {
      auto places = placesOf(cut, n, uneven);
      for (int i = 0; i < 200; ++i) {
        glm::dvec3 pin(unit(random) * cut.size.x, unit(random) * cut.size.y, height(random));
        cut.membrane->pins = {{{0.5, 0.5}, worldFrom(cut, pin)}};
        auto held = heldByPins(cut, n, places);
        ASSERT_EQ(held.size(), 4u);
        glm::vec2 low(1e9f), high(-1e9f);
        for (const auto& one : held) {
          glm::vec2 p(places.at(std::size_t(one.particle)));
          low = glm::min(low, p);
          high = glm::max(high, p);
          EXPECT_NEAR(one.place.z, pin.z, 1e-4);
        }
        // The pin stands over them, and nobody stands between.
        EXPECT_LE(low.x, pin.x + 1e-4);
        EXPECT_LE(low.y, pin.y + 1e-4);
        EXPECT_GE(high.x, pin.x - 1e-4);
        EXPECT_GE(high.y, pin.y - 1e-4);
        EXPECT_GT((high - low).x * (high - low).y, 0.0f);
        for (glm::vec3 p : places)
          EXPECT_FALSE(p.x > low.x + 1e-4f && p.x < high.x - 1e-4f && p.y > low.y + 1e-4f && p.y < high.y - 1e-4f);
      }
    }
}

TEST(Pins, LiftsRaiseTheRestPlaneToEveryPin) {
  scene::Cut cut = membraneBy(scene::KernelRule::Sided);
  const glm::dvec3 pins[] = {{-12, 20, 9}, {-4, 26, -5}, {15, -30, 14}};
  for (glm::dvec3 pin : pins) cut.membrane->pins.push_back({{0.5, 0.5}, worldFrom(cut, pin)});
  auto lifts = liftsByPins(cut);
  ASSERT_EQ(lifts.size(), 3u);
  auto heightAt = [&](glm::dvec2 place) {
    double sum = 0;
    for (const auto& lift : lifts) {
      double r = glm::length(place - glm::dvec2(lift.centre)) / lift.halfWidth;
      if (r < 1) sum += lift.lift * std::pow(1 - r, 4.0) * (4 * r + 1);  // [WENDLAND] phi_3,1
    }
    return sum;
  };
  // Matrix and shader are floats.
  for (glm::dvec3 pin : pins) EXPECT_NEAR(heightAt(glm::dvec2(pin)), pin.z, 1e-4);
  EXPECT_NEAR(lifts[0].halfWidth, 2.5 * 14, 1e-9) << "as wide as the highest needs";
}

}  // namespace
}  // namespace velum::membrane
