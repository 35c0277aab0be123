// Cuts are known by their ids.
#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/Json.h"
#include "scene/json/Paths.h"

namespace velum::scene {
namespace {

TEST(CutIds, AFileWithoutThemOrWithTheSameTwiceGetsSome) {
  Scene scene = fromJson(
      R"({"velum": 1, "cuts": [{"name": "a"}, {"id": 4}, {"id": 4, "name": "c"}, {"id": 2}, {"id": 0, "name": "e"}]})");
  std::vector<int> ids;
  for (const auto& cut : scene.cuts) ids.push_back(cut.id);
  EXPECT_EQ(ids, (std::vector<int>{5, 4, 6, 2, 7}));
  EXPECT_EQ(fromJson(toJson(scene)), scene);
}

TEST(CutIds, TheLargestNumberLeavesRoomForOthers) {
  Scene scene = fromJson(R"({"velum": 1, "cuts": [{"id": 1000000000}, {"id": 1}, {}]})");
  EXPECT_EQ(scene.cuts[2].id, 2);
  EXPECT_EQ(addCut(scene, {}), 3);
  EXPECT_TRUE(fromJson(toJson(scene)) == scene);
}

TEST(CutIds, AnAddedCutHasANumberOfItsOwnWhateverItCameWith) {
  Scene scene;
  Cut cut;
  cut.id = 7;
  EXPECT_EQ(addCut(scene, cut), 1);
  EXPECT_EQ(addCut(scene, cut), 2);
  scene.cuts.erase(scene.cuts.begin());
  EXPECT_EQ(addCut(scene, cut), 3);
  EXPECT_EQ(cutPlace(scene, 3), 1);
  EXPECT_EQ(findCut(scene, 1), nullptr);
  EXPECT_EQ(findCut(scene, 0), nullptr);
}

TEST(CutIds, OnlyMembranesHaveOne) {
  Scene scene = fromJson(R"({"velum": 1, "cuts": [{"shape": "membrane"}, {"shape": "box", "membrane": {}}]})");
  EXPECT_EQ(scene.cuts[0].membrane, Membrane{});
  EXPECT_FALSE(scene.cuts[1].membrane);
  EXPECT_THROW(setField(scene, "cuts.1.membrane.use", "inlay"), ArgumentError);
  setField(scene, "cuts.1.shape", "membrane");
  setField(scene, "cuts.1.membrane.use", "inlay");
  EXPECT_TRUE(isInlay(scene.cuts[1]));
  setField(scene, "cuts.1.shape", "plane");
  EXPECT_FALSE(scene.cuts[1].membrane);
}

}  // namespace
}  // namespace velum::scene
