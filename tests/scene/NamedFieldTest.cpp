#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/Paths.h"

namespace velum::scene {
namespace {

Scene organs() {
  Scene scene;
  scene.labels.structures = {{2, "aorta"}, {5, "V. cava [inf]"}, {12, "7"},  {40, ""},
                             {41, "rib"},  {42, "rib"},          {43, "Rib"}};
  for (int i = 0; i < 2; ++i) addCut(scene, {});
  scene.cuts[1].name = "Plane 2";
  return scene;
}

std::string messageOf(const char* path) {
  Scene scene = organs();
  try {
    setField(scene, path, "false");
  } catch (const ArgumentError& error) {
    EXPECT_TRUE(scene == organs());
    return error.what();
  }
  return {};
}

void expectMentions(const std::string& message, std::initializer_list<const char*> words) {
  for (const char* word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in: " << message;
}

TEST(NamedField, AStructureIsReachedByNameOrId) {
  Scene scene = organs();
  setField(scene, "labels.structures[aorta].visible", "false");
  setField(scene, "labels.structures[V. cava [inf]].opacity", "0.5");
  setField(scene, "labels.structures[40].color", "1,0,0");
  setField(scene, "labels.structures[AORTA].opacity", "0.25");
  setField(scene, "cuts[Plane 2].enabled", "false");
  EXPECT_FALSE(scene.labels.structures[0].visible);
  EXPECT_EQ(scene.labels.structures[0].opacity, 0.25);
  EXPECT_EQ(scene.labels.structures[1].opacity, 0.5);
  EXPECT_EQ(scene.labels.structures[3].color, glm::vec3(1, 0, 0));
  EXPECT_TRUE(scene.cuts[0].enabled);
  EXPECT_FALSE(scene.cuts[1].enabled);
  setField(scene, "cuts[Plane 2].spares.+", "5");
  EXPECT_EQ(scene.cuts[1].spares, std::vector<Spare>{{5}});
  setField(scene, "labels.structures[2]", R"({"name": "Aorta"})");
  EXPECT_EQ(scene.labels.structures[0].name, "Aorta");
}

/// Types of a model are no structures, whatever their paths.
TEST(NamedField, WhatACutLeavesOfAModelIsSaidByPaths) {
  Scene scene;
  addCut(scene, {});
  setField(scene, "cuts.0.model.spares", "root.blood");
  ASSERT_EQ(scene.cuts[0].model.spares.size(), 1u);
  EXPECT_EQ(scene.cuts[0].model.spares[0].type, "root.blood");
}

TEST(NamedField, WhatACutSparesIsSaidByNameOrId) {
  Scene scene = organs();
  setField(scene, "cuts.0.spares", "aorta, V. cava [inf]");
  EXPECT_EQ(scene.cuts[0].spares, (std::vector<Spare>{{2}, {5}}));
  setField(scene, "cuts.0.spares.+", "AORTA");
  EXPECT_EQ(scene.cuts[0].spares.back(), Spare{2});
  setField(scene, "cuts[Plane 2].spares", "41,aorta");
  EXPECT_EQ(scene.cuts[1].spares, (std::vector<Spare>{{41}, {2}}));
  setField(scene, "cuts.0.spares.0.structure", "V. cava [inf]");
  EXPECT_EQ(scene.cuts[0].spares[0].structure, 5);
  for (auto [value, word] :
       {std::pair("liver", "aorta (2)"), {"aorta,rib", "2 items"}, {"aorta,", "labels.structures"}}) {
    try {
      setField(scene, "cuts.0.spares", value);
      ADD_FAILURE() << value;
    } catch (const ArgumentError& error) {
      expectMentions(error.what(), {word});
    }
  }
}

TEST(NamedField, ANameThatIsANumberGoesBeforeTheId) {
  Scene scene = organs();
  scene.labels.structures[4].id = 7;
  setField(scene, "labels.structures[7].opacity", "0.5");
  EXPECT_EQ(scene.labels.structures[2].opacity, 0.5);
  EXPECT_EQ(scene.labels.structures[4].opacity, 1.0);
}

TEST(NamedField, TheExactCaseGoesBeforeAnother) {
  Scene scene = organs();
  setField(scene, "labels.structures[Rib].opacity", "0.5");
  EXPECT_EQ(scene.labels.structures[6].opacity, 0.5);
}

TEST(NamedField, AnUnknownOrSharedNameIsRefusedWithWhatThereIs) {
  expectMentions(messageOf("labels.structures[liver].visible"), {"labels.structures", "liver", "aorta (2)"});
  expectMentions(messageOf("labels.structures[rib].visible"), {"rib", "2 items", "41", "42"});
  expectMentions(messageOf("labels.structures[99].visible"), {"99"});
  expectMentions(messageOf("labels.structures[].visible"), {"labels.structures"});
  expectMentions(messageOf("cuts[0].enabled"), {"cuts", "Plane 2"});
  expectMentions(messageOf("cuts.0.spares[3]"), {"cuts.0.spares"});
}

TEST(NamedField, ABracketThatDoesNotCloseIsRefused) {
  for (const char* path :
       {"labels.structures[aorta", "labels.structures[aorta]x", "labels.structures[aorta].", "labels.structures["})
    expectMentions(messageOf(path), {"labels.structures", "[NAME]"});
  expectMentions(messageOf("camera[eye]"), {"camera", "eye"});
}

}  // namespace
}  // namespace velum::scene
