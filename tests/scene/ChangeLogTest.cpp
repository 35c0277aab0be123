#include "scene/json/ChangeLog.h"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "ChangeFields.h"
#include "core/Error.h"
#include "scene/json/Json.h"

namespace velum::scene {

namespace {

/// One change of many kinds, as a person makes them.
void changeSomething(Scene& scene, std::mt19937& random) {
  auto number = [&](double least, double most) { return std::uniform_real_distribution<>(least, most)(random); };
  switch (random() % 8) {
    case 0:
      addCut(scene, {});
      return void(scene.cuts.back().centre.x = number(-100, 100));
    case 1:
      return scene.cuts.empty() ? void() : void(scene.cuts.erase(scene.cuts.begin() + random() % scene.cuts.size()));
    case 2:
      return void(scene.camera.eye = {number(-900, 900), number(-900, 900), 1.0 / 3.0});
    case 3:
      return void(scene.labels.structures.emplace_back().id = int(random() % 65535) + 1);
    case 4:
      return void(scene.volume.transfer.opacities.insert(scene.volume.transfer.opacities.begin(), {number(0, 9), 0.5}));
    case 5:
      return void(scene.volume.transfer.preset = "\"pre\\set\" \n,\"patch\":[]}");
    case 6:
      return void(scene.background.transparent = !scene.background.transparent);
    default:
      return void(scene.volume.windowLevel = number(-1e3, 3e3));
  }
}

/// A journal of random changes, and the scene after each line.
struct Written {
  std::string text;
  std::vector<Scene> scenes;
  std::vector<std::size_t> ends;  ///< bytes up to the end of each line
};

Written writeJournal(int lines, unsigned seed) {
  std::mt19937 random(seed);
  Written out;
  Scene scene;
  SceneMirror mirror;
  for (int i = 1; i <= lines; ++i) {
    changeSomething(scene, random);
    std::string patch = mirror.follow(scene);
    if (patch.empty()) patch = "[]";
    out.text += encodeLine({i, i * 0.1, "Change " + std::to_string(i), "head.nrrd", "/a/b.json", patch});
    out.scenes.push_back(scene);
    out.ends.push_back(out.text.size());
  }
  return out;
}

}  // namespace

TEST(ChangeLog, AReplayedJournalIsTheLastScene) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Written written = writeJournal(200, seed);
    auto found = replay("", written.text);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->scene, written.scenes.back());
    EXPECT_TRUE(found->isWhole);
    EXPECT_EQ(found->last.label, "Change 200");
    EXPECT_EQ(found->last.title, "head.nrrd");
    EXPECT_EQ(found->last.path, "/a/b.json");
    EXPECT_NEAR(found->last.seconds, 20.0, 1e-9);
  }
}

TEST(ChangeLog, EveryFieldIsFollowed) {
  Scene changed = changedScene();
  SceneMirror mirror;
  std::string text = encodeLine({1, 0, "a", "", "", mirror.follow(Scene{})});
  text += encodeLine({2, 0, "b", "", "", mirror.follow(changed)});
  auto found = replay("", text);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scene, changed);
}

TEST(ChangeLog, ALineHoldsOnlyWhatHasChanged) {
  Scene scene;
  for (int id = 1; id <= 500; ++id) scene.labels.structures.emplace_back().id = id;
  SceneMirror mirror;
  mirror.follow(scene);
  scene.labels.structures[250].opacity = 0.25;
  EXPECT_LT(mirror.follow(scene).size(), 100u);
  EXPECT_TRUE(mirror.follow(scene).empty());
}

TEST(ChangeLog, ATearAtAnyByteOfTheLastLineGivesTheOneBefore) {
  Written written = writeJournal(6, 7);
  for (std::size_t size = written.ends[4]; size < written.ends[5]; ++size) {
    auto found = replay("", written.text.substr(0, size));
    ASSERT_TRUE(found) << size;
    EXPECT_EQ(found->scene, written.scenes[4]) << size;
    EXPECT_EQ(found->isWhole, size == written.ends[4]) << size;
  }
}

TEST(ChangeLog, DamageAtAnyByteGivesAnEarlierSceneOrTheSame) {
  Written written = writeJournal(12, 3);
  SceneMirror first;
  first.follow(written.scenes[0]);
  std::mt19937 random(11);
  for (std::size_t at = 0; at < written.text.size(); at += 7) {
    std::string text = written.text;
    text[at] = char(text[at] ^ (1 + random() % 255));
    auto found = replay(first.text(), text);
    ASSERT_TRUE(found) << at;
    EXPECT_NE(std::find(written.scenes.begin(), written.scenes.end(), found->scene), written.scenes.end()) << at;
  }
}

TEST(ChangeLog, TheAutosaveStandsInForADamagedFirstLine) {
  Written written = writeJournal(20, 5);
  SceneMirror first;
  first.follow(written.scenes[0]);
  std::string text = written.text;
  text[10] = '#';
  EXPECT_FALSE(replay("", text));
  EXPECT_FALSE(replay("{\"velum\": 1", text));
  auto found = replay(first.text(), text);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scene, written.scenes.back());
  found = replay(first.text(), "");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scene, written.scenes[0]);
}

TEST(ChangeLog, AMissingLineEndsTheReplay) {
  Written written = writeJournal(9, 5);
  std::string text = written.text.substr(0, written.ends[4]) + written.text.substr(written.ends[5]);
  auto found = replay("", text);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scene, written.scenes[4]);
  EXPECT_FALSE(found->isWhole);
}

TEST(ChangeLog, AValueThatNoSceneMayHoldCostsNoMoreThanItsLine) {
  Scene scene;
  SceneMirror mirror;
  std::string text;
  int number = 0;
  auto add = [&] { text += encodeLine({++number, 0, std::to_string(number), "", "", mirror.follow(scene)}); };
  for (int i = 0; i < 9; ++i) scene.volume.windowLevel = i, add();
  Scene before = scene;
  scene.camera.fieldOfViewDeg = 1000;  // a mistake of the program
  add();
  scene.volume.windowLevel = 20;
  add();
  auto found = replay("", text);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->scene, before);
  EXPECT_EQ(found->last.label, "9");
}

TEST(ChangeLog, HostileChangesAreRefusedFast) {
  SceneMirror mirror;
  mirror.follow(Scene{});
  std::string deep(100000, '['), path;
  for (int i = 0; i < 1000; ++i) path += "/a";
  auto start = std::chrono::steady_clock::now();
  for (std::string patch :
       {std::string("{}"), std::string("[1]"), std::string("null"), std::string(""), deep, std::string("[{}]"),
        std::string(R"([{"op": "copy", "from": "/cuts", "path": "/cuts/-"}])"),
        std::string(R"([{"op": "copy", "from": "/camera/eye", "path": "/camera/eye", "value": 1}])"),
        std::string(R"([{"op": "move", "from": "/cuts", "path": "/camera"}])"),
        std::string(R"([{"op": "test", "path": "/velum", "value": 1}])"),
        std::string(R"([{"op": "remove", "path": ""}])"), std::string(R"([{"op": "remove", "path": "/nothing"}])"),
        std::string(R"([{"op": "replace", "path": "", "value": 4}])"), std::string(R"([{"op": "add", "path": "a"}])"),
        std::string(R"([{"op": "add", "path": "/cuts/99", "value": {}}])"),
        std::string(R"([{"op": "add", "path": "/cuts/01", "value": {}}])"),
        std::string(R"([{"op": "add", "path": "/cuts/99999999999999999999", "value": {}}])"),
        std::string(R"([{"op": "add", "path": "/camera/~2", "value": 1}])"),
        R"([{"op": "add", "value": 1, "path": ")" + path + "\"}]"}) {
    SceneMirror copy(mirror.text());
    EXPECT_THROW(copy.apply(patch), InputError) << patch.substr(0, 80);
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

TEST(ChangeLog, WhatIsNoJournalGivesNothing) {
  for (const char* text :
       {"", "\n", "\n\n\n", "{}\n", "[]\n", "{\"n\": 1, \"patch\": []}\n", "\xff\xfe\n", "}\n", ",\"patch\":}\n"})
    EXPECT_FALSE(replay(text, text)) << text;
}

}  // namespace velum::scene
