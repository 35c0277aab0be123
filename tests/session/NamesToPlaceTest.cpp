// Which things of a picture are named.
#include "session/lettering/NamesToPlace.h"

#include <gtest/gtest.h>

#include "core/Error.h"
#include "lettered.h"
#include "render/Renderer.h"
#include "session/command/LetteringCommands.h"
#include "session/lettering/SeenNames.h"
#include "session/model/ModelEdit.h"

namespace velum::session {

namespace {

constexpr glm::ivec2 kSeenSize(100, 60);

/// Bands of a map from the top: a key and how many rows it has.
std::vector<std::int32_t> bands(const std::vector<std::pair<int, int>>& rows, int rest) {
  std::vector<std::int32_t> keys;
  for (auto [key, count] : rows) keys.insert(keys.end(), std::size_t(count * kSeenSize.x), key);
  keys.resize(std::size_t(kSeenSize.x * kSeenSize.y), rest);
  return keys;
}

std::vector<std::string> seenWords(const std::vector<SeenName>& names) {
  std::vector<std::string> out;
  for (const SeenName& name : names) out.push_back(name.name);
  return out;
}

using NamedWords = std::vector<std::string>;

/// Three structures, the model of lettered(), and both at once.
scene::Scene namedInScene() {
  scene::Scene scene = lettered(glm::vec3(1.0f));
  scene.labels.data = Shared<LabelVolume>(LabelVolume{});
  for (auto [id, name] : {std::pair(7, "liver"), std::pair(8, "spleen"), std::pair(9, "")})
    scene.labels.structures.push_back({.id = id, .name = name});
  return scene;
}

}  // namespace

TEST(NamesToPlace, StructuresAndTypesThatAreSeenMostComeFirst) {
  scene::Scene scene = namedInScene();
  auto types = bands({{3, 10}, {1, 4}, {2, 20}}, -1), structures = bands({{9, 2}, {0, 34}, {8, 6}, {7, 15}}, 0);
  auto names = namesToPlace(scene, {kSeenSize, structures, types, 2});
  EXPECT_EQ(seenWords(names), (NamedWords{"type2", "liver", "type3", "spleen", "type1"})) << "nothing without a name";
  EXPECT_EQ(names[0].pixels, 20u * 100 * 4);
  EXPECT_NEAR(names[0].anchor.y, 2 * 24, 4);
  EXPECT_NEAR(names[0].anchor.x, 100, 4);
  scene.lettering.mostNames = 2;
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, structures, types, 2})), (NamedWords{"type2", "liver"}));
  scene.labels.visible = false;
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, structures, types, 2})), (NamedWords{"type2", "type3"}));
}

TEST(NamesToPlace, AnAnchorLiesOnWhatItNames) {
  scene::Scene scene = namedInScene();
  auto types = bands({{3, 10}, {1, 4}, {2, 20}, {4, 1}}, -1), structures = bands({{0, 40}, {7, 15}}, 0);
  auto names = namesToPlace(scene, {kSeenSize, structures, types, 1});
  ASSERT_EQ(names.size(), 5u);
  for (const SeenName& name : names) {
    std::size_t at = std::size_t(name.anchor.y) * 100 + std::size_t(name.anchor.x);
    EXPECT_EQ(name.name, types[at] >= 0 ? "type" + std::to_string(types[at]) : "liver");
  }
}

TEST(NamesToPlace, ThoseThatAreListedAreNamedEvenWhereLittleIsSeenOfThem) {
  scene::Scene scene = namedInScene();
  auto types = bands({{3, 10}, {1, 4}, {2, 20}}, -1), structures = bands({{0, 59}}, 7);
  scene.lettering.named = {"root.a.type2", "liver", "spleen"};
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, structures, types, 1})), (NamedWords{"type2", "liver"}))
      << "not what is hidden";
}

TEST(NamesToPlace, ACompartmentHasOneNameForAllInItButWhatIsListedItself) {
  scene::Scene scene = namedInScene();
  auto types = bands({{3, 10}, {1, 15}, {2, 20}}, -1);
  scene.lettering.named = {"root.b"};
  auto names = namesToPlace(scene, {kSeenSize, {}, types, 1});
  EXPECT_EQ(seenWords(names), NamedWords{"b"});
  EXPECT_EQ(names[0].pixels, 2500u) << "of types 1 and 3, which lie in it";
  EXPECT_NEAR(names[0].anchor.y, 12.5, 3) << "in the middle of both together";
  scene.lettering.named = {"root.b", "root.b.type1"};
  names = namesToPlace(scene, {kSeenSize, {}, types, 1});
  ASSERT_EQ(seenWords(names), (NamedWords{"b", "type1"}));
  EXPECT_LT(names[0].anchor.y, 10);
  EXPECT_GT(names[1].anchor.y, 10);
}

TEST(NamesToPlace, WhatIsCalledAlikeHasOneName) {
  scene::Scene scene = namedInScene();
  scene = after(scene, RenameType{"root.a.type0", "Spike"});
  scene = after(scene, RenameType{"root.b.type3", "Spike"});
  auto types = bands({{3, 10}, {0, 15}, {2, 20}}, -1);
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, {}, types, 1})), (NamedWords{"Spike", "type2"}));
}

TEST(NamesToPlace, ANameGivesWayOnlyToAClearlyLargerOneAndKeepsItsKeyAndItsAnchor) {
  scene::Scene scene = namedInScene();
  scene.lettering.mostNames = 1;
  auto first = bands({{3, 10}, {2, 9}}, -1), closer = bands({{3, 10}, {2, 12}}, -1),
       larger = bands({{3, 10}, {2, 14}}, -1);
  auto names = namesToPlace(scene, {kSeenSize, {}, first, 1});
  EXPECT_EQ(seenWords(names), NamedWords{"type3"});
  names[0].anchor.x = 20.5;
  auto next = namesToPlace(scene, {kSeenSize, {}, closer, 1}, names);
  EXPECT_EQ(seenWords(next), NamedWords{"type3"});
  EXPECT_EQ(next[0].key, names[0].key);
  EXPECT_EQ(next[0].anchor, names[0].anchor);
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, {}, closer, 1})), NamedWords{"type2"});
  EXPECT_EQ(seenWords(namesToPlace(scene, {kSeenSize, {}, larger, 1}, names)), NamedWords{"type2"});
}

TEST(NamesToPlace, NothingIsNamedOfAnEmptyPictureAndAMapOfAnotherSizeIsRefused) {
  scene::Scene scene = namedInScene();
  EXPECT_TRUE(namesToPlace(scene, {{0, 0}, {}, {}, 1}).empty());
  EXPECT_TRUE(namesToPlace(scene, {kSeenSize, {}, {}, 1}).empty());
  EXPECT_TRUE(namesToPlace({}, {kSeenSize, bands({}, 0), bands({}, -1), 1}).empty());
  std::vector<std::int32_t> few(10);
  EXPECT_THROW(namesToPlace(scene, {kSeenSize, few, {}, 1}), ArgumentError);
}

TEST(NamesToPlace, InstancesBeyondExactFloatsAreFoundByNumberAndType) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data = Shared<Model>(ModelMaker{.atoms = 4, .instances = 60000}.make());
  scene.model.copies = 400;
  std::uint32_t first = render::firstModelInstance(scene);
  for (int wanted : {5, 16777219, 20000001, 23999999}) {
    auto place = instancePlace(scene, std::uint32_t(wanted));
    ASSERT_TRUE(place && !place->isWhole) << wanted;
    scene.lettering.marks.clear();
    scene::addMark(scene.lettering.marks,
                   {.kind = scene::MarkKind::Label, .points = {{0, 0, 0}}, .pointInstances = {wanted}});
    float value = float(std::uint32_t(wanted) + first), type = float(place->type);
    Image image{4,
                1,
                {"id", "instance", "type"},
                {0, value, type,                                              //
                 0, value, wanted > 5 ? float((place->type + 1) % 3) : type,  //
                 0, float(7u + first), 0,                                     //
                 0, -1, -1}};
    ImageMap map(scene, image, 1);
    EXPECT_EQ(map.map().instances[0], wanted);
    EXPECT_EQ(map.map().instances[1] == wanted, wanted == 5) << "another type is another instance";
    EXPECT_EQ(map.map().instances[2], 7);
    EXPECT_EQ(map.map().instances[3], -1);
    EXPECT_EQ(map.mapOfLarger(4).step, 4);
  }
}

}  // namespace velum::session
