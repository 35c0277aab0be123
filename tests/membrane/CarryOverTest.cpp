// A sheet that is carried over to another frame.
#include <gtest/gtest.h>

#include <cmath>

#include "membrane/sheet/Simulation.h"

#include "scene/Scene.h"

namespace velum::membrane {
namespace {

scene::Cut frameAt(glm::dvec3 centre, scene::KernelRule rule) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.axis = {0.6, 0.0, 0.8};
  cut.spinDeg = 30;
  cut.centre = centre;
  cut.size = {80, 60, 40};
  cut.membrane.emplace().field.rule = rule;
  return cut;
}

/// A hill, over places of a frame.
double hillAt(glm::dvec2 p) { return 9.0 * std::exp(-glm::dot(p, p) / 300.0); }

TEST(CarryOver, ASheetStaysWhereItIsInTheWorld) {
  for (auto rule : {scene::KernelRule::Sided, scene::KernelRule::Paper}) {
    scene::Cut from = frameAt({10, -4, 7}, rule);
    glm::dvec3 normal = glm::normalize(from.axis);
    scene::SheetShape shape;
    shape.particles = {41, 31};
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 41; ++x) {
        glm::dvec2 p(2.0 * x - 40.0, 2.0 * y - 30.0);
        shape.places.emplace_back(p, hillAt(p));
      }
    for (double along : {-6.0, 0.0, 5.0}) {
      scene::Cut to = from;
      to.centre += along * normal;
      scene::SheetShape carried = carryOver(shape, from, to);
      ASSERT_EQ(carried.places.size(), shape.places.size());
      glm::dmat4 worldFromOld = scene::worldFromCut(from), worldFromNew = scene::worldFromCut(to);
      for (std::size_t i = 0; i < carried.places.size(); ++i) {
        glm::dvec3 was(worldFromOld * glm::dvec4(shape.places[i], 1.0)),
            is(worldFromNew * glm::dvec4(carried.places[i], 1.0));
        ASSERT_LT(glm::distance(was, is), 1e-3) << i << " along " << along;
      }
    }
  }
}

TEST(CarryOver, WhatLiesOutsideOfTheNewFrameLiesOnItsFace) {
  scene::Cut from = frameAt({0, 0, 0}, scene::KernelRule::Sided), to = from;
  to.centre += 25.0 * glm::normalize(from.axis);
  scene::SheetShape carried = carryOver(flatShape(from, {9, 9}), from, to);
  for (glm::vec3 place : carried.places) EXPECT_NEAR(place.z, -20.0f, 1e-4f);
}

}  // namespace
}  // namespace velum::membrane
