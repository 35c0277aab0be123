// Voxels that cuts leave of a structure, on a grid that is not the labels'.
#include <gtest/gtest.h>

#include <algorithm>

#include "makeVolume.h"
#include "render/kept/KeptVoxels.h"
#include "scene/Scene.h"
#include "scene/StructureAt.h"

namespace velum::session {
namespace {

constexpr glm::ivec3 kDims(48, 44, 40);

/// A ball in labels that are three times as coarse as the volume, and turned; a plane takes all else.
scene::Scene ballInCoarseLabels() {
  constexpr glm::ivec3 kCoarse(19, 18, 17);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(
      kDims, SampleType::UInt8, [](glm::ivec3) { return 100; }, centredFrame(kDims)));
  auto idAt = [](glm::ivec3 p) { return glm::length(glm::dvec3(p) - glm::dvec3(9.2, 8.9, 8.4)) < 4.6 ? 3 : 0; };
  scene.labels.data =
      Shared<LabelVolume>(makeLabels(kCoarse, idAt, centredFrame(kCoarse, glm::dvec3(3.1, 2.9, 3.0), 0.4)));
  scene::completeStructures(scene.labels);
  scene::Cut plane;
  plane.centre = {0, 0, -1000};
  plane.axis = {0, 0, 1};
  plane.spares = {{3}};
  scene::addCut(scene, plane);
  return scene;
}

TEST(KeptBorders, LieWherePicturesHaveThem) {
  scene::Scene scene = ballInCoarseLabels();
  Progress progress;
  auto kept = render::keptVoxels(scene, kDims, scene.volume.data->worldFromVoxel, progress);
  auto field = scene::structureFieldOf(scene);  // held: one is asked for each place
  glm::dmat4 labelFromWorld = glm::inverse(scene.labels.data->worldFromVoxel());
  std::size_t i = 0;
  int keptCount = 0, otherThanNearest = 0;
  for (int z = 0; z < kDims.z; ++z)
    for (int y = 0; y < kDims.y; ++y)
      for (int x = 0; x < kDims.x; ++x, ++i) {
        glm::dvec3 world(scene.volume.data->worldFromVoxel * glm::dvec4(x, y, z, 1.0));
        ASSERT_EQ(kept[i] != 0, scene::structureAt(scene, world).id == 3) << x << ", " << y << ", " << z;
        glm::ivec3 nearest(glm::floor(glm::dvec3(labelFromWorld * glm::dvec4(world, 1.0)) + 0.5));
        keptCount += kept[i];
        otherThanNearest += (kept[i] != 0) != (scene.labels.data->at(nearest) == 3);
      }
  EXPECT_GT(keptCount, 5000);
  EXPECT_GT(otherThanNearest, 300) << "where the nearest voxel would make stairs";
  scene.labels.visible = false;
  kept = render::keptVoxels(scene, kDims, scene.volume.data->worldFromVoxel, progress);
  EXPECT_EQ(std::count(kept.begin(), kept.end(), 1), 0) << "labels that are not shown have no structures";
}

}  // namespace
}  // namespace velum::session
