#include <gtest/gtest.h>

#include "core/Error.h"
#include "scene/Project.h"
#include "session/document/Document.h"
#include "session/structure/StructureEdit.h"
#include "session/structure/StructureSizes.h"

namespace velum::session {

namespace {

scene::Scene structureThreeStructures() {
  scene::Scene scene;
  for (int id : {2, 5, 9}) scene.labels.structures.push_back({id, "", {1, 1, 1}, 1.0, id != 5});
  scene.labels.structures[0].name = "aorta";
  scene.labels.unlabelled = 0.3;
  return scene;
}

std::vector<bool> visible(const scene::Scene& scene) {
  std::vector<bool> out;
  for (const auto& structure : scene.labels.structures) out.push_back(structure.visible);
  return out;
}

using Flags = std::vector<bool>;

}  // namespace

TEST(Structures, SoloRemembersAndRestoresWhatWasVisible) {
  scene::Scene scene = structureThreeStructures(), before = scene;
  SoloMemory memory = toggleSolo(scene, {}, 9);
  EXPECT_EQ(visible(scene), (Flags{false, false, true}));
  EXPECT_EQ(scene.labels.unlabelled, 0.0);
  EXPECT_EQ(soloStructure(scene), 9);
  memory = toggleSolo(scene, memory, 9);
  EXPECT_EQ(scene, before);
  EXPECT_EQ(memory.structure, 0);
}

TEST(Structures, SoloFromOneToAnotherKeepsWhatWasVisibleBeforeBoth) {
  scene::Scene scene = structureThreeStructures(), before = scene;
  SoloMemory memory = toggleSolo(scene, {}, 9);
  memory = toggleSolo(scene, memory, 5);
  EXPECT_EQ(visible(scene), (Flags{false, true, false}));
  toggleSolo(scene, memory, 5);
  EXPECT_EQ(scene, before);
}

TEST(Structures, SoloAfterOtherChangesRemembersThose) {
  scene::Scene scene = structureThreeStructures();
  SoloMemory memory = toggleSolo(scene, {}, 9);
  for (auto& structure : scene.labels.structures) structure.visible = true;
  scene::Scene all = scene;
  memory = toggleSolo(scene, memory, 2);
  toggleSolo(scene, memory, 2);
  EXPECT_EQ(scene, all);
}

TEST(Structures, UndoNamesSayWhich) {
  scene::Scene scene = structureThreeStructures();
  EXPECT_EQ(structureLabel(scene, "Hide", {2}), "Hide aorta");
  EXPECT_EQ(structureLabel(scene, "Solo", {5}), "Solo structure 5");
  EXPECT_EQ(structureLabel(scene, "Show", {2, 5}), "Show 2 structures");
}

TEST(Structures, SizesEqualACountOfTheVoxels) {
  glm::dmat4 world(1.0);
  world[0][0] = 2.0;
  world[1][1] = 0.5;
  world[3] = {10, 20, 30, 1};
  LabelVolume labels({50, 40, 35}, world);
  // A block that fills bricks whole and in part, and a ring whose middle is not in it.
  std::vector<std::uint16_t> block(40 * 33 * 34, 7);
  labels.write({0, 0, 0}, {40, 33, 34}, block);
  std::vector<std::uint16_t> ring(9 * 5, 300);
  for (int y = 1; y < 4; ++y)
    for (int x = 1; x < 8; ++x) ring[std::size_t(y * 9 + x)] = 0;
  labels.write({40, 34, 34}, {9, 5, 1}, ring);
  Progress progress;
  auto sizes = measureStructures(labels, progress);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_EQ(sizes[7].voxels, 40u * 33u * 34u);
  EXPECT_NEAR(sizes[7].volume, 40 * 33 * 34 * 1.0 / 1000.0, 1e-9);
  EXPECT_EQ(sizes[7].centroid, glm::dvec3(19.5, 16.0, 16.5));
  EXPECT_EQ(sizes[300].voxels, 24u);
  EXPECT_EQ(sizes[300].low, glm::ivec3(40, 34, 34));
  EXPECT_EQ(sizes[300].high, glm::ivec3(48, 38, 34));
  glm::dvec3 middle = middleOfStructure(labels, 300, sizes[300]);
  glm::ivec3 voxel(glm::round(glm::dvec3(glm::inverse(world) * glm::dvec4(middle, 1.0))));
  EXPECT_EQ(labels.at(voxel), 300);
  Progress stopped;
  stopped.cancel();
  EXPECT_THROW(measureStructures(labels, stopped), Cancelled);
}

TEST(Structures, ACloseUpShowsAllOfTheBall) {
  for (auto projection : {scene::Projection::Perspective, scene::Projection::Orthographic}) {
    scene::Camera camera;
    camera.projection = projection;
    camera.eye = {100, -300, 50};
    glm::dvec3 middle(7, 8, 9);
    for (glm::dvec2 size : {glm::dvec2(800, 600), glm::dvec2(300, 900)}) {
      scene::Camera near = closeUp(camera, middle, 20.0, size.x / size.y);
      scene::CameraBasis basis = scene::cameraBasis(near);
      EXPECT_LT(glm::length(basis.forward - scene::cameraBasis(camera).forward), 1e-9);
      for (glm::dvec3 side : {basis.right, -basis.right, basis.up, -basis.up}) {
        auto p = scene::pixelFromWorld(near, size, middle + side * 20.0);
        ASSERT_TRUE(p);
        EXPECT_GT(std::min(p->x, p->y), 0.0);
        EXPECT_LT(p->x, size.x);
        EXPECT_LT(p->y, size.y);
      }
    }
  }
}

}  // namespace velum::session
