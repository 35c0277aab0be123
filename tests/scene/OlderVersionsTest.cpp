// Files of older versions open to the scenes that they held, files of newer ones are refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "SceneKinds.h"
#include "SourceFolder.h"
#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/ChangeLog.h"
#include "scene/json/Json.h"

namespace velum::scene {
namespace {

std::string v1Text(const std::string& name) {
  std::ifstream in(sourceFolder() / "tests" / "scene" / "v1" / (name + ".json"));
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(OlderVersions, FilesOfVersion1OpenToTheScenesThatTheyHeld) {
  for (const auto& [name, scene] : kinds::all()) {
    SCOPED_TRACE(name);
    testing::internal::CaptureStderr();
    Scene opened = fromJson(v1Text(name));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "every field is known";
    EXPECT_EQ(toJson(opened), toJson(scene));
    EXPECT_TRUE(opened == scene);
  }
}

TEST(OlderVersions, WhatIsWrittenIsOfTheNewestVersionAndOpensAgain) {
  for (const auto& [name, scene] : kinds::all()) {
    std::string text = toJson(fromJson(v1Text(name)));
    EXPECT_EQ(nlohmann::json::parse(text)["velum"], kSceneVersion) << name;
    EXPECT_TRUE(fromJson(text) == scene) << name;
  }
}

TEST(OlderVersions, OtherShapesThanMembranesLoseTheOneThatTheyNeverShowed) {
  Scene scene = fromJson(R"({"velum": 1, "cuts": [{"shape": "box", "membrane": {"sliceOpacity": 0.5}}]})");
  EXPECT_FALSE(scene.cuts.at(0).membrane);
}

TEST(OlderVersions, WhatVersion2ToldOfAModelIsInOnePart) {
  testing::internal::CaptureStderr();
  Scene scene = fromJson(R"({"velum": 2, "cuts": [{"typeSpares": [{"type": "root", "share": 0.25, "falloff": 3}],
      "wholeInstances": true, "leastMass": 10, "mostMass": 20, "leastCopies": 3, "mostCopies": null,
      "focus": {"types": [{"type": "root.a"}], "guidesDepth": true}}, {"shape": "box"}]})");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "every field is known";
  ModelCut wanted;
  wanted.spares = {{.type = "root", .share = 0.25, .falloff = 3.0}};
  wanted.wholeInstances = true;
  wanted.leastMass = 10.0;
  wanted.mostMass = 20.0;
  wanted.leastCopies = 3.0;
  wanted.focus.emplace().types = {{"root.a"}};
  wanted.focus->guidesDepth = true;
  EXPECT_TRUE(scene.cuts.at(0).model == wanted);
  EXPECT_TRUE(scene.cuts.at(1).model == ModelCut{});
  EXPECT_TRUE(fromJson(toJson(scene)) == scene);
}

/// It was all or nothing for the material of a volume.
TEST(OlderVersions, TheShareOfAStructureIsAllOrNothing) {
  testing::internal::CaptureStderr();
  Scene scene = fromJson(R"({"velum": 2, "cuts": [{"spares": [{"structure": 1, "distance": 4, "share": 1.0},
      {"structure": 2, "distance": null, "share": 0}, {"structure": 3, "distance": 5, "share": 0.5}]}]})");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(scene.cuts.at(0).spares, (std::vector<Spare>{{1, 4.0}, {2, 0.0}, {3, 5.0}}));
}

TEST(OlderVersions, AJournalOfVersion1IsReplayed) {
  auto text = nlohmann::json::parse(v1Text("planes"));
  nlohmann::json first = {{{"op", "replace"}, {"path", ""}, {"value", text}}};
  nlohmann::json second = {{{"op", "add"}, {"path", "/cuts/1/exempt/1"}, {"value", 9}}};
  std::string journal = encodeLine({1, 0, "Open", "", "", first.dump()});
  journal += encodeLine({2, 1, "Keep whole", "", "", second.dump()});
  auto found = replay("", journal);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->isWhole);
  EXPECT_EQ(found->scene.cuts.at(1).spares, (std::vector<Spare>{{7}, {9}}));
}

/// It is a place now.
TEST(OlderVersions, ANumberInBracketsOfATracksPathWasAnId) {
  auto pathsOf = [](int version) {
    Scene scene = fromJson(fmt::format(
        R"({{"velum": {}, "cuts": [{{"id": 2}}, {{"id": 1}}, {{"id": 5, "name": "7"}}],
          "lettering": {{"captions": [{{"id": 4, "text": "a"}}]}}, "timeline": {{"tracks": [
          {{"path": "cuts[1].centre"}}, {{"path": "cuts[7].centre"}}, {{"path": "cuts[#2].centre"}},
          {{"path": "cuts.1.centre"}}, {{"path": "cuts[2].spares[3].distance"}}, {{"path": "lettering.captions[4].size"}},
          {{"path": "labels.structures[5].opacity"}}, {{"path": "cuts[1"}},
          {{"path": "cuts[2].membrane.field.byLabel[6].strength"}}]}}}})",
        version));
    std::vector<std::string> paths;
    for (const Track& track : scene.timeline.tracks) paths.push_back(track.path);
    return paths;
  };
  const std::vector<std::string> asWritten = {"cuts[1].centre",
                                              "cuts[7].centre",
                                              "cuts[#2].centre",
                                              "cuts.1.centre",
                                              "cuts[2].spares[3].distance",
                                              "lettering.captions[4].size",
                                              "labels.structures[5].opacity",
                                              "cuts[1",
                                              "cuts[2].membrane.field.byLabel[6].strength"};
  std::vector<std::string> marked = asWritten;
  marked[0] = "cuts[#1].centre";
  marked[4] = "cuts[#2].spares[3].distance";
  marked[5] = "lettering.captions[#4].size";
  marked[8] = "cuts[#2].membrane.field.byLabel[6].strength";
  EXPECT_EQ(pathsOf(3), marked) << "but where a cut is called 7, and of structures";
  EXPECT_EQ(pathsOf(4), asWritten);
}

TEST(OlderVersions, AFileOfAFutureVersionSaysSoInOneLine) {
  std::string message;
  try {
    fromJson(R"({"velum": 5, "cuts": {}})");
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("newer Velum"), std::string::npos) << message;
  EXPECT_NE(message.find("version 5"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace
}  // namespace velum::scene
