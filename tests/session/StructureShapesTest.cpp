// Shapes of structures that are smoothed, from the file through the scene and back.
#include "session/document/StructureShapes.h"

#include <gtest/gtest.h>

#include "TempFolder.h"
#include "io/labels/WriteLabels.h"
#include "io/volumes/WriteVolume.h"
#include "session/document/Open.h"
#include "session/growth/Growths.h"
#include "session/structure/StructureEdit.h"

namespace velum::session {
namespace {

constexpr int kStructureShapesSize = 48;
constexpr double kSpacing = 1.5;

glm::dmat4 worldFromVoxel() {
  glm::dmat4 m(kSpacing);
  m[3][3] = 1.0;
  return m;
}

/// Structure 1, a ball in blocks of two voxels, beside structure 2, one of voxels.
LabelVolume labelsOfBlocks() {
  LabelVolume labels(glm::ivec3(kStructureShapesSize), worldFromVoxel());
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < kStructureShapesSize; ++z)
    for (int y = 0; y < kStructureShapesSize; ++y)
      for (int x = 0; x < kStructureShapesSize; ++x) {
        glm::dvec3 voxel(x, y, z), block = glm::floor(voxel / 2.0) * 2.0 + 0.5;
        bool isBall = glm::length(block - glm::dvec3(16, 18, 20)) < 12;
        ids.push_back(isBall ? 1 : glm::length(voxel - glm::dvec3(36.2, 36.4, 34)) < 9 ? 2 : 0);
      }
  labels.write(glm::ivec3(0), glm::ivec3(kStructureShapesSize), ids);
  labels.table = {{1, "heart_atrium"}, {2, "aorta"}};
  return labels;
}

Volume scan() {
  Volume v;
  v.dims = glm::ivec3(kStructureShapesSize);
  v.type = SampleType::UInt8;
  v.worldFromVoxel = worldFromVoxel();
  v.voxels.resize(timeStepBytes(v));
  for (std::size_t i = 0; i < voxelCount(v); ++i)
    v.voxels[i] = std::byte(i % kStructureShapesSize < kStructureShapesSize / 2 ? 200 : i % 7);
  return v;
}

class StructureShapes : public testing::Test {
 protected:
  void SetUp() override {
    io::writeVolume(scan(), folder / "scan.nrrd", progress);
    io::writeLabels(labelsOfBlocks(), folder / "labels.seg.nrrd", progress);
  }
  scene::Scene load(const char* name) {
    scene::Source source;
    source.path = (folder / name).string();
    return open(source, progress);
  }
  scene::Scene loadBoth() {
    scene::Scene scene = load("scan.nrrd");
    scene::Source labels;
    labels.path = (folder / "labels.seg.nrrd").string();
    add(scene, labels, progress);
    return scene;
  }
  static std::vector<std::uint16_t> idsOf(const LabelVolume& labels) {
    std::vector<std::uint16_t> ids(std::size_t(kStructureShapesSize) * kStructureShapesSize * kStructureShapesSize);
    labels.read(glm::ivec3(0), glm::ivec3(kStructureShapesSize), ids);
    return ids;
  }
  static void smooth(scene::Scene& scene, int id, double deviation) {
    changeStructures(scene, {id}, [&](scene::Structure& s) { s.smoothing = deviation; });
  }
  TempFolder folder;
  Progress progress;
};

}  // namespace

TEST_F(StructureShapes, WhatIsMadeOfBlocksOpensSmoothedAndSaysSo) {
  scene::Scene scene = loadBoth();
  EXPECT_NEAR(findStructure(scene, 1)->smoothing, 2 * kSpacing, 0.05);
  EXPECT_EQ(findStructure(scene, 2)->smoothing, 0.0);
  ASSERT_TRUE(scene.labels.unsmoothed);
  auto file = idsOf(labelsOfBlocks()), now = idsOf(*scene.labels.data);
  EXPECT_EQ(idsOf(*scene.labels.unsmoothed), file);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < file.size(); ++i) {
    changed += file[i] != now[i];
    EXPECT_EQ(file[i] == 2, now[i] == 2) << "the other one stays as it is";
  }
  EXPECT_GT(changed, 200u);
  ASSERT_FALSE(scene.labels.data->warnings.empty());
  EXPECT_NE(scene.labels.data->warnings.back().find("blocks"), std::string::npos);
}

TEST_F(StructureShapes, ASceneKeepsTheSmoothingAndOneWithoutHasTheShapesOfTheFile) {
  scene::Scene scene = loadBoth();
  auto smoothed = idsOf(*scene.labels.data);
  saveScene(scene, folder / "smooth.json");
  EXPECT_EQ(idsOf(*load("smooth.json").labels.data), smoothed);
  smooth(scene, 1, 0.0);
  saveScene(scene, folder / "file.json");
  EXPECT_EQ(idsOf(*load("file.json").labels.data), idsOf(labelsOfBlocks()));
}

TEST_F(StructureShapes, BackToNothingAreTheShapesOfTheFile) {
  scene::Scene scene = loadBoth();
  Shared<LabelVolume> file = scene.labels.unsmoothed;
  smooth(scene, 1, 0.0);
  settleShapes(scene, progress);
  EXPECT_EQ(scene.labels.data, file);
  EXPECT_FALSE(scene.labels.unsmoothed);
  settleShapes(scene, progress);
  EXPECT_EQ(scene.labels.data, file) << "nothing is to be done twice";
}

TEST_F(StructureShapes, WhatWasGrownIsGrownOnThemAnew) {
  scene::Scene scene = loadBoth();
  scene::Growth step;
  step.structure = 7;
  step.seeds = {glm::dvec3(worldFromVoxel() * glm::dvec4(4, 44, 44, 1))};
  step.low = 100, step.high = 255;
  scene.labels.growths.push_back(step);
  settleGrowths(scene, progress);
  EXPECT_EQ(scene.labels.data->at({4, 44, 44}), 7);
  scene::LabelLayer before = scene.labels;
  scene::Scene after = scene;
  smooth(after, 1, 0.0);
  settleShapes(after, progress);
  EXPECT_FALSE(isOfFile(after.labels, 7));
  EXPECT_TRUE(isOfFile(after.labels, 1));
  ASSERT_TRUE(takeShapes(scene, before, after.labels));
  EXPECT_FALSE(isGrown(scene));
  settleGrowths(scene, progress);
  EXPECT_EQ(scene.labels.data->at({4, 44, 44}), 7);
  EXPECT_EQ(idsOf(*scene.labels.given), idsOf(labelsOfBlocks()));
}

TEST_F(StructureShapes, AreNotTakenByASceneThatHasOtherLabelsMeanwhile) {
  scene::Scene scene = loadBoth();
  scene::LabelLayer before = scene.labels;
  scene::Scene after = scene;
  smooth(after, 1, 0.0);
  settleShapes(after, progress);
  scene::Scene other = loadBoth();
  Shared<LabelVolume> data = other.labels.data;
  EXPECT_FALSE(takeShapes(other, before, after.labels));
  EXPECT_EQ(other.labels.data, data);
}

}  // namespace velum::session
