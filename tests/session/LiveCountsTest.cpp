#include "session/model/LiveCounts.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "makeModel.h"
#include "render/kept/KeptInstances.h"
#include "scene/Scene.h"
#include "session/cut/CutEdit.h"
#include "session/model/ClipState.h"

namespace velum::session {

namespace {

/// Bits of which the first so many instances are shown, and the last so many removed.
render::InstanceBits bitsOf(const Model& model, std::size_t shown, std::size_t removed) {
  std::size_t count = model.instances.size(), words = (count + 31) / 32;
  render::InstanceBits bits{count, std::vector<std::uint32_t>(words), std::vector<std::uint32_t>(words), {}};
  for (std::size_t i = 0; i < shown; ++i) bits.shown[i / 32] |= 1u << (i % 32);
  for (std::size_t i = count - removed; i < count; ++i) bits.removed[i / 32] |= 1u << (i % 32);
  return bits;
}

scene::Scene countedScene() {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{}.make());
  return scene;
}

}  // namespace

TEST(LiveCounts, AreThoseOfACompletePicture) {
  Shared<Model> model(ModelMaker{.types = 1, .instances = 100}.make());
  LiveCounts counts;
  counts.take(model, bitsOf(*model, 30, 20), true);
  EXPECT_TRUE(counts.isExact());
  EXPECT_EQ(counts.types()[0], (Counts{30, 50, 20}));
  EXPECT_EQ(counts.compartments()[0], (Counts{30, 50, 20}));
}

TEST(LiveCounts, OfCoarsePicturesAreAsManyMoreAsTheCompleteOneHad) {
  Shared<Model> model(ModelMaker{.types = 1, .instances = 100}.make());
  LiveCounts counts;
  counts.take(model, bitsOf(*model, 15, 20), false);
  EXPECT_EQ(counts.types()[0].visible(), 15u) << "nothing better is known";
  counts.take(model, bitsOf(*model, 30, 20), true);
  counts.take(model, bitsOf(*model, 10, 40), false);
  EXPECT_FALSE(counts.isExact());
  EXPECT_EQ(counts.types()[0], (Counts{20, 40, 40})) << "what is removed is exact at any size";
  counts.take(model, bitsOf(*model, 40, 50), false);
  EXPECT_EQ(counts.types()[0], (Counts{50, 0, 50})) << "not more than are drawn";
}

TEST(LiveCounts, ForgetAnotherModel) {
  Shared<Model> model(ModelMaker{.types = 1, .instances = 100}.make()), other(ModelMaker{.instances = 90}.make());
  LiveCounts counts;
  counts.take(model, bitsOf(*model, 10, 0), false);
  counts.take(model, bitsOf(*model, 100, 0), true);
  counts.take(other, bitsOf(*other, 30, 0), false);
  EXPECT_EQ(counts.model(), other);
  EXPECT_EQ(counts.compartments()[0].visible(), 30u);
}

TEST(ClipState, IsWholeWhereNothingIsTakenAway) {
  scene::Scene scene = countedScene();
  EXPECT_EQ(clipState(scene), ClipState::Whole);
  scene::addCut(scene, makeCut(scene, scene::CutShape::Everywhere));
  EXPECT_EQ(clipState(scene), ClipState::Whole) << "it spares all until shares say so";
  scene::addCut(scene, makeCut(scene, scene::CutShape::Sphere));
  EXPECT_EQ(clipState(scene), ClipState::Cut);
  setTypeShare(scene.cuts[1], "root", 1.0);
  EXPECT_EQ(clipState(scene), ClipState::Whole);
}

TEST(ClipState, IsThinnedWhereLotsDecide) {
  scene::Scene scene = countedScene();
  scene::addCut(scene, makeCut(scene, scene::CutShape::Sphere));
  setTypeShare(scene.cuts[0], "root.a", 1.0);
  EXPECT_EQ(clipState(scene), ClipState::Cut) << "all of a type";
  setTypeShare(scene.cuts[0], "root.a", 0.4);
  EXPECT_EQ(clipState(scene), ClipState::Thinned);
  setTypeShare(scene.cuts[0], "root.a", 0.0);
  scene.cuts[0].model.spares[0].falloff = 30.0;
  EXPECT_EQ(clipState(scene), ClipState::Thinned);
  scene.cuts[0].enabled = false;
  EXPECT_EQ(clipState(scene), ClipState::Whole);
}

TEST(ClipState, IsWholeExactlyWhereNothingIsRemovedWhateverARowOrACutSays) {
  scene::Scene whole = countedScene();
  scene::Cut ball = makeCut(whole, scene::CutShape::Sphere);
  ball.size = glm::dvec3(300.0);
  ball.model.spares = {{.type = "root"}};
  scene::addCut(whole, ball);
  struct Change {
    const char* what;
    bool removes;
    void (*to)(scene::Cut& cut, scene::TypeSpare& row);
  };
  const Change changes[] = {
      {"nothing", false, [](auto&, auto&) {}},
      {"share", true, [](auto&, auto& row) { row.share = 0.0; }},
      {"distance", true, [](auto&, auto& row) { row.distance = 20.0; }},
      {"share and falloff outside", true, [](auto&, auto& row) { row.share = 0.0, row.falloff = -60.0; }},
      {"falloff outside alone", false, [](auto&, auto& row) { row.falloff = -60.0; }},
      {"falloff inside alone", false, [](auto&, auto& row) { row.falloff = 60.0; }},
      {"least mass", true, [](auto& cut, auto&) { cut.model.leastMass = 1e12; }},
      {"most mass", true, [](auto& cut, auto&) { cut.model.mostMass = 1.0; }},
      {"least copies", true, [](auto& cut, auto&) { cut.model.leastCopies = 1e6; }},
      {"most copies", true, [](auto& cut, auto&) { cut.model.mostCopies = 3.0; }},
      {"a row for some alone", true, [](auto&, auto& row) { row.type = "root.a"; }},
  };
  for (const Change& change : changes) {
    scene::Scene scene = whole;
    change.to(scene.cuts[0], scene.cuts[0].model.spares[0]);
    std::vector<std::uint8_t> kept = render::keptInstances(scene);
    EXPECT_EQ(std::count(kept.begin(), kept.end(), 0) > 0, change.removes) << change.what;
    EXPECT_EQ(clipState(scene) != ClipState::Whole, change.removes) << change.what;
  }
}

TEST(ClipState, GoesToTheCutAndToTheWhole) {
  scene::Scene scene = countedScene();
  scene::addCut(scene, makeCut(scene, scene::CutShape::Sphere));
  scene::addCut(scene, makeCut(scene, scene::CutShape::Everywhere));
  for (scene::Cut& cut : scene.cuts) setTypeShare(cut, "root.a.type0", 0.4);
  ASSERT_EQ(clipState(scene), ClipState::Thinned);
  showCut(scene);
  EXPECT_EQ(clipState(scene), ClipState::Cut);
  EXPECT_EQ(scene.cuts[0].model.spares.back().share, 0.0);
  EXPECT_EQ(findTypeSpare(scene.cuts[1], "root.a.type0")->share, 1.0);
  showWhole(scene);
  EXPECT_EQ(clipState(scene), ClipState::Whole);
  showCut(scene);
  EXPECT_EQ(clipState(scene), ClipState::Cut) << "cuts are on again where all were off";
}

}  // namespace velum::session
