// Files of older versions open to the scenes that they held, files of newer ones are refused.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "SceneKinds.h"
#include "SourceFolder.h"
#include "velum/core/Error.h"
#include "velum/scene/json/ChangeLog.h"
#include "velum/scene/json/Json.h"

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

TEST(OlderVersions, AFileOfAFutureVersionSaysSoInOneLine) {
  std::string message;
  try {
    fromJson(R"({"velum": 3, "cuts": {}})");
  } catch (const InputError& error) {
    message = error.what();
  }
  EXPECT_NE(message.find("newer Velum"), std::string::npos) << message;
  EXPECT_NE(message.find("version 3"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

}  // namespace
}  // namespace velum::scene
