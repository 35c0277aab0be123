// The handle of a bar where nobody says which cuts: one motion from all to none.
#include <gtest/gtest.h>

#include "makeModel.h"
#include "session/cut/CutEdit.h"
#include "session/model/RenderedSolver.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

scene::Scene cutScene() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = 4, .instances = 2000}.make());
  scene::Cut cut = makeCut(scene, scene::CutShape::Sphere);
  cut.centre = glm::dvec3(0.0);
  cut.size = glm::dvec3(300.0);
  scene::addCut(scene, cut);
  return scene;
}

std::vector<std::uint8_t> keptOf(const scene::Scene& scene, std::string_view path) {
  const Model& model = *scene.model.data;
  std::vector<std::uint8_t> all = render::keptInstances(scene), kept;
  for (std::uint32_t type : typesAt(model, path).types)
    for (std::size_t i = 0; i < model.types[type].instanceCount; ++i)
      kept.push_back(all[model.types[type].firstInstance + i]);
  return kept;
}

std::uint64_t count(const std::vector<std::uint8_t>& kept) {
  return std::uint64_t(std::count(kept.begin(), kept.end(), 1));
}

}  // namespace

TEST(AllCuts, GoesFromAllToNoneWhateverCutsThereAre) {
  scene::Scene scene = cutScene();
  for (const char* path : {"type1", "root.a", "root"}) {
    RenderedSolver solver = RenderedSolver::ofAllCuts(scene, path);
    CountRange range = solver.range();
    EXPECT_EQ(range.least, 0u);
    EXPECT_EQ(range.most, range.total);
    for (double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      auto wanted = std::uint64_t(std::llround(share * double(range.total)));
      Solved solved = solver.solve(double(wanted));
      EXPECT_EQ(solved.reached, wanted);
      EXPECT_EQ(count(keptOf(solved.scene, path)), wanted) << path << " " << share;
    }
  }
}

TEST(AllCuts, WhatLiesInRegionsGoesFirstAndComesBackLast) {
  scene::Scene scene = cutScene();
  RenderedSolver solver = RenderedSolver::ofAllCuts(scene, "type1");
  std::vector<std::uint8_t> outside = keptOf(scene, "type1"), last;
  std::uint64_t least = count(outside);
  ASSERT_GT(least, 40u);
  ASSERT_GT(solver.range().total, least + 40);
  for (std::uint64_t wanted = 0; wanted <= solver.range().total; wanted += 20) {
    std::vector<std::uint8_t> kept = keptOf(solver.solve(double(wanted)).scene, "type1");
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (wanted <= least) {
        EXPECT_LE(kept[i], outside[i]) << "nothing of the region";
      }
      if (wanted >= least) {
        EXPECT_GE(kept[i], outside[i]) << "all of the rest";
      }
      if (!last.empty()) {
        EXPECT_GE(kept[i], last[i]) << "one that is there stays while more come";
      }
    }
    last = kept;
  }
}

TEST(AllCuts, AddsACutEverywhereOnlyWhereItIsNeeded) {
  scene::Scene scene = cutScene();
  RenderedSolver solver = RenderedSolver::ofAllCuts(scene, "type1");
  std::uint64_t least = count(keptOf(scene, "type1"));
  EXPECT_EQ(solver.solve(double(least) + 10.0).scene.cuts.size(), 1u);
  scene::Scene thinned = solver.solve(double(least) - 10.0).scene;
  EXPECT_EQ(thinned.cuts.size(), 2u);
  EXPECT_EQ(count(keptOf(thinned, "type2")), count(keptOf(scene, "type2"))) << "other types stay as they are";
  RenderedSolver again = RenderedSolver::ofAllCuts(thinned, "type1");
  EXPECT_EQ(again.solve(double(least) - 30.0).scene.cuts.size(), 2u) << "the one that is there is taken";
  EXPECT_EQ(keptOf(again.solve(double(least)).scene, "type1"), keptOf(scene, "type1"));
}

/// How many are drawn of each type.
std::vector<std::uint64_t> drawnByType(const scene::Scene& scene) {
  std::vector<std::uint64_t> counts;
  for (const auto& type : scene.model.data->types)
    counts.push_back(count(keptOf(scene, pathOf(*scene.model.data, type))));
  return counts;
}

TEST(AllCuts, NoTypeGetsMoreWhenTheNumberOfItsGroupGoesDown) {
  // Types that are left in other proportions than they have instances.
  scene::Scene scene = cutScene();
  scene = RenderedSolver::ofAllCuts(scene, "type1").solve(60.0).scene;
  scene = RenderedSolver::ofAllCuts(scene, "type2").solve(300.0).scene;
  std::vector<std::uint64_t> before = drawnByType(scene), last = before;
  std::uint64_t all = before[0] + before[1] + before[2] + before[3];
  RenderedSolver solver = RenderedSolver::ofAllCuts(scene, "root");
  for (double share : {1.0, 0.95, 0.8, 0.5, 0.2, 0.0}) {
    auto wanted = std::uint64_t(std::llround(share * double(all)));
    Solved solved = solver.solve(double(wanted));
    EXPECT_EQ(solved.reached, wanted);
    std::vector<std::uint64_t> now = drawnByType(solved.scene);
    for (std::size_t t = 0; t < now.size(); ++t) EXPECT_LE(now[t], last[t]) << share << " type" << t;
    last = now;
  }
}

TEST(AllCuts, ANumberSetByHandStaysWhenThatOfItsGroupIsSet) {
  scene::Scene scene = cutScene();
  Solved one = RenderedSolver::ofAllCuts(scene, "type1").solve(100.0);
  scene = one.scene;
  holdDrawn(scene, typesAt(*scene.model.data, "type1").path, 100.0);
  RenderedSolver solver = RenderedSolver::ofAllCuts(scene, "root");
  EXPECT_EQ(solver.range().total, 2000u);
  for (double wanted : {1500.0, 900.0, 300.0, 100.0}) {
    Solved solved = solver.solve(wanted);
    EXPECT_EQ(double(solved.reached), wanted) << solved.words;
    EXPECT_EQ(count(keptOf(solved.scene, "root")), solved.reached);
    EXPECT_EQ(count(keptOf(solved.scene, "type1")), 100u) << wanted;
    EXPECT_NE(solved.words.find("set by hand stays"), std::string::npos) << solved.words;
  }
  Solved most = solver.solve(2000.0);
  EXPECT_EQ(most.reached, 1600u) << "all of the others, and it";
  EXPECT_NE(most.words.find("set by hand"), std::string::npos) << most.words;
}

TEST(AllCuts, NumbersSetByHandGoDownInProportionWhereTheirGroupHasNoRoomForThem) {
  scene::Scene scene = cutScene();
  for (auto [name, number] : {std::pair("type1", 90.0), {"type2", 30.0}}) {
    scene = RenderedSolver::ofAllCuts(scene, name).solve(number).scene;
    holdDrawn(scene, typesAt(*scene.model.data, name).path, number);
  }
  Solved solved = RenderedSolver::ofAllCuts(scene, "root").solve(40.0);
  EXPECT_EQ(solved.reached, 40u) << solved.words;
  EXPECT_EQ(drawnByType(solved.scene), (std::vector<std::uint64_t>{0, 30, 10, 0}));
  EXPECT_NE(solved.words.find("go down"), std::string::npos) << solved.words;
  EXPECT_EQ(targetOf(solved.scene.model, typesAt(*scene.model.data, "type1").path)->rendered, 30.0)
      << "what is held is what is drawn";
}

}  // namespace velum::session
