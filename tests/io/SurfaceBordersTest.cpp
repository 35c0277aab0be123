// Surfaces against shapes that are known, and against whoever says whose places are.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "closedSurface.h"
#include "io/meshes/ExtractSurface.h"
#include "makeVolume.h"

namespace velum::io {
namespace {

using Depth = std::function<double(glm::dvec3)>;  ///< voxels inside the surface, below 0 outside

const double kPi = std::acos(-1.0);

Mesh surfaceOf(const StructureField& field, std::uint16_t id, double smoothness = 0.0) {
  Progress progress;
  return extractSurface(field, id, glm::ivec3(0), field.cover().labels()->dims() - 1, smoothness, progress);
}

template <class IdAt>
StructureField fieldOf(glm::ivec3 dims, const IdAt& idAt) {
  return StructureField(LabelCover(Shared<LabelVolume>(makeLabels(dims, idAt))));
}

StructureField labelled(glm::ivec3 dims, const Depth& depth) {
  return fieldOf(dims, [&](glm::ivec3 p) { return depth(p) >= 0.0 ? 1 : 0; });
}

/// Of values that fall over four voxels, as in a scan that is as sharp as its voxels are.
StructureField grown(glm::ivec3 dims, const Depth& depth) {
  auto valueAt = [&](glm::ivec3 p) { return 500.0 + 120.0 * std::clamp(depth(p), -2.0, 2.0); };
  Shared<Volume> volume(makeVolume(dims, SampleType::Float32, valueAt));
  Shared<LabelVolume> labels(makeLabels(dims, [&](glm::ivec3 p) { return depth(p) >= 0.0 ? 1 : 0; }));
  return StructureField(LabelCover(labels, {{1, 0, volume, 0, 0, 500.0, 1e9, 400.0}}));
}

/// A ball, or a tube that slants through all of its grid.
struct Shape {
  double radius;
  bool isTube;
  glm::dvec3 off{0.31, 0.17, 0.43};
  glm::ivec3 dims() const { return glm::ivec3(int(2.0 * radius + 13.0)); }
  /// From the middle or the axis.
  glm::dvec3 away(glm::dvec3 p) const {
    glm::dvec3 axis = glm::normalize(glm::dvec3(0.3, 0.4, 0.87)), from = p - 0.5 * glm::dvec3(dims() - 1) - off;
    return isTube ? from - axis * glm::dot(from, axis) : from;
  }
  Depth depth() const {
    return [shape = *this](glm::dvec3 p) { return shape.radius - glm::length(shape.away(p)); };
  }
  double volume() const { return 4.0 / 3.0 * kPi * radius * radius * radius; }
};

struct Fit {
  double rms = 0.0, mean = 0.0, worst = 0.0;  ///< voxels outside the surface
  double normalDeg = 0.0;                     ///< between normals, the median
};

Fit fitOf(const Mesh& mesh, const Shape& shape) {
  Fit fit;
  std::vector<double> angles;
  glm::dvec3 last = glm::dvec3(shape.dims()) - 1.0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    glm::dvec3 p(mesh.positions[i]);
    // Where the grid ends so does a tube.
    if (glm::any(glm::lessThan(p, glm::dvec3(2.0))) || glm::any(glm::greaterThan(p, last - 2.0))) continue;
    double off = glm::length(shape.away(p)) - shape.radius;
    fit.mean += off, fit.rms += off * off, fit.worst = std::max(fit.worst, std::abs(off));
    double cosine = glm::dot(glm::normalize(shape.away(p)), glm::dvec3(mesh.normals[i]));
    angles.push_back(std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / kPi);
  }
  auto middle = angles.begin() + std::ptrdiff_t(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  fit.normalDeg = *middle;
  fit.mean /= double(angles.size()), fit.rms = std::sqrt(fit.rms / double(angles.size()));
  return fit;
}

class SurfaceFit : public testing::TestWithParam<std::tuple<double, bool, bool>> {};

TEST_P(SurfaceFit, SurfacesLieWhereTheyAreAndFaceWhereTheyFace) {
  auto [radius, isTube, isGrown] = GetParam();
  Shape shape{radius, isTube};
  StructureField field = isGrown ? grown(shape.dims(), shape.depth()) : labelled(shape.dims(), shape.depth());
  Mesh mesh = surfaceOf(field, 1);
  expectWatertight(mesh);
  Fit fit = fitOf(mesh, shape);
  std::printf("%s %s of %g: rms %.3f mean %.3f worst %.3f, normals %.1f\n", isGrown ? "grown" : "labelled",
              isTube ? "tube" : "ball", radius, fit.rms, fit.mean, fit.worst, fit.normalDeg);
  EXPECT_LE(fit.rms, 0.15);
  EXPECT_LE(fit.worst, 0.5);
  EXPECT_LE(fit.normalDeg, 5.0);
}
INSTANTIATE_TEST_SUITE_P(Shapes, SurfaceFit,
                         testing::Combine(testing::Values(2.0, 3.0, 4.0, 6.0, 10.0, 20.0, 40.0), testing::Bool(),
                                          testing::Bool()));

TEST(SurfaceBorders, BallsEncloseTheirVolume) {
  for (bool isGrown : {false, true})
    for (double radius : {4.0, 5.0, 8.0, 12.0, 25.0}) {
      // A ball's voxels are a few more or fewer, as it happens to lie: of several places the mean.
      std::mt19937 random(7);
      std::uniform_real_distribution<double> shift(-0.5, 0.5);
      double sum = 0.0;
      constexpr int kPlaces = 8;
      for (int i = 0; i < kPlaces; ++i) {
        Shape ball{radius, false, {shift(random), shift(random), shift(random)}};
        StructureField field = isGrown ? grown(ball.dims(), ball.depth()) : labelled(ball.dims(), ball.depth());
        sum += volumeOf(surfaceOf(field, 1)) / ball.volume() / kPlaces;
      }
      std::printf("%s ball of %g: volume %.4f\n", isGrown ? "grown" : "labelled", radius, sum);
      EXPECT_NEAR(sum, 1.0, 0.01) << "of radius " << radius;
    }
}

TEST(SurfaceBorders, APlateOneVoxelThickComesOutWhole) {
  // A slanting one, too, whose voxels are joined by faces.
  for (bool isSlanting : {false, true}) {
    auto inPlate = [&](glm::ivec3 p) {
      bool ends = p.x < 3 || p.x > 21 || p.y < 3 || p.y > 21 || p.z < 3 || p.z > 21;
      return !ends && (isSlanting ? p.x + p.y == 24 || p.x + p.y == 25 : p.x == 12);
    };
    StructureField field = fieldOf(glm::ivec3(25), [&](glm::ivec3 p) { return inPlate(p) ? 1 : 0; });
    Mesh mesh = surfaceOf(field, 1);
    expectWatertight(mesh);
    EXPECT_EQ(eulerOf(mesh), 2) << "one piece without a hole";
    // In its middle plane, a voxel inside its rim.
    for (double along = 4.1; along < 20.0; along += 1.7)
      for (double z = 4.1; z < 20.0; z += 1.7) {
        glm::dvec3 place = isSlanting ? glm::dvec3(along, 24.5 - along, z) : glm::dvec3(12.0, along, z);
        ASSERT_GT(windingAbout(mesh, place), 0.5) << along << ", " << z;
        ASSERT_GT(distanceTo(mesh, place), 0.2) << along << ", " << z;
      }
  }
}

/// Two halves of a ball and what is about it.
StructureField halves() {
  return fieldOf(glm::ivec3(33), [](glm::ivec3 p) {
    double side = glm::dot(glm::dvec3(p) - 16.2, glm::normalize(glm::dvec3(1.0, 0.4, 0.2)));
    return glm::length(glm::dvec3(p) - 16.2) > 12.0 ? 0 : side < 0.0 ? 4 : 9;
  });
}

TEST(SurfaceBorders, TwoSideBySideHaveTheSameBorder) {
  StructureField field = halves();
  Mesh one = surfaceOf(field, 4), other = surfaceOf(field, 9);
  int shared = 0;
  for (const glm::vec3& p : one.positions) {
    // Where a third is not: two voxels inside the ball.
    if (glm::length(glm::dvec3(p) - 16.2) > 10.0) continue;
    ASSERT_LT(distanceTo(other, p), 0.02);
    ++shared;
  }
  EXPECT_GT(shared, 200);
  // Where three meet, too: no place of the ball is both's or nobody's that lies a tenth of a voxel off both.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(4.0, 28.5);
  int between = 0, inside = 0;
  for (int i = 0; i < 4000; ++i) {
    glm::dvec3 p(place(random), place(random), place(random));
    double side = glm::dot(p - 16.2, glm::normalize(glm::dvec3(1.0, 0.4, 0.2)));
    if (field.at(p).id == 0 || std::abs(side) > 1.0) continue;
    bool inOne = windingAbout(one, p) > 0.5, inOther = windingAbout(other, p) > 0.5;
    ++inside;
    if (inOne != inOther || std::min(distanceTo(one, p), distanceTo(other, p)) < 0.1) continue;
    ++between;
  }
  EXPECT_GT(inside, 200);
  EXPECT_EQ(between, 0) << "of " << inside;
}

/// Balls that touch, tubes and a plate, with values of their own, or none.
StructureField manyThings() {
  return fieldOf(glm::ivec3(40, 36, 34), [](glm::ivec3 at) {
    glm::dvec3 p(at);
    if (glm::length(p - glm::dvec3(12.3, 13.1, 15.2)) < 7.7) return 1;
    if (glm::length(p - glm::dvec3(21.4, 16.6, 14.9)) < 6.1) return 2;
    if (std::hypot(p.y - 26.3, p.z - 17.8) < 2.4) return 3;
    return at.x > 5 && at.y == 30 ? 4 : 0;
  });
}

TEST(SurfaceBorders, InsideIsWhereverPlacesAreTheStructures) {
  StructureField field = manyThings();
  std::mt19937 random(3);
  std::normal_distribution<double> step(0.0, 0.5);
  for (std::uint16_t id : {1, 2, 3, 4}) {
    Mesh mesh = surfaceOf(field, id);
    expectWatertight(mesh);
    std::uniform_int_distribution<std::size_t> any(0, mesh.positions.size() - 1);
    int asked = 0, right = 0;
    for (int i = 0; i < 3000; ++i) {
      glm::dvec3 p = glm::dvec3(mesh.positions[any(random)]) + glm::dvec3(step(random), step(random), step(random));
      if (distanceTo(mesh, p) <= 0.15) continue;
      ++asked;
      right += (windingAbout(mesh, p) > 0.5) == (field.at(p).id == id);
    }
    std::printf("structure %d: %d of %d places agree\n", id, right, asked);
    EXPECT_GT(asked, 1000);
    EXPECT_GE(right, 0.99 * asked) << "of structure " << id;
  }
}

TEST(SurfaceBorders, AQuarterTurnOfTheGridTurnsTheSurface) {
  constexpr int kEdge = 38;
  auto idAt = [](glm::dvec3 p) {
    double r = glm::length(p - 18.3), wave = std::sin(p.x * 0.4) + std::cos(p.y * 0.3) * std::sin(p.z * 0.5);
    return r > 15.0 ? 0 : wave > 0.6 ? 1 : wave > -0.2 ? 2 : 700;
  };
  auto turned = [](glm::dvec3 p) { return glm::dvec3(p.y, double(kEdge - 1) - p.x, p.z); };
  StructureField field = fieldOf(glm::ivec3(kEdge), [&](glm::ivec3 p) { return idAt(p); });
  StructureField other = fieldOf(glm::ivec3(kEdge), [&](glm::ivec3 p) { return idAt(turned(p)); });
  for (std::uint16_t id : {1, 2, 700}) {
    Mesh mesh = surfaceOf(field, id), back = surfaceOf(other, id);
    for (glm::vec3& p : back.positions) p = glm::vec3(turned(p));
    ASSERT_EQ(mesh.positions.size(), back.positions.size());
    EXPECT_NEAR(volumeOf(mesh), volumeOf(back), 2e-3 * volumeOf(mesh));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      float nearest = 1e9f, angle = -1.0f;
      for (std::size_t k = 0; k < back.positions.size(); ++k) {
        float off = glm::length(mesh.positions[i] - back.positions[k]);
        nearest = std::min(nearest, off);
        // Where a border runs twice through a cell there are two of one place.
        glm::vec3 normal(turned(back.normals[k]) - turned({0, 0, 0}));
        if (off < 2e-3f) angle = std::max(angle, glm::dot(mesh.normals[i], normal));
      }
      ASSERT_LT(nearest, 2e-3f) << "of structure " << id;
      ASSERT_GT(angle, 0.999f) << "of structure " << id;
    }
  }
}

TEST(SurfaceBorders, AnswersDoNotDependOnTheBoxOrOnWhatWasAskedBefore) {
  StructureField field = manyThings();
  Progress progress;
  Mesh whole = surfaceOf(field, 2);
  Mesh inBox = extractSurface(manyThings(), 2, {15, 10, 8}, {28, 23, 21}, 0.0, progress);
  ASSERT_EQ(whole.indices, inBox.indices);
  for (std::size_t i = 0; i < whole.positions.size(); ++i)
    ASSERT_LT(glm::length(whole.positions[i] - inBox.positions[i]), 1e-5f);
}

}  // namespace
}  // namespace velum::io
