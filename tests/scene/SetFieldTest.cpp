#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ChangeFields.h"
#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"

namespace velum::scene {
namespace {

std::string messageOf(std::string_view path, std::string_view value, Scene scene = {}) {
  Scene before = scene;
  try {
    setField(scene, path, value);
  } catch (const ArgumentError& error) {
    EXPECT_TRUE(scene == before) << path << ": a refused change has changed something";
    return error.what();
  }
  return {};
}

void expectMentions(const std::string& message, std::initializer_list<const char*> words) {
  for (const char* word : words)
    EXPECT_NE(message.find(word), std::string::npos) << "no '" << word << "' in: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

TEST(SetField, NumbersWordsAndTexts) {
  Scene scene;
  setField(scene, "rayCast.stepVoxels", "0.25");
  setField(scene, "rayCast.mode", "mip");
  setField(scene, "rayCast.jitter", "false");
  setField(scene, "volume.source.path", "a b.nrrd");
  setField(scene, "camera.projection", "\"orthographic\"");
  setField(scene, "rayCast.samplesPerPixel", "9");
  EXPECT_EQ(scene.rayCast.stepVoxels, 0.25);
  EXPECT_EQ(scene.rayCast.mode, RenderMode::Mip);
  EXPECT_FALSE(scene.rayCast.jitter);
  EXPECT_EQ(scene.volume.source.path, "a b.nrrd");
  EXPECT_EQ(scene.camera.projection, Projection::Orthographic);
  EXPECT_EQ(scene.rayCast.samplesPerPixel, 9);
}

TEST(SetField, ATextThatLooksLikeANumberStaysAText) {
  Scene scene;
  setField(scene, "cuts.+.name", "42");
  setField(scene, "volume.source.path", "1,2");
  setField(scene, "volume.source.series", "true");
  EXPECT_EQ(scene.cuts.at(0).name, "42");
  EXPECT_EQ(scene.volume.source.path, "1,2");
  EXPECT_EQ(scene.volume.source.series, "true");
}

TEST(SetField, VectorsAsCommaListsOrJson) {
  Scene scene;
  setField(scene, "camera.eye", "1,-2.5,3e2");
  EXPECT_EQ(scene.camera.eye, glm::dvec3(1, -2.5, 300));
  setField(scene, "camera.eye", "[4, 5, 6]");
  EXPECT_EQ(scene.camera.eye, glm::dvec3(4, 5, 6));
  setField(scene, "background.top", "0, 0.5, 1");
  EXPECT_EQ(scene.background.top, glm::vec3(0, 0.5f, 1));
}

TEST(SetField, ListsGrowAndTheirItemsChange) {
  Scene scene;
  setField(scene, "cuts.+", R"({"shape": "sphere", "size": [10, 10, 10]})");
  setField(scene, "cuts.+.shape", "box");
  setField(scene, "cuts.1.spares", "3,4");
  setField(scene, "cuts.0.spares", "7");
  setField(scene, "cuts.0.spares.+", "8");
  setField(scene, "cuts.0.spares.0", "6");
  setField(scene, "cuts.0.spares.1.distance", "2.5");
  ASSERT_EQ(scene.cuts.size(), 2u);
  EXPECT_EQ(scene.cuts[0].shape, CutShape::Sphere);
  EXPECT_EQ(scene.cuts[0].size.x, 10.0);
  EXPECT_EQ(scene.cuts[0].spares, (std::vector<Spare>{{6}, {8, 2.5}}));
  setField(scene, "cuts.0.spares.1.distance", "null");
  EXPECT_EQ(scene.cuts[0].spares, (std::vector<Spare>{{6}, {8}}));
  EXPECT_EQ(scene.cuts[1].shape, CutShape::Box);
  EXPECT_EQ(scene.cuts[1].spares, (std::vector<Spare>{{3}, {4}}));
  setField(scene, "cuts", "[]");
  EXPECT_TRUE(scene.cuts.empty());
}

TEST(SetField, AnUnknownPartNamesTheKnownFields) {
  expectMentions(messageOf("rayCats.mode", "mip"), {"rayCats", "rayCast", "camera", "cuts"});
  expectMentions(messageOf("rayCast.mod", "mip"), {"mod", "rayCast", "mode", "stepVoxels"});
  expectMentions(messageOf("", "1"), {"camera"});
  expectMentions(messageOf(".", "1"), {"camera"});
  expectMentions(messageOf("cuts.+.shap", "box"), {"shap", "cuts.0", "shape", "axis"});
  expectMentions(messageOf("rayCast.mode.x", "1"), {"rayCast.mode", "x"});
}

TEST(SetField, AnItemThatIsNotThereIsRefused) {
  Scene two;
  two.cuts.resize(2);
  for (const char* path : {"cuts.3", "cuts.-1", "cuts.x", "cuts..name", "cuts.1e0", "cuts.18446744073709551616.name",
                           "cuts.4294967296.name"})
    expectMentions(messageOf(path, "{}", two), {"cuts", "2 items"});
}

TEST(SetField, AValueThatDoesNotFitIsRefusedWithPathAndReason) {
  expectMentions(messageOf("rayCast.stepVoxels", "9"), {"rayCast.stepVoxels", "9", "0.05"});
  expectMentions(messageOf("rayCast.stepVoxels", "fine"), {"rayCast.stepVoxels", "number"});
  expectMentions(messageOf("rayCast.mode", "cube"), {"rayCast.mode", "cube", "mip"});
  expectMentions(messageOf("camera.eye", "1,2"), {"camera.eye", "3 numbers"});
  expectMentions(messageOf("camera.eye", "1,2,nan"), {"camera.eye"});
  expectMentions(messageOf("rayCast.jitter", "maybe"), {"rayCast.jitter", "true or false"});
  expectMentions(messageOf("rayCast.samplesPerPixel", "2.5"), {"rayCast.samplesPerPixel"});
  expectMentions(messageOf("camera", "5"), {"camera", "object"});
  expectMentions(messageOf("volume.timeStep", "-1"), {"volume.timeStep"});
}

TEST(SetField, AValueNestedDeeperThanAnySceneIsRefused) {
  EXPECT_NE(messageOf("cuts", std::string(1000000, '[')), "");
  EXPECT_NE(messageOf("cuts", std::string(1000, '[') + std::string(1000, ']')), "");
}

/// Sets each leaf of `from` in `scene` by its path, depth first.
void setAll(Scene& scene, const nlohmann::ordered_json& value, const std::string& path) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items())
      if (key != "velum") setAll(scene, member, path.empty() ? key : path + "." + key);
  } else if (value.is_array() && !value.empty() && value[0].is_object()) {
    for (std::size_t i = 0; i < value.size(); ++i) setAll(scene, value[i], path + "." + std::to_string(i));
  } else {
    setField(scene, path, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

TEST(SetField, AStarIsEachOfAList) {
  Scene scene;
  scene.labels.structures = {{2, "liver"}, {9, "aorta"}};
  setField(scene, "labels.structures.*.showAs", "solid");
  setField(scene, "labels.structures.*.color", "1,0.5,0");
  for (const Structure& structure : scene.labels.structures) {
    EXPECT_EQ(structure.showAs, ShowAs::Solid);
    EXPECT_EQ(structure.color, glm::vec3(1.0f, 0.5f, 0.0f));
  }
  setField(scene, "cuts.*.enabled", "false");
  EXPECT_TRUE(scene.cuts.empty()) << "of none there is none";
  EXPECT_THROW(setField(scene, "labels.structures.*.showAs", "glass"), ArgumentError);
}

TEST(SetField, ReachesEveryFieldOfAScene) {
  Scene changed = changedScene(), scene;
  setAll(scene, nlohmann::ordered_json::parse(toJson(changed)), "");
  EXPECT_EQ(toJson(scene), toJson(changed));
  EXPECT_TRUE(scene == changed);
}

}  // namespace
}  // namespace velum::scene
