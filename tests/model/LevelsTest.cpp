#include "model/Levels.h"

#include <gtest/gtest.h>

#include "makeModel.h"

namespace velum {
namespace {

using model::computeLevels;

Molecule moleculeOf(std::vector<Atom> atoms) {
  Molecule molecule;
  molecule.atoms = std::move(atoms);
  glm::vec4 sphere = sphereAround(molecule.atoms, molecule.beads);
  molecule.centre = glm::vec3(sphere);
  molecule.radius = sphere.w;
  return molecule;
}

/// What share of the directions a set of balls covers that lie between two radii around a centre, by brute force: an
/// outline seen without perspective, pixel by pixel.
std::vector<bool> silhouette(const std::vector<Ball>& balls, glm::vec3 side, float pixel, int edge) {
  glm::vec3 helper = std::abs(side.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(1, 0, 0);
  glm::vec3 right = glm::normalize(glm::cross(helper, side)), up = glm::cross(side, right);
  std::vector<bool> bits(std::size_t(edge) * std::size_t(edge));
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      glm::vec2 at((float(x) - 0.5f * float(edge)) * pixel, (float(y) - 0.5f * float(edge)) * pixel);
      for (const Ball& ball : balls) {
        glm::vec2 d = at - glm::vec2(glm::dot(ball.centre, right), glm::dot(ball.centre, up));
        if (glm::dot(d, d) <= ball.radius * ball.radius) bits[std::size_t(y * edge + x)] = true;
      }
    }
  return bits;
}

/// The farthest that a pixel of one lies from the other, in pixels.
float farthest(const std::vector<bool>& a, const std::vector<bool>& b, int edge) {
  float worst = 0.0f;
  for (int y = 0; y < edge; ++y)
    for (int x = 0; x < edge; ++x) {
      if (!a[std::size_t(y * edge + x)]) continue;
      float best = 1e9f;
      for (int v = 0; v < edge; ++v)
        for (int u = 0; u < edge; ++u)
          if (b[std::size_t(v * edge + u)]) best = std::min(best, std::hypot(float(u - x), float(v - y)));
      worst = std::max(worst, best);
    }
  return worst;
}

TEST(Levels, TheFinestIsTheAtoms) {
  Molecule molecule = moleculeOf(randomAtoms(300, 20.0f, 3));
  auto levels = computeLevels(molecule);
  ASSERT_EQ(levels.front().size(), molecule.atoms.size());
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    EXPECT_EQ(levels.front()[i].centre, molecule.atoms[i].position);
    EXPECT_EQ(levels.front()[i].radius, radiusOf(molecule.atoms[i].element));
  }
}

TEST(Levels, EachIsAThirdOfTheOneBeforeDownToASingleBall) {
  auto levels = computeLevels(moleculeOf(randomAtoms(4000, 30.0f, 5)));
  ASSERT_GT(levels.size(), 4u);
  for (std::size_t l = 1; l < levels.size(); ++l) EXPECT_LE(levels[l].size(), levels[l - 1].size() * 3 / 4);
  EXPECT_EQ(levels.back().size(), 1u);
}

TEST(Levels, OutlinesAreNoFurtherOffThanTheyClaim) {
  Molecule molecule = moleculeOf(randomAtoms(1500, 24.0f, 7));
  std::vector<float> errors;
  auto levels = computeLevels(molecule, &errors);
  ASSERT_EQ(errors.size(), levels.size());
  constexpr int kEdge = 72;
  constexpr float kPixel = 1.0f;
  // Sides of which the level knows nothing: between those that it was measured from.
  for (glm::vec3 side : {glm::vec3(0.8f, 0.6f, 0.0f), glm::vec3(0.36f, -0.48f, 0.8f)}) {
    auto atoms = silhouette(levels.front(), side, kPixel, kEdge);
    for (std::size_t l = 1; l < levels.size(); ++l) {
      auto own = silhouette(levels[l], side, kPixel, kEdge);
      float apart = std::max(farthest(atoms, own, kEdge), farthest(own, atoms, kEdge)) * kPixel;
      // A pixel and a half for the grids of both; a fifth for sides that were not looked at.
      EXPECT_LE(apart, 1.2f * errors[l] + 1.5f * kPixel) << "level " << l << " of " << levels[l].size() << " balls";
    }
  }
}

TEST(Levels, AreSeenAsLargeAsTheAtoms) {
  Molecule molecule = moleculeOf(randomAtoms(200, 14.0f, 11));
  auto levels = computeLevels(molecule);
  constexpr float kPixel = 0.5f;
  constexpr int kEdge = 96;
  for (glm::vec3 side : {glm::vec3(0, 0, 1), glm::normalize(glm::vec3(1, -2, 0.5f))}) {
    auto area = [&](const std::vector<Ball>& balls) {
      auto bits = silhouette(balls, side, kPixel, kEdge);
      return double(std::count(bits.begin(), bits.end(), true));
    };
    double whole = area(levels.front());
    // A ball is at least 0.72 as wide as the sphere around what it stands for, and a cluster's corners are empty.
    for (const auto& level : levels) {
      EXPECT_GT(area(level), 0.7 * whole) << level.size() << " balls";
      EXPECT_LT(area(level), 1.35 * whole) << level.size() << " balls";
    }
  }
}

TEST(Levels, ErrorsGrow) {
  std::vector<float> errors;
  computeLevels(moleculeOf(randomAtoms(2000, 40.0f, 9)), &errors);
  EXPECT_EQ(errors.front(), 0.0f);
  for (std::size_t l = 1; l < errors.size(); ++l) EXPECT_GE(errors[l], errors[l - 1]);
}

TEST(Levels, AreTheSameForAnyNumberOfCores) {
  ModelMaker maker;
  maker.types = 9;
  maker.atoms = 700;
  maker.instances = 20;
  Model model = maker.make();
  Progress progress;
  LevelSet all = computeLevels(model, progress);
  for (std::size_t m = 0; m < model.molecules.size(); ++m) {
    auto own = computeLevels(model.molecules[m]);
    auto rows = all.of(m);
    ASSERT_EQ(rows.size(), own.size());
    for (std::size_t l = 0; l < own.size(); ++l) {
      ASSERT_EQ(rows[l].count, own[l].size());
      for (std::size_t i = 0; i < own[l].size(); ++i) EXPECT_EQ(all.balls[rows[l].first + i], own[l][i]);
    }
  }
}

TEST(Levels, OfASingleAtomIsThatAtom) {
  auto levels = computeLevels(moleculeOf({{{1, 2, 3}, 8, 0}}));
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_EQ(levels[0][0].radius, radiusOf(8));
}

TEST(Levels, OfThinThingsComeToAnEnd) {
  // A thread, a disc, and many atoms in one place.
  std::vector<Atom> thread, disc, heap(500, Atom{});
  for (int i = 0; i < 3000; ++i) {
    thread.push_back({{0.3f * float(i), 0, 0}, 6, 0});
    disc.push_back({{float(i % 55), float(i / 55), 0}, 6, 0});
  }
  for (const auto& atoms : {thread, disc, heap}) EXPECT_EQ(computeLevels(moleculeOf(atoms)).back().size(), 1u);
}

TEST(Levels, WithBeadsAloneBeginWithTheFinestBeads) {
  Molecule molecule;
  molecule.beads = {{{0, 0, 0, 5}, {9, 0, 0, 4}, {0, 9, 0, 6}}, {{3, 3, 0, 12}}};
  auto levels = computeLevels(molecule);
  ASSERT_EQ(levels.front().size(), 3u);
  EXPECT_EQ(levels.front()[1].radius, 4.0f);
}

/// What a model is drawn with until its levels are there: the same atoms, and outlines that are nearly as good.
TEST(Levels, QuickOnesHaveTheSameAtomsAndOutlinesThatAreNoFurtherOffThanTheyClaim) {
  Model model = ModelMaker{.types = 3, .atoms = 1500, .instances = 3, .moleculeRadius = 24.0f}.make();
  Progress progress;
  LevelSet quick = model::makeQuickLevels(model, progress), made = computeLevels(model, progress);
  EXPECT_TRUE(model::areQuick(quick));
  EXPECT_FALSE(model::areQuick(made));
  auto ballsOf = [](const LevelSet& set, const Level& level) {
    return std::vector<Ball>(set.balls.begin() + level.first, set.balls.begin() + level.first + level.count);
  };
  constexpr int kEdge = 72;
  constexpr float kPixel = 1.0f;
  const glm::vec3 side(0.36f, -0.48f, 0.8f);
  for (std::size_t m = 0; m < model.molecules.size(); ++m) {
    auto levels = quick.of(m);
    EXPECT_EQ(ballsOf(quick, levels.front()), ballsOf(made, made.of(m).front()));
    EXPECT_EQ(levels.back().count, 1u);
    auto atoms = silhouette(ballsOf(quick, levels.front()), side, kPixel, kEdge);
    for (std::size_t l = 1; l < levels.size(); ++l) {
      EXPECT_LT(levels[l].count, levels[l - 1].count);
      EXPECT_GT(levels[l].error, levels[l - 1].error);
      auto own = silhouette(ballsOf(quick, levels[l]), side, kPixel, kEdge);
      float off = kPixel * std::max(farthest(atoms, own, kEdge), farthest(own, atoms, kEdge));
      EXPECT_LE(off, levels[l].error + 2.0f * kPixel) << "molecule " << m << ", level " << l;
    }
  }
}

TEST(Levels, TheShareThatIsDoneGrowsAndEndsNearAll) {
  Model model = ModelMaker{.types = 6, .atoms = 300}.make();
  std::vector<double> told;
  Progress progress([&](double fraction, const std::string&) { told.push_back(fraction); });
  computeLevels(model, progress);
  EXPECT_EQ(told.size(), 1 + model.molecules.size());
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_NEAR(told.back(), 1.0, 0.01);
}

}  // namespace
}  // namespace velum
