#include "scene/json/Json.h"
#include "scene/json/Paths.h"
#include "scene/json/Schema.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "ChangeFields.h"
#include "core/Error.h"
#include "scene/Scene.h"

namespace velum::scene {
namespace {

std::string messageOf(const std::string& text) {
  try {
    fromJson(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

double secondsOf(auto&& work) {
  auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(SceneJson, EveryFieldSurvivesTheRoundTrip) {
  Scene changed = changedScene();
  ASSERT_FALSE(changed == Scene{});
  Scene back = fromJson(toJson(changed));
  EXPECT_EQ(toJson(back), toJson(changed));
  EXPECT_TRUE(back == changed);
}

TEST(SceneJson, DefaultsSurviveTheRoundTrip) { EXPECT_TRUE(fromJson(toJson(Scene{})) == Scene{}); }

TEST(SceneJson, TheSameSceneGivesTheSameBytes) {
  Scene scene = changedScene();
  Scene copy = scene;
  EXPECT_EQ(toJson(scene), toJson(copy));
  EXPECT_EQ(toJson(fromJson(toJson(scene))), toJson(scene));
}

TEST(SceneJson, AnyDoubleSurvivesExactly) {
  Scene scene;
  scene.camera.eye = {1.0 / 3.0, -1e-17, 123456789.123456789};
  scene.background.top = glm::vec3(0.1f, 1.0f / 3.0f, 1e-7f);
  EXPECT_TRUE(fromJson(toJson(scene)) == scene);
}

TEST(SceneJson, AnErrorNamesItsLine) {
  for (auto [text, line] : {std::pair("{\"velum\": 2,\n  \"rayCast\": {\n    \"mode\": mip}}", "line 3"),
                            {"{\"velum\": 2,\n\n", "line 3"},
                            {"{\n\"velum\" 2}", "line 2"}})
    EXPECT_NE(messageOf(text).find(line), std::string::npos) << messageOf(text);
  EXPECT_NE(messageOf("{\"velum\": 1e999}").find("1e999"), std::string::npos) << "a number beyond all";
  EXPECT_LT(messageOf("{\"velum\": \"" + std::string(100'000, 'a')).size(), 300u);
}

TEST(SceneJson, AnUnknownFieldIsNamedWithTheOneThatIsMeant) {
  testing::internal::CaptureStderr();
  Scene scene = fromJson(
      R"({"velum": 2, "rayCats": {}, "rayCast": {"stepVoxel": 2, "mdoe": "mip", "qqq": 1}, "cuts": [{"centr": [1, 2, 3]}]})");
  std::string said = testing::internal::GetCapturedStderr();
  for (const char* words : {"'rayCats' (is 'rayCast' meant?)", "'stepVoxel' (is 'stepVoxels' meant?)",
                            "'mdoe' (is 'mode' meant?)", "'qqq'", "'centr' (is 'centre' meant?)"})
    EXPECT_NE(said.find(words), std::string::npos) << words << " in " << said;
  EXPECT_EQ(said.find("'qqq' (is"), std::string::npos) << "nothing is near";
  EXPECT_EQ(scene.rayCast, RayCast{}) << "what is unknown is left out";
}

TEST(SceneJson, AMissingFieldKeepsItsDefault) {
  EXPECT_TRUE(fromJson(R"({"velum": 1})") == Scene{});
  Scene scene = fromJson(R"({"velum": 1, "rayCast": {"mode": "mip"}})");
  EXPECT_EQ(scene.rayCast.mode, RenderMode::Mip);
  EXPECT_EQ(scene.rayCast.stepVoxels, RayCast{}.stepVoxels);
}

TEST(SceneJson, UnknownFieldsAreLeftOutWithAWarning) {
  testing::internal::CaptureStderr();
  Scene scene = fromJson(R"({"velum": 1, "rayCast": {"mode": "mip", "future": [1, {"a": 2}]}, "other": null})");
  std::string warnings = testing::internal::GetCapturedStderr();
  EXPECT_EQ(scene.rayCast.mode, RenderMode::Mip);
  EXPECT_NE(warnings.find("rayCast"), std::string::npos) << warnings;
  EXPECT_NE(warnings.find("the file"), std::string::npos) << warnings;
}

TEST(SceneJson, KnownFieldsWarnOfNothing) {
  Scene scene = changedScene();
  testing::internal::CaptureStderr();
  fromJson(toJson(scene));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SceneJson, ANewerVersionIsRefused) {
  std::string message = messageOf(R"({"velum": 5})");
  EXPECT_NE(message.find("newer"), std::string::npos) << message;
  EXPECT_NE(message.find("5"), std::string::npos) << message;
  for (const char* text : {R"({"velum": 0})", R"({"velum": -1})", R"({"velum": 1.5})", R"({"velum": "1"})", R"({})",
                           R"({"velum": 99999999999999999999999})"})
    EXPECT_NE(messageOf(text), "") << text;
}

TEST(SceneJson, WhatIsNoSceneIsRefusedInOneLine) {
  for (const char* text : {"", "x", "null", "[]", "1", "\"velum\"", "{", "{\"velum\": 1", "{\"velum\": 1}}", "\xff\xfe",
                           "{\"velum\": 1, \"camera\": }", "{'velum': 1}"}) {
    std::string message = messageOf(text);
    EXPECT_NE(message, "") << text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

struct Refusal {
  const char* text;
  const char* path;
};

TEST(SceneJson, WrongKindsAndRangesAreRefusedWithTheirPath) {
  const Refusal kRefusals[] = {
      {R"("camera": [])", "camera"},
      {R"("camera": {"eye": [1, 2]})", "camera.eye"},
      {R"("camera": {"eye": [1, 2, "3"]})", "camera.eye.2"},
      {R"("camera": {"eye": [1, 2, null]})", "camera.eye.2"},
      {R"("camera": {"fieldOfViewDeg": 151})", "camera.fieldOfViewDeg"},
      {R"("camera": {"fieldOfViewDeg": true})", "camera.fieldOfViewDeg"},
      {R"("camera": {"projection": "fisheye"})", "camera.projection"},
      {R"("camera": {"projection": 1})", "camera.projection"},
      {R"("camera": {"height": 0})", "camera.height"},
      {R"("rayCast": {"samplesPerPixel": 0})", "rayCast.samplesPerPixel"},
      {R"("rayCast": {"samplesPerPixel": 1.5})", "rayCast.samplesPerPixel"},
      {R"("rayCast": {"samplesPerPixel": 1e9})", "rayCast.samplesPerPixel"},
      {R"("rayCast": {"jitter": 1})", "rayCast.jitter"},
      {R"("rayCast": {"stepVoxels": -0.5})", "rayCast.stepVoxels"},
      {R"("cuts": {})", "cuts"},
      {R"("cuts": [{}, {"size": [1, -1, 1]}])", "cuts.1.size.1"},
      {R"("cuts": [{"spares": [{"structure": 1}, {"structure": 70000}]}])", "cuts.0.spares.1.structure"},
      {R"("cuts": [{"spares": 4}])", "cuts.0.spares"},
      {R"("cuts": [{"spares": [{"distance": -1}]}])", "cuts.0.spares.0.distance"},
      {R"("cuts": [{"spares": [{"structure": null}]}])", "cuts.0.spares.0.structure"},
      {R"("cuts": [{"exempt": [1, 70000]}])", "cuts.0.spares.1.structure"},
      {R"("cuts": [{"exempt": 4}])", "cuts.0.spares"},
      {R"("cuts": [{"name": 4}])", "cuts.0.name"},
      {R"("cuts": [4])", "cuts.0"},
      {R"("background": {"top": [0, 0, 1.5]})", "background.top.2"},
      {R"("labels": {"structures": [{"id": 0}]})", "labels.structures.0.id"},
      {R"("labels": {"structures": [{"id": 65536}]})", "labels.structures.0.id"},
      {R"("volume": {"transfer": {"opacities": [{"opacity": 2}]}})", "volume.transfer.opacities.0.opacity"},
      {R"("volume": {"source": {"raw": {"dims": [1, 2, 1e7]}}})", "volume.source.raw.dims.2"},
      {R"("volume": {"source": {"raw": {"channels": 5}}})", "volume.source.raw.channels"},
  };
  for (const Refusal& refusal : kRefusals) {
    std::string message = messageOf(std::string("{\"velum\": 1, ") + refusal.text + "}");
    EXPECT_NE(message.find(std::string(" ") + refusal.path + ": "), std::string::npos)
        << refusal.text << " gives '" << message << "'";
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(SceneJson, ARefusedEnumerationNamesTheKnownWords) {
  std::string message = messageOf(R"({"velum": 1, "rayCast": {"mode": "cube"}})");
  for (const char* word : {"cube", "volume", "mip", "iso"}) EXPECT_NE(message.find(word), std::string::npos) << message;
}

TEST(SceneJson, NumbersThatAreNotFiniteAreRefused) {
  for (const char* number : {"1e999", "-1e999", "NaN", "Infinity"})
    EXPECT_NE(messageOf(std::string(R"({"velum": 1, "camera": {"eye": [0, 0, )") + number + "]}}"), "") << number;
}

TEST(SceneJson, PlacesThatNothingCanBeDrawnWithAreRefused) {
  Scene scene;
  setField(scene, "camera.eye", "1e15,-1e15,0");
  for (const char* field : {"camera.eye", "camera.target", "camera.up", "sections.crosshair", "lighting.keyDirection"})
    for (const char* value : {"1e16,0,0", "0,-1e300,0"}) EXPECT_THROW(setField(scene, field, value), Error) << field;
  setField(scene, "cuts.+.shape", "membrane");
  EXPECT_THROW(setField(scene, "cuts.0.membrane.pins.+.place", "0,0,1e16"), Error);
}

TEST(SceneJson, ASceneHoldsSoManyCutsAndNoMore) {
  Scene scene;
  for (std::size_t i = 0; i < kMostCuts; ++i) addCut(scene, Cut{});
  EXPECT_TRUE(fromJson(toJson(scene)) == scene);
  EXPECT_THROW(addCut(scene, Cut{}), ArgumentError);
  EXPECT_THROW(setField(scene, "cuts.+.shape", "box"), ArgumentError);
  EXPECT_EQ(scene.cuts.size(), kMostCuts);
  scene.cuts.push_back(scene.cuts.back());
  EXPECT_THROW(fromJson(toJson(scene)), InputError);
}

TEST(SceneJson, DeepNestingIsRefusedFast) {
  std::string open, mixed;
  for (int i = 0; i < 2000000; ++i) open += '[';
  for (int i = 0; i < 500000; ++i) mixed += "{\"a\":[";
  EXPECT_LT(secondsOf([&] { EXPECT_NE(messageOf(open).find("nested"), std::string::npos); }), 1.0);
  EXPECT_LT(secondsOf([&] { EXPECT_NE(messageOf(mixed).find("nested"), std::string::npos); }), 1.0);
  EXPECT_LT(secondsOf([&] { EXPECT_NE(messageOf("{\"velum\": 1, \"x\": " + open), ""); }), 1.0);
}

TEST(SceneJson, BracketsInTextsDoNotCount) {
  Scene scene;
  scene.volume.source.path = std::string(500, '[') + "\\\"{{{";
  EXPECT_TRUE(fromJson(toJson(scene)) == scene);
}

TEST(SceneJson, AHugeListIsRefusedFast) {
  std::string text = R"({"velum": 1, "cuts": [{})";
  for (int i = 0; i < 200000; ++i) text += ",{}";
  text += "]}";
  std::string message;
  EXPECT_LT(secondsOf([&] { message = messageOf(text); }), 3.0);
  EXPECT_NE(message.find("cuts"), std::string::npos) << message;
  EXPECT_NE(message.find("200001"), std::string::npos) << message;
}

TEST(SceneJson, APathThatIsNotUtf8StillMakesAText) {
  Scene scene;
  scene.volume.source.path = "caf\xe9.nrrd";  // Latin-1, as old disks have it
  std::string text;
  ASSERT_NO_THROW(text = toJson(scene));
  EXPECT_NO_THROW(fromJson(text));
}

TEST(SceneJson, TheSchemaInTheDocsIsThisOne) {
  std::filesystem::path path = std::filesystem::path(VELUM_SOURCE_DIR) / "docs" / "scene.schema.json";
  std::ifstream in(path, std::ios::binary);
  std::string known((std::istreambuf_iterator<char>(in)), {});
  std::string now = jsonSchema();
  if (known == now) return;
  std::string beside = path.string() + ".new";
  std::ofstream(beside, std::ios::binary) << now;
  FAIL() << "the scene format has changed; look at the difference, then accept it with\n  mv " << beside << " "
         << path.string();
}

/// Checks a value against the few words of JSON Schema that ours uses.
void checkAgainst(const nlohmann::json& schema, const nlohmann::json& value, const std::string& path) {
  if (schema.contains("enum")) {
    EXPECT_NE(std::find(schema["enum"].begin(), schema["enum"].end(), value), schema["enum"].end()) << path;
    return;
  }
  if (!schema.contains("type") || (schema["type"].is_array() && value.is_null())) return;  // any; or endless
  std::string type = schema["type"].is_array() ? schema["type"][0] : schema["type"];
  bool fits = type == "object"    ? value.is_object()
              : type == "array"   ? value.is_array()
              : type == "string"  ? value.is_string()
              : type == "boolean" ? value.is_boolean()
              : type == "integer" ? value.is_number_integer()
                                  : value.is_number();
  EXPECT_TRUE(fits) << path << " is no " << type << ": " << value.dump();
  if (schema.contains("minimum")) {
    EXPECT_GE(value.get<double>(), schema["minimum"].get<double>()) << path;
  }
  if (schema.contains("maximum")) {
    EXPECT_LE(value.get<double>(), schema["maximum"].get<double>()) << path;
  }
  if (type == "array") {
    if (schema.contains("minItems")) {
      EXPECT_GE(value.size(), schema["minItems"].get<std::size_t>()) << path;
    }
    if (schema.contains("maxItems")) {
      EXPECT_LE(value.size(), schema["maxItems"].get<std::size_t>()) << path;
    }
    for (const auto& item : value) checkAgainst(schema.at("items"), item, path + "[]");
  }
  if (type == "object")
    for (const auto& [key, member] : value.items()) {
      ASSERT_TRUE(schema.at("properties").contains(key)) << path << "." << key;
      checkAgainst(schema["properties"][key], member, path + "." + key);
    }
}

TEST(SceneJson, WhatWeWriteFitsTheSchema) {
  auto schema = nlohmann::json::parse(jsonSchema());
  Scene changed = changedScene();
  checkAgainst(schema, nlohmann::json::parse(toJson(Scene{})), "");
  checkAgainst(schema, nlohmann::json::parse(toJson(changed)), "");
}

TEST(FieldTable, CoversEveryLeafOnce) {
  std::set<std::string> leaves, rows;
  collectLeaves(Scene{}, "", leaves);
  for (const FieldRow& row : fieldTable()) {
    EXPECT_TRUE(rows.insert(row.path).second) << row.path << " is there twice";
    EXPECT_FALSE(row.type.empty()) << row.path;
    EXPECT_FALSE(row.doc.empty()) << row.path;
    EXPECT_FALSE(row.defaultValue.empty()) << row.path;
  }
  EXPECT_EQ(rows, leaves);
}

/// The table of docs/SCENE-FORMAT.md, a row a field.
std::string markdownTable() {
  std::string table = "| field | type | unit | range | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const FieldRow& row : fieldTable())
    table += "| `" + row.path + "` | " + row.type + " | " + row.unit + " | " + row.range + " | `" + row.defaultValue +
             "` | " + row.doc + " |\n";
  return table;
}

TEST(FieldTable, TheTableInTheDocsIsThisOne) {
  std::filesystem::path path = std::filesystem::path(VELUM_SOURCE_DIR) / "docs" / "SCENE-FORMAT.md";
  std::ifstream in(path, std::ios::binary);
  std::string known((std::istreambuf_iterator<char>(in)), {});
  const std::string begin = "<!-- fields -->\n", end = "<!-- end of fields -->\n";
  std::size_t first = known.find(begin), last = known.find(end);
  ASSERT_NE(first, std::string::npos) << path << " has no line " << begin;
  ASSERT_NE(last, std::string::npos) << path << " has no line " << end;
  first += begin.size();
  ASSERT_LE(first, last) << path;
  std::string now = known.substr(0, first) + markdownTable() + known.substr(last);
  if (known == now) return;
  std::string beside = path.string() + ".new";
  std::ofstream(beside, std::ios::binary) << now;
  FAIL() << "the scene format has changed; look at the difference, then accept it with\n  mv " << beside << " "
         << path.string();
}

}  // namespace
}  // namespace velum::scene
