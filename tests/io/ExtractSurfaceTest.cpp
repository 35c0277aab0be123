#include "io/meshes/ExtractSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "closedSurface.h"
#include "core/Error.h"
#include "makeVolume.h"

namespace velum::io {
namespace {

using Inside = std::function<bool(glm::dvec3 voxel)>;

LabelVolume labelsOf(glm::ivec3 dims, const glm::dmat4& matrix, const Inside& isInside) {
  LabelVolume labels(dims, matrix);
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ids.push_back(isInside({x, y, z}) ? 7 : (x + y) % 3 ? 0 : 2);
  labels.write({0, 0, 0}, dims, ids);
  return labels;
}

StructureField fieldOf(const LabelVolume& labels) {
  return StructureField(LabelCover(Shared<LabelVolume>(LabelVolume(labels))));
}

Mesh surfaceOf(const LabelVolume& labels, double smoothness) {
  Progress progress;
  return extractSurface(fieldOf(labels), 7, glm::ivec3(0), labels.dims() - 1, smoothness, progress);
}

/// Turned, with voxels of three lengths, and mirrored or sheared where asked.
glm::dmat4 oddFrame(bool isMirrored, bool isSheared) {
  double a = 0.4, b = -0.8;
  glm::dmat3 rz(std::cos(a), std::sin(a), 0, -std::sin(a), std::cos(a), 0, 0, 0, 1);
  glm::dmat3 rx(1, 0, 0, 0, std::cos(b), std::sin(b), 0, -std::sin(b), std::cos(b));
  glm::dmat3 turn = rz * rx;
  glm::dmat4 m(glm::dmat3(turn[0] * 0.7, turn[1] * 0.9, turn[2] * (isMirrored ? -2.0 : 2.0)));
  if (isSheared) m[2] += m[0] * 0.4;
  m[3] = glm::dvec4(-120, 45, 310, 1);
  return m;
}

Inside ball(glm::dvec3 centre, double radius) {
  return [=](glm::dvec3 v) { return glm::length(v - centre) < radius; };
}

TEST(ExtractSurface, BallsAndRingsAreClosedAndOfTheirKind) {
  auto ring = [](glm::dvec3 v) {
    v -= glm::dvec3(20, 20, 8);
    return std::hypot(std::hypot(v.x, v.y) - 12.0, v.z) < 4.5;
  };
  for (double smoothness : {0.0, 0.5, 1.0}) {
    Mesh sphere = surfaceOf(labelsOf({25, 25, 25}, glm::dmat4(1.0), ball({12, 12, 12}, 9.3)), smoothness);
    expectWatertight(sphere);
    EXPECT_EQ(eulerOf(sphere), 2);
    Mesh torus = surfaceOf(labelsOf({41, 41, 17}, glm::dmat4(1.0), ring), smoothness);
    expectWatertight(torus);
    EXPECT_EQ(eulerOf(torus), 0);
  }
}

TEST(ExtractSurface, NoiseIsClosed) {
  for (unsigned share : {2u, 5u, 9u}) {
    std::mt19937 random(share);
    LabelVolume labels =
        labelsOf({23, 21, 19}, oddFrame(false, false), [&](glm::dvec3) { return random() % 10 < share; });
    expectWatertight(surfaceOf(labels, 0.0));
    expectWatertight(surfaceOf(labels, 0.5));
  }
}

TEST(ExtractSurface, WhatMeetsTheBorderIsClosedThere) {
  LabelVolume all = labelsOf({6, 5, 4}, glm::dmat4(1.0), [](glm::dvec3) { return true; });
  Mesh mesh = surfaceOf(all, 0.0);
  expectWatertight(mesh);
  EXPECT_EQ(eulerOf(mesh), 2);
  LabelVolume half = labelsOf({20, 20, 20}, glm::dmat4(1.0), ball({0, 10, 19}, 8.0));
  expectWatertight(surfaceOf(half, 0.5));
}

TEST(ExtractSurface, SmoothingKeepsTheVolume) {
  for (double radius : {2.6, 5.2, 9.1})
    for (double smoothness : {0.3, 0.5, 0.8}) {
      LabelVolume labels = labelsOf({25, 25, 25}, oddFrame(false, true), ball({12, 12, 12}, radius));
      double wanted = volumeOf(surfaceOf(labels, 0.0));
      EXPECT_NEAR(volumeOf(surfaceOf(labels, smoothness)), wanted, 0.01 * wanted) << radius << ", " << smoothness;
    }
  // A rod two voxels thick, which smoothing alone would make a thread of.
  LabelVolume rod = labelsOf({40, 12, 12}, glm::dmat4(1.0), [](glm::dvec3 v) {
    return v.x > 2 && v.x < 37 && v.y >= 5 && v.y <= 6 && v.z >= 5 && v.z <= 6;
  });
  double wanted = volumeOf(surfaceOf(rod, 0.0));
  EXPECT_NEAR(volumeOf(surfaceOf(rod, 0.5)), wanted, 0.01 * wanted);
}

TEST(ExtractSurface, LiesWhereTheVoxelsLieAndFacesOutwards) {
  glm::dvec3 middle(13, 11, 9);
  for (bool isMirrored : {false, true})
    for (bool isSheared : {false, true}) {
      LabelVolume labels = labelsOf({27, 23, 19}, oddFrame(isMirrored, isSheared), ball(middle, 7.5));
      Mesh mesh = surfaceOf(labels, 0.5);
      EXPECT_GT(volumeOf(mesh), 0.0);
      glm::dmat4 voxelFromWorld = glm::inverse(labels.worldFromVoxel());
      glm::dvec3 sum(0.0), centre(labels.worldFromVoxel() * glm::dvec4(middle, 1.0));
      for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        glm::dvec3 p(mesh.positions[i]);
        sum += p;
        EXPECT_NEAR(glm::length(glm::dvec3(voxelFromWorld * glm::dvec4(p, 1.0)) - middle), 7.5, 0.8);
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1.0f, 1e-5f);
        EXPECT_GT(glm::dot(glm::dvec3(mesh.normals[i]), p - centre), 0.0);
      }
      EXPECT_LT(glm::length(sum / double(mesh.positions.size()) - centre), 0.1);
    }
}

TEST(ExtractSurface, SmoothBallsHaveTheAreaOfABall) {
  double radius = 10.4, pi = std::acos(-1.0), area = 0;
  Inside isInside = ball({12, 12, 12}, radius);
  auto alone = [&](glm::ivec3 p) { return isInside(p) ? 7 : 0; };  // others beside it would be in its border
  Mesh mesh = surfaceOf(makeLabels({25, 25, 25}, alone), 0.5);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]); };
    area += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  EXPECT_NEAR(area, 4 * pi * radius * radius, 0.03 * 4 * pi * radius * radius) << "steps would have some 9 % more";
}

/// Numbers of a surface that depend on no order.
std::vector<double> sortedNumbers(const Mesh& mesh) {
  std::vector<double> all, one;
  auto take = [&] {
    std::sort(one.begin(), one.end());
    all.insert(all.end(), one.begin(), one.end());
    one.clear();
  };
  for (int axis = 0; axis < 3; ++axis, take())
    for (const auto& p : mesh.positions) one.push_back(p[axis]);
  for (int axis = 0; axis < 3; ++axis, take())
    for (const auto& n : mesh.normals) one.push_back(n[axis]);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    glm::dvec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
               c = mesh.positions[mesh.indices[i + 2]];
    one.push_back(glm::length(glm::cross(b - a, c - a)));
  }
  take();
  return all;
}

TEST(ExtractSurface, ALargeBoxIsWorkedOnInBlocksThatLeaveNoSeam) {
  // Two balls in the corners of a grid that is too large to be worked on as a whole; each meets several blocks, and one
  // the border of the grid.
  glm::ivec3 dims(660, 640, 650);
  LabelVolume labels(dims, glm::dmat4(1.0));
  struct Ball {
    glm::ivec3 centre;
    int radius;
  } balls[] = {{{128, 127, 130}, 38}, {{645, 610, 625}, 24}};
  std::vector<Mesh> apart;
  std::vector<std::pair<glm::ivec3, glm::ivec3>> boxes;
  for (auto [centre, radius] : balls) {
    glm::ivec3 low = glm::max(centre - radius, glm::ivec3(0)), size = glm::min(centre + radius + 1, dims) - low, v;
    std::vector<std::uint16_t> ids;
    for (v.z = 0; v.z < size.z; ++v.z)
      for (v.y = 0; v.y < size.y; ++v.y)
        for (v.x = 0; v.x < size.x; ++v.x) {
          glm::dvec3 off(low + v - centre);
          double bumps = 0.8 * std::sin(off.x * 1.3) * std::sin(off.y * 1.7);
          ids.push_back(glm::length(off) + bumps < radius - 1.5 ? 7 : off.x > 3 * off.y ? 2 : 0);
        }
    labels.write(low, size, ids);
    boxes.emplace_back(low, low + size - 1);
  }
  StructureField field = fieldOf(labels);
  Progress progress;
  Mesh all = extractSurface(field, 7, glm::ivec3(0), dims - 1, 0.0, progress);
  expectWatertight(all);
  std::vector<double> numbers = sortedNumbers(all);
  Mesh joined;
  for (auto [low, high] : boxes) {
    Mesh part = extractSurface(field, 7, low, high, 0.0, progress);
    auto first = std::uint32_t(joined.positions.size());
    joined.positions.insert(joined.positions.end(), part.positions.begin(), part.positions.end());
    joined.normals.insert(joined.normals.end(), part.normals.begin(), part.normals.end());
    for (std::uint32_t i : part.indices) joined.indices.push_back(first + i);
  }
  std::vector<double> expected = sortedNumbers(joined);
  ASSERT_EQ(numbers.size(), expected.size());
  EXPECT_GT(all.positions.size(), 20'000u);
  for (std::size_t i = 0; i < numbers.size(); ++i) ASSERT_NEAR(numbers[i], expected[i], 1e-5) << i;
}

TEST(ExtractSurface, NothingIsRefusedAndACancelIsHeard) {
  StructureField field = fieldOf(labelsOf({25, 25, 25}, glm::dmat4(1.0), ball({12, 12, 12}, 9)));
  Progress progress;
  EXPECT_THROW(extractSurface(field, 9, {0, 0, 0}, {24, 24, 24}, 0.5, progress), InputError);
  progress.cancel();
  EXPECT_THROW(extractSurface(field, 7, {0, 0, 0}, {24, 24, 24}, 0.5, progress), Cancelled);
}

}  // namespace
}  // namespace velum::io
