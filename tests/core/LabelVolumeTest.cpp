#include "core/LabelVolume.h"

#include <gtest/gtest.h>

#include <random>

#include "core/Error.h"
#include "core/Memory.h"

namespace velum {
namespace {

TEST(LabelVolume, WhatIsWrittenIsRead) {
  glm::ivec3 dims(70, 33, 40);
  LabelVolume labels(dims, glm::dmat4(1.0));
  std::vector<std::uint16_t> plain(std::size_t(dims.x * dims.y * dims.z), 0);
  std::mt19937 random(7);
  for (int turn = 0; turn < 40; ++turn) {
    glm::ivec3 origin(int(random() % 70), int(random() % 33), int(random() % 40));
    glm::ivec3 size = glm::min(dims - origin, glm::ivec3(1 + int(random() % 40)));
    std::vector<std::uint16_t> box(std::size_t(size.x * size.y * size.z));
    bool uniform = turn % 2;
    for (auto& id : box) id = uniform ? std::uint16_t(turn) : std::uint16_t(random() % 65536);
    labels.write(origin, size, box);
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
          plain[std::size_t(((origin.z + z) * dims.y + origin.y + y) * dims.x + origin.x + x)] =
              box[std::size_t((z * size.y + y) * size.x + x)];
  }
  std::vector<std::uint16_t> back(plain.size());
  labels.read(glm::ivec3(0), dims, back);
  EXPECT_EQ(back, plain);
  EXPECT_EQ(labels.at({69, 32, 39}), plain.back());
  EXPECT_EQ(labels.at({70, 0, 0}), 0);
}

TEST(LabelVolume, OutsideOfItThereIsNoLabel) {
  // No edge is a multiple of a brick's.
  glm::ivec3 dims(70, 33, 41);
  LabelVolume labels(dims, glm::dmat4(1.0));
  std::vector<std::uint16_t> all(std::size_t(dims.x * dims.y * dims.z), 7);
  labels.write(glm::ivec3(0), dims, all);
  EXPECT_EQ(labels.at(dims - 1), 7);
  for (int axis = 0; axis < 3; ++axis)
    for (int off : {-1, dims[axis], dims[axis] + 1, dims[axis] + 100}) {
      glm::ivec3 p(5);
      p[axis] = off;
      EXPECT_EQ(labels.at(p), 0) << p.x << ", " << p.y << ", " << p.z;
    }
}

TEST(LabelVolume, AFilledBrickIsThatOfAWrittenOneAndChangesNoCopy) {
  glm::ivec3 dims(150, 140, 70), corner(128, 128, 64), size = dims - corner;
  LabelVolume written(dims, glm::dmat4(1.0)), filled = written;
  std::vector<std::uint16_t> ids(std::size_t(size.x * size.y * size.z), 9);
  written.write(corner, size, ids);
  LabelVolume before = filled;
  filled.fillBrick(corner / 32, 9);
  EXPECT_EQ(filled.storedBytes(), 0u);
  EXPECT_EQ(filled.idsInUse(), std::vector<std::uint16_t>{9});
  EXPECT_TRUE(before.idsInUse().empty());
  std::vector<std::uint16_t> a(std::size_t(dims.x * dims.y * dims.z)), b = a;
  written.read(glm::ivec3(0), dims, a);
  filled.read(glm::ivec3(0), dims, b);
  EXPECT_EQ(a, b);
  std::uint64_t id = filled.brickId(corner / 32);
  filled.fillBrick(corner / 32, 9);
  EXPECT_EQ(filled.brickId(corner / 32), id) << "its ids have not changed";
}

TEST(LabelVolume, AGridOfAnySizeCostsWhatIsWrittenToIt) {
  std::size_t before = allocatedBytes();
  LabelVolume labels(glm::ivec3(8192), glm::dmat4(1.0));
  std::uint16_t id = 3;
  labels.write({8191, 4000, 77}, {1, 1, 1}, {&id, 1});
  std::vector<LabelVolume> copies(10, labels);
  for (LabelVolume& copy : copies) copy.write({5, 6, 7}, {1, 1, 1}, {&id, 1});
  EXPECT_LT(double(allocatedBytes()) - double(before), 80e6);
  EXPECT_EQ(copies[3].at({8191, 4000, 77}), 3);
  EXPECT_EQ(labels.at({5, 6, 7}), 0);
}

TEST(LabelVolume, AnEditCostsTheBricksItTouches) {
  LabelVolume before(glm::ivec3(256), glm::dmat4(1.0));
  EXPECT_EQ(before.storedBytes(), 0u);
  LabelVolume after = before;
  std::uint16_t id = 9;
  after.write({100, 100, 100}, {1, 1, 1}, {&id, 1});
  EXPECT_EQ(before.at({100, 100, 100}), 0);
  EXPECT_EQ(after.at({100, 100, 100}), 9);
  EXPECT_EQ(after.storedBytes(), 32u * 32u * 32u * 2u);
}

TEST(LabelVolume, AFilledBrickFolds) {
  LabelVolume labels(glm::ivec3(40), glm::dmat4(1.0));
  std::vector<std::uint16_t> ids(40 * 40 * 40, 65535);
  labels.write(glm::ivec3(0), glm::ivec3(40), ids);
  EXPECT_EQ(labels.storedBytes(), 0u);
  EXPECT_EQ(labels.idsInUse(), std::vector<std::uint16_t>{65535});
}

TEST(LabelVolume, OnlyBricksThatDifferGetAnotherId) {
  glm::ivec3 dims(70, 33, 40);
  LabelVolume before(dims, glm::dmat4(1.0));
  std::vector<std::uint16_t> all(std::size_t(dims.x * dims.y * dims.z));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = std::uint16_t(i % 5);
  before.write({0, 0, 0}, dims, all);
  auto differing = [&](const LabelVolume& after) {
    std::vector<glm::ivec3> bricks;
    glm::ivec3 grid = before.brickGrid();
    for (int i = 0; i < grid.x * grid.y * grid.z; ++i) {
      glm::ivec3 at(i % grid.x, i / grid.x % grid.y, i / (grid.x * grid.y));
      if (before.brickId(at) != after.brickId(at)) bricks.push_back(at);
    }
    return bricks;
  };
  LabelVolume after = before;
  EXPECT_TRUE(differing(after).empty());
  after.write({0, 0, 0}, dims, all);
  EXPECT_TRUE(differing(after).empty()) << "the same again";
  std::uint16_t nine[] = {9};
  after.write({69, 32, 39}, {1, 1, 1}, nine);
  EXPECT_EQ(differing(after), (std::vector<glm::ivec3>{{2, 1, 1}}));
}

TEST(LabelVolume, ABoxOutsideIsRefused) {
  LabelVolume labels(glm::ivec3(8), glm::dmat4(1.0));
  std::vector<std::uint16_t> ids(27);
  EXPECT_THROW(labels.write({6, 0, 0}, {3, 3, 3}, ids), ArgumentError);
  EXPECT_THROW(labels.write({-1, 0, 0}, {3, 3, 3}, ids), ArgumentError);
}

}  // namespace
}  // namespace velum
