// What becomes of all that is protected, by volume.
#include "membrane/forces/Fate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <vector>

#include "makeVolume.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

template <class IsProtected>
ProtectedVoxels voxelsOf(glm::ivec3 dims, IsProtected isProtected, const glm::dmat4& frame = glm::dmat4(1.0)) {
  ProtectedVoxels voxels{{glm::ivec3(0), dims}, {}, frame};
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) voxels.mask.push_back(isProtected(glm::ivec3(x, y, z)) ? 1 : 0);
  return voxels;
}

scene::Cut membraneAt(glm::dvec3 centre, glm::dvec3 axis = {0, 0, 1}) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = centre;
  cut.axis = axis;
  cut.size = {100, 100, 8};
  return cut;
}

Fate fateOf(const ProtectedVoxels& voxels, const scene::Cut& cut, const SideOfPoints& side = sideOfPlane()) {
  Progress progress;
  return measureFate(voxels, cut, side, progress);
}

TEST(Fate, APieceStaysOrGoesOrIsCutOff) {
  // Three bars: behind the plane, in front of it, and through it by three voxels of eight.
  auto bars = [](glm::ivec3 p) {
    bool isBehind = p.x == 2 && p.z < 4, isBefore = p.x == 5 && p.z > 12, isThrough = p.x == 8 && p.z > 4 && p.z < 13;
    return p.y == 3 && (isBehind || isBefore || isThrough);
  };
  ProtectedVoxels voxels = voxelsOf({12, 8, 18}, bars);
  Fate fate = fateOf(voxels, membraneAt({6, 4, 9.5}));
  EXPECT_TRUE(fate.isOfSomething);
  EXPECT_DOUBLE_EQ(fate.kept, 9.0 / 17.0);
  EXPECT_DOUBLE_EQ(fate.removed, 5.0 / 17.0);
  EXPECT_DOUBLE_EQ(fate.cutOff, 3.0 / 17.0);
  scene::Cut other = membraneAt({6, 4, 9.5});
  other.invert = true;
  fate = fateOf(voxels, other);
  EXPECT_DOUBLE_EQ(fate.kept, 8.0 / 17.0);
  EXPECT_DOUBLE_EQ(fate.removed, 4.0 / 17.0);
  EXPECT_DOUBLE_EQ(fate.cutOff, 5.0 / 17.0);
}

TEST(Fate, EqualsPiecesFoundByJoiningAllPairs) {
  glm::ivec3 dims(13, 11, 12);
  glm::dmat4 frame = centredFrame(dims, {1.0, 1.3, 0.8}, 0.7, {3, 4, 5});
  ProtectedVoxels voxels = voxelsOf(
      dims, [](glm::ivec3 p) { return hashNoise(p) > 0.66; }, frame);
  scene::Cut cut = membraneAt({3.1, 4.2, 5.3}, {0.3, 0.5, 0.9});
  auto height = [](glm::vec3 p) { return std::sin(p.x) * std::cos(0.8f * p.y); };
  SideOfPoints side = [&](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = local[i].z > height(local[i]);
  };
  // Each voxel takes the smallest number of those that it hangs together with, until nothing changes.
  std::size_t count = voxels.mask.size(), step[3] = {1, std::size_t(dims.x), std::size_t(dims.x * dims.y)};
  glm::dmat4 local = glm::inverse(scene::worldFromCut(cut)) * frame;
  std::vector<std::size_t> piece(count);
  std::vector<bool> stays(count);
  std::iota(piece.begin(), piece.end(), std::size_t(0));
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec4 voxel(double(i % step[1]), double(i / step[1] % std::size_t(dims.y)), double(i / step[2]), 1.0);
    glm::vec3 p(local * voxel);
    stays[i] = p.z <= height(p);
  }
  for (bool changes = true; changes;) {
    changes = false;
    for (std::size_t i = 0; i < count; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        bool isLast = int(i / step[axis]) % dims[axis] == dims[axis] - 1;
        if (isLast || !voxels.mask[i] || !voxels.mask[i + step[axis]]) continue;
        std::size_t least = std::min(piece[i], piece[i + step[axis]]);
        changes = changes || piece[i] != least || piece[i + step[axis]] != least;
        piece[i] = piece[i + step[axis]] = least;
      }
  }
  std::map<std::size_t, double> staying, whole;
  for (std::size_t i = 0; i < count; ++i)
    if (voxels.mask[i]) staying[piece[i]] += stays[i], whole[piece[i]] += 1;
  double all = 0, kept = 0, removed = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!voxels.mask[i]) continue;
    all += 1;
    kept += stays[i];
    removed += !stays[i] && staying[piece[i]] < 0.02 * whole[piece[i]];
  }
  Fate fate = fateOf(voxels, cut, side);
  EXPECT_GT(removed, 5);
  EXPECT_GT(all - kept - removed, 5);
  EXPECT_NEAR(fate.kept, kept / all, 1e-12);
  EXPECT_NEAR(fate.removed, removed / all, 1e-12);
  EXPECT_NEAR(fate.cutOff, (all - kept - removed) / all, 1e-12);
}

TEST(Fate, OfAPieceAScrapThatStaysIsNoPart) {
  // A long bar of 100 voxels of which the last one, or the last five, lie behind the plane.
  ProtectedVoxels voxels = voxelsOf({5, 5, 100}, [](glm::ivec3 p) { return p.x == 2 && p.y == 2; });
  Fate gone = fateOf(voxels, membraneAt({2, 2, 0.5})), cut = fateOf(voxels, membraneAt({2, 2, 4.5}));
  EXPECT_DOUBLE_EQ(gone.removed, 0.99);
  EXPECT_DOUBLE_EQ(gone.kept, 0.01);
  EXPECT_DOUBLE_EQ(cut.cutOff, 0.95);
  EXPECT_DOUBLE_EQ(cut.removed, 0.0);
}

TEST(Fate, OfNothingIsThatAllIsKept) {
  Fate fate = fateOf(voxelsOf({4, 4, 4}, [](glm::ivec3) { return false; }), membraneAt({2, 2, 2}));
  EXPECT_FALSE(fate.isOfSomething);
  EXPECT_EQ(fate.kept, 1.0);
}

}  // namespace
}  // namespace velum::membrane
