#include "session/document/Body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/Error.h"
#include "scene/Scene.h"

namespace velum::session {
namespace {

enum class Part { Air, Body, Lung, Table, Cable };

/// A trunk with two lungs, on a curved table of 8 mm, and a cable in the air, millimetres from the middle.
/// @param cushion  between back and table, millimetres
Part partAt(glm::dvec3 p, double cushion) {
  auto inEllipse = [](double x, double y, double a, double b) { return x * x / (a * a) + y * y / (b * b) < 1; };
  if (inEllipse(p.x - 38, p.y, 26, 34) || inEllipse(p.x + 38, p.y, 26, 34)) return Part::Lung;
  if (inEllipse(p.x, p.y, 82, 55)) return Part::Body;
  double plate = p.y - (55 + cushion - p.x * p.x / 900.0);
  if (plate > 0 && plate < 8 && std::abs(p.x) < 110) return Part::Table;
  if (std::hypot(p.x + 60, p.y + 66) < 4) return Part::Cable;
  return Part::Air;
}

struct Case {
  glm::dvec3 spacing;
  bool isHounsfield;
  double noise;  ///< Of the range between air and tissue.
  double cushion = 12.0;
};

struct Trunk {
  Volume volume;
  std::vector<Part> parts;
};

Trunk makeTrunk(const Case& one) {
  Trunk trunk;
  Volume& v = trunk.volume;
  v.dims = glm::ivec3(glm::dvec3(240, 180, 60) / one.spacing);
  v.type = one.isHounsfield ? SampleType::Int16 : SampleType::UInt8;
  v.modality = one.isHounsfield ? Modality::CT : Modality::Unknown;
  for (int i = 0; i < 3; ++i) v.worldFromVoxel[i][i] = one.spacing[i];
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, one.noise);
  v.voxels.resize(voxelCount(v) * sampleSize(v.type));
  for (std::size_t i = 0; i < voxelCount(v); ++i) {
    glm::ivec3 voxel(int(i) % v.dims.x, int(i) / v.dims.x % v.dims.y, int(i) / v.dims.x / v.dims.y);
    Part part = partAt((glm::dvec3(voxel) + 0.5) * one.spacing - glm::dvec3(120, 80, 30), one.cushion);
    trunk.parts.push_back(part);
    double share = part == Part::Air ? 0.0 : part == Part::Lung ? 0.15 : part == Part::Body ? 1.0 : 1.3;
    share += noise(random);
    if (one.isHounsfield)
      reinterpret_cast<std::int16_t*>(v.voxels.data())[i] = std::int16_t(-1000 + 1040 * share);
    else
      reinterpret_cast<std::uint8_t*>(v.voxels.data())[i] = std::uint8_t(std::clamp(20 + 150 * share, 0.0, 255.0));
  }
  computeRange(v);
  return trunk;
}

/// Share of the voxels of a part that are not what they were.
double changed(const Trunk& trunk, const Volume& body, Part part) {
  double all = 0, other = 0;
  for (std::size_t i = 0; i < trunk.parts.size(); ++i) {
    if (trunk.parts[i] != part) continue;
    glm::ivec3 dims = body.dims, voxel(int(i) % dims.x, int(i) / dims.x % dims.y, int(i) / dims.x / dims.y);
    all += 1;
    other += valueAt(body, voxel) != valueAt(trunk.volume, voxel);
  }
  return all > 0 ? other / all : 0.0;
}

TEST(Body, KeepsTheTrunkWithItsLungsAndLeavesOutTableAndCable) {
  for (const Case& one : {Case{{2, 2, 2}, true, 0.0}, Case{{1, 1, 5}, true, 0.05}, Case{{3, 3, 3}, true, 0.05},
                          Case{{2, 2, 4}, false, 0.03}}) {
    SCOPED_TRACE(testing::Message() << one.spacing.x << " x " << one.spacing.z << " mm, noise " << one.noise);
    Trunk trunk = makeTrunk(one);
    Progress progress;
    Body body = findBody(trunk.volume, progress);
    EXPECT_EQ(changed(trunk, body.volume, Part::Body), 0.0);
    EXPECT_EQ(changed(trunk, body.volume, Part::Lung), 0.0);
    EXPECT_GT(changed(trunk, body.volume, Part::Cable), 0.98);
    EXPECT_GT(changed(trunk, body.volume, Part::Table), 0.97);
    EXPECT_GT(body.removedVolume, 0.9 * 8 * 220 * 60);
  }
}

TEST(Body, OfASeriesTheTableGoesFromEachMoment) {
  Trunk trunk = makeTrunk({{2, 2, 2}, true, 0.01});
  Volume series = trunk.volume;
  series.voxels.insert(series.voxels.end(), trunk.volume.voxels.begin(), trunk.volume.voxels.end());
  series.timeSteps = 2;
  Progress progress;
  Body one = findBody(trunk.volume, progress), both = findBody(series, progress);
  auto sizeOf = [](const Volume& volume) { return std::ptrdiff_t(volume.voxels.size()); };
  ASSERT_EQ(sizeOf(both.volume), 2 * sizeOf(one.volume));
  ASSERT_NE(one.volume.voxels, trunk.volume.voxels) << "there is a table";
  for (int moment = 0; moment < 2; ++moment)
    EXPECT_TRUE(std::equal(one.volume.voxels.begin(), one.volume.voxels.end(),
                           both.volume.voxels.begin() + moment * sizeOf(one.volume)))
        << "moment " << moment;
}

TEST(Body, LosesNothingWhereTheTableTouches) {
  Trunk trunk = makeTrunk({{2, 2, 2}, true, 0.05, 0.0});
  Progress progress;
  Body body = findBody(trunk.volume, progress);
  EXPECT_EQ(changed(trunk, body.volume, Part::Body), 0.0);
  EXPECT_EQ(changed(trunk, body.volume, Part::Lung), 0.0);
}

TEST(Body, RefusesWhereMostWouldBeHidden) {
  // Three balls of one size: none of them is the body.
  Volume volume;
  volume.dims = {96, 32, 32};
  volume.voxels.resize(voxelCount(volume));
  for (std::size_t i = 0; i < voxelCount(volume); ++i) {
    glm::dvec3 p(double(i % 96), double(i / 96 % 32), double(i / 96 / 32));
    double nearest = 1e9;
    for (double x : {16.0, 48.0, 80.0}) nearest = std::min(nearest, glm::length(p - glm::dvec3(x, 16, 16)));
    volume.voxels[i] = std::byte(nearest < 12 ? 200 : 5);
  }
  computeRange(volume);
  Progress progress;
  EXPECT_THROW(findBody(volume, progress), InputError);
}

TEST(Body, GoesAndComesBackWithTheField) {
  scene::Scene scene;
  Shared<Volume> all(makeTrunk({{3, 3, 5}, true, 0.0}).volume);
  scene.volume.data = all;
  Progress progress;
  EXPECT_EQ(settleBody(scene, progress), 0.0);
  EXPECT_EQ(scene.volume.data, all);
  scene.volume.bodyOnly = true;
  EXPECT_GT(settleBody(scene, progress), 0.0);
  EXPECT_FALSE(scene.volume.data == all);
  EXPECT_EQ(scene.volume.given, all);
  EXPECT_EQ(settleBody(scene, progress), 0.0) << "it is there already";
  scene.volume.bodyOnly = false;
  settleBody(scene, progress);
  EXPECT_EQ(scene.volume.data, all);
  EXPECT_FALSE(scene.volume.given);
}

TEST(Body, RefusesWhatHasNone) {
  Progress progress;
  Volume air;
  air.dims = {8, 8, 8};
  air.voxels.resize(512);
  std::fill(air.voxels.begin(), air.voxels.end(), std::byte{0});
  computeRange(air);
  EXPECT_THROW(findBody(air, progress), InputError);
  air.channels = 2;
  EXPECT_THROW(findBody(air, progress), InputError);
}

}  // namespace
}  // namespace velum::session
