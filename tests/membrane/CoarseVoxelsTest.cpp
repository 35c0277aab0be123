#include "membrane/forces/CoarseVoxels.h"

#include <gtest/gtest.h>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

scene::Scene sceneOf(glm::ivec3 dims, const std::function<double(glm::ivec3)>& value) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(dims, SampleType::UInt8, value, centredFrame(dims)));
  return scene;
}

scene::ForceField above(double value) {
  scene::ForceField field;
  field.byValue = {{value, 100}, {255, 100}};
  return field;
}

TEST(CoarseVoxels, ABlockCountsWhereAQuarterOfItDoes) {
  glm::ivec3 dims(22, 17, 11);
  auto isIn = [](glm::ivec3 p) { return (p.x * 7 + p.y * 5 + p.z * 3) % 11 < 3; };
  scene::Scene scene = sceneOf(dims, [&](glm::ivec3 p) { return isIn(p) ? 200.0 : 10.0; });
  Progress progress;
  CoarseVoxels coarse = coarseVoxels(Potential(scene), above(100), 8, progress);
  ASSERT_EQ(coarse.step, glm::ivec3(3, 3, 2));
  glm::ivec3 n = coarse.grid.box.end;
  ASSERT_EQ(n, glm::ivec3(8, 6, 6));
  std::size_t i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) {
        int held = 0, all = 0;
        glm::ivec3 first = glm::ivec3(x, y, z) * coarse.step, end = glm::min(first + coarse.step, dims);
        for (glm::ivec3 p = first; p.z < end.z; ++p.z)
          for (p.y = first.y; p.y < end.y; ++p.y)
            for (p.x = first.x; p.x < end.x; ++p.x) held += isIn(p), ++all;
        EXPECT_EQ(coarse.grid.mask[i] != 0, 4 * held >= all) << x << " " << y << " " << z;
      }
}

TEST(CoarseVoxels, BlocksLieWhereTheirVoxelsDo) {
  glm::ivec3 dims(30, 30, 30);
  scene::Scene scene = sceneOf(dims, [](glm::ivec3 p) { return p == glm::ivec3(13, 13, 13) ? 200.0 : 10.0; });
  Progress progress;
  CoarseVoxels fine = coarseVoxels(Potential(scene), above(100), 30, progress);
  EXPECT_EQ(fine.grid.worldFromVoxel, Potential(scene).worldFromVoxel());
  CoarseVoxels coarse = coarseVoxels(Potential(scene), above(100), 10, progress);
  glm::dvec3 middle(coarse.grid.worldFromVoxel * glm::dvec4(4, 4, 4, 1));
  glm::dvec3 voxel(Potential(scene).worldFromVoxel() * glm::dvec4(13, 13, 13, 1));
  EXPECT_NEAR(glm::length(middle - voxel), 0.0, 1e-9);
  EXPECT_EQ(coarse.voxelOf({4, 4, 4}), glm::ivec3(13));
}

TEST(CoarseVoxels, WithoutDataThereIsNothing) {
  Progress progress;
  EXPECT_TRUE(coarseVoxels(Potential(scene::Scene()), above(100), 8, progress).grid.mask.empty());
}

TEST(CoarseVoxels, MiddlesOfBlocksAtTheEndLieInTheData) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      {21, 9, 17}, SampleType::Int16, [](glm::ivec3) { return 200; }, glm::dmat4(1.0)));
  Progress progress;
  CoarseVoxels coarse = coarseVoxels(Potential(scene), above(100), 5, progress);
  EXPECT_EQ(coarse.voxelOf(coarse.grid.box.end - 1), glm::ivec3(20, 8, 16));
  EXPECT_EQ(coarse.voxelOf({0, 0, 0}), coarse.step / 2);
}

}  // namespace
}  // namespace velum::membrane
