// Borders between labels against shapes whose surfaces are known, and whose voxels are what lies in them.
#include "core/LabelCover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "makeVolume.h"

namespace velum {

namespace {

using Inside = std::function<double(glm::dvec3)>;  ///< above 0 inside, about the distance to the surface

Shared<LabelVolume> labelsOf(glm::ivec3 dims, const std::function<std::uint16_t(glm::dvec3)>& idAt) {
  LabelVolume labels(dims, glm::dmat4(1.0));
  std::vector<std::uint16_t> ids;
  ids.reserve(std::size_t(dims.x) * std::size_t(dims.y) * std::size_t(dims.z));
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ids.push_back(idAt({x, y, z}));
  labels.write(glm::ivec3(0), dims, ids);
  return labels;
}

/// How far the border of structure 1 lies outside the surface, along rays from places inside it outwards.
struct Fit {
  double rms = 0.0, bias = 0.0;
};
struct Ray {
  glm::dvec3 from, to;
  double truth;  ///< how far along the surface lies
};

Fit fitOf(StructureField& field, const std::vector<Ray>& rays) {
  double sum = 0.0, squares = 0.0;
  for (const Ray& ray : rays) {
    glm::dvec3 way = glm::normalize(ray.to - ray.from);
    double inside = 0.0, outside = glm::length(ray.to - ray.from), step = 0.05;
    // The first that is not inside, then exactly.
    while (inside + step < outside && field.at(ray.from + (inside + step) * way).id == 1) inside += step;
    outside = inside + step;
    for (int i = 0; i < 12; ++i) {
      double middle = 0.5 * (inside + outside);
      (field.at(ray.from + middle * way).id == 1 ? inside : outside) = middle;
    }
    double off = inside - ray.truth;
    sum += off, squares += off * off;
  }
  auto n = double(rays.size());
  return {std::sqrt(squares / n), sum / n};
}

std::vector<glm::dvec3> directions(int count) {
  std::vector<glm::dvec3> all;
  for (int i = 0; i < count; ++i) {
    double z = 1.0 - 2.0 * (i + 0.5) / count, turn = i * 2.399963229728653;
    double r = std::sqrt(1.0 - z * z);
    all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return all;
}

}  // namespace

class CoverOfBalls : public testing::TestWithParam<double> {};

TEST_P(CoverOfBalls, BordersLieOnTheirSurfaces) {
  double radius = GetParam();
  glm::dvec3 centre = glm::dvec3(radius + 6.0) + glm::dvec3(0.31, 0.17, 0.43);
  glm::ivec3 dims(int(2.0 * radius + 13.0));
  auto labels = labelsOf(dims, [&](glm::dvec3 p) { return std::uint16_t(glm::length(p - centre) <= radius); });
  StructureField field{LabelCover(labels)};
  std::vector<Ray> rays;
  for (glm::dvec3 way : directions(2000)) rays.push_back({centre, centre + (radius + 3.0) * way, radius});
  Fit fit = fitOf(field, rays);
  std::printf("ball of %g: rms %.3f bias %.3f\n", radius, fit.rms, fit.bias);
  EXPECT_LE(fit.rms, 0.15);
  EXPECT_LE(std::abs(fit.bias), radius < 3.0 ? 0.1 : 0.03);
}
INSTANTIATE_TEST_SUITE_P(Radii, CoverOfBalls, testing::Values(2.0, 3.0, 4.0, 6.0, 10.0, 20.0, 40.0));

class CoverOfTubes : public testing::TestWithParam<double> {};

TEST_P(CoverOfTubes, BordersLieOnTheirSurfaces) {
  double radius = GetParam();
  glm::ivec3 dims(int(2.0 * radius + 13.0));
  glm::dvec3 middle = 0.5 * glm::dvec3(dims - 1) + glm::dvec3(0.31, 0.17, 0.43),
             axis = glm::normalize(glm::dvec3(0.3, 0.4, 0.87));
  auto away = [&](glm::dvec3 p) { return p - middle - axis * glm::dot(p - middle, axis); };
  auto labels = labelsOf(dims, [&](glm::dvec3 p) { return std::uint16_t(glm::length(away(p)) <= radius); });
  StructureField field{LabelCover(labels)};
  std::vector<Ray> rays;
  for (glm::dvec3 way : directions(2000)) {
    glm::dvec3 from = middle + axis * (2.0 * way.z), out = glm::normalize(way - axis * glm::dot(way, axis));
    rays.push_back({from, from + (radius + 3.0) * out, radius});
  }
  Fit fit = fitOf(field, rays);
  std::printf("tube of %g: rms %.3f bias %.3f\n", radius, fit.rms, fit.bias);
  EXPECT_LE(fit.rms, 0.15);
  EXPECT_LE(std::abs(fit.bias), radius < 3.0 ? 0.1 : 0.03);
}
INSTANTIATE_TEST_SUITE_P(Radii, CoverOfTubes, testing::Values(2.0, 3.0, 4.0, 6.0, 10.0, 20.0, 40.0));

namespace {

/// Voxels that a structure fills, by places a quarter of a voxel apart.
double volumeOf(const StructureField& field, std::uint16_t id) {
  const LabelVolume& labels = *field.cover().labels();
  std::size_t count = 0;
  glm::ivec3 ends = labels.dims() * 4;
  for (int z = 0; z < ends.z; ++z)
    for (int y = 0; y < ends.y; ++y)
      for (int x = 0; x < ends.x; ++x) count += field.at((glm::dvec3(x, y, z) + 0.5) / 4.0 - 0.5).id == id;
  return double(count) / 64.0;
}

}  // namespace

TEST(LabelCover, BallsKeepTheirVolume) {
  for (double radius : {4.0, 5.0, 8.0, 12.0}) {
    // A ball's voxels are a few more or fewer, as it happens to lie: of several places the mean.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.5, 0.5);
    double sum = 0.0, truth = 4.0 / 3.0 * 3.141592653589793 * radius * radius * radius;
    constexpr int kPlaces = 8;
    for (int i = 0; i < kPlaces; ++i) {
      glm::dvec3 centre = glm::dvec3(radius + 3.0) + glm::dvec3(shift(random), shift(random), shift(random));
      auto labels = labelsOf(glm::ivec3(int(2.0 * radius + 7.0)),
                             [&](glm::dvec3 p) { return std::uint16_t(glm::length(p - centre) <= radius); });
      sum += volumeOf(StructureField{LabelCover(labels)}, 1) / truth / kPlaces;
    }
    EXPECT_NEAR(sum, 1.0, 0.01) << "of radius " << radius;
  }
}

TEST(LabelCover, APlateOneVoxelThickStaysWhole) {
  // A slanting one, too, whose voxels are joined by faces.
  for (bool isSlanting : {false, true}) {
    auto inPlate = [&](glm::dvec3 p) { return isSlanting ? std::abs(p.x + p.y - 24.5) < 0.6 : p.x == 12.0; };
    auto labels = labelsOf(glm::ivec3(25), [&](glm::dvec3 p) { return std::uint16_t(inPlate(p)); });
    StructureField field{LabelCover(labels)};
    for (double along = 4.0; along < 20.0; along += 0.13)
      for (double z = 4.0; z < 20.0; z += 0.13) {
        glm::dvec3 place = isSlanting ? glm::dvec3(along, 24.5 - along, z) : glm::dvec3(12.0, along, z);
        ASSERT_EQ(field.at(place).id, 1) << along << ", " << z;
      }
  }
}

TEST(LabelCover, NoMiddleOfAVoxelChangesSides) {
  std::mt19937 random(3);
  glm::ivec3 dims(40, 35, 33);
  auto labels = labelsOf(dims, [&](glm::dvec3) { return std::uint16_t(random() % 5); });
  StructureField field{LabelCover(labels)};
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ASSERT_EQ(field.at({x, y, z}).id, labels->at({x, y, z}));
}

TEST(LabelCover, TurningTheGridByAQuarterTurnsTheBordersAlong) {
  constexpr int kEdge = 38;
  auto idAt = [](glm::dvec3 p) {
    double r = glm::length(p - 18.3), wave = std::sin(p.x * 0.4) + std::cos(p.y * 0.3) * std::sin(p.z * 0.5);
    return std::uint16_t(r > 15.0 ? 0 : wave > 0.6 ? 1 : wave > -0.2 ? 2 : 700);
  };
  auto turned = [](glm::dvec3 p) { return glm::dvec3(p.y, double(kEdge - 1) - p.x, p.z); };
  StructureField field{LabelCover(labelsOf(glm::ivec3(kEdge), idAt))};
  StructureField other{LabelCover(labelsOf(glm::ivec3(kEdge), [&](glm::dvec3 p) { return idAt(turned(p)); }))};
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0.0, kEdge - 1.0);
  int borders = 0, different = 0;
  for (int i = 0; i < 20000; ++i) {
    glm::dvec3 p(place(random), place(random), place(random));
    StructurePlace here = other.at(p), there = field.at(turned(p));
    borders += here.coverage < 1.0f;
    // Rounding may put a place on a border on either side.
    different += here.id != there.id && there.coverage > 0.5001f;
    ASSERT_NEAR(here.coverage, there.coverage, 1e-4);
  }
  EXPECT_GT(borders, 3000);
  EXPECT_EQ(different, 0);
}

TEST(LabelCover, TwoStructuresSideBySideLeaveNothingBetweenThem) {
  // Along lines through the border of two halves of a block: one owner after the other, and no third.
  auto labels =
      labelsOf(glm::ivec3(30), [](glm::dvec3 p) { return std::uint16_t(p.x + 0.4 * p.y + 0.2 * p.z < 22.0 ? 4 : 9); });
  StructureField field{LabelCover(labels)};
  for (double y = 4.0; y < 26.0; y += 0.7)
    for (double z = 4.0; z < 26.0; z += 0.7) {
      int changes = 0;
      std::uint16_t before = 4;
      for (double x = 1.0; x < 28.0; x += 0.05) {
        std::uint16_t now = field.at({x, y, z}).id;
        ASSERT_TRUE(now == 4 || now == 9);
        changes += now != before;
        before = now;
      }
      ASSERT_EQ(changes, 1);
    }
}

TEST(LabelCover, WhatHasGrownEndsWhereItsValuesDo) {
  double radius = 9.3;
  glm::dvec3 centre(15.2, 14.7, 15.4);
  glm::ivec3 dims(31);
  auto valueAt = [&](glm::dvec3 p) { return 500.0 + 120.0 * std::clamp(radius - glm::length(p - centre), -2.0, 2.0); };
  Shared<Volume> volume(makeVolume(dims, SampleType::Float32, [&](glm::ivec3 p) { return valueAt(p); }));
  auto labels = labelsOf(dims, [&](glm::dvec3 p) { return std::uint16_t(valueAt(p) >= 500.0); });
  ValueBorder border{1, 0, volume, 0, 0, 500.0, 1e9, 400.0};
  std::vector<Ray> rays;
  for (glm::dvec3 way : directions(1000)) rays.push_back({centre, centre + (radius + 3.0) * way, radius});
  StructureField byValues{LabelCover(labels, {border})};
  EXPECT_LE(fitOf(byValues, rays).rms, 0.03) << "of values that fall evenly";
}

TEST(LabelCover, ARangeThatHardlyHoldsTheStructureDoesNotMakeItThinner) {
  // Its values lie just below the range's upper end, and what lies beside it below the lower one.
  Shared<Volume> volume(makeVolume(glm::ivec3(20), SampleType::Int16, [](glm::ivec3 p) { return p.x > 8 ? 168 : 20; }));
  auto labels = labelsOf(glm::ivec3(20), [](glm::dvec3 p) { return std::uint16_t(p.x > 8); });
  StructureField field{LabelCover(labels, {{1, 0, volume, 0, 0, 60.0, 170.0, 150.0}})};
  double where = 8.0 + (60.0 - 20.0) / (168.0 - 20.0);
  EXPECT_EQ(field.at({where + 0.02, 9.5, 10.2}).id, 1);
  EXPECT_EQ(field.at({where - 0.02, 9.5, 10.2}).id, 0);
}

TEST(LabelCover, WhatAPlaneHasEndedGoesOnUpToIt) {
  // Grown out of a plane that lies between voxels: its values go on in those behind the plane, and so does it.
  glm::ivec3 dims(20);
  Shared<Volume> volume(
      makeVolume(dims, SampleType::Int16, [](glm::ivec3 p) { return p.y >= 6 && p.y < 14 ? 900 : 0; }));
  auto labels = labelsOf(dims, [](glm::dvec3 p) { return std::uint16_t(p.y >= 6 && p.y < 14 && p.x > 8.3); });
  StructureField field{LabelCover(labels, {{1, 0, volume, 0, 0, 300.0, 3000.0, 900.0}})};
  for (double x = 8.3; x < 15.0; x += 0.1) ASSERT_EQ(field.at({x, 10.0, 9.5}).id, 1) << x;
  EXPECT_EQ(field.at({7.5, 10.0, 9.5}).id, 0);
}

}  // namespace velum
