#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "IdSource.h"
#include "PeakMemory.h"
#include "TestFiles.h"
#include "ZarrFiles.h"
#include "core/Memory.h"
#include "io/labels/LabelBricks.h"
#include "io/labels/LabelStore.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"

namespace velum::io {
namespace {

TEST(LargeLabels, WideIdsBecomeOursAndKeepTheirNumbersHoweverBricksLie) {
  for (glm::ivec3 brick : {glm::ivec3(13, 17, 21), glm::ivec3(64), glm::ivec3(32, 32, 96)}) {
    IdSource source({101, 77, 66}, brick, blobs);
    Progress progress;
    LabelVolume labels = readLabelBricks(source, carried(), progress);
    expectIds(labels, blobs);
    // 3 and 40000 are their own ids, the others take the smallest that are left, in their order.
    ASSERT_EQ(labels.table.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(labels.table[i].id, (std::array{1, 2, 4})[i]);
      EXPECT_EQ(labels.table[i].fileId, kFirst + i);
      EXPECT_EQ(labels.table[i].name, fmt::format("segment {}", kFirst + i));
    }
    EXPECT_TRUE(labels.warnings.empty());
  }
}

TEST(LargeLabels, AStoreGivesThemWithItsNamesAndIsWrittenAgainWithThem) {
  TempFolder folder;
  IdSource source({101, 77, 66}, glm::ivec3(50), blobs);
  for (OmeVersion version : {OmeVersion::V04, OmeVersion::V05}) {
    auto first = folder / fmt::format("a{}.zarr", int(version)),
         second = folder / fmt::format("b{}.zarr", int(version));
    StoreOptions options;
    options.version = version;
    options.isLabels = options.carriesIds = true;
    options.structures = {{3, "three", {1, 0, 0}, 1}, {0, "axon", {0, 1, 0}, 1, kFirst + 1}};
    Progress progress;
    writeStore(source, first, options, progress);
    LabelVolume labels = readLabelsOf(first);
    expectIds(labels, blobs);
    writeLabelStore(labels, second, version, progress);
    LabelVolume again = readLabelsOf(second);
    expectIds(again, blobs);
    ASSERT_EQ(labels.table.size(), 5u);
    ASSERT_EQ(again.table.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(again.table[i].id, labels.table[i].id);
      EXPECT_EQ(again.table[i].fileId, labels.table[i].fileId);
      EXPECT_EQ(again.table[i].name, labels.table[i].name);
      EXPECT_LT(glm::length(again.table[i].color - labels.table[i].color), 0.01f);  // colours have 8 bits there
    }
    EXPECT_EQ(labels.table[1].name, "axon");
    EXPECT_EQ(labels.table[1].color, glm::vec3(0, 1, 0));
    EXPECT_EQ(labels.table[2].name, "three");
    // Coarser levels hold ids that are there, and no mixtures of bits.
    auto image = openImage(second, "");
    EXPECT_EQ(nameOf(image->facts().levels.back().type), "uint64");
    image->carryIds();
    ASSERT_TRUE(image->carriesIds());
    ASSERT_GT(image->levels().size(), 0u);
    Volume coarsest = readLevel(*image, int(image->levels().size()) - 1, progress);
    for (std::size_t i = 0; i < voxelCount(coarsest); ++i) {
      std::uint64_t id;
      std::memcpy(&id, coarsest.voxels.data() + i * sizeof(id), sizeof(id));
      ASSERT_TRUE(id == 0 || id == 3 || id == 40000 || (id >= kFirst && id < kFirst + 3)) << id;
    }
  }
}

TEST(LargeLabels, ArraysOfOtherProgramsWithIdsOfAllWidthsAreRead) {
  TempFolder folder;
  for (const char* type : {"uint32", "int32", "uint64", "int64", "uint16", "float32"}) {
    ZarrFile file;
    file.folder = folder / type / "labels/cells/0";
    file.shape = {9, 20, 30};
    file.chunk = {4, 7, 16};
    file.isBigEndian = true;
    file.type = type;
    std::string_view name(type);
    double wide = name.ends_with("64") ? 0x1p60 : name.ends_with("32") ? 0x1p20 : 500.0;
    auto number = [wide](glm::ivec3 p) { return (p.x / 5 + p.y / 4) % 3 == 0 ? 0.0 : wide + 4096.0 * (p.x / 10); };
    file.value = [&](const Sizes& i) { return number({int(i[2]), int(i[1]), int(i[0])}); };
    file.write();
    writeGroup(folder / type / "labels/cells", 3,
               {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {4, 2, 2})}}}}},
                {"image-label", Json::object()}});
    LabelVolume labels = readLabelsOf(folder / type / "labels/cells");
    ASSERT_EQ(labels.dims(), glm::ivec3(30, 20, 9));
    expectIds(labels, [&](glm::ivec3 p) { return std::uint64_t(number(p)); });
    EXPECT_EQ(labels.table.size(), 3u) << type;
  }
}

TEST(LargeLabels, WhatIsNoIdIsRefusedInWords) {
  TempFolder folder;
  for (auto [type, value] : {std::pair("int64", -1.0), {"int32", -7.0}, {"float32", 2.5}}) {
    ZarrFile file;
    file.folder = folder / type;
    file.shape = {3, 4, 5};
    file.chunk = {2, 2, 2};
    file.type = type;
    file.value = [value](const Sizes& i) { return i[2] == 3 ? value : 1.0; };
    file.write();
    try {
      readLabelsOf(file.folder);
      FAIL() << type;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(fmt::format("the value {}", value)), std::string::npos) << error.what();
    }
  }
}

TEST(LargeLabels, IdsThatASceneKnowsStay) {
  IdSource source({60, 50, 40}, glm::ivec3(32), blobs);
  LabelBrickOptions how = carried();
  how.known = {{kFirst + 2, 900}, {kFirst, 3}};  // 3 is an id of the file's own
  Progress progress;
  LabelVolume labels = readLabelBricks(source, how, progress);
  expectIds(labels, blobs);
  auto ids = fileIds(labels);
  EXPECT_EQ(ids[900], kFirst + 2);
  EXPECT_EQ(ids[1], kFirst);
}

TEST(LargeLabels, OfTooManyTheLargestAreTakenAndThatIsSaid) {
  // 80000 ids in pieces of 1, 2 or 4 voxels: those of one voxel have no room.
  auto value = [](glm::ivec3 p) {
    std::uint64_t piece = std::uint64_t(p.x / 4) + 50u * std::uint64_t(p.y) + 50u * 40u * std::uint64_t(p.z);
    int in = p.x % 4;
    return piece % 4 == 0   ? kFirst + 4 * piece
           : piece % 4 == 1 ? kFirst + 4 * piece + std::uint64_t(in / 2)
                            : kFirst + 4 * piece + std::uint64_t(in);
  };
  IdSource source({200, 40, 16}, {37, 40, 8}, value);
  std::map<std::uint64_t, int> sizes;
  glm::ivec3 p;
  for (p.z = 0; p.z < 16; ++p.z)
    for (p.y = 0; p.y < 40; ++p.y)
      for (p.x = 0; p.x < 200; ++p.x) ++sizes[value(p)];
  ASSERT_GT(sizes.size(), 65535u);
  LabelBrickOptions how = carried();
  std::uint64_t small = 0;
  for (auto [id, size] : sizes)
    if (size == 1) small = id;  // the last of all, but somebody knows it
  how.known = {{small, 77}};
  Progress progress;
  LabelVolume labels = readLabelBricks(source, how, progress);
  EXPECT_EQ(labels.table.size(), 65535u);
  ASSERT_EQ(labels.warnings.size(), 1u);
  EXPECT_NE(labels.warnings[0].find(fmt::format("it has {} ids, and 65535", sizes.size())), std::string::npos)
      << labels.warnings[0];
  auto ids = fileIds(labels);
  EXPECT_EQ(ids[77], small);
  for (p.z = 0; p.z < 16; ++p.z)
    for (p.y = 0; p.y < 40; ++p.y)
      for (p.x = 0; p.x < 200; ++p.x) {
        int id = labels.at(p);
        if (id != 0) {
          ASSERT_EQ(ids[id], value(p));
        } else {
          ASSERT_EQ(sizes[value(p)], 1);
        }
      }
}

TEST(LargeLabels, WhatDoesNotFitIsReadCoarserAndThatIsSaid) {
  TempFolder folder;
  IdSource source({200, 150, 120}, glm::ivec3(50), blobs);
  StoreOptions options;
  options.isLabels = options.carriesIds = true;
  Progress progress;
  writeStore(source, folder / "a.zarr", options, progress);
  auto image = openImage(folder / "a.zarr", "");
  image->carryIds();
  ASSERT_GT(image->levels().size(), 1u);
  LabelBrickOptions how = carried();
  how.worldFromFinest = glm::dmat4(3.0);
  how.worldFromFinest[3][3] = 1.0;
  how.mostBytes = 2e6;
  LabelVolume labels = readLabelBricks(*image, how, progress);
  EXPECT_EQ(labels.dims(), image->levels()[1].dims);
  ASSERT_EQ(labels.warnings.size(), 1u);
  EXPECT_NE(labels.warnings[0].find("read at a coarser level, 100 x 75 x 60 voxels"), std::string::npos)
      << labels.warnings[0];
  Volume level = readLevel(*image, 1, progress);
  auto bits = [&](glm::ivec3 p) {
    std::uint64_t id;
    std::size_t at = (std::size_t(p.z) * std::size_t(level.dims.y) + std::size_t(p.y)) * std::size_t(level.dims.x);
    std::memcpy(&id, level.voxels.data() + (at + std::size_t(p.x)) * sizeof(id), sizeof(id));
    return id;
  };
  expectIds(labels, bits);
  EXPECT_NEAR(labels.worldFromVoxel()[3][0], 1.5, 1e-12);  // the first centre of voxels twice as long
  EXPECT_NEAR(labels.worldFromVoxel()[0][0], 6.0, 1e-12);
  // Without levels the same comes of halving.
  LabelVolume halved = readLabelBricks(source, how, progress);
  EXPECT_EQ(halved.dims(), labels.dims());
  EXPECT_NE(halved.warnings.at(0).find("halved to 100 x 75 x 60 voxels"), std::string::npos) << halved.warnings[0];
  expectIds(halved, bits);
  expectSameMatrix(halved.worldFromVoxel(), labels.worldFromVoxel(), 1e-12);
  // Or of a level that is asked for.
  how.mostBytes = 1e12;
  how.level = 1;
  expectIds(readLabelBricks(*image, how, progress), bits);
  // And again and again.
  how.level = 0;
  how.mostBytes = 1e5;
  LabelVolume quarter = readLabelBricks(source, how, progress);
  EXPECT_LT(quarter.dims().x, 100);
  EXPECT_LE(double(quarter.storedBytes()), how.mostBytes);
}

TEST(LargeLabels, SparseOnesOfAnySizeOpenInLittleMemory) {
  TempFolder folder;
  ZarrFile file;
  file.folder = folder / "labels/one/0";
  file.shape = {8192, 8192, 8192};
  file.chunk = {128, 128, 128};
  file.shard = {1024, 1024, 1024};
  file.type = "uint64";
  file.codec = "zstd";
  file.value = [](const Sizes& i) { return i[0] % 128 < 40 ? 0x1p60 : 0.0; };
  file.isThere = [](const Sizes& i) { return i == Sizes{13, 21, 34}; };
  file.write();
  writeGroup(folder / "labels/one", 3,
             {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {1, 1, 1})}}}}},
              {"image-label", Json::object()}});
  LabelVolume labels;
  std::size_t peak = peakGrowth([&] { labels = readLabelsOf(folder / "labels/one"); });
  EXPECT_LT(peak, 150u << 20);
  EXPECT_EQ(labels.dims(), glm::ivec3(8192));
  EXPECT_EQ(labels.at({34 * 128, 21 * 128, 13 * 128 + 39}), 1);
  EXPECT_EQ(labels.at({34 * 128, 21 * 128, 13 * 128 + 40}), 0);
  EXPECT_EQ(labels.storedBytes(), 16u << 16);  // the layer of bricks in which the border lies
  ASSERT_EQ(labels.table.size(), 1u);
  std::size_t copies = peakGrowth([&] {
    std::vector<LabelVolume> many(20, labels);
    EXPECT_EQ(many.back().at({34 * 128, 21 * 128, 13 * 128}), 1);
  });
  EXPECT_LT(copies, 110u << 20);  // 5 MB each
}

TEST(LargeLabels, ReadingEndsWhenSomebodyCancels) {
  IdSource source({400, 300, 200}, glm::ivec3(32), blobs);
  Progress* self = nullptr;
  Progress progress([&](double fraction, const std::string&) {
    if (fraction > 0.2) self->cancel();
  });
  self = &progress;
  EXPECT_THROW(readLabelBricks(source, carried(), progress), Cancelled);
}

TEST(LargeLabels, LayersAndWholeFilesWithWideIdsAreNamedByTheirTables) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt32, {20, 10, 5});
  auto* ids = reinterpret_cast<std::uint32_t*>(v.voxels.data());
  for (std::size_t i = 0; i < voxelCount(v); ++i) ids[i] = i % 20 < 5 ? 0 : i % 20 < 12 ? 7 : 3'000'000'000u;
  computeRange(v);
  write(v, folder / "seg.nrrd");
  writeText(folder / "seg.txt", "7 seven\n");
  LabelVolume labels = readLabelsOf(folder / "seg.nrrd");
  ASSERT_EQ(labels.table.size(), 2u);
  EXPECT_EQ(labels.table[0].fileId, 3'000'000'000u);
  EXPECT_EQ(labels.table[1].name, "seven");
  EXPECT_EQ(labels.at({15, 3, 2}), 1);
  Progress progress;
  EXPECT_TRUE(std::holds_alternative<LabelVolume>(readVoxels({.path = (folder / "seg.nrrd").string()}, progress)));
}

}  // namespace
}  // namespace velum::io
