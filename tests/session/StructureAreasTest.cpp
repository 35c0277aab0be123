// Bars of structures: what rays meet of them, what cuts leave of it, and how far one must be pulled out for an area.
#include "session/structure/StructureAreas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "core/Error.h"
#include "makeVolume.h"
#include "scene/Project.h"
#include "scene/StructureAt.h"
#include "session/extrusion/AreaSolver.h"
#include "session/extrusion/Extrusion.h"

namespace velum::session {

namespace {

constexpr double kNever = 1e30;
const glm::ivec2 kView(40, 30);

using Random = std::mt19937;
double in(Random& random, double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
bool oneOf(Random& random, int n) { return random() % unsigned(n) == 0; }

/// Balls of different structures, some in each other, in a turned grid whose voxels are no cubes.
LabelVolume ballLabels(Random& random) {
  struct Ball {
    glm::dvec3 middle;
    double radius;
  };
  std::vector<Ball> balls;
  for (int i = 0; i < 5; ++i)
    balls.push_back({{in(random, 4, 32), in(random, 4, 26), in(random, 4, 40)}, in(random, 3, 9)});
  glm::ivec3 dims(36, 30, 44);
  return makeLabels(
      dims,
      [&](glm::ivec3 voxel) {
        int id = 0;
        for (std::size_t i = 0; i < balls.size(); ++i)
          if (glm::distance(glm::dvec3(voxel), balls[i].middle) < balls[i].radius) id = 3 * int(i) + 2;
        return id;
      },
      centredFrame(dims, {1.0, 1.5, -0.8}, 0.7, {100, -50, 20}));
}

scene::Cut randomCut(Random& random, int id) {
  constexpr scene::CutShape kShapes[] = {scene::CutShape::Plane, scene::CutShape::Box, scene::CutShape::Sphere,
                                         scene::CutShape::Cylinder, scene::CutShape::Cone};
  scene::Cut cut;
  cut.id = id;
  cut.shape = kShapes[random() % std::size(kShapes)];
  cut.centre = glm::dvec3(100, -50, 20) + glm::dvec3(in(random, -10, 10), in(random, -10, 10), in(random, -10, 10));
  cut.axis = {in(random, -1, 1), in(random, -1, 1), in(random, -1, 1)};
  cut.size = glm::dvec3(in(random, 15, 45));
  cut.invert = oneOf(random, 3);
  cut.joined = oneOf(random, 3);
  cut.enabled = !oneOf(random, 6);
  for (int structure : {0, 2, 5, 8})
    if (oneOf(random, 3))
      cut.spares.push_back({structure, oneOf(random, 2) ? scene::Spare::kEndless : in(random, 0.5, 10)});
  return cut;
}

scene::Scene randomScene(unsigned seed) {
  Random random(seed);
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(ballLabels(random));
  scene::completeStructures(scene.labels);
  int cuts = int(random() % 4u);
  for (int i = 0; i < cuts; ++i) scene.cuts.push_back(randomCut(random, 10 + i));
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, double(kView.x) / kView.y);
  if (oneOf(random, 2)) scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.fieldOfViewDeg *= 0.5;
  scene.camera.height *= 0.5;
  return scene;
}

std::vector<int> someCuts(const scene::Scene& scene, unsigned seed) {
  Random random(seed + 1000);
  std::vector<int> chosen;
  for (const scene::Cut& cut : scene.cuts)
    if (chosen.empty() || oneOf(random, 2)) chosen.push_back(cut.id);
  return chosen;
}

std::vector<render::StructureHit> hitsOf(const scene::Scene& scene, const std::vector<int>& cuts) {
  Progress progress;
  return render::structureHits(scene, kView, cuts, progress);
}

/// How deep cuts must leave a place, of all cuts together: the largest of the groups of joined ones, of each the least.
/// @param set  those that it is asked of; others take or leave it by what they spare
double depthAt(const scene::Scene& scene, const std::vector<int>& set, int structure, glm::dvec3 world,
               double* nearest) {
  std::vector<double> groups;
  bool begins = true;
  for (const scene::Cut& cut : scene.cuts) {
    begins = begins || !cut.joined;
    if (!cut.enabled) continue;
    double depth = depthInCut(cut, world);
    *nearest = std::min(*nearest, std::abs(depth));
    double own = depth > 0.0 ? depth : -1.0;
    if (std::find(set.begin(), set.end(), cut.id) == set.end()) {
      double spared = extrusionOf(cut, structure);
      if (std::isfinite(spared)) *nearest = std::min(*nearest, std::abs(depth - spared));
      own = depth <= 0.0 || (spared > 0.0 && depth <= spared) ? -1.0 : kNever;
    }
    if (begins)
      groups.push_back(own);
    else
      groups.back() = std::min(groups.back(), own);
    begins = false;
  }
  double depth = -1.0;
  for (double group : groups) depth = std::max(depth, group);
  return depth;
}

struct Met {
  double depth = kNever, now = kNever;
  bool isUnsure = false;  ///< a face passes through a place that is asked, as near as floats tell
};

/// What a ray meets, by a look at every voxel of the grid.
std::map<int, Met> meetAll(const scene::Scene& scene, const std::vector<int>& set, const scene::PictureRay& ray) {
  const LabelVolume& labels = *scene.labels.data;
  glm::dmat4 voxelFromWorld = glm::inverse(labels.worldFromVoxel());
  glm::dvec3 o(voxelFromWorld * glm::dvec4(ray.origin, 1.0)), d(voxelFromWorld * glm::dvec4(ray.direction, 0.0));
  std::map<int, Met> met;
  glm::ivec3 dims = labels.dims(), v;
  auto field = scene::structureFieldOf(scene);
  for (v.z = 0; v.z < dims.z; ++v.z)
    for (v.y = 0; v.y < dims.y; ++v.y)
      for (v.x = 0; v.x < dims.x; ++v.x) {
        double from = 0.0, to = 1e300;
        for (int i = 0; i < 3; ++i) {
          double a = (v[i] - 0.5 - o[i]) / d[i], b = (v[i] + 0.5 - o[i]) / d[i];
          from = std::max(from, std::min(a, b)), to = std::min(to, std::max(a, b));
        }
        if (to <= from) continue;
        int places = field->hasBorder(v) ? 4 : 1;
        for (int i = 0; i < places; ++i) {
          glm::dvec3 world = ray.origin + (from + (i + 0.5) / places * (to - from)) * ray.direction;
          int id = scene::structureAt(scene, world).id;
          if (id == 0) continue;
          double nearest = 1.0;
          Met& one = met[id];
          one.depth = std::min(one.depth, depthAt(scene, set, id, world, &nearest));
          one.now = std::min(one.now, depthAt(scene, {}, id, world, &nearest));
          one.isUnsure = one.isUnsure || nearest < 1e-4 || to - from < 1e-9;
        }
      }
  return met;
}

std::uint64_t leftOf(const scene::Scene& scene, int structure) {
  std::uint64_t count = 0;
  for (const render::StructureHit& hit : hitsOf(scene, {})) count += hit.structure == structure && hit.isLeft;
  return count;
}

scene::Scene withDistance(scene::Scene scene, const std::vector<int>& cuts, int structure, double distance) {
  for (int cut : cuts) setExtrusion(*scene::findCut(scene, cut), structure, distance);
  return scene;
}

}  // namespace

TEST(StructureAreas, RaysMeetWhatALookAtEveryVoxelFinds) {
  int checked = 0, unsure = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    scene::Scene scene = randomScene(seed);
    std::vector<int> set = someCuts(scene, seed);
    std::vector<render::StructureHit> hits = hitsOf(scene, set);
    std::size_t at = 0;
    for (int pixel = 0; pixel < kView.x * kView.y; ++pixel) {
      auto ray = scene::rayFromPixel(scene.camera, kView, {pixel % kView.x + 0.5, pixel / kView.x + 0.5});
      bool isAsked = pixel % 7 == 0;  // the plain loop is slow
      std::map<int, Met> met = isAsked ? meetAll(scene, set, ray) : std::map<int, Met>();
      auto expected = met.begin();
      for (; at < hits.size() && hits[at].pixel == std::uint32_t(pixel); ++at) {
        if (!isAsked) continue;
        ASSERT_NE(expected, met.end());
        ASSERT_EQ(hits[at].structure, expected->first) << "seed " << seed << " pixel " << pixel;
        ++checked;
        if (expected->second.isUnsure) {
          ++unsure;
        } else {
          EXPECT_EQ(hits[at].isLeft, expected->second.now < 0.0) << "seed " << seed << " pixel " << pixel;
          EXPECT_NEAR(std::min(double(hits[at].depth), kNever), expected->second.depth,
                      expected->second.depth < kNever ? 1e-3 : 1e25);
        }
        ++expected;
      }
      EXPECT_EQ(expected, met.end());
    }
    EXPECT_EQ(at, hits.size());
  }
  EXPECT_GT(checked, 400);
  EXPECT_LT(unsure, checked / 20);
}

TEST(StructureAreas, ToldToStopRaysDo) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(render::structureHits(randomScene(1), kView, {}, progress), Cancelled);
  scene::Scene hidden = randomScene(1);
  EXPECT_FALSE(hitsOf(hidden, {}).empty());
  hidden.labels.visible = false;
  EXPECT_TRUE(hitsOf(hidden, {}).empty());
}

TEST(StructureAreas, EachPixelOfAStructureIsOneOfThree) {
  Random random(4);
  scene::Scene scene = randomScene(4);
  scene.cuts = {randomCut(random, 1)};
  scene.cuts[0].enabled = true;
  std::vector<render::StructureHit> hits = hitsOf(scene, {});
  ASSERT_FALSE(hits.empty());
  // A picture that shows what is left of the structure with the largest number, and one pixel of an instance.
  Image picture{kView.x, kView.y, {"R", "id", "instance"}, {}};
  std::map<int, StructureArea> expected;
  std::vector<int> shown(std::size_t(kView.x) * std::size_t(kView.y), 0);
  for (const render::StructureHit& hit : hits)
    if (hit.isLeft) shown[hit.pixel] = hit.structure;
  std::size_t covered = hits.back().pixel;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    picture.pixels.insert(picture.pixels.end(), {0.5f, float(shown[i]), i == covered ? 3.0f : 0.0f});
    if (i == covered) shown[i] = 0;
  }
  for (const scene::Structure& structure : scene.labels.structures)
    expected[structure.id] = {structure.id, structure.name};
  for (const render::StructureHit& hit : hits) {
    CountOf left = hit.isLeft ? CountOf::Hidden : CountOf::Clipped;
    ++expected[hit.structure].count[shown[hit.pixel] == hit.structure ? CountOf::Visible : left];
  }
  std::vector<StructureArea> areas = structureAreas(scene, hits, picture);
  ASSERT_EQ(areas.size(), expected.size());
  for (const StructureArea& area : areas) EXPECT_EQ(area, expected.at(area.structure));
  // What is not shown counts as clipped, as do types that are not.
  scene::Structure& first = scene.labels.structures.front();
  first.visible = false;
  std::uint64_t total = expected.at(first.id).count.total();
  for (std::size_t i = 1; i < picture.pixels.size(); i += 3)
    if (picture.pixels[i] == float(first.id)) picture.pixels[i] = 0.0f;
  areas = structureAreas(scene, hits, picture);
  EXPECT_EQ(areas.front().count.clipped(), total);
  EXPECT_EQ(areas.front().count.total(), total);
}

TEST(AreaSolver, TheNthDepthLeavesNPixels) {
  int solved = 0, ties = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    scene::Scene scene = randomScene(seed);
    std::vector<int> set = someCuts(scene, seed);
    std::vector<render::StructureHit> hits = hitsOf(scene, set);
    for (const scene::Structure& structure : scene.labels.structures) {
      AreaSolver solver(scene, set, structure.id, hits);
      CountRange range = solver.range();
      EXPECT_EQ(range.least, leftOf(withDistance(scene, set, structure.id, 0.0), structure.id)) << "seed " << seed;
      EXPECT_EQ(range.most, leftOf(withDistance(scene, set, structure.id, 1e6), structure.id)) << "seed " << seed;
      SolvedArea before;
      for (int i = 0; i <= 3; ++i) {
        double wanted = double(range.least) + i / 3.0 * double(range.most - range.least);
        SolvedArea one = solver.solve(wanted);
        EXPECT_EQ(leftOf(one.scene, structure.id), one.reached) << "seed " << seed << " of " << structure.id;
        EXPECT_EQ(one.wanted, std::uint64_t(std::llround(wanted)));
        ties += one.reached != one.wanted;
        solved += range.most > range.least;
        EXPECT_GE(one.distance, before.distance);
        EXPECT_GE(one.reached, before.reached);
        before = std::move(one);
      }
    }
  }
  EXPECT_GT(solved, 100);
  EXPECT_LT(ties, solved / 20);
}

TEST(AreaSolver, OfPixelsThatComeTogetherTheNearerNumber) {
  // A slab seen face on: a layer of voxels comes at once.
  scene::Scene scene;
  glm::ivec3 dims(8, 6, 8);
  scene.labels.data = Shared<LabelVolume>(makeLabels(
      dims, [](glm::ivec3 v) { return v.y > 2 ? 4 : 0; }, centredFrame(dims)));
  scene::completeStructures(scene.labels);
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kView.x) / kView.y);
  scene.camera.projection = scene::Projection::Orthographic;
  scene::Cut cut;
  cut.id = 1;
  cut.centre = {0, 20, 0};
  scene.cuts = {cut};
  AreaSolver solver(scene, {1}, 4, hitsOf(scene, {1}));
  CountRange range = solver.range();
  ASSERT_EQ(range.least, 0u);
  ASSERT_GT(range.most, 20u);
  EXPECT_EQ(solver.solve(0.4 * double(range.most)).reached, 0u);
  EXPECT_EQ(solver.solve(0.4 * double(range.most)).distance, 0.0);
  SolvedArea solved = solver.solve(0.6 * double(range.most));
  EXPECT_EQ(solved.reached, range.most);
  EXPECT_EQ(leftOf(solved.scene, 4), range.most);
  EXPECT_NE(solved.words.find(", the nearest to "), std::string::npos);
}

TEST(AreaSolver, ChangesNothingButTheStructureInItsCuts) {
  scene::Scene scene = randomScene(3);
  int structure = scene.labels.structures.front().id;
  scene::Cut ball;
  ball.id = 1;
  ball.shape = scene::CutShape::Sphere;
  ball.centre = scene.camera.target;
  ball.size = glm::dvec3(1000.0);
  ball.spares = {{structure, 3.0}, {90, 4.0}};
  scene.cuts = {ball, ball};
  scene.cuts[1].id = 2;
  scene.cuts[1].spares = {{structure, scene::Spare::kEndless}};
  AreaSolver solver(scene, {1}, structure, hitsOf(scene, {1}));
  ASSERT_GT(solver.range().most, solver.range().least);
  SolvedArea solved = solver.solve(0.5 * double(solver.range().least + solver.range().most));
  scene::Scene expected = scene;
  setExtrusion(expected.cuts[0], structure, solved.distance);
  EXPECT_EQ(solved.scene, expected);
  EXPECT_EQ(extrusionOf(solved.scene.cuts[0], 90), 4.0);
  EXPECT_EQ(solver.solve(0.0).scene.cuts[0].spares.size(), 1u) << "what does not stand out is no spare";
}

TEST(AreaSolver, SaysWhatIsOutOfReach) {
  scene::Scene scene = randomScene(2);
  scene.cuts.clear();
  int structure = scene.labels.structures.front().id;
  std::string name = scene.labels.structures.front().name;
  std::uint64_t total = AreaSolver(scene, {}, structure, hitsOf(scene, {})).range().total;
  ASSERT_GT(total, 10u);
  auto words = [&](double wanted) {
    std::vector<int> cuts = cutsToPullFrom(scene);
    return AreaSolver(scene, cuts, structure, hitsOf(scene, cuts)).solve(wanted).words;
  };
  std::string all = name + " is left on " + std::to_string(total) + " of " + std::to_string(total) + " pixels";
  EXPECT_EQ(words(double(total)), all);
  EXPECT_EQ(words(3), all + ": no cut is on out of which it could stand");
  scene::Cut cut;
  cut.id = 1;
  cut.centre = {1e4, 0, 0};
  cut.axis = {1, 0, 0};
  scene.cuts = {cut};
  EXPECT_NE(words(3).find(", not fewer: "), std::string::npos);
  scene.cuts[0].axis = {-1, 0, 0};
  scene.cuts.push_back(scene.cuts[0]);
  scene.cuts[1].id = 2, scene.cuts[1].shape = scene::CutShape::Everywhere;
  EXPECT_EQ(cutsToPullFrom(scene), std::vector<int>{1});
  EXPECT_NE(words(3).find(", not more: "), std::string::npos);
  scene.labels.structures.front().visible = false;
  EXPECT_EQ(words(3), name + " is not shown");
}

}  // namespace velum::session
