// Labels that were brought onto a finer grid by the nearest voxel, against the shapes that they are of.
#include "core/SmoothLabels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/Error.h"

namespace velum {

namespace {

using IdAt = std::function<int(glm::dvec3)>;

std::vector<std::uint16_t> idsOf(const LabelVolume& labels) {
  std::vector<std::uint16_t> ids(std::size_t(labels.dims().x) * std::size_t(labels.dims().y) *
                                 std::size_t(labels.dims().z));
  labels.read(glm::ivec3(0), labels.dims(), ids);
  return ids;
}

LabelVolume labelsOf(glm::ivec3 dims, const IdAt& idAt, glm::dvec3 spacing = glm::dvec3(1.0)) {
  glm::dmat4 worldFromVoxel(1.0);
  for (int axis = 0; axis < 3; ++axis) worldFromVoxel[axis][axis] = spacing[axis];
  LabelVolume labels(dims, worldFromVoxel);
  std::vector<std::uint16_t> ids;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) ids.push_back(std::uint16_t(idAt({x, y, z})));
  labels.write(glm::ivec3(0), dims, ids);
  return labels;
}

/// As a coarser grid has it, whose voxels are so many of this one's along each axis.
IdAt inBlocks(IdAt idAt, glm::dvec3 block) {
  return [idAt, block](glm::dvec3 voxel) { return idAt((glm::floor((voxel + 0.5) / block) + 0.5) * block - 0.5); };
}

IdAt ball(glm::dvec3 middle, double radius, int id = 1) {
  return [=](glm::dvec3 voxel) { return glm::length(voxel - middle) <= radius ? id : 0; };
}

LabelVolume smoothed(const LabelVolume& labels, std::vector<ShapeSmoothing> smoothings) {
  Progress progress;
  return smoothLabels(labels, smoothings, progress);
}

std::size_t countOf(const LabelVolume& labels, int id) {
  auto ids = idsOf(labels);
  return std::size_t(std::count(ids.begin(), ids.end(), std::uint16_t(id)));
}

/// Voxels that two label volumes give to different structures.
std::size_t differences(const LabelVolume& a, const LabelVolume& b) {
  auto first = idsOf(a), second = idsOf(b);
  std::size_t count = 0;
  for (std::size_t i = 0; i < first.size(); ++i) count += first[i] != second[i];
  return count;
}

}  // namespace

TEST(SmoothLabels, BringBackWhatBlocksTookFromABall) {
  for (double radius : {9.0, 16.0, 22.0})
    for (double block : {1.6, 2.0, 3.0}) {
      glm::ivec3 dims(56, 54, 58);
      IdAt truth = ball({27.3, 26.8, 28.4}, radius);
      LabelVolume fine = labelsOf(dims, truth), blocks = labelsOf(dims, inBlocks(truth, glm::dvec3(block)));
      LabelVolume smooth = smoothed(blocks, {{1, block}});
      EXPECT_LT(double(differences(smooth, fine)), 0.6 * double(differences(blocks, fine)))
          << radius << " in blocks of " << block;
      EXPECT_NEAR(double(countOf(smooth, 1)), double(countOf(blocks, 1)), 0.016 * double(countOf(blocks, 1)))
          << radius << " in blocks of " << block;
    }
}

TEST(SmoothLabels, KeepWhatIsOneBlockThin) {
  glm::ivec3 dims(48);
  LabelVolume plate = labelsOf(dims, [](glm::dvec3 v) { return v.z >= 20 && v.z < 22 ? 1 : 0; });
  EXPECT_EQ(differences(smoothed(plate, {{1, 2.0}}), plate), 0u);
  LabelVolume rod = labelsOf(dims, [](glm::dvec3 v) { return v.z >= 20 && v.z < 22 && v.y >= 8 && v.y < 10 ? 1 : 0; });
  EXPECT_EQ(differences(smoothed(rod, {{1, 2.0}}), rod), 0u);
  // A gap between two as well.
  LabelVolume gap = labelsOf(dims, [](glm::dvec3 v) { return v.z < 20 ? 1 : v.z < 22 ? 0 : 2; });
  EXPECT_EQ(differences(smoothed(gap, {{1, 2.0}, {2, 2.0}}), gap), 0u);
}

TEST(SmoothLabels, LeaveOthersAsTheyAreAndNoGapBeside) {
  glm::ivec3 dims(48);
  auto both = [](glm::dvec3 v) {
    if (v.x + 0.4 * v.y > 34) return 2;  // one that is not named, of single voxels
    return glm::length(v - glm::dvec3(20, 24, 24)) < 15 ? 1 : 0;
  };
  auto blocks = [&](glm::dvec3 v) { return both(v) == 2 ? 2 : inBlocks(both, glm::dvec3(2))(v) == 1 ? 1 : 0; };
  LabelVolume labels = labelsOf(dims, blocks), smooth = smoothed(labels, {{1, 2.0}});
  auto before = idsOf(labels), after = idsOf(smooth);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(before[i] == 2, after[i] == 2) << i;
    // Deep in the ball nothing opens along the other.
    glm::dvec3 voxel(double(i % 48), double(i / 48 % 48), double(i / (48 * 48)));
    bool isDeep = glm::length(voxel - glm::dvec3(20, 24, 24)) < 12;
    EXPECT_FALSE(isDeep && before[i] == 1 && after[i] != 1) << i;
  }
}

TEST(SmoothLabels, TwoSideBySideShareABorder) {
  glm::ivec3 dims(48);
  IdAt halves = [](glm::dvec3 v) {
    if (glm::length(v - glm::dvec3(23.5)) > 17) return 0;
    return v.x + 0.6 * v.y - 0.3 * v.z < 31 ? 1 : 2;
  };
  LabelVolume labels = labelsOf(dims, inBlocks(halves, glm::dvec3(2)));
  auto after = idsOf(smoothed(labels, {{1, 2.0}, {2, 2.0}}));
  std::size_t holes = 0;
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x)
        holes += glm::length(glm::dvec3(x, y, z) - glm::dvec3(23.5)) < 13 &&
                 after[(std::size_t(z) * 48 + std::size_t(y)) * 48 + std::size_t(x)] == 0;
  EXPECT_EQ(holes, 0u);
}

TEST(SmoothLabels, GoWithTheGridWhenItTurns) {
  IdAt shape = [](glm::dvec3 v) {
    if (glm::length((v - glm::dvec3(20, 22, 18)) / glm::dvec3(12, 8, 10)) < 1) return 1;
    return glm::length(v - glm::dvec3(30, 22, 20)) < 7 ? 2 : 0;
  };
  LabelVolume labels = labelsOf({44, 44, 44}, inBlocks(shape, glm::dvec3(2)));
  auto turned = [](const LabelVolume& of) {
    return labelsOf({44, 44, 44}, [&](glm::dvec3 v) { return int(of.at({int(v.y), 43 - int(v.x), int(v.z)})); });
  };
  std::vector<ShapeSmoothing> smoothings{{1, 2.0}, {2, 2.0}};
  // Sums are made in another order: what stands at a tie may go either way.
  EXPECT_LE(differences(turned(smoothed(labels, smoothings)), smoothed(turned(labels), smoothings)), 2u);
}

TEST(SmoothLabels, MeasureLengthsInTheWorld) {
  IdAt truth = ball({23.5, 23.5, 11.5}, 10);
  LabelVolume even = labelsOf({48, 48, 24}, truth), wide = labelsOf({48, 48, 24}, truth, glm::dvec3(2.0));
  EXPECT_EQ(idsOf(smoothed(even, {{1, 1.5}})), idsOf(smoothed(wide, {{1, 3.0}})));
  // A voxel is larger than the Gaussian along z: nothing crosses from plane to plane.
  IdAt plates = [](glm::dvec3 v) { return int(v.z) % 2; };
  LabelVolume thick = labelsOf({32, 32, 24}, plates, {1, 1, 10});
  EXPECT_EQ(differences(smoothed(thick, {{1, 1.5}}), thick), 0u);
}

TEST(SmoothLabels, KeepBricksThatAreFarFromTheirBorders) {
  LabelVolume labels = labelsOf({128, 64, 64}, inBlocks(ball({16, 16, 16}, 9), glm::dvec3(2)));
  LabelVolume smooth = smoothed(labels, {{1, 2.0}});
  EXPECT_NE(smooth.brickId({0, 0, 0}), labels.brickId({0, 0, 0}));
  EXPECT_EQ(smooth.brickId({3, 1, 1}), labels.brickId({3, 1, 1}));
}

TEST(SmoothLabels, SayWhatTheyCannotDo) {
  LabelVolume labels = labelsOf({8, 8, 8}, ball({4, 4, 4}, 3));
  EXPECT_THROW(smoothed(labels, {{1, 0.0}}), ArgumentError);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(smoothLabels(labels, std::vector<ShapeSmoothing>{{1, 1.0}}, progress), Cancelled);
}

TEST(LabelBlocks, AreFoundWhereAFinerGridWasFilled) {
  IdAt truth = ball({40, 41, 39}, 30);
  for (glm::dvec3 block : {glm::dvec3(2.0), glm::dvec3(1.53, 1.53, 1.0), glm::dvec3(3.0, 3.0, 2.0), glm::dvec3(2.14)}) {
    auto found = findBlocks(labelsOf({80, 80, 80}, inBlocks(truth, block)));
    ASSERT_EQ(found.size(), 1u) << block.x;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[0].size[axis], block[axis], 0.02) << block.x;
  }
}

TEST(LabelBlocks, AreNotSeenInShapesOfVoxels) {
  for (double radius : {4.0, 9.0, 30.0})
    EXPECT_TRUE(findBlocks(labelsOf({80, 80, 80}, ball({40, 41, 39}, radius))).empty());
  // A box has no more than two steps an axis; slices that were doubled are blocks along one axis only.
  EXPECT_TRUE(findBlocks(labelsOf({40, 40, 40}, [](glm::dvec3 v) {
                return glm::all(glm::lessThan(glm::abs(v - 20.0), glm::dvec3(9))) ? 1 : 0;
              })).empty());
  EXPECT_TRUE(findBlocks(labelsOf({80, 80, 80}, inBlocks(ball({40, 41, 39}, 30), {1, 1, 3}))).empty());
}

TEST(LabelBlocks, AreEachStructuresOwn) {
  auto mixed = [](glm::dvec3 v) {
    if (inBlocks(ball({26, 26, 26}, 20), glm::dvec3(2))(v)) return 5;
    return ball({60, 60, 60}, 15, 9)(v);
  };
  auto found = findBlocks(labelsOf({80, 80, 80}, mixed));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].id, 5);
}

}  // namespace velum
