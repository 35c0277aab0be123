// Borders between labels against shapes whose surfaces are known, and whose voxels are what lies in them.
#include "velum/core/LabelCover.h"

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

}  // namespace velum
