// Which compartments a first picture hides, and how that is said.
#include "session/model/HiddenInside.h"

#include <gtest/gtest.h>

#include "core/ModelBuilder.h"
#include "scene/Scene.h"

namespace velum::session {

namespace {

/// A membrane with a capsid in it, and a genome in the capsid; plasma around. Compartments 0 to 4: the root, plasma,
/// membrane, capsid, genome.
scene::Scene virionScene() {
  ModelBuilder builder("virion");
  for (const auto& path : std::vector<std::vector<std::string>>{
           {"plasma"}, {"membrane"}, {"membrane", "capsid"}, {"membrane", "capsid", "genome"}}) {
    MoleculeType type;
    type.name = "protein";
    type.compartment = builder.compartment(path);
    std::uint32_t molecule = builder.addMolecule(builder.addType(type), {}, {{glm::vec4(0, 0, 0, 10)}});
    builder.addInstance(molecule, glm::vec3(0.0f), glm::quat(1, 0, 0, 0));
  }
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(builder.build());
  return scene;
}

/// Counts of an instance kind: seen, hidden, removed.
std::vector<Counts> countsOf(std::uint64_t capsidSeen, std::uint64_t genomeSeen) {
  return {{500, 1500, 0},
          {200, 300, 0},
          {300, 1200, 0},
          {capsidSeen, 600 - capsidSeen, 0},
          {genomeSeen, 200 - genomeSeen, 0}};
}

}  // namespace

TEST(HiddenInside, IsTheOutermostOfWhatNothingIsSeenOf) {
  scene::Scene scene = virionScene();
  EXPECT_EQ(hiddenInside(scene, countsOf(0, 0)), std::vector<std::uint32_t>{3});
  EXPECT_EQ(hiddenInside(scene, countsOf(5, 0)), std::vector<std::uint32_t>{3})
      << "five of six hundred are through gaps";
  EXPECT_EQ(hiddenInside(scene, countsOf(60, 0)), std::vector<std::uint32_t>{4});
  EXPECT_TRUE(hiddenInside(scene, countsOf(60, 20)).empty());
  EXPECT_EQ(hiddenWords(scene, {3}), "Next to nothing is seen of capsid: what is around it hides it.");
  EXPECT_EQ(hiddenWords(scene, {3, 4}),
            "Next to nothing is seen of capsid and genome: what is around them hides them.");
  EXPECT_EQ(hiddenWords(scene, {}), "");
}

TEST(HiddenInside, IsNothingWhereSomethingIsCutOrTheModelIsNotInSight) {
  scene::Scene scene = virionScene();
  auto outOfSight = countsOf(0, 0);
  outOfSight[0] = {0, 2000, 0};
  EXPECT_TRUE(hiddenInside(scene, outOfSight).empty());
  scene.cuts.emplace_back();
  EXPECT_TRUE(hiddenInside(scene, countsOf(0, 0)).empty());
  scene.cuts[0].enabled = false;
  EXPECT_FALSE(hiddenInside(scene, countsOf(0, 0)).empty());
  scene.model = {};
  EXPECT_TRUE(hiddenInside(scene, {}).empty());
}

}  // namespace velum::session
