#include "membrane/forces/KeptWhole.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "makeVolume.h"

#include "membrane/forces/Limit.h"
#include "scene/Scene.h"

namespace velum::membrane {
namespace {

const scene::ForceField kField = [] {
  scene::ForceField field;
  field.byValue = {{0.5, 100}, {2, 100}};
  return field;
}();

template <class IsProtected>
scene::Scene sceneOf(glm::ivec3 dims, IsProtected isProtected, const glm::dmat4& frame) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makeVolume(dims, SampleType::UInt8, isProtected, frame));
  return scene;
}

/// A membrane's frame that faces along a voxel axis, through the middle of the volume.
scene::Cut cutAlong(const Volume& volume, int axis, bool backwards, glm::dvec3 size, double spinDeg = 0.0) {
  scene::Cut cut;
  cut.shape = scene::CutShape::Membrane;
  cut.membrane.emplace();
  cut.centre = centreOf(volume);
  cut.axis = direction(volume)[axis] * (backwards ? -1.0 : 1.0);
  cut.spinDeg = spinDeg;
  cut.size = size;
  return cut;
}

ProtectedVoxels protectedOf(const scene::Scene& scene, const scene::Cut& cut) {
  Progress progress;
  Potential potential(scene);
  return potential.computeProtected(kField, voxelsInReach(potential, cut), progress);
}

/// A sheet z = height(x, y).
template <class Height>
SideOfPoints sheetOf(Height height) {
  return [=](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = local[i].z > height(local[i].x, local[i].y);
  };
}

KeptWhole measure(const scene::Scene& scene, const scene::Cut& cut, const SideOfPoints& side) {
  Progress progress;
  return measureKeptWhole(protectedOf(scene, cut), cut, side, 0.0, progress);
}

TEST(KeptWhole, CountsPairsLikeAPlainLoop) {
  glm::ivec3 dims(17, 14, 15);
  glm::dmat4 frame = centredFrame(dims, {1.0, 1.5, 0.7}, 0.9, {4, 5, 6});
  auto scene = sceneOf(
      dims, [](glm::ivec3 v) { return hashNoise(v) > 0.4; }, frame);
  scene::Cut cut;
  cut.centre = {4.2, 5.1, 6.3};
  cut.axis = {0.3, 0.5, 0.9};
  cut.spinDeg = 33;
  cut.size = {9, 7, 5};
  auto height = [](double x, double y) { return 1.5 * std::sin(x) * std::cos(0.7 * y); };
  glm::dmat4 local = glm::inverse(scene::worldFromCut(cut)) * frame;
  std::int64_t plane = 0, sheet = 0;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 a(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y)), b = a;
      if (++b[axis] >= dims[axis] || hashNoise(a) <= 0.4 || hashNoise(b) <= 0.4) continue;
      glm::dvec3 p(local * glm::dvec4(glm::dvec3(a), 1)), q(local * glm::dvec4(glm::dvec3(b), 1));
      auto inFrame = [&](glm::dvec3 r) { return glm::all(glm::lessThanEqual(glm::abs(r), cut.size * 0.5)); };
      if (!inFrame(p) && !inFrame(q)) continue;
      plane += (p.z > 0) != (q.z > 0);
      sheet += (p.z > height(p.x, p.y)) != (q.z > height(q.x, q.y));
    }
  KeptWhole result = measure(scene, cut, sheetOf(height));
  EXPECT_GT(plane, 20);
  EXPECT_EQ(result.cutAreaPlane, plane);
  EXPECT_EQ(result.cutAreaMembrane, sheet);
  EXPECT_DOUBLE_EQ(result.ratio, double(sheet) / double(plane));
}

TEST(KeptWhole, AFlatSheetHasTheRatioOne) {
  glm::ivec3 dims(12, 12, 12);
  auto scene = sceneOf(
      dims, [](glm::ivec3) { return 1; }, centredFrame(dims));
  // The rest plane passes through a layer of voxels: those count as below with both.
  auto cut = cutAlong(*scene.volume.data, 2, false, {8, 6, 4});
  cut.centre.z += 0.5;
  KeptWhole flat = measure(scene, cut, sheetOf([](double, double) { return 0.0; }));
  EXPECT_EQ(flat.cutAreaPlane, 8 * 6);
  EXPECT_EQ(flat.ratio, 1.0);
}

TEST(KeptWhole, NothingCutIsOne) {
  glm::ivec3 dims(8, 8, 8);
  auto scene = sceneOf(
      dims, [](glm::ivec3) { return 0; }, centredFrame(dims));
  auto cut = cutAlong(*scene.volume.data, 2, false, {8, 8, 8});
  EXPECT_EQ(measure(scene, cut, sheetOf([](double, double) { return 0.0; })).ratio, 1.0);
}

TEST(KeptWhole, MeanDistanceOfASheetIsTheIntegralOverItsTriangles) {
  // z = x over a frame of 4 x 2: the mean of |x| is 1, whether or not triangles cross 0.
  for (int columns : {3, 4, 7}) {
    scene::SheetShape shape{{columns, 3}, {}};
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < columns; ++x) {
        float u = -2.0f + 4.0f * float(x) / float(columns - 1);
        shape.places.push_back({u, float(y) - 1.0f, u});
      }
    EXPECT_NEAR(meanDistance(shape), 1.0, 1e-6) << columns;
  }
  EXPECT_EQ(meanDistance(scene::SheetShape()), 0.0);
}

TEST(KeptWhole, LatticeOfAnAlignedFrameIsTheVoxels) {
  glm::ivec3 dims(16, 14, 12);
  glm::dmat4 frame = centredFrame(dims, {1.0, -1.5, 0.7}, 0.6, {1, 2, 3});
  auto scene = sceneOf(
      dims, [](glm::ivec3 v) { return hashNoise(v) > 0.5; }, frame);
  const Volume& volume = *scene.volume.data;
  // A square frame, so that all 24 orientations see the same voxels when they see all of them.
  std::int64_t all = 0;
  for (int i = 0; i < dims.x * dims.y * dims.z; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 a(i % dims.x, i / dims.x % dims.y, i / (dims.x * dims.y)), b = a;
      if (++b[axis] < dims[axis]) all += hashNoise(a) > 0.5 && hashNoise(b) > 0.5;
    }
  glm::dmat3 axes = direction(volume);
  for (int axis = 0; axis < 3; ++axis)
    for (int turn = 0; turn < 8; ++turn) {
      auto cut = cutAlong(volume, axis, turn & 1, glm::dvec3(200.0));
      // Spin until the frame's x runs along another voxel axis.
      glm::dvec3 x(scene::worldFromCut(cut)[0]), y(scene::worldFromCut(cut)[1]), to = axes[(axis + 1) % 3];
      cut.spinDeg = glm::degrees(std::atan2(glm::dot(to, y), glm::dot(to, x))) + 90.0 * (turn / 2);
      CutLattice lattice = gatherLattice(protectedOf(scene, cut), cut);
      double pairs = 0.0;
      for (const auto& p : lattice.pairs)
        for (std::uint8_t halves : p) {
          EXPECT_TRUE(halves == 0 || halves == 2);
          pairs += 0.5 * halves;
        }
      EXPECT_EQ(pairs, double(all));
      EXPECT_EQ(lattice.dims.x * lattice.dims.y * lattice.dims.z, (dims.x + 2) * (dims.y + 2) * (dims.z + 2));
    }
}

TEST(KeptWhole, CountOfAnAlignedLeastCutIsItsOwn) {
  glm::ivec3 dims(20, 18, 16);
  glm::dmat4 frame = centredFrame(dims, {1.0, 1.5, 0.7}, 0.6, {1, 2, 3});
  auto scene = sceneOf(
      dims, [](glm::ivec3 v) { return hashNoise(v / 3) > 0.6; }, frame);
  for (int axis = 0; axis < 3; ++axis) {
    auto cut = cutAlong(*scene.volume.data, axis, axis == 1, {axis == 0 ? 100 : 11, 13, 9});
    cut.centre += 0.2 * glm::normalize(cut.axis);
    Progress progress;
    KeptWholeLimit limit = computeLimit(protectedOf(scene, cut), cut, progress);
    EXPECT_GT(limit.figure.cutAreaPlane, 20);
    EXPECT_LT(limit.figure.ratio, 1.0);
    EXPECT_EQ(double(limit.figure.cutAreaMembrane), limit.least.cutPairs);
    EXPECT_LE(limit.figure.meanDistance, 4.5 + 0.75);
    EXPECT_GT(limit.figure.meanDistance, 0.0);
  }
}

TEST(KeptWhole, NoSheetIsBetterThanTheLimit) {
  glm::ivec3 dims(24, 24, 20);
  auto scene = sceneOf(
      dims, [](glm::ivec3 v) { return std::hypot(v.x - 12.0, v.z - 9.0) < 4.0; }, centredFrame(dims));
  auto cut = cutAlong(*scene.volume.data, 2, false, {22, 22, 16});
  Progress progress;
  auto voxels = protectedOf(scene, cut);
  double least = computeLimit(voxels, cut, progress).figure.ratio;
  for (double rise : {1.0, 2.0, 4.0, 6.0}) {
    auto dome = sheetOf([=](double x, double y) {
      return rise * std::clamp(2.0 - std::max(std::abs(x), std::abs(y)) / 5.5, 0.0, 1.0);
    });
    EXPECT_GE(measureKeptWhole(voxels, cut, dome, 0.0, progress).ratio, least);
  }
}

TEST(KeptWhole, ThreeSharesSayWhatBecomesOfWhatThePlaneWouldCut) {
  // Three bars across the plane, of 9, 4 and 1 voxels: the sheet passes above the first, below the second, and cuts the
  // third where the plane does.
  auto width = [](glm::ivec3 p) { return p.x < 8 ? 1 : p.x < 16 ? 0 : -1; };
  auto isBar = [&](glm::ivec3 p) {
    int x = p.x % 8 - 3, reach = width(p);
    if (p.z < 4 || p.z > 10) return 0.0;
    return reach == 1   ? double(std::abs(x) <= 1 && std::abs(p.y - 3) <= 1)
           : reach == 0 ? double(x >= 0 && x <= 1 && p.y >= 3 && p.y <= 4)
                        : double(x == 0 && p.y == 3);
  };
  scene::Scene scene = sceneOf({24, 8, 15}, isBar, glm::dmat4(1.0));
  scene::Cut cut = cutAlong(*scene.volume.data, 2, false, {40, 20, 20});
  KeptWhole figure = measure(scene, cut, sheetOf([&](double x, double) { return x < -4 ? 9.0 : x < 4 ? -9.0 : 0.0; }));
  EXPECT_EQ(figure.cutAreaPlane, 14);
  EXPECT_EQ(figure.cutAreaMembrane, 1);
  Shares shares = sharesOf(figure, cut);
  EXPECT_NEAR(shares.cut, 1.0 / 14.0, 1e-12);
  EXPECT_NEAR(shares.kept, 9.0 / 14.0, 1e-12);
  EXPECT_NEAR(shares.removed, 4.0 / 14.0, 1e-12);
  cut.invert = true;
  EXPECT_NEAR(sharesOf(figure, cut).removed, 9.0 / 14.0, 1e-12);
  figure.ratio = 2.0;
  EXPECT_EQ(sharesOf(figure, cut).cut, 1.0);
  EXPECT_EQ(sharesOf(figure, cut).kept, 0.0);
  EXPECT_EQ(sharesOf({}, cut).kept, 1.0) << "the plane cuts nothing";
}

TEST(KeptWhole, AnObliqueFrameHasALimitToo) {
  // A ball on an oblique rest plane: the sheet can go around it.
  glm::ivec3 dims(40, 40, 40);
  auto scene = sceneOf(
      dims, [](glm::ivec3 v) { return glm::length(glm::dvec3(v) - 19.5) < 6.0; }, centredFrame(dims));
  auto cut = cutAlong(*scene.volume.data, 2, false, {30, 30, 20});
  cut.axis = {0.4, -0.3, 0.8};
  cut.spinDeg = 20;
  Progress progress;
  KeptWholeLimit limit = computeLimit(protectedOf(scene, cut), cut, progress);
  EXPECT_GT(limit.figure.cutAreaPlane, 100);
  EXPECT_EQ(limit.figure.cutAreaMembrane, 0);
}

TEST(KeptWhole, FramesBesideTheDataAreNoTrouble) {
  glm::ivec3 dims(8, 8, 8);
  auto scene = sceneOf(
      dims, [](glm::ivec3) { return 1; }, centredFrame(dims));
  for (double away : {3.0, 6.0, 20.0, 1e7})
    for (int axis = 0; axis < 3; ++axis) {
      auto cut = cutAlong(*scene.volume.data, 2, false, {10, 10, 10});
      cut.centre[axis] += away;
      Progress progress;
      KeptWholeLimit limit = computeLimit(protectedOf(scene, cut), cut, progress);
      EXPECT_LE(limit.figure.ratio, 1.0);
    }
}

TEST(Limit, TheMeanDistanceIsOfTheMiddleBetweenTheLayersThatTheSheetPasses) {
  CutLattice lattice;
  lattice.dims = {2, 2, 9};
  lattice.restLayer = 3.5;
  lattice.origin = {0, 0, -7};
  lattice.step = {1.5, 1, 2};
  LeastCut least;
  least.dims = {2, 2};
  // One column lies on the rest plane, one a layer higher, one two lower, one four higher.
  least.below = {4, 5, 2, 8};
  ASSERT_EQ(flatCount(lattice), 4);
  scene::Cut cut;
  cut.size = {3, 2, 18};
  EXPECT_NEAR(meanDistance(lattice, least, cut), (0.0 + 2.0 + 4.0 + 8.0) / 4.0, 1e-9);
  cut.size = {6, 2, 18};
  EXPECT_NEAR(meanDistance(lattice, least, cut), 14.0 / 8.0, 1e-9) << "beyond the data it is flat";
}

}  // namespace
}  // namespace velum::membrane
