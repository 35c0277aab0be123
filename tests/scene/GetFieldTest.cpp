// What a field is, as text, and what to set so that one scene becomes another.
#include <gtest/gtest.h>

#include "ChangeFields.h"
#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"

namespace velum::scene {
namespace {

/// A scene with one of everything that can be a list.
Scene fullScene() {
  Scene scene;
  scene.labels.structures = {{.id = 1, .name = "aorta"}, {.id = 2, .name = "left, kidney"}};
  scene.surfaces.emplace_back();
  scene.volume.transfer.opacities = {{0, 0}, {100, 0.5}};
  Cut plane;
  plane.name = "Plane 1";
  addCut(scene, plane);
  Cut sheet;
  sheet.shape = CutShape::Membrane;
  addCut(scene, sheet);
  completeItems(scene);
  return scene;
}

Scene withChanges(Scene scene, const std::vector<FieldValue>& changes) {
  for (const auto& [path, value] : changes) setField(scene, path, value);
  return scene;
}

TEST(GetField, TellsWhatSetFieldTakes) {
  Scene scene = fullScene();
  const std::pair<const char*, const char*> kRows[] = {{"rayCast.mode", "mip"},
                                                       {"rayCast.stepVoxels", "0.25"},
                                                       {"camera.eye", "1,-2.5,300"},
                                                       {"cuts[Plane 1].enabled", "false"},
                                                       {"cuts.1.name", "my 2nd cut"},
                                                       {"labels.structures[aorta].color", "0.5,0.25,1"},
                                                       {"labels.structures.*.visible", "[false,false]"},
                                                       {"cuts.0.name", "\"42\""},
                                                       {"labels.structures[2].name", "\"1,2\""}};
  for (auto [path, value] : kRows) {
    if (std::string_view(path).find('*') == std::string_view::npos)
      setField(scene, path, value);
    else
      for (auto& structure : scene.labels.structures) structure.visible = false;
    EXPECT_EQ(getField(scene, path == std::string_view("cuts[Plane 1].enabled") ? "cuts.0.enabled" : path), value);
  }
  EXPECT_EQ(scene.cuts[0].name, "42");
}

TEST(GetField, APathThatIsNoneIsRefusedByName) {
  Scene scene = fullScene();
  const std::pair<const char*, const char*> kRows[] = {{"camra", "camera"},
                                                       {"camera.eyes", "eye"},
                                                       {"cuts.7", "2 items"},
                                                       {"cuts.first", "first"},
                                                       {"cuts[gone].name", "gone"},
                                                       {"rayCast.mode.x", "no part"},
                                                       {"cuts.0.membrane.field", "null"}};
  for (auto [path, word] : kRows) try {
      getField(scene, path);
      ADD_FAILURE() << path;
    } catch (const ArgumentError& error) {
      EXPECT_NE(std::string_view(error.what()).find(word), std::string_view::npos) << error.what();
    }
}

TEST(FieldChanges, OfEachFieldLeadToTheOtherScene) {
  Scene before = fullScene();
  int fields = 0;
  for (int n = 0;; ++n) {
    Scene after = before;
    std::string path;
    int left = n;
    changeNthField(after, left, "", path);
    if (path.empty()) break;
    completeItems(after);
    auto changes = fieldChanges(before, after);
    if (path.find("membrane.shape") != std::string::npos) {
      EXPECT_TRUE(changes.empty()) << path << ": where a sheet rests is nobody's wish";
      continue;
    }
    ++fields;
    ASSERT_FALSE(changes.empty()) << path;
    EXPECT_EQ(toJson(withChanges(before, changes)), toJson(after)) << path;
    EXPECT_EQ(toJson(withChanges(after, fieldChanges(after, before))), toJson(before)) << path << ", back";
  }
  EXPECT_GT(fields, 200);
}

TEST(FieldChanges, AListThatGrowsOrShrinksIsSetWhole) {
  Scene before = fullScene(), after = before;
  after.cuts.erase(after.cuts.begin());
  after.labels.structures.push_back({.id = 9, .name = "two\nlines"});
  auto changes = fieldChanges(before, after);
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].path, "labels.structures");
  EXPECT_EQ(changes[1].path, "cuts");
  for (const auto& change : changes) EXPECT_EQ(change.value.find('\n'), std::string::npos) << "a line each";
  EXPECT_EQ(toJson(withChanges(before, changes)), toJson(after));
  EXPECT_TRUE(fieldChanges(after, after).empty());
}

}  // namespace
}  // namespace velum::scene
