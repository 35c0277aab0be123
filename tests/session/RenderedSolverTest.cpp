#include "session/model/RenderedSolver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/Error.h"
#include "makeModel.h"
#include "render/kept/KeptInstances.h"
#include "session/cut/CutEdit.h"
#include "session/cut/ShapeTraits.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

using Random = std::mt19937;
double unit(Random& random) { return std::uniform_real_distribution<double>(0.0, 1.0)(random); }
double in(Random& random, double low, double high) { return low + (high - low) * unit(random); }
bool oneOf(Random& random, int n) { return random() % unsigned(n) == 0; }

scene::Scene modelScene(const ModelMaker& maker) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(maker.make());
  return scene;
}

scene::TypeSpare randomSpare(Random& random, std::string path) {
  scene::TypeSpare spare;
  spare.type = std::move(path);
  spare.share = unit(random);
  if (oneOf(random, 3)) spare.distance = in(random, 0.0, 150.0);
  if (!oneOf(random, 3)) spare.falloff = in(random, -150.0, 150.0);
  spare.amount = oneOf(random, 3) ? 1.0 : unit(random);
  spare.exponent = in(random, 0.3, 3.0);
  return spare;
}

scene::Cut randomCut(Random& random, const Model& model, int id) {
  scene::Cut cut;
  cut.id = id;
  constexpr scene::CutShape kShapes[] = {scene::CutShape::Plane,    scene::CutShape::Box,  scene::CutShape::Sphere,
                                         scene::CutShape::Cylinder, scene::CutShape::Cone, scene::CutShape::Everywhere};
  cut.shape = kShapes[random() % std::size(kShapes)];
  cut.centre = {in(random, -80, 80), in(random, -80, 80), in(random, -80, 80)};
  cut.axis = {in(random, -1, 1), in(random, -1, 1), in(random, -1, 1)};
  cut.size = glm::dvec3(in(random, 150, 450));
  cut.invert = cut.shape != scene::CutShape::Everywhere && oneOf(random, 3);
  cut.joined = oneOf(random, 3);
  cut.model.wholeInstances = oneOf(random, 3);
  for (const MoleculeType& type : model.types)
    if (oneOf(random, 2)) cut.model.spares.push_back(randomSpare(random, pathOf(model, type)));
  for (std::uint32_t i = 0; i < model.compartments.size(); ++i)
    if (oneOf(random, 2)) cut.model.spares.push_back(randomSpare(random, compartmentPath(model, i)));
  return cut;
}

/// Drawn instances by type.
std::vector<std::uint64_t> countsOf(const scene::Scene& scene) {
  const Model& model = *scene.model.data;
  std::vector<std::uint8_t> kept = render::keptInstances(scene);
  std::vector<std::uint64_t> counts(model.types.size(), 0);
  for (std::size_t i = 0; i < kept.size(); ++i)
    counts[model.molecules[model.instances[i % model.instances.size()].molecule].type] += kept[i];
  return counts;
}

std::uint64_t countOf(const scene::Scene& scene, std::string_view path) {
  std::vector<std::uint64_t> counts = countsOf(scene);
  std::uint64_t count = 0;
  for (std::uint32_t type : typesAt(*scene.model.data, path).types) count += counts[type];
  return count;
}

/// The scene with one share for a path in cuts.
std::uint64_t countWith(scene::Scene scene, const std::vector<int>& cuts, std::string_view path, double share) {
  const Model& model = *scene.model.data;
  for (scene::Cut& cut : scene.cuts)
    if (std::find(cuts.begin(), cuts.end(), cut.id) != cuts.end())
      for (std::uint32_t type : typesAt(model, path).types) setTypeShare(cut, pathOf(model, model.types[type]), share);
  return countOf(scene, path);
}

/// A ball in the middle that takes all.
scene::Scene ballScene(ModelMaker maker = {.types = 4, .instances = 1200}) {
  scene::Scene scene = modelScene(maker);
  scene::Cut cut;
  cut.id = 7;
  cut.shape = scene::CutShape::Sphere;
  cut.size = glm::dvec3(300.0);
  scene.cuts = {cut};
  return scene;
}

}  // namespace

TEST(RenderedSolver, EveryNumberInTheRangeIsDrawnExactly) {
  int solved = 0;
  for (unsigned seed = 1; seed <= 150; ++seed) {
    Random random(seed);
    scene::Scene scene = modelScene({.types = 4, .atoms = 8, .instances = 1200, .seed = seed});
    const Model& model = *scene.model.data;
    int cuts = 1 + int(random() % 4u);
    for (int i = 0; i < cuts; ++i) scene.cuts.push_back(randomCut(random, model, 10 + i));
    scene.model.copies = oneOf(random, 4) ? 2 : 1;
    std::vector<int> chosen;
    for (const scene::Cut& cut : scene.cuts)
      if (chosen.empty() || oneOf(random, 2)) chosen.push_back(cut.id);
    std::string path = oneOf(random, 3) ? compartmentPath(model, std::uint32_t(random() % model.compartments.size()))
                                        : pathOf(model, model.types[random() % model.types.size()]);
    RenderedSolver solver(scene, chosen, path);
    CountRange range = solver.range();
    EXPECT_EQ(range.least, countWith(scene, chosen, path, 0.0)) << "seed " << seed;
    EXPECT_EQ(range.most, countWith(scene, chosen, path, 1.0)) << "seed " << seed;
    for (int i = 0; i < 4; ++i) {
      std::uint64_t wanted = range.least + random() % (range.most - range.least + 1);
      Solved one = solver.solve(double(wanted));
      EXPECT_EQ(countOf(one.scene, path), wanted) << "seed " << seed << " of " << path;
      EXPECT_EQ(one.reached, wanted) << "seed " << seed;
      solved += range.most > range.least;
    }
  }
  EXPECT_GT(solved, 400);
}

TEST(RenderedSolver, EveryNumberOfThoseThatHideAViewIsDrawnExactly) {
  scene::Scene scene = ballScene({.types = 3, .atoms = 8, .instances = 900});
  scene.cuts[0].shape = scene::CutShape::Everywhere;
  scene.cuts[0].model.spares = {{.type = "root"}};
  scene.cuts[0].model.focus.emplace().types = {{"root.a.type0"}};
  scene.camera.target = {0, 0, 0};
  RenderedSolver solver(scene, {7}, "type1", {}, render::kUsualAspect, DialField::ViewShare);
  CountRange range = solver.range();
  ASSERT_GT(range.most, range.least + 25);
  EXPECT_EQ(range.least, countOf(scene, "type1"));
  for (std::uint64_t wanted = range.least; wanted <= range.most; wanted += 1 + (range.most - range.least) / 40) {
    Solved solved = solver.solve(double(wanted));
    EXPECT_EQ(countOf(solved.scene, "type1"), wanted);
    EXPECT_EQ(solved.reached, wanted);
  }
}

TEST(RenderedSolver, LeavesOtherTypesAndAllElseOfTheRowInForce) {
  scene::Scene scene = ballScene();
  const Model& model = *scene.model.data;
  scene.cuts[0].model.spares.push_back(
      {.type = "root.a", .share = 0.3, .falloff = 60.0, .amount = 0.4, .exponent = 2.0});
  std::vector<std::uint64_t> before = countsOf(scene);
  std::string path = pathOf(model, model.types[0]);
  scene::Scene after = solveRendered(scene, {7}, path, double(before[0] + 10)).scene;
  std::vector<std::uint64_t> counts = countsOf(after);
  EXPECT_EQ(counts[0], before[0] + 10);
  counts[0] = before[0];
  EXPECT_EQ(counts, before);
  scene::TypeSpare row = *findTypeSpare(after.cuts[0], path), expected = scene.cuts[0].model.spares[0];
  expected.type = path, expected.share = row.share;
  EXPECT_EQ(row, expected);
  after.cuts[0].model.spares.pop_back();
  EXPECT_EQ(after, scene);
}

TEST(RenderedSolver, SharesOfSeveralCutsAreOne) {
  scene::Scene scene = ballScene();
  scene.cuts.push_back(scene.cuts[0]);
  scene.cuts[1].id = 8, scene.cuts[1].shape = scene::CutShape::Plane;
  RenderedSolver solver(scene, {7, 8}, "type1");
  scene::Scene after = solver.solve(double(solver.range().least + 17)).scene;
  EXPECT_EQ(findTypeSpare(after.cuts[0], solver.path())->share, findTypeSpare(after.cuts[1], solver.path())->share);
  EXPECT_EQ(countOf(after, "type1"), solver.range().least + 17);
}

TEST(RenderedSolver, ACompartmentGivesItsTypesWhatIsInProportion) {
  scene::Scene scene = ballScene();
  const Model& model = *scene.model.data;
  RenderedSolver solver(scene, {7}, "root");
  CountRange range = solver.range();
  std::uint64_t wanted = range.least + (range.most - range.least) / 3;
  Solved solved = solver.solve(double(wanted));
  EXPECT_EQ(countOf(solved.scene, "root"), wanted);
  std::vector<std::uint64_t> counts = countsOf(solved.scene);
  double part = double(wanted - range.least) / double(range.most - range.least);
  for (std::size_t t = 0; t < counts.size(); ++t) {
    CountRange own = RenderedSolver(scene, {7}, pathOf(model, model.types[t])).range();
    EXPECT_NEAR(double(counts[t]), double(own.least) + part * double(own.most - own.least), 1.0) << t;
  }
}

TEST(RenderedSolver, SaysInWordsWhatCannotBe) {
  scene::Scene scene = ballScene();
  scene::Cut plane;
  plane.id = 9;
  scene.cuts.push_back(plane);
  RenderedSolver solver(scene, {7}, "type0");
  CountRange range = solver.range();
  ASSERT_GT(range.least, 0u);
  ASSERT_LT(range.most, range.total);
  Solved few = solver.solve(0.0), many = solver.solve(1e9);
  EXPECT_EQ(few.reached, range.least);
  EXPECT_EQ(many.reached, range.most);
  EXPECT_NE(few.words.find("not fewer"), std::string::npos) << few.words;
  EXPECT_NE(many.words.find("not more"), std::string::npos) << many.words;
  EXPECT_EQ(countOf(many.scene, "type0"), range.most);
  Solved met = solver.solve(double(range.least + 1));
  EXPECT_EQ(met.words, std::to_string(range.least + 1) + " of 300 type0 drawn");
  scene.cuts.clear();
  EXPECT_NE(solveRendered(scene, {7}, "type0", 3.0).words.find("no cut is on"), std::string::npos);
}

TEST(RenderedSolver, DrawsNothingOfWhatIsNotShown) {
  scene::Scene scene = ballScene();
  setTypesVisible(scene, {2}, false);
  RenderedSolver solver(scene, {7}, "type2");
  EXPECT_EQ(solver.range(), (CountRange{0, 0, 300}));
  EXPECT_EQ(solver.solve(5.0).words, "type2 is not shown");
}

TEST(RenderedSolver, TypesThatACutLeavesOutByTheirNumberFollowNoShare) {
  scene::Scene scene = ballScene();
  scene.cuts[0].model.leastCopies = 1000.0;
  CountRange range = RenderedSolver(scene, {7}, "type2").range();
  EXPECT_EQ(range.least, range.most);
}

/// Dials with so many candidates each, which begin to stay at random numbers; some at the same.
std::vector<TypeDial> randomDials(Random& random) {
  std::vector<TypeDial> dials(1 + random() % 5);
  for (TypeDial& dial : dials) {
    std::size_t count = random() % 60;
    for (std::size_t i = 0; i < count; ++i) {
      bool isTwin = i > 0 && oneOf(random, 4);
      dial.candidates.push_back({isTwin ? dial.candidates.back().from : float(unit(random)), std::uint32_t(i)});
    }
  }
  return dials;
}

TEST(Dials, ShareANumberInProportionByLargestRemainders) {
  for (unsigned seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    std::vector<TypeDial> dials = randomDials(random);
    std::uint64_t all = 0;
    for (const Dial& dial : dials) all += dial.candidates.size();
    std::uint64_t count = random() % (all + 10), given = 0;
    std::vector<std::uint64_t> parts = splitAmong(dials, count);
    ASSERT_EQ(parts.size(), dials.size());
    double leastMore = 1.0, mostLess = 0.0;  // remainders of those that got one more, and of those that did not
    for (std::size_t i = 0; i < parts.size(); ++i) {
      given += parts[i];
      if (all == 0) continue;
      double wanted = double(std::min(count, all)) * double(dials[i].candidates.size()) / double(all);
      double rest = wanted - std::floor(wanted);
      ASSERT_LE(parts[i], dials[i].candidates.size());
      ASSERT_LT(std::abs(double(parts[i]) - wanted), 1.0) << "seed " << seed;
      if (double(parts[i]) > wanted) leastMore = std::min(leastMore, rest);
      if (double(parts[i]) < wanted) mostLess = std::max(mostLess, rest);
    }
    ASSERT_EQ(given, std::min(count, all)) << "seed " << seed;
    ASSERT_GE(leastMore, mostLess - 1e-9) << "seed " << seed;
  }
}

TEST(Dials, ANumberLeavesAsManyAsIsSaidAndNoneIsNearerToWhatIsWanted) {
  int exact = 0, others = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    for (const Dial& dial : randomDials(random)) {
      auto stayingAt = [&](double number) {
        return std::uint64_t(std::count_if(dial.candidates.begin(), dial.candidates.end(),
                                           [&](const Candidate& one) { return one.from < float(number); }));
      };
      for (std::uint64_t wanted = 0; wanted <= dial.candidates.size() + 1; ++wanted) {
        DialSetting setting = settingFor(dial, wanted);
        ASSERT_EQ(stayingAt(setting.number), setting.staying) << "seed " << seed;
        auto off = [&](std::uint64_t staying) { return std::abs(double(staying) - double(wanted)); };
        ASSERT_LE(off(setting.staying), off(stayingAt(1.0)));
        for (const Candidate& one : dial.candidates) ASSERT_LE(off(setting.staying), off(stayingAt(double(one.from))));
        ++(setting.staying == wanted ? exact : others);
      }
    }
  }
  EXPECT_GT(exact, 1000);
  EXPECT_GT(others, 200) << "several that begin to stay at once";
}

TEST(TypesAt, FindsPathsAndEndsAndNamesTheNearest) {
  Model model = ModelMaker{.types = 5}.make();
  EXPECT_EQ(typesAt(model, "root.a.type2").types, (TypeNumbers{2}));
  EXPECT_EQ(typesAt(model, "type3").path, "root.b.type3");
  EXPECT_EQ(typesAt(model, "a").types, (TypeNumbers{0, 2, 4}));
  EXPECT_TRUE(typesAt(model, "root").isCompartment);
  for (const auto& [name, nearest] : {std::pair("typ3", "root.b.type3"), std::pair("root.b.tipe1", "root.b.type1"),
                                      std::pair("TYPE4", "root.a.type4"), std::pair("YPE2", "root.a.type2")}) {
    try {
      typesAt(model, name);
      FAIL() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(nearest), std::string::npos) << error.what();
    }
  }
  try {
    typesAt(model, "haemoglobin");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("root."), std::string::npos) << "nothing is near: " << error.what();
  }
}

}  // namespace velum::session
