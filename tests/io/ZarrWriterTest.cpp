#include <gtest/gtest.h>
#include <zstd.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "GeneratedSource.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/stores/Crc32c.h"
#include "io/stores/OmeImage.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

void writeStoreOf(const Volume& v, const fs::path& path, StoreOptions options = {}) {
  Progress progress;
  writeStore(VolumeSource(v), path, options, progress);
}

Volume levelOf(const fs::path& path, int level) {
  Progress progress;
  return readLevel(*openImage(path, ""), level, progress);
}

int levelCount(const fs::path& path) { return int(openImage(path, "")->levels().size()); }

/// Brightest at a place between voxels, and falling off to nothing around it.
Volume ball(glm::ivec3 dims, glm::dvec3 spacing) {
  Volume v;
  v.dims = dims;
  v.type = SampleType::Float32;
  v.voxels.resize(timeStepBytes(v));
  v.worldFromVoxel = obliqueMatrix(false, false);
  for (int i = 0; i < 3; ++i) v.worldFromVoxel[i] *= spacing[i] / glm::length(v.worldFromVoxel[i]);
  glm::dvec3 centre = glm::dvec3(dims) * 0.47;
  auto* to = reinterpret_cast<float*>(v.voxels.data());
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        glm::dvec3 offset = (glm::dvec3(x, y, z) - centre) / (glm::dvec3(dims) * 0.1);
        *to++ = float(1000.0 * std::exp(-glm::dot(offset, offset)));
      }
  return v;
}

/// Where the mass of a level lies, in the world.
glm::dvec3 centroid(const Volume& v) {
  glm::dvec3 sum(0.0);
  double mass = 0.0;
  for (int z = 0; z < v.dims.z; ++z)
    for (int y = 0; y < v.dims.y; ++y)
      for (int x = 0; x < v.dims.x; ++x) {
        double value = valueAt(v, {x, y, z});
        sum += value * glm::dvec3(x, y, z);
        mass += value;
      }
  return glm::dvec3(v.worldFromVoxel * glm::dvec4(sum / mass, 1.0));
}

/// The samples of the level before that one sample stands for; those at the far border count twice.
std::vector<double> blockOf(const Volume& finer, glm::ivec3 factor, glm::ivec3 at, int channel, int timeStep) {
  std::vector<double> block;
  for (int z = 0; z < factor.z; ++z)
    for (int y = 0; y < factor.y; ++y)
      for (int x = 0; x < factor.x; ++x)
        block.push_back(valueAt(finer, glm::min(at * factor + glm::ivec3(x, y, z), finer.dims - 1), channel, timeStep));
  return block;
}

glm::ivec3 factorBetween(const Volume& finer, const Volume& coarser) {
  return glm::ivec3(glm::round(spacingOf(coarser) / spacingOf(finer)));
}

TEST(ZarrWriter, ReadsBackWhatItWrote) {
  TempFolder folder;
  int number = 0;
  for (SampleType type : {SampleType::UInt8, SampleType::Int8, SampleType::UInt16, SampleType::Int16,
                          SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64})
    for (glm::ivec3 dims : {glm::ivec3(1, 1, 1), glm::ivec3(131, 67, 3), glm::ivec3(65, 64, 70)})
      for (auto [channels, frames] : {std::pair(1, 1), std::pair(2, 3)})
        for (OmeVersion version : {OmeVersion::V05, OmeVersion::V04}) {
          if (version == OmeVersion::V04 && dims.z == 1) continue;
          Volume v = rampVolume(type, dims, channels, frames);
          v.worldFromVoxel = obliqueMatrix(true, true);
          v.timeStepSeconds = frames > 1 ? 0.25 : 0.0;
          v.scale = 2.5;
          v.offset = -1024;
          v.unit = "HU";
          v.modality = Modality::CT;
          StoreOptions options;
          options.version = version;
          fs::path path = folder / (std::to_string(number++) + ".ome.zarr");
          SCOPED_TRACE(path.string());
          writeStoreOf(v, path, options);
          Volume back = read(path);
          EXPECT_TRUE(back.voxels == v.voxels);
          EXPECT_EQ(back.type, v.type);
          EXPECT_EQ(back.worldFromVoxel, v.worldFromVoxel);
          EXPECT_EQ(std::tuple(back.scale, back.offset, back.unit), std::tuple(v.scale, v.offset, v.unit));
          EXPECT_EQ(back.timeStepSeconds, v.timeStepSeconds);
          EXPECT_EQ(back.modality, v.modality);
        }
}

TEST(ZarrWriter, KeepsChannelsUnitsAndPlaces) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {20, 30, 10}, 2);
  v.worldFromVoxel = glm::dmat4(0.0004, 0, 0, 0, 0, 0.0004, 0, 0, 0, 0, 0.002, 0, 0.5, -0.25, 1.5, 1);
  v.channelNames = {"nuclei", "membranes \"A\""};
  v.channelColors = {{1, 0, 0.2f}, {0, 1, 0}};
  write(v, folder / "a.zarr");
  auto source = openImage(folder / "a.zarr", "");
  EXPECT_EQ(source->head().channelNames, v.channelNames);
  EXPECT_EQ(source->head().channelColors, v.channelColors);
  EXPECT_TRUE(source->channelWindows().empty()) << "nobody chose what is written";
  OmeImage image = *readOmeImage(*openStore(folder / "a.zarr"), "");
  EXPECT_EQ(image.axes.back().unit, "micrometer");
  EXPECT_NEAR(image.levels[0].scale.back(), 0.4, 1e-12);
  EXPECT_NEAR(image.levels[0].translation.back(), 500.0, 1e-9);
  EXPECT_EQ(source->head().worldFromVoxel, v.worldFromVoxel);
}

TEST(ZarrWriter, LevelsAreMeansOfBlocks) {
  TempFolder folder;
  for (SampleType type : {SampleType::UInt8, SampleType::Int16, SampleType::UInt32, SampleType::Float32}) {
    Volume v = rampVolume(type, {301, 150, 37}, 2);
    v.worldFromVoxel = glm::dmat4(glm::dmat3(0.5, 0, 0, 0, 0.6, 0, 0, 0, 1.2));
    fs::path path = folder / (std::string(enumName(type)) + ".zarr");
    writeStoreOf(v, path);
    ASSERT_EQ(levelCount(path), 3);
    glm::ivec3 dims[] = {{301, 150, 37}, {151, 75, 37}, {76, 38, 19}};
    for (int level = 1; level < 3; ++level) {
      Volume finer = levelOf(path, level - 1), coarser = levelOf(path, level);
      ASSERT_EQ(coarser.dims, dims[level]);
      for (int c = 0; c < 2; ++c)
        for (int i = 0; i < int(voxelCount(coarser)); ++i) {
          glm::ivec3 at(i % coarser.dims.x, i / coarser.dims.x % coarser.dims.y, i / coarser.dims.x / coarser.dims.y);
          auto block = blockOf(finer, factorBetween(finer, coarser), at, c, 0);
          double sum = 0;
          for (double value : block) sum += value;
          double mean = sum / double(block.size());
          if (type != SampleType::Float32) {
            ASSERT_EQ(valueAt(coarser, at, c), std::nearbyint(mean)) << i;
          } else {
            ASSERT_NEAR(valueAt(coarser, at, c), mean, 1e-3) << i;  // a float's precision of a thousand
          }
        }
    }
  }
}

TEST(ZarrWriter, LevelsLieOnEachOther) {
  TempFolder folder;
  // Sizes that are halved without a rest: at the border of others a block stands for less than it covers.
  for (glm::dvec3 spacing : {glm::dvec3(0.5), glm::dvec3(0.5, 0.5, 2.0)}) {
    Volume v = ball({192, 160, spacing.z > 1 ? 40 : 160}, spacing);
    fs::path path = folder / (std::to_string(spacing.z) + ".zarr");
    StoreOptions options;
    writeStoreOf(v, path, options);
    ASSERT_GT(levelCount(path), 1);
    glm::dvec3 finest = centroid(levelOf(path, 0));
    for (int level = 1; level < levelCount(path); ++level)
      EXPECT_LT(glm::length(centroid(levelOf(path, level)) - finest), 0.01 * 0.5) << level;
    // By the letter of the file, without what only we know.
    OmeImage image = *readOmeImage(*openStore(path), "");
    for (const OmeLevel& level : image.levels)
      for (std::size_t axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(level.translation[axis], (level.scale[axis] - image.levels[0].scale[axis]) / 2, 1e-12);
  }
}

TEST(ZarrWriter, LabelsAreTheMostFrequentIdAndKeepTheirNames) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt16, {150, 40, 30});
  auto* ids = reinterpret_cast<std::uint16_t*>(v.voxels.data());
  for (std::size_t i = 0; i < voxelCount(v); ++i) ids[i] = std::uint16_t((i * 2654435761u >> 16) % 4 * 300);
  StoreOptions options;
  options.isLabels = true;
  options.structures = {{300, "liver, left", {1, 0, 0}, 1}, {600, "spleen", {0, 0, 1}, 1}, {900, "skin", {0, 1, 0}, 1}};
  writeStoreOf(v, folder / "a.zarr", options);
  Volume finer = levelOf(folder / "a.zarr", 0), coarser = levelOf(folder / "a.zarr", 1);
  for (int i = 0; i < int(voxelCount(coarser)); ++i) {
    glm::ivec3 at(i % coarser.dims.x, i / coarser.dims.x % coarser.dims.y, i / coarser.dims.x / coarser.dims.y);
    std::map<double, int> counts;
    for (double id : blockOf(finer, {2, 2, 2}, at, 0, 0)) ++counts[id];
    double expected = 0;
    int most = 0;
    for (auto [id, count] : counts)
      if (count > most || (count == most && expected == 0)) expected = id, most = count;
    ASSERT_EQ(valueAt(coarser, at), expected) << i;
  }
  LabelVolume labels = readLabelsOf(folder / "a.zarr");
  EXPECT_EQ(labels.table, options.structures);
}

/// By nothing but the words of the specification: the first brick of the second shard's row.
TEST(ZarrWriter, ShardsAreAsTheSpecificationSays) {
  TempFolder folder;
  GeneratedSource source({600, 130, 70}, {600, 130, 1}, noisy);
  Progress progress;
  writeStore(source, folder / "a.zarr", {}, progress);
  auto metadata = nlohmann::json::parse(bytesOf(folder / "a.zarr/0/zarr.json"));
  EXPECT_EQ(metadata["shape"], nlohmann::json({70, 130, 600}));
  EXPECT_EQ(metadata["chunk_grid"]["configuration"]["chunk_shape"], nlohmann::json({64, 192, 512}));
  EXPECT_EQ(metadata["codecs"][0]["configuration"]["chunk_shape"], nlohmann::json({64, 64, 64}));
  std::string shard = bytesOf(folder / "a.zarr/0/c/0/0/1");
  std::size_t bricks = 3 * 8, table = shard.size() - 16 * bricks - 4;
  auto number = [&](std::size_t i) {
    std::uint64_t value;
    std::memcpy(&value, shard.data() + table + 8 * i, 8);
    return value;
  };
  std::uint32_t sum;
  std::memcpy(&sum, shard.data() + shard.size() - 4, 4);
  EXPECT_EQ(sum, crc32cByTable(std::as_bytes(std::span(shard).subspan(table, 16 * bricks))));
  EXPECT_EQ(number(2 * 2), ~std::uint64_t(0)) << "the brick lies outside";
  std::size_t brick = 8;  // y 64, x 512
  std::vector<std::uint16_t> samples(64 * 64 * 64);
  ASSERT_EQ(
      ::ZSTD_decompress(samples.data(), samples.size() * 2, shard.data() + number(2 * brick), number(2 * brick + 1)),
      samples.size() * 2);
  for (int i = 0; i < 64 * 64 * 64; ++i) {
    glm::ivec3 at(512 + i % 64, 64 + i / 64 % 64, i / 4096);
    bool isInside = at.x < 600 && at.y < 130;
    ASSERT_EQ(samples[std::size_t(i)], isInside ? noisy(at) : 0) << i;
  }
}

TEST(ZarrWriter, ZarrPythonReadsVersion2) {
  if (std::system("/usr/bin/python3 -c 'import zarr' 2>/dev/null") != 0) GTEST_SKIP() << "there is no python3-zarr";
  TempFolder folder;
  Volume v = rampVolume(SampleType::Int16, {150, 140, 131}, 2);
  StoreOptions options;
  options.version = OmeVersion::V04;
  writeStoreOf(v, folder / "a.zarr", options);
  writeText(folder / "raw", std::string(reinterpret_cast<const char*>(v.voxels.data()), v.voxels.size()));
  writeText(folder / "check.py",
            "import sys, zarr, numpy\n"
            "group = zarr.open(sys.argv[1] + '/a.zarr', 'r')\n"
            "raw = numpy.fromfile(sys.argv[1] + '/raw', '<i2').reshape(131, 140, 150, 2)\n"
            "assert (group['0'][:] == numpy.moveaxis(raw, 3, 0)).all()\n"
            "assert group['1'].shape == (2, 66, 70, 75), group['1'].shape\n"
            "assert len(group.attrs['multiscales'][0]['datasets']) == 2\n");
  EXPECT_EQ(std::system(("/usr/bin/python3 " + (folder / "check.py").string() + " " + (folder / "").string()).c_str()),
            0);
}

}  // namespace
}  // namespace velum::io
