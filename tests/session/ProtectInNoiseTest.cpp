#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "io/phantoms/Sample.h"
#include "membrane/forces/Kernels.h"
#include "scene/Scene.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::session {
namespace {

Progress sProgress;

/// A share of what two sets of voxels hold together: 1 where they are the same.
double diceOf(const std::vector<std::uint8_t>& mask, const LabelVolume& truth) {
  glm::ivec3 n = truth.dims();
  std::size_t both = 0, found = 0, all = 0, i = 0;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x, ++i) {
        bool isTrue = truth.at({x, y, z}) != 0;
        both += isTrue && mask[i];
        found += mask[i] != 0;
        all += isTrue;
      }
  return 2.0 * double(both) / double(found + all);
}

/// Voxels of fibres spread over the data, each in the middle of one: where somebody would click.
std::vector<glm::ivec3> clicksOn(const LabelVolume& truth, int count) {
  glm::ivec3 n = truth.dims();
  std::vector<glm::ivec3> middles;
  for (int z = 2; z < n.z - 2; ++z)
    for (int y = 2; y < n.y - 2; ++y)
      for (int x = 2; x < n.x - 2; ++x) {
        bool isMiddle = truth.at({x, y, z}) != 0;
        for (int axis = 0; axis < 3 && isMiddle; ++axis)
          for (int side : {-1, 1}) {
            glm::ivec3 p(x, y, z);
            p[axis] += side;
            isMiddle = isMiddle && truth.at(p) != 0;
          }
        if (isMiddle) middles.push_back({x, y, z});
      }
  std::vector<glm::ivec3> clicks;
  for (int i = 0; i < count && !middles.empty(); ++i)
    clicks.push_back(middles[(std::size_t(i) * 2 + 1) * middles.size() / (std::size_t(count) * 2)]);
  return clicks;
}

class ProtectInNoise : public ::testing::Test {
 protected:
  void make(int size, double contrast) {
    io::Sample sample = io::makeSample("fibres", size, sProgress, 0, contrast);
    mScene.volume.data = Shared<Volume>(std::move(sample.volume));
    mTruth = std::move(sample.labels);
    mPotential.emplace(mScene);
  }
  glm::dvec3 worldOf(glm::ivec3 voxel) const {
    return {mScene.volume.data->worldFromVoxel * glm::dvec4(glm::dvec3(voxel), 1.0)};
  }
  std::vector<std::uint8_t> protectedBy(const scene::ForceField& field) const {
    return mPotential->computeProtected(field, {{0, 0, 0}, mPotential->dims()}, sProgress).mask;
  }
  /// No fibre is next to it: noise alone.
  bool isFar(glm::ivec3 p) const {
    for (int i = 0; i < 27; ++i)
      if (mTruth.at(p + glm::ivec3(i % 3, i / 3 % 3, i / 9) - 1) != 0) return false;
    return true;
  }
  /// Voxels of the truth that are protected, and those far from it.
  std::pair<double, double> countsOf(const scene::ForceField& field) const {
    auto mask = protectedBy(field);
    double both = 0, far = 0;
    std::size_t i = 0;
    glm::ivec3 n = mTruth.dims();
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x, ++i)
          if (mask[i]) both += mTruth.at({x, y, z}) != 0, far += isFar({x, y, z});
    return {both, far};
  }
  scene::Scene mScene;
  LabelVolume mTruth;
  std::optional<membrane::Potential> mPotential;
};

TEST_F(ProtectInNoise, AClickOnAFibreTakesTheFibresAndNotTheirHaze) {
  make(128, 3.0);
  scene::ForceField first;
  for (glm::ivec3 click : clicksOn(mTruth, 12)) {
    scene::Membrane membrane;
    auto tissue = protectTissue(membrane, mScene.volume, worldOf(click));
    ASSERT_TRUE(tissue);
    EXPECT_TRUE(membrane.field.denoise);
    if (membrane.field == first) continue;  // most clicks find the same border
    if (first.byValue.empty()) first = membrane.field;
    EXPECT_GT(diceOf(protectedBy(membrane.field), mTruth), 0.8) << tissue->value;
  }
}

TEST_F(ProtectInNoise, NoThresholdOnSingleVoxelsDoesThat) {
  make(128, 3.0);
  double best = 0.0;
  for (double low = 1100.0; low < 1400.0; low += 20.0) {
    scene::Membrane membrane;
    protectValues(membrane, low, 1e5);
    best = std::max(best, diceOf(protectedBy(membrane.field), mTruth));
  }
  EXPECT_LT(best, 0.72);
}

TEST_F(ProtectInNoise, SpecksAreLeftOutAndFibresStay) {
  make(128, 4.0);
  scene::ForceField field;
  field.byValue = {{1230.0, 100.0}, {1e5, 100.0}};
  scene::ForceField all = field;
  all.leastPiece = 1;
  auto [fibresLeft, specksLeft] = countsOf(field);
  auto [fibres, specks] = countsOf(all);
  EXPECT_GT(fibresLeft, 0.95 * fibres);
  EXPECT_LT(specksLeft, 0.2 * specks) << specks;
  auto leftOut = mPotential->computeLeftOut(field, sProgress);
  EXPECT_GT(leftOut.leastPiece, 2);
  EXPECT_GT(double(leftOut.voxels), 0.8 * specks);
}

TEST_F(ProtectInNoise, WhatStandsOutIsNotCalmed) {
  make(128, 20.0);
  scene::Membrane membrane;
  ASSERT_TRUE(protectTissue(membrane, mScene.volume, worldOf(clicksOn(mTruth, 1).front())));
  EXPECT_FALSE(membrane.field.denoise);
}

// At values that tell their structures apart; in the noise of one of them there are specks.
TEST(LeastPiece, PhantomsCutBetweenTheirMaterialsLoseNothing) {
  for (const char* name : {"two-spheres", "vessels"}) {
    scene::Scene scene;
    io::Sample sample = io::makeSample(name, 64, sProgress);
    scene.volume.data = Shared<Volume>(std::move(sample.volume));
    membrane::Potential potential(scene);
    glm::dvec2 range = scene.volume.data->range;
    for (double share : {0.25, 0.3, 0.35, 0.4}) {
      scene::ForceField field;
      field.byValue = {{range.x + share * (range.y - range.x), 100.0}, {range.y, 100.0}};
      EXPECT_EQ(potential.computeLeftOut(field, sProgress).pieces, 0u) << name << " above " << share;
    }
  }
}

}  // namespace
}  // namespace velum::session
