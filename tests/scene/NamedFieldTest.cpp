#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/FieldFacts.h"
#include "scene/json/Paths.h"
#include "scene/timeline/Tracks.h"

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

TEST(NamedField, ABareNumberIsAPlaceWhereNothingIsCalledSo) {
  Scene scene = organs();
  setField(scene, "cuts[0].face", "section");
  setField(scene, "cuts[1].faceOpacity", "0.5");
  EXPECT_EQ(scene.cuts[0].face, CutFace::Section);
  EXPECT_EQ(scene.cuts[1].faceOpacity, 0.5) << "whose id is 2";
  EXPECT_EQ(getField(scene, "cuts[0].face"), "section");
  EXPECT_EQ(stablePath(scene, "cuts[0].centre"), fmt::format("cuts[#{}].centre", scene.cuts[0].id));
  scene.cuts[1].name = "0";
  setField(scene, "cuts[0].faceOpacity", "0.25");
  EXPECT_EQ(scene.cuts[1].faceOpacity, 0.25) << "names go before places";
  // What is known by a number is called by it.
  setField(scene, "labels.structures[2].opacity", "0.75");
  EXPECT_EQ(getField(scene, "labels.structures[aorta].opacity"), "0.75");
  setField(scene, "lettering.captions.+.text", "a");
  EXPECT_EQ(getField(scene, "lettering.captions[0].text"), "a");
}

TEST(NamedField, AStrengthIsKnownByTheNumberOfItsLabel) {
  Scene scene;
  scene.cuts.emplace_back().membrane.emplace().field.byLabel = {LabelStrength{7, 1.0}, LabelStrength{1, 2.0}};
  EXPECT_EQ(getField(scene, "cuts[0].membrane.field.byLabel[7].strength"), "1");
  EXPECT_EQ(getField(scene, "cuts[0].membrane.field.byLabel[1].strength"), "2");
  EXPECT_EQ(getField(scene, "cuts[0].membrane.field.byLabel.0.strength"), "1");
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
  expectMentions(messageOf("cuts[Plane 7].enabled"), {"cuts", "Plane 2"});
  expectMentions(messageOf("cuts[2].enabled"), {"cuts", "2 items", "[#2]"});
  expectMentions(messageOf("cuts.0.spares[3]"), {"cuts.0.spares"});
}

TEST(NamedField, ABracketThatDoesNotCloseIsRefused) {
  for (const char* path :
       {"labels.structures[aorta", "labels.structures[aorta]x", "labels.structures[aorta].", "labels.structures["})
    expectMentions(messageOf(path), {"labels.structures", "[NAME]"});
  expectMentions(messageOf("camera[eye]"), {"camera", "eye"});
}

TEST(NamedField, ANumberSignNamesAnIdWhateverOthersAreCalled) {
  Scene scene = organs();
  scene.labels.structures.push_back({50, "#40"});
  scene.labels.structures.push_back({51, "#x"});
  scene.labels.structures[4].id = 7;
  setField(scene, "labels.structures[#7].opacity", "0.5");
  EXPECT_EQ(scene.labels.structures[4].opacity, 0.5);
  EXPECT_EQ(scene.labels.structures[2].opacity, 1.0) << "which is called 7";
  setField(scene, "labels.structures[#40].opacity", "0.25");
  EXPECT_EQ(scene.labels.structures[3].opacity, 0.25);
  EXPECT_EQ(getField(scene, "labels.structures[#51].name"), "#x");
  EXPECT_EQ(getField(scene, "labels.structures[#x].id"), "51");
  scene.labels.structures.erase(scene.labels.structures.begin() + 3);
  EXPECT_THROW(setField(scene, "labels.structures[#40].opacity", "0.25"), ArgumentError) << "none has the id";
  setField(scene, "cuts[#2].enabled", "false");
  EXPECT_FALSE(scene.cuts[1].enabled);
}

TEST(NamedField, AnItemThatIsKnownByAFieldIsReachedByItOrAddedWithIt) {
  Scene scene = organs();
  setField(scene, "model.types[root.a.CA].visible", "false");
  setField(scene, "model.types[root.a.b[2]].visible", "false");
  setField(scene, "model.types[root.a.CA].color", "1,0,0");
  ASSERT_EQ(scene.model.types.size(), 2u);
  EXPECT_EQ(scene.model.types[0], (TypeLook{.type = "root.a.CA", .visible = false, .color = glm::vec3(1, 0, 0)}));
  EXPECT_EQ(scene.model.types[1], (TypeLook{.type = "root.a.b[2]", .visible = false}));
  EXPECT_EQ(getField(scene, "model.types[root.a.b[2]].visible"), "false");
  setField(scene, "model.types[root.a.ca].visible", "false");
  EXPECT_EQ(scene.model.types.size(), 3u) << "paths are told apart by case";
  setField(scene, "model.types[12]", R"({"name": "twelve"})");
  EXPECT_EQ(scene.model.types[3], (TypeLook{.type = "12", .name = "twelve"}));

  setField(scene, "model.targets[root.a].rendered", "7");
  EXPECT_EQ(scene.model.targets, (std::vector<TypeTarget>{{"root.a", 7.0, {}}}));
  setField(scene, "cuts[#1].model.spares[root.a].share", "0.5");
  EXPECT_EQ(scene.cuts[0].model.spares, (std::vector<TypeSpare>{{.type = "root.a", .share = 0.5}}));
  setField(scene, "cuts[#1].model.focus.types[root.b]", "root.c");
  EXPECT_EQ(scene.cuts[0].model.focus->types, (std::vector<FocusType>{{"root.c"}}));
  for (const char* distance : {"2.5", "3"}) setField(scene, "cuts[#1].spares[12].distance", distance);
  EXPECT_EQ(scene.cuts[0].spares, (std::vector<Spare>{{12, 3.0}}));
}

TEST(NamedField, WhatIsNotThereIsSaidAndNoKeyIsRefused) {
  Scene scene = organs();
  setField(scene, "model.types[root.a].visible", "false");
  for (const char* path : {"model.types[root.b].visible", "model.types[ROOT.a].visible", "model.types[].visible"}) {
    try {
      getField(scene, path);
      ADD_FAILURE() << path;
    } catch (const ArgumentError& error) {
      expectMentions(error.what(), {"model.types has nothing", "root.a"});
    }
  }
  Scene before = scene;
  EXPECT_THROW(setField(scene, "model.types[].visible", "false"), ArgumentError);
  EXPECT_THROW(setField(scene, "model.types[root.b].nothing", "false"), ArgumentError);
  EXPECT_THROW(setField(scene, "cuts[#1].spares[aorta].distance", "1"), ArgumentError);
  EXPECT_THROW(setField(scene, "cuts[#1].spares[70000].distance", "1"), ArgumentError);
  EXPECT_TRUE(scene == before);
}

TEST(NamedField, FactsOfFieldsAreFoundWhateverNamesThePathHolds) {
  for (const char* name : {"N", "12", "[#12]", "[aorta]", "[V. cava [inf]]", "[a.b.c]"}) {
    std::string dot = name[0] == '[' ? "" : ".";
    FieldFacts facts = fieldFacts("labels.structures" + dot + name + ".opacity");
    EXPECT_EQ(facts.kind, FieldKind::Number) << name;
    EXPECT_EQ(facts.range.max, 1.0) << name;
    EXPECT_EQ(fieldFacts("model.types" + dot + name + ".visible").kind, FieldKind::Truth) << name;
    EXPECT_EQ(fieldFacts("model.types" + dot + name).kind, FieldKind::Other) << name;
  }
  for (const char* path : {"labels.structures[aorta", "labels.structures[aorta]x", "labels.structures[a.b].none"})
    EXPECT_THROW(fieldFacts(path), ArgumentError) << path;
}

}  // namespace
}  // namespace velum::scene
