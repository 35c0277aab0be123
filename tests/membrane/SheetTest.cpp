// What shaders/shared/sheet.h says about sheets, against loops over all their triangles in doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "membrane/sheet/SheetIndex.h"
#include "shared/cut.h"
#include "sheetShapes.h"

namespace velum {
namespace {

using glm::dvec3, glm::vec3;
constexpr glm::ivec2 kParticles(23, 17);
const dvec3 kSize(120, 90, 50);

/// A sheet's triangles, and the index over it.
struct TestSheet {
  explicit TestSheet(const scene::SheetShape& shape, dvec3 size = kSize)
      : index(membrane::makeSheetIndex(shape, kParticles, size)),
        plan{{0, index.particles, 0}, vec3(size * 0.5), 1.0f} {
    int n = index.particles.x;
    auto place = [&](int v) { return dvec3(vec3(index.rows[std::size_t(v)])); };
    for (int y = 0; y + 1 < index.particles.y; ++y)
      for (int x = 0; x + 1 < n; ++x) {
        int v = y * n + x;
        triangles.push_back({place(v), place(v + 1), place(v + n + 1)});
        triangles.push_back({place(v), place(v + n + 1), place(v + n)});
        ids.push_back(2 * v), ids.push_back(2 * v + 1);
      }
  }
  shared::SheetRows rows() const { return {index.rows.data()}; }
  bool above(vec3 p) const { return shared::sheetIsAbove(plan, p, rows()); }

  membrane::SheetIndex index;
  shared::SheetPlan plan;
  std::vector<std::array<dvec3, 3>> triangles;
  std::vector<int> ids;
};

struct Crossings {
  std::vector<double> t;
  std::vector<int> ids;
  bool isClear = true;  ///< no crossing so near an edge, or so flat, that floats may tell otherwise
};

/// Every crossing of a line with a sheet, in order, from all triangles.
Crossings crossingsOf(const TestSheet& sheet, dvec3 o, dvec3 d) {
  std::vector<std::pair<double, int>> found;
  Crossings out;
  for (std::size_t i = 0; i < sheet.triangles.size(); ++i) {
    auto [a, b, c] = sheet.triangles[i];
    dvec3 n = glm::cross(b - a, c - a);
    double along = glm::dot(n, d), area = glm::length(n);
    if (area == 0.0 || along == 0.0) continue;
    double t = glm::dot(n, a - o) / along;
    dvec3 p = o + t * d;
    double wa = glm::dot(n, glm::cross(b - p, c - p)), wb = glm::dot(n, glm::cross(c - p, a - p)),
           wc = glm::dot(n, glm::cross(a - p, b - p));
    double least = std::min(wa, std::min(wb, wc)) / (area * area);
    if (least < -1e-4) continue;
    if (least < 1e-4 || std::abs(along) < 1e-3 * area) out.isClear = false;
    if (least >= 0) found.emplace_back(t, sheet.ids[i]);
  }
  std::sort(found.begin(), found.end());
  for (auto [t, id] : found) out.t.push_back(t), out.ids.push_back(id);
  for (std::size_t i = 1; i < found.size(); ++i) out.isClear = out.isClear && out.t[i] - out.t[i - 1] > 1e-2;
  return out;
}

vec3 placeIn(std::mt19937& random, vec3 half) {
  std::uniform_real_distribution<float> u(-1.0f, 1.0f);
  return vec3(u(random), u(random), u(random)) * half;
}

TEST(Sheet, AFlatOneIsThePlane) {
  TestSheet sheet{scene::SheetShape{}};
  EXPECT_EQ(sheet.index.particles, kParticles);
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    vec3 p = placeIn(random, {80, 60, i % 2 ? 30.0f : 0.01f});
    if (std::abs(p.z) < 1e-6f) continue;
    EXPECT_EQ(sheet.above(p), p.z > 0) << p.x << " " << p.y << " " << p.z;
    EXPECT_NEAR(shared::sheetDistance(sheet.plan, p, sheet.rows()), -p.z, 1e-5f);
  }
}

TEST(Sheet, APointIsAboveWhereAnEvenNumberOfTrianglesLiesOverIt) {
  std::mt19937 random(2);
  for (const auto& [name, shape] : allSheets(kParticles, kSize)) {
    TestSheet sheet(shape);
    int compared = 0, above = 0;
    for (int i = 0; i < 4000; ++i) {
      vec3 p = placeIn(random, vec3(kSize * 0.5) * vec3(1, 1, 1.1));
      Crossings all = crossingsOf(sheet, dvec3(p), {0, 0, 1});
      bool isNear = std::any_of(all.t.begin(), all.t.end(), [](double t) { return std::abs(t) < 1e-3; });
      if (!all.isClear || isNear) continue;
      EXPECT_EQ(all.t.size() % 2, 1u);
      bool expected = std::count_if(all.t.begin(), all.t.end(), [](double t) { return t > 0; }) % 2 == 0;
      ASSERT_EQ(sheet.above(p), expected) << name << " at " << p.x << " " << p.y << " " << p.z;
      float distance = shared::sheetDistance(sheet.plan, p, sheet.rows());
      ASSERT_EQ(distance < 0, expected) << name;
      ++compared, above += expected;
    }
    EXPECT_GT(compared, 2000) << name;
    EXPECT_GT(above, compared / 5) << name;
    EXPECT_LT(above, compared * 4 / 5) << name;
  }
}

TEST(Sheet, NoPlaceOnAnEdgeOrACornerIsLeftOut) {
  // Exactly over particles, edges and the rim every line meets the sheet an odd number of times, so that high above it
  // is above and far below it is below.
  for (const auto& [name, shape] : allSheets(kParticles, kSize)) {
    TestSheet sheet(shape);
    std::size_t asked = 0;
    for (std::size_t v = 0; v < shape.places.size(); ++v)
      for (std::size_t w : {v, v + 1, v + std::size_t(kParticles.x) + 1}) {
        if (w >= shape.places.size()) continue;
        vec3 p = 0.5f * (vec3(sheet.index.rows[v]) + vec3(sheet.index.rows[w]));
        if (!shared::sheetHolds(sheet.plan, p)) continue;
        shared::SheetColumn column =
            shared::sheetColumn(sheet.plan, p, shared::sheetCellOf(sheet.plan, p, sheet.rows()), sheet.rows());
        EXPECT_EQ(column.all % 2, 1) << name << " at " << p.x << " " << p.y;
        ++asked;
      }
    EXPECT_GT(asked, 2 * shape.places.size()) << name;
  }
}

TEST(Sheet, TheDistanceToASlopeIsAlongItsNormal) {
  // Over the middle of a ridge of constant slope.
  TestSheet sheet(makeSheet({41, 41}, kSize, [](glm::vec2 s) {
    return vec3(s * glm::vec2(60, 45), 0.5f * (60.0f - std::abs(s.x * 60.0f)) * 0.5f);
  }));
  double cosine = 1 / std::hypot(1.0, 0.25);
  for (float x : {-30.0f, 17.0f})
    for (float dz : {-2.0f, 0.5f, 3.0f})
      EXPECT_NEAR(shared::sheetDistance(sheet.plan, {x, 3, 0.25f * (60 - std::abs(x)) + dz}, sheet.rows()),
                  -dz * cosine, 1e-4);
}

/// Rays through the box: across, steep, along the axes, and nearly along the sheet.
std::vector<std::pair<vec3, vec3>> raysThrough(std::mt19937& random, int count) {
  std::vector<std::pair<vec3, vec3>> rays;
  vec3 half(kSize * 0.5);
  for (int i = 0; i < count; ++i) {
    vec3 through = placeIn(random, half), d = placeIn(random, vec3(1));
    if (i % 5 == 1) d.z *= 0.05f;
    if (i % 5 == 2) d = vec3(0), d[i / 5 % 3] = i % 2 ? 1.0f : -1.0f;
    if (i % 5 == 3) d = vec3(0.02f * d.x, 0.02f * d.y, 1);
    d = glm::normalize(d);
    rays.emplace_back(through - (i % 7 == 0 ? 5.0f : 300.0f) * d, d);
  }
  return rays;
}

TEST(Sheet, ALineCrossesItWhereItsTrianglesAre) {
  std::mt19937 random(3);
  for (const auto& [name, shape] : allSheets(kParticles, kSize)) {
    TestSheet sheet(shape);
    int compared = 0, crossings = 0;
    for (auto [o, d] : raysThrough(random, 3000)) {
      Crossings all = crossingsOf(sheet, dvec3(o), dvec3(d));
      if (!all.isClear) continue;
      ++compared;
      float from = 0.0f;
      for (std::size_t i = 0; i <= all.t.size(); ++i) {
        if (i < all.t.size() && all.t[i] <= 0) continue;
        shared::SheetHit hit = shared::sheetCrossing(sheet.plan, o, d, from, 1e30f, sheet.rows());
        if (i == all.t.size()) {
          ASSERT_EQ(hit.t, shared::kSheetFar) << name << ": a crossing too many after " << from;
          ASSERT_EQ(hit.triangle, -1);
          break;
        }
        ASSERT_NEAR(hit.t, all.t[i], 5e-3) << name << ": crossing " << i << " of " << all.t.size() << " from " << o.x
                                           << " " << o.y << " " << o.z << " along " << d.x << " " << d.y << " " << d.z;
        ASSERT_EQ(hit.triangle, all.ids[i]) << name;
        ++crossings;
        from = hit.t + 1e-3f;
      }
    }
    EXPECT_GT(compared, 1200) << name;
    EXPECT_GT(crossings, 1000) << name;
  }
}

TEST(Sheet, CrossingsEndWhereTheyAreAskedTo) {
  TestSheet sheet{scene::SheetShape{}};
  auto crossing = [&](float from, float to) {
    return shared::sheetCrossing(sheet.plan, {3, 2, 20}, {0, 0, -1}, from, to, sheet.rows()).t;
  };
  EXPECT_FLOAT_EQ(crossing(0, 100), 20);
  EXPECT_EQ(crossing(0, 19), shared::kSheetFar);
  EXPECT_EQ(crossing(21, 100), shared::kSheetFar);
  EXPECT_EQ(crossing(50, 10), shared::kSheetFar);
}

shared::CutData cutOf(const TestSheet& sheet, bool isInlay, bool invert = false) {
  shared::CutData cut{};
  cut.localFromScene = glm::mat4(1.0f);
  cut.halfSize = glm::vec4(sheet.plan.halfSize, invert ? -1.0f : 1.0f);
  cut.kind = {shared::kCutMembrane, 0, 0, isInlay ? shared::kMembraneInlay : shared::kMembraneClip};
  cut.sheet = sheet.plan.rows;
  cut.face.y = 1.0f;
  return cut;
}

TEST(Membrane, WhatItRemovesChangesAtItsCrossingsOnly) {
  std::mt19937 random(4);
  for (const auto& [name, shape] : allSheets(kParticles, kSize))
    for (bool isInlay : {false, true}) {
      TestSheet sheet(shape);
      shared::CutData cut = cutOf(sheet, isInlay);
      int runs = 0, removed = 0, wrong = 0;
      for (auto [o, d] : raysThrough(random, 1500)) {
        float t = 0.0f;
        for (int guard = 0; t < 600.0f && guard < 200; ++guard) {
          float end = std::min(shared::membraneCrossing(cut, o, d, t + 1e-4f, 600.0f, sheet.rows()).t, 600.0f);
          bool state = shared::membraneRemoves(cut, o + 0.5f * (t + end) * d, sheet.rows());
          ++runs, removed += state;
          for (float share : {0.05f, 0.3f, 0.8f, 0.95f}) {
            vec3 p = o + glm::mix(t, end, share) * d;
            // Floats may disagree within a hair of the sheet, and beside the frame's rim.
            if (std::abs(shared::membraneDistance(cut, p, sheet.rows())) < 2e-3f) continue;
            if (std::abs(std::abs(p.x) - 60.0f) < 2e-3f || std::abs(std::abs(p.y) - 45.0f) < 2e-3f) continue;
            wrong += shared::membraneRemoves(cut, p, sheet.rows()) != state;
          }
          t = end;
        }
        EXPECT_GE(t, 600.0f);
      }
      EXPECT_EQ(wrong, 0) << name << (isInlay ? " as an inlay" : "") << " of " << runs << " runs";
      if (name == "flat" && isInlay) continue;
      EXPECT_GT(removed, runs / 10) << name;
      EXPECT_LT(removed, runs * 19 / 20) << name;
    }
}

TEST(Membrane, InvertedItRemovesTheOtherSide) {
  TestSheet sheet(domeSheet(kParticles, kSize));
  std::mt19937 random(5);
  for (int i = 0; i < 2000; ++i) {
    vec3 p = placeIn(random, {70, 55, 30});
    EXPECT_NE(shared::cutRemoves(cutOf(sheet, false), p, sheet.rows()),
              shared::cutRemoves(cutOf(sheet, false, true), p, sheet.rows()));
    EXPECT_EQ(shared::cutRemoves(cutOf(sheet, false), p, sheet.rows()),
              shared::cutDistance(cutOf(sheet, false), p, sheet.rows()) < 0);
  }
}

TEST(Membrane, AnInlayKeepsWhatLiesBetweenItAndTheSheet) {
  TestSheet dome(domeSheet(kParticles, kSize));
  shared::CutData cut = cutOf(dome, true);
  auto removes = [&](vec3 p) { return shared::cutRemoves(cut, p, dome.rows()); };
  EXPECT_FALSE(removes({0, 0, 10}));
  EXPECT_TRUE(removes({0, 0, -1}));
  EXPECT_TRUE(removes({0, 0, 21}));
  EXPECT_TRUE(removes({61, 0, 1}));
  EXPECT_TRUE(removes({61, 0, -1}));
}

TEST(Membrane, MaterialFadesWithTheDistanceAndByTheEmphasis) {
  shared::CutData cut{};
  cut.inlay = {1, 1 / 20.0f, 1.0f, 0.25f};
  EXPECT_FLOAT_EQ(shared::membraneShare(cut, 1e-6f), 1.0f);
  EXPECT_FLOAT_EQ(shared::membraneShare(cut, -1e-6f), 0.25f);
  EXPECT_FLOAT_EQ(shared::membraneShare(cut, 10.0f), 0.5f);
  EXPECT_EQ(shared::membraneShare(cut, 20.0f), 0.0f);
  EXPECT_EQ(shared::membraneShare(cut, 50.0f), 0.0f);
}

TEST(FitShape, MakesSenseOfAnything) {
  EXPECT_EQ(membrane::fitShape({}, {5, 4}, kSize).places.size(), 20u);
  EXPECT_EQ(membrane::fitShape({}, {0, -3}, kSize).places.size(), 4u);
  scene::SheetShape few{{5, 4}, std::vector<vec3>(7)};
  EXPECT_EQ(membrane::fitShape(few, {3, 3}, kSize).places.size(), 9u);
  scene::SheetShape bad = domeSheet({5, 4}, kSize);
  bad.places[7].y = std::nanf("");
  EXPECT_EQ(membrane::fitShape(bad, {3, 3}, kSize).places.size(), 9u);
  // Made for another frame: as wide as this one, no higher than its reach, its rim on it.
  scene::SheetShape large = membrane::fitShape(domeSheet({5, 5}, kSize * 10.0), {3, 3}, kSize);
  for (vec3 p : large.places) {
    EXPECT_LE(std::abs(p.x), 60.0f);
    EXPECT_LE(std::abs(p.y), 45.0f);
    EXPECT_LE(std::abs(p.z), 25.0f);
  }
  EXPECT_EQ(large.places.front(), vec3(-60, -45, 0));
  EXPECT_EQ(large.places.back(), vec3(60, 45, 0));
}

TEST(SheetIndex, HangingFlatEveryCellListsFourMeshes) {
  membrane::SheetIndex index = membrane::makeSheetIndex({}, {50, 50}, kSize);
  EXPECT_LE(index.rows.size(), 4u * 50 * 50);
  for (std::size_t cell = 5000; cell < 7500; ++cell) {
    EXPECT_GE(index.rows[cell].y, 1.0f);
    EXPECT_LE(index.rows[cell].y, 4.0f);
  }
}

}  // namespace
}  // namespace velum
