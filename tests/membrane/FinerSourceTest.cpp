// The box of finer voxels from which the forces of a membrane over a streamed volume come.
#include "membrane/forces/FinerSource.h"

#include <gtest/gtest.h>

#include "PyramidSource.h"
#include "core/Memory.h"
#include "makeVolume.h"
#include "membrane/forces/FrameBox.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

/// A volume of any size, whose bricks nobody has.
class EndlessSource : public VoxelSource {
 public:
  EndlessSource(int along, int levels) {
    mHead.dims = glm::ivec3(along);
    mHead.type = SampleType::UInt16;
    for (int i = 0; i < levels; ++i) {
      VoxelLevel level;
      level.dims = glm::ivec3(along >> i);
      level.brickSize = glm::ivec3(64);
      double edge = double(1 << i);
      level.worldFromVoxel = glm::dmat4(edge);
      level.worldFromVoxel[3] = glm::dvec4(glm::dvec3(0.5 * edge - 0.5), 1.0);
      mLevels.push_back(level);
    }
  }
  const Volume& head() const override { return mHead; }
  void read(const BrickAddress&, const SampleTarget&) const override { throw InputError("nobody has it"); }

 private:
  Volume mHead;
};

PotentialSource endless(int along, int levels) {
  auto source = std::make_shared<EndlessSource>(along, levels);
  Volume volume = source->head();
  const VoxelLevel& coarse = source->levels().back();
  volume.dims = coarse.dims;
  volume.worldFromVoxel = coarse.worldFromVoxel;
  volume.finer = std::make_shared<FinerLevels>(
      FinerLevels{std::make_shared<BrickCache>(source, std::size_t(1) << 20), levels - 1});
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  return sourceOf(scene);
}

scene::Cut frameAt(glm::dvec3 centre, glm::dvec3 size) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.membrane->field.byValue = {{500, 400}, {4000, 400}};
  cut.centre = centre;
  cut.axis = {0, 0, 1};
  cut.size = size;
  return cut;
}

double voxelsIn(const VoxelBox& box) {
  glm::dvec3 n(box.end - box.min);
  return n.x * n.y * n.z;
}

TEST(FinerSource, IsTheFinestLevelThatKeepsToTheBudget) {
  MemoryBudget before = memoryBudget();
  for (double brickBytes : {64.0 * (1 << 20), 512.0 * (1 << 20), 4096.0 * (1 << 20)}) {
    setMemoryBudget({.brickBytes = brickBytes});
    double most = finerVoxelBudget(SampleType::UInt16);
    EXPECT_LE(most * 4.0, 0.5 * brickBudget() + 1.0);
    PotentialSource source = endless(8192, 7);
    for (double edge : {60.0, 200.0, 800.0, 3000.0, 8191.0}) {
      auto box = finerBoxOf(source, frameAt(glm::dvec3(4095.5), {edge, edge, 0.22 * edge}));
      ASSERT_TRUE(box);
      EXPECT_LE(voxelsIn(box->box), most);
      if (box->level == 0) continue;
      // The next finer one has at least six times as many voxels, but for what is around.
      EXPECT_GT(voxelsIn(box->box) * 9.0, most) << edge << ", level " << box->level;
    }
    EXPECT_EQ(finerBoxOf(source, frameAt(glm::dvec3(4095.5), {60, 60, 13}))->level, 0);
  }
  setMemoryBudget(before);
}

TEST(FinerSource, HoldsAllThatTheSheetReachesInWholeSuperVoxels) {
  PotentialSource source = endless(2048, 5);
  for (glm::dvec3 axis : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0.6, 0.35), glm::dvec3(-0.3, 0.5, 1)})
    for (int level : {0, 1, 3}) {
      scene::Cut cut = frameAt({900, 1000, 1100}, {300, 200, 80});
      cut.axis = glm::normalize(axis);
      cut.membrane->field.level = level;
      auto found = finerBoxOf(source, cut);
      ASSERT_TRUE(found && found->level == 0);
      EXPECT_EQ(found->box.min % (1 << level), glm::ivec3(0));
      EXPECT_EQ(found->box.end % (1 << level), glm::ivec3(0));
      glm::dmat4 worldFromLocal = scene::worldFromCut(cut);
      for (int corner = 0; corner < 8; ++corner) {
        glm::dvec3 local = 0.5 * cut.size * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        glm::dvec3 voxel(worldFromLocal * glm::dvec4(local, 1.0));
        EXPECT_TRUE(glm::all(glm::greaterThan(voxel - 8.0, glm::dvec3(found->box.min))));
        EXPECT_TRUE(glm::all(glm::lessThan(voxel + 8.0, glm::dvec3(found->box.end))));
      }
    }
}

TEST(FinerSource, ThereIsNoneWhereNothingFinerIsToBeHad) {
  PotentialSource source = endless(2048, 5);
  EXPECT_FALSE(finerBoxOf(source, frameAt({1e5, 0, 0}, {50, 50, 20}))) << "beside the data";
  source.volume = Shared<Volume>(makeVolume({8, 8, 8}, SampleType::UInt8, [](glm::ivec3) { return 1.0; }));
  EXPECT_FALSE(finerBoxOf(source, frameAt({4, 4, 4}, {5, 5, 3}))) << "in memory as a whole";
}

TEST(FinerSource, HasTheVoxelsOfItsLevel) {
  Volume volume = makeVolume({90, 70, 50}, SampleType::UInt16,
                             [](glm::ivec3 p) { return double((p.x * 31 + p.y * 17 + p.z * 57) % 4001); });
  auto pyramid = std::make_shared<PyramidSource>(volume, 3, glm::ivec3(24, 16, 40));
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(streamedVolume(pyramid, 2));
  PotentialSource source = sourceOf(scene);
  EXPECT_EQ(source.level, 2);
  scene::Cut cut = frameAt({40, 30, 25}, {30, 20, 8});
  auto box = finerBoxOf(source, cut);
  ASSERT_TRUE(box);
  Progress progress;
  PotentialSource finer = finerSource(source, *box, progress);
  EXPECT_EQ(finer.level, 0);
  EXPECT_EQ(finer.dims, box->box.end - box->box.min);
  for (glm::ivec3 at(0); at.z < finer.dims.z; ++at.z)
    for (at.y = 0; at.y < finer.dims.y; ++at.y)
      for (at.x = 0; at.x < finer.dims.x; ++at.x)
        ASSERT_EQ(valueAt(*finer.volume, at), valueAt(volume, box->box.min + at));
  EXPECT_EQ(glm::dvec3(finer.worldFromVoxel[3]),
            glm::dvec3(volume.worldFromVoxel * glm::dvec4(glm::dvec3(box->box.min), 1.0)));
  pyramid->damaged = true;
  EXPECT_THROW(finerSource(sourceOf([&] {
                             scene.volume.data = Shared<Volume>(streamedVolume(pyramid, 2));
                             return scene;
                           }()),
                           *box, progress),
               InputError);
  // Without values nothing is read.
  cut.membrane->field.byValue.clear();
  pyramid->reads = 0;
  auto ofLabels = finerBoxOf(source, cut);
  ASSERT_TRUE(ofLabels && !ofLabels->holdsValues);
  EXPECT_FALSE(finerSource(source, *ofLabels, progress).volume);
  EXPECT_EQ(pyramid->reads, 0);
}

}  // namespace
}  // namespace velum::membrane
