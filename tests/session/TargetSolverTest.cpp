#include "session/model/TargetSolver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/Error.h"
#include "makeModel.h"
#include "session/cut/CutEdit.h"
#include "session/model/TypesAt.h"
#include "session/model/WhatHides.h"

namespace velum::session {

namespace {

scene::Scene ballScene(int types = 4, int instances = 1200) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.types = types, .atoms = 8, .instances = instances}.make());
  scene::Cut cut;
  cut.id = 7;
  cut.shape = scene::CutShape::Sphere;
  cut.size = glm::dvec3(330.0);
  scene.cuts = {cut};
  return scene;
}

/// A picture without a driver: the model seen along z in cells, each of which shows the first that is drawn in it.
render::InstanceBits cellPicture(const scene::Scene& scene, double cell) {
  const Model& model = *scene.model.data;
  std::vector<std::uint8_t> kept = render::keptInstances(scene);
  std::vector<bool> shown = visibleTypes(scene.model);
  scene::CopyGrid copies = scene::copyGrid(scene.model);
  auto placeOf = [&](std::size_t i) {
    int copy = int(i / model.instances.size()), line = copy / copies.counts.x;
    glm::dvec3 block(copy % copies.counts.x, line % copies.counts.y, line / copies.counts.y);
    return glm::dvec3(model.instances[i % model.instances.size()].position) + block * copies.step;
  };
  render::InstanceBits bits;
  bits.count = kept.size();
  bits.removed.assign((kept.size() + 31) / 32, 0u), bits.shown = bits.removed;
  std::map<std::pair<int, int>, std::size_t> first;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Instance& instance = model.instances[i % model.instances.size()];
    if (!kept[i] || !shown[model.molecules[instance.molecule].type]) {
      bits.removed[i >> 5] |= 1u << (i & 31u);
      continue;
    }
    glm::dvec3 place = placeOf(i);
    std::pair at(int(std::floor(place.x / cell)), int(std::floor(place.y / cell)));
    auto [found, isNew] = first.try_emplace(at, i);
    if (!isNew && place.z > placeOf(found->second).z) found->second = i;
  }
  for (const auto& [at, i] : first) bits.shown[i >> 5] |= 1u << (i & 31u);
  return bits;
}

CountPicture cells(double cell) {
  return [cell](const scene::Scene& scene) { return cellPicture(scene, cell); };
}

Counts countOf(const scene::Scene& scene, std::string_view path, double cell) {
  std::vector<Counts> counts = render::countTypes(*scene.model.data, cellPicture(scene, cell));
  Counts sum;
  for (std::uint32_t type : typesAt(*scene.model.data, path).types) sum += counts[type];
  return sum;
}

std::uint64_t mostSeen(scene::Scene scene, std::string_view path, double cell) {
  RenderedSolver solver(scene, {7}, path);
  return countOf(solver.solve(1e9).scene, path, cell).visible();
}

}  // namespace

TEST(VisibleSolver, ReachesEveryNumberThatCanBeSeenOfAType) {
  scene::Scene scene = ballScene();
  for (double cell : {14.0, 30.0})
    for (const char* path : {"type0", "type1", "type3"}) {
      std::uint64_t least = countOf(scene, path, cell).visible(), most = mostSeen(scene, path, cell);
      ASSERT_GT(most, least + 6);
      for (std::uint64_t wanted = least + 1; wanted <= most; wanted += 7) {
        Solved solved = solveVisible(scene, {7}, path, double(wanted), cells(cell));
        EXPECT_EQ(solved.reached, wanted) << path << ": " << solved.words;
        EXPECT_EQ(countOf(solved.scene, path, cell).visible(), wanted) << path;
      }
    }
}

TEST(VisibleSolver, SaysWhyMoreCannotBeSeen) {
  scene::Scene scene = ballScene();
  Solved solved = solveVisible(scene, {7}, "type0", 290.0, cells(30.0));
  EXPECT_EQ(solved.reached, mostSeen(scene, "type0", 30.0));
  EXPECT_NE(solved.words.find("not 290: all are drawn, and"), std::string::npos) << solved.words;
  Solved few = solveVisible(scene, {7}, "type0", 0.0, cells(30.0));
  EXPECT_NE(few.words.find("lie outside of the cuts"), std::string::npos) << few.words;
}

TEST(VisibleSolver, SetsWhatStaysInTheViewWhereACutKeepsAnotherTypeInIt) {
  scene::Scene scene = ballScene();
  scene.camera.target = {0, 0, 0};
  scene.cuts.clear();
  int cut = clearTheWay(scene, "type0");
  render::InstanceBits bits = cellPicture(scene, 20.0);
  std::uint64_t cleared = render::countTypes(*scene.model.data, bits)[1].clipped();
  ASSERT_GT(cleared, 20u);
  std::uint64_t wanted = countOf(scene, "type1", 20.0).visible() + 5;
  Solved solved = solveVisible(scene, {cut}, "type1", double(wanted), cells(20.0));
  const scene::TypeSpare* row = findTypeSpare(solved.scene.cuts[0], "root.b.type1");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->share, 1.0);
  EXPECT_GT(row->viewShare, 0.0);
  EXPECT_NEAR(double(solved.reached), double(wanted), 1.0) << solved.words;
}

TEST(VisibleSolver, GoesOnWithTheShareOfAllWhereTooManyShowBesideTheView) {
  scene::Scene scene = ballScene();
  scene.camera.target = {0, 0, 0};
  scene.cuts.clear();
  int cut = clearTheWay(scene, "type0");
  std::uint64_t beside = countOf(scene, "type1", 20.0).visible();  // none of these hides it
  ASSERT_GT(beside, 40u);
  Solved solved = solveVisible(scene, {cut}, "type1", double(beside / 2), cells(20.0));
  EXPECT_EQ(solved.reached, beside / 2) << solved.words;
  const scene::TypeSpare* row = findTypeSpare(solved.scene.cuts[0], "root.b.type1");
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->viewShare, 0.0);
  EXPECT_LT(row->share, 1.0);
}

TEST(TargetSolver, MeetsSeveralAtOnceAndDrawnOnesExactly) {
  scene::Scene scene = ballScene();
  // Numbers that some shares give.
  scene::Scene met = solveRendered(scene, {7}, "type0", 250.0).scene;
  for (const auto& [path, share] :
       {std::pair("root.b.type1", 0.4), std::pair("root.a.type2", 0.7), std::pair("root.b.type3", 0.5)})
    setTypeShare(met.cuts[0], path, share);
  auto seen = [&](const char* path) { return double(countOf(met, path, 20.0).visible()); };
  std::vector<scene::TypeTarget> targets{{"type0", 250.0, std::nullopt},
                                         {"type1", std::nullopt, seen("type1")},
                                         {"type2", std::nullopt, seen("type2")},
                                         {"type3", std::nullopt, seen("type3")}};
  TargetsReport report = solveTargets(scene, {7}, targets, cells(20.0));
  ASSERT_EQ(report.targets.size(), 4u);
  EXPECT_EQ(report.residual, 0u) << report.targets[1].words << "; " << report.targets[2].words;
  EXPECT_EQ(countOf(report.scene, "type0", 20.0).left(), 250u);
  for (int i : {1, 2, 3}) {
    const auto& target = report.targets[std::size_t(i)];
    EXPECT_EQ(double(*target.visible), *targets[std::size_t(i)].visible) << target.words;
    EXPECT_EQ(countOf(report.scene, target.path, 20.0).visible(), *target.visible);
  }
}

TEST(TargetSolver, ReportsStandInTheOrderOfTheTargets) {
  scene::Scene scene = ballScene();
  // Types are met first: one compartment before two of them is a turn of three.
  std::vector<scene::TypeTarget> targets{
      {"root.b", 500.0, std::nullopt}, {"type0", 250.0, std::nullopt}, {"type2", 240.0, std::nullopt}};
  TargetsReport report = solveTargets(scene, {7}, targets, cells(20.0));
  ASSERT_EQ(report.targets.size(), targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    EXPECT_TRUE(report.targets[i].path.ends_with(targets[i].type)) << report.targets[i].path;
    EXPECT_EQ(double(report.targets[i].rendered), *targets[i].rendered) << report.targets[i].words;
  }
}

TEST(TargetSolver, CopiesCountLikeAllOtherInstances) {
  scene::Scene scene = ballScene();
  scene.model.copies = 2;
  RenderedSolver drawn(scene, {7}, "type0");
  double wantedDrawn = double(drawn.range().least + 30);
  double wantedSeen = double(countOf(scene, "type1", 20.0).visible() + 9);
  TargetsReport report = solveTargets(
      scene, {7}, {{"type0", wantedDrawn, std::nullopt}, {"type1", std::nullopt, wantedSeen}}, cells(20.0));
  EXPECT_EQ(report.residual, 0u) << report.targets[0].words << "; " << report.targets[1].words;
  EXPECT_EQ(double(countOf(report.scene, "type0", 20.0).left()), wantedDrawn);
  EXPECT_EQ(double(countOf(report.scene, "type1", 20.0).visible()), wantedSeen);
  for (const TargetReport& target : report.targets) EXPECT_EQ(target.total, 600u) << target.words;
}

// A focus on type1 keeps type1 in view, and clears type11.
TEST(VisibleSolver, NamesThatBeginAlikeAreTwoTypes) {
  scene::Scene scene = ballScene(12, 3600);
  scene.cuts.clear();
  int cut = clearTheWay(scene, "root.b.type1");
  auto isCleared = [&](std::uint32_t type) { return session::isCleared(scene, {cut}, {type}); };
  EXPECT_FALSE(isCleared(1));
  EXPECT_TRUE(isCleared(11));
  EXPECT_TRUE(isCleared(3));
  scene.cuts[0].model.focus->types = {{"root.b"}};
  EXPECT_FALSE(isCleared(11)) << "what hangs in a compartment is meant with it";
}

TEST(TypesAt, ANameIsAWholeOne) {
  ModelBuilder builder("capsid");
  for (const char* name : {"NCA", "CA"}) {
    MoleculeType type;
    type.name = name;
    type.compartment = builder.compartment(std::vector<std::string>{"capsid"});
    builder.addInstance(builder.addMolecule(builder.addType(type), randomAtoms(8, 10.0f, 5)), glm::vec3(0.0f),
                        glm::quat(1, 0, 0, 0));
  }
  Model model = builder.build();
  EXPECT_TRUE(typesAt(model, "CA").path.ends_with(".CA"));
  EXPECT_TRUE(typesAt(model, "capsid.CA").path.ends_with(".CA"));
  EXPECT_THROW(typesAt(model, "A"), InputError) << "which is the end of both";
}

TEST(TargetSolver, ACompartmentLeavesTypesAloneThatHaveTargetsOfTheirOwn) {
  scene::Scene scene = ballScene();
  RenderedSolver all(scene, {7}, "root.a"), one(scene, {7}, "root.a.type0");
  double wantedOne = double(one.range().least + 11), wantedAll = double(all.range().least + 60);
  std::vector<scene::TypeTarget> targets{{"root.a", wantedAll, std::nullopt},
                                         {"root.a.type0", wantedOne, std::nullopt}};
  TargetsReport report = solveTargets(scene, {7}, targets, cells(20.0));
  EXPECT_EQ(report.pictures, 0);
  EXPECT_EQ(report.residual, 0u);
  EXPECT_EQ(double(countOf(report.scene, "root.a.type0", 20.0).left()), wantedOne);
  EXPECT_EQ(double(countOf(report.scene, "root.a", 20.0).left()), wantedAll);
  EXPECT_EQ(report.targets[0].path, "root.a");
  EXPECT_FALSE(report.targets[0].visible.has_value());
}

TEST(TargetSolver, AsksForPicturesOneByOne) {
  scene::Scene scene = ballScene();
  TargetSolver solver(scene, {7}, {{"type1", std::nullopt, double(countOf(scene, "type1", 20.0).visible() + 9)}});
  int asked = 0;
  while (const scene::Scene* next = solver.next()) solver.take(cellPicture(*next, 20.0)), ++asked;
  EXPECT_TRUE(solver.report().targets.front().isMet);
  EXPECT_EQ(solver.report().pictures, asked);
  EXPECT_LE(asked, kMostPicturesOfOne);
}

TEST(TargetSolver, WithoutACutOneEverywhereTakesWhatIsTooMany) {
  scene::Scene scene = ballScene();
  scene.cuts.clear();
  EXPECT_EQ(countOf(scene, "root", 20.0).clipped(), 0u);
  TargetsReport report = solveTargets(scene, {{"type2", 12.0, std::nullopt}}, cells(20.0));
  ASSERT_EQ(report.scene.cuts.size(), 1u);
  EXPECT_EQ(countOf(report.scene, "type2", 20.0).left(), 12u);
  EXPECT_EQ(countOf(report.scene, "root", 20.0).clipped(), 288u);
}

TEST(TargetSolver, FewerThanLieOutsideOfTheCutsAreThinnedByACutEverywhere) {
  scene::Scene scene = ballScene();
  scene.cuts[0].model.spares = {{.type = "root", .share = 0.0}};
  Counts before = countOf(scene, "type1", 20.0), others = countOf(scene, "type2", 20.0);
  ASSERT_GT(before.clipped(), 10u);
  ASSERT_GT(before.visible(), 60u);
  for (double wanted : {0.0, 7.0, 20.0, 41.0}) {
    TargetsReport report = solveTargets(scene, {{"type1", std::nullopt, wanted}}, cells(20.0));
    EXPECT_TRUE(report.targets[0].isMet) << report.targets[0].words;
    EXPECT_EQ(report.scene.cuts.size(), 2u) << wanted;
    EXPECT_EQ(double(countOf(report.scene, "type1", 20.0).visible()), wanted);
    EXPECT_EQ(countOf(report.scene, "type2", 20.0).left(), others.left()) << "other types stay as they are";
    std::vector<std::uint8_t> kept = render::keptInstances(report.scene), was = render::keptInstances(scene);
    for (std::size_t i = 0; i < kept.size(); ++i) ASSERT_LE(kept[i], was[i]) << "nothing of the region comes back";
  }
  TargetsReport more = solveTargets(scene, {{"type1", double(before.left() + 5), std::nullopt}}, cells(20.0));
  EXPECT_EQ(more.scene.cuts.size(), 1u) << "the region alone has them";
  EXPECT_EQ(countOf(more.scene, "type1", 20.0).left(), before.left() + 5);
}

TEST(TargetSolver, NumbersWithinACompartmentStayWhileItIsLetSee) {
  scene::Scene scene = ballScene();
  scene = RenderedSolver::ofAllCuts(scene, "root.a.type0").solve(31.0).scene;
  holdDrawn(scene, "root.a.type0", 31.0);
  Solved solved = solveVisible(scene, {}, "root.a", 60.0, cells(20.0));
  EXPECT_EQ(solved.reached, 60u) << solved.words;
  EXPECT_EQ(countOf(solved.scene, "root.a.type0", 20.0).left(), 31u);
}

}  // namespace velum::session
