// What a legend names.
#include "session/lettering/Legend.h"

#include <gtest/gtest.h>

#include "core/Error.h"
#include "lettered.h"
#include "session/command/LetteringCommands.h"
#include "session/model/LegendLacks.h"

namespace velum::session {

TEST(Legend, ALegendNamesWhatIsSeenMostOrWhatIsListedInItsOrder) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"type4", "type3", "type2", "type1", "type0"}));
  EXPECT_EQ(namesOf(scene, {{1, 2000, 0, 0, 0}, 1000000}), std::vector<std::string>{"type1"}) << "not a mere dot";
  scene = after(scene, ListInLegend{{"root.a.type2"}, true});
  scene = after(scene, ListInLegend{{"root.b"}, true});
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"type2", "b"}));
  auto entries = legendEntries(scene, kPixels);
  std::vector<glm::vec3> colors = scene::typeColors(scene.model);
  EXPECT_EQ(entries[0].colors, std::vector<glm::vec3>{colors[2]});
  EXPECT_EQ(entries[1].colors, (std::vector<glm::vec3>{colors[3], colors[1]})) << "that of which more is seen first";
  scene = after(scene, ListInLegend{{"root.b", "root.a.type2"}, false});
  EXPECT_EQ(namesOf(scene).size(), 5u);
  scene.model.visible = false;
  EXPECT_TRUE(namesOf(scene).empty());
}

TEST(Legend, StructuresAreListedByTheirNamesAndStayListedWhenTheyAreRenamed) {
  scene::Scene scene;
  scene.labels.data = Shared<LabelVolume>(LabelVolume());
  for (int id : {1, 2, 3}) scene.labels.structures.push_back({.id = id, .name = "s" + std::to_string(id)});
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"s1", "s2", "s3"}));
  EXPECT_FALSE(scene.lettering.legend);
  scene = after(scene, ListStructuresInLegend{{"s3", "1"}, true});
  EXPECT_TRUE(scene.lettering.legend) << "who lists something wants to see it";
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"s3", "s1"})) << "in the order of listing";
  scene = after(scene, RenameStructure{"s3", " Aorta "});
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"Aorta", "s1"}));
  scene = after(scene, ListStructuresInLegend{{"Aorta", "s1"}, false});
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"s1", "s2", "Aorta"}));
  EXPECT_THROW(after(scene, ListStructuresInLegend{{"s9"}, true}), ArgumentError);
}

TEST(Legend, TypesThatAreCalledAlikeShareAnEntry) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene = after(scene, RenameType{"root.a.type0", "Spike"});
  scene = after(scene, RenameType{"root.b.type3", "Spike"});
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"type4", "Spike", "type2", "type1"}));
}

TEST(Legend, StructuresStandInTheLegendThatAreShownOrListed) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene.labels.data = Shared<LabelVolume>(LabelVolume{});
  scene.labels.structures = {{1, "liver", {0.6f, 0.2f, 0.1f}}, {2, "spleen", {0.4f, 0.1f, 0.3f}}, {3, "", {1, 1, 1}}};
  EXPECT_EQ(namesOf(scene, {{1, 2000, 0, 0, 0}, 1000000}), (std::vector<std::string>{"type1", "liver", "spleen"}));
  scene.model.visible = false;
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"liver", "spleen"}));
  EXPECT_EQ(legendEntries(scene, {})[1].colors, std::vector<glm::vec3>{scene.labels.structures[1].color});
  scene.labels.structures[0].visible = false;
  EXPECT_EQ(namesOf(scene), std::vector<std::string>{"spleen"});
  scene.model.visible = true;
  scene.lettering.entries = {"liver", "root.a.type2"};
  EXPECT_EQ(namesOf(scene), (std::vector<std::string>{"liver", "type2"})) << "whoever lists it wants it";
  scene.labels.visible = false;
  EXPECT_EQ(namesOf(scene), std::vector<std::string>{"type2"});
}

TEST(Legend, WhatALegendListsInVainIsSaidInOneLine) {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene.lettering.entries = {"root.a.type2", "root.b"};
  EXPECT_EQ(whatLegendLacks(scene), "");
  scene.lettering.entries = {"root.x", "root.b", "liver"};
  EXPECT_EQ(whatLegendLacks(scene), "the legend leaves out what the data do not have: root.x, liver");
  EXPECT_EQ(namesOf(scene), std::vector<std::string>{"b"});
  scene.lettering.entries.clear();
  Progress progress;
  EXPECT_EQ(editOf(scene, SetField{"lettering.entries", R"(["root.y"])"}, progress).told,
            std::vector<std::string>{"the legend leaves out what the data do not have: root.y"});
}

}  // namespace velum::session
