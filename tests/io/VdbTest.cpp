#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/LevelSetSphere.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>

#include "Damage.h"
#include "PeakMemory.h"
#include "TestFiles.h"
#include "core/Error.h"

namespace velum::io {
namespace {

/// A block of values with some inactive ones in it, a tile, and a transform of its own.
openvdb::FloatGrid::Ptr someGrid(float background = 0.5f) {
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(background);
  auto access = grid->getAccessor();
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x)
        if ((x + y + z) % 3) access.setValue({x, y, z}, float(x + 32 * y) / 4 + float(z) * 256);
  for (int i = 0; i < 20; ++i) access.setValueOff({i, 3, 0}, i % 2 ? -7.0f : 9.0f);
  grid->setName("density");
  openvdb::math::Mat4d m(0.0, 2.0, 0.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 10.0, 20.0, 30.0, 1.0);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(m));
  return grid;
}

void writeGrids(const std::filesystem::path& path, const openvdb::GridPtrVec& grids,
                std::uint32_t compression = openvdb::io::COMPRESS_BLOSC | openvdb::io::COMPRESS_ACTIVE_MASK) {
  openvdb::io::File file(path.string());
  file.setCompression(compression);
  file.write(grids);
}

void expectGrid(const Volume& v, const openvdb::FloatGrid& grid, double tolerance) {
  ASSERT_EQ(v.dims, glm::ivec3(20, 20, 20));
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x)
        ASSERT_NEAR(valueAt(v, {x, y, z}), double(grid.tree().getValue({x, y, z})), tolerance) << x << y << z;
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(0, 2, 0, 0));
  EXPECT_EQ(v.worldFromVoxel[3], glm::dvec4(10, 20, 30, 1));
  EXPECT_EQ(v.name, "density");
}

TEST(Vdb, EveryCompressionIsRead) {
  using namespace openvdb::io;
  TempFolder folder;
  for (std::uint32_t packing : {COMPRESS_NONE, COMPRESS_ZIP, COMPRESS_BLOSC})
    for (std::uint32_t mask : {0u, std::uint32_t(COMPRESS_ACTIVE_MASK)})
      for (bool isHalf : {false, true}) {
        SCOPED_TRACE(testing::Message() << packing << mask << isHalf);
        auto grid = someGrid();
        grid->setSaveFloatAsHalf(isHalf);
        writeGrids(folder / "a.vdb", {grid}, packing | mask);
        expectGrid(read(folder / "a.vdb"), *grid, isHalf ? 4.0 : 0.0);
      }
}

TEST(Vdb, TheGridOfFloatsIsFoundAmongOthers) {
  TempFolder folder;
  auto grid = someGrid();
  auto vectors = openvdb::Vec3SGrid::create();
  vectors->tree().setValue({1, 2, 3}, {1, 2, 3});
  vectors->setName("velocity");
  auto instance = grid->copy();
  instance->setName("again");
  writeGrids(folder / "a.vdb", {vectors, grid, instance});
  expectGrid(read(folder / "a.vdb"), *grid, 0);
  writeGrids(folder / "a.vdb", {vectors});
  try {
    read(folder / "a.vdb");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Tree_vec3s_5_4_3"), std::string::npos) << error.what();
  }
}

TEST(Vdb, EveryLinearTransformIsRead) {
  using namespace openvdb::math;
  TempFolder folder;
  for (MapBase::Ptr map :
       {MapBase::Ptr(new UniformScaleMap(2)), MapBase::Ptr(new ScaleMap({2, 3, 4})),
        MapBase::Ptr(new TranslationMap({5, 6, 7})), MapBase::Ptr(new ScaleTranslateMap({2, 3, 4}, {5, 6, 7})),
        MapBase::Ptr(new UniformScaleTranslateMap(2, {5, 6, 7})), MapBase::Ptr(new UnitaryMap({0, 0, 1}, 1.0))}) {
    SCOPED_TRACE(map->type());
    auto grid = someGrid();
    grid->setTransform(openvdb::math::Transform::Ptr(new Transform(map)));
    writeGrids(folder / "a.vdb", {grid});
    Volume v = read(folder / "a.vdb");
    Vec3d there = map->applyMap({1, 2, 3});
    glm::dvec4 ours = v.worldFromVoxel * glm::dvec4(1, 2, 3, 1);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], there[i], 1e-12);
  }
}

TEST(Vdb, ATransformInOnePlaneGivesWayToTheSpacing) {
  TempFolder folder;
  auto grid = someGrid();
  openvdb::math::Mat4d m(2.0, 0.0, 0.0, 0.0, 2.0, 1e-7, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 10.0, 20.0, 30.0, 1.0);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(m));
  writeGrids(folder / "a.vdb", {grid});
  Volume v = read(folder / "a.vdb");
  EXPECT_EQ(v.worldFromVoxel[0], glm::dvec4(2, 0, 0, 0));
  EXPECT_NEAR(v.worldFromVoxel[1].y, 2, 1e-6);
  EXPECT_FALSE(v.isOrientationKnown);
}

TEST(Vdb, AFlippedLengthAllocatesNothing) {
  TempFolder folder;
  writeGrids(folder / "a.vdb", {someGrid()});
  std::string good = bytesOf(folder / "a.vdb");
  std::size_t most = 0;
  for (std::size_t at = 8; at + 4 < good.size(); at += at < 1200 ? 1 : 97) {
    std::string bad = good;
    for (std::uint32_t value : {0x3fffffffu, 0xffffffffu}) {
      std::memcpy(bad.data() + at, &value, 4);
      writeText(folder / "b.vdb", bad);
      most = std::max(most, peakGrowth([&] {
                        try {
                          read(folder / "b.vdb");
                        } catch (const InputError&) {
                        }
                      }));
    }
  }
  EXPECT_LT(most, std::size_t(96) << 20);
}

TEST(Vdb, DamageIsReadOrRefused) {
  TempFolder folder;
  writeGrids(folder / "a.vdb", {someGrid()});
  expectReadOrRefused(bytesOf(folder / "a.vdb"), folder / "b.vdb", 500, [&] { read(folder / "b.vdb"); });
}

TEST(Vdb, ABoxThatItsVoxelsDoNotJustifyIsRefused) {
  TempFolder folder;
  auto grid = someGrid();
  grid->tree().setValue({400, 400, 400}, 1.0f);
  writeGrids(folder / "a.vdb", {grid});
  try {
    read(folder / "a.vdb");
    FAIL();
  } catch (const InputError& error) {
    std::string said = error.what();
    EXPECT_NE(said.find("401 x 401 x 401"), std::string::npos) << said;
    EXPECT_NE(said.find("1000 voxels for each active one"), std::string::npos) << said;
  }
}

TEST(Vdb, AFewTilesDoNotJustifyABox) {
  TempFolder folder;
  auto grid = someGrid();
  // Of 128 voxels a side: each a flipped bit of a mask.
  grid->tree().addTile(2, {0, 0, 128}, 1.0f, true);
  writeGrids(folder / "a.vdb", {grid});
  EXPECT_EQ(read(folder / "a.vdb").dims, glm::ivec3(128, 128, 256));
  for (int i = 0; i < 16; ++i) grid->tree().addTile(2, {i % 4 * 128, i / 4 * 128, 512}, 1.0f, true);
  writeGrids(folder / "a.vdb", {grid});
  EXPECT_THROW(read(folder / "a.vdb"), InputError);
}

TEST(Vdb, SparseGridsAreRead) {
  TempFolder folder;
  // A shell of 3 voxels about a ball: a seventieth of its box.
  auto shell = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(140, openvdb::Vec3f(0), 1.0f, 1.5f);
  writeGrids(folder / "a.vdb", {shell});
  EXPECT_GT(voxelCount(read(folder / "a.vdb")), std::size_t(1) << 24);
  // Points that were scattered, one in five thousand.
  auto points = openvdb::FloatGrid::create();
  std::mt19937 random(3);
  for (int i = 0; i < 10000; ++i)
    points->tree().setValue({int(random() % 370), int(random() % 370), int(random() % 370)}, 1.0f);
  writeGrids(folder / "a.vdb", {points});
  EXPECT_GT(voxelCount(read(folder / "a.vdb")), std::size_t(1) << 25);
}

TEST(Vdb, WhatWeWroteIsReadWhenItIsNearlyEmpty) {
  TempFolder folder;
  Volume v;
  v.dims = {300, 300, 300};
  v.voxels.assign(voxelCount(v), std::byte(0));
  v.voxels[12345] = std::byte(9);
  computeRange(v);
  write(v, folder / "a.vdb");
  EXPECT_EQ(read(folder / "a.vdb").dims, v.dims);
}

}  // namespace
}  // namespace velum::io
