#include <gtest/gtest.h>

#include "TestFiles.h"
#include "ZarrFiles.h"
#include "core/Error.h"
#include "core/VoxelSource.h"
#include "io/stores/AxisUnits.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

/// A value for each index, other than its neighbours', below 250.
double mixed(const Sizes& index) {
  std::uint64_t hash = 17;
  for (std::uint64_t i : index) hash = hash * 31 + i * 7;
  return double(hash % 250);
}

ZarrFile plainFile(const std::filesystem::path& folder) {
  ZarrFile file;
  file.folder = folder;
  file.shape = {5, 7, 9};
  file.chunk = {2, 4, 4};
  file.value = mixed;
  return file;
}

/// Each sample of a volume is that of a file whose axes are z, y, x.
void expectValues(const Volume& v, const ZarrFile& file) {
  ASSERT_EQ(v.dims, glm::ivec3(file.shape[2], file.shape[1], file.shape[0]));
  forEach(file.shape, [&](const Sizes& i) {
    ASSERT_EQ(valueAt(v, {int(i[2]), int(i[1]), int(i[0])}), file.value(i)) << i[0] << " " << i[1] << " " << i[2];
  });
}

TEST(Zarr, EveryCodecOfBothVersionsGivesTheSamples) {
  TempFolder folder;
  for (int version : {2, 3})
    for (const char* codec : {"raw", "gzip", "zlib", "zstd", "lz4", "blosc"})
      for (bool hasCrc : {false, true}) {
        if (hasCrc && version == 2) continue;
        SCOPED_TRACE(std::string(codec) + std::to_string(version));
        ZarrFile file = plainFile(folder / (std::string(codec) + std::to_string(version) + (hasCrc ? "crc" : "")));
        file.version = version;
        file.codec = codec;
        file.hasCrc = hasCrc;
        file.write();
        expectValues(read(file.folder), file);
      }
}

TEST(Zarr, EveryTypeIsReadInBothByteOrders) {
  TempFolder folder;
  std::pair<const char*, SampleType> types[] = {
      {"bool", SampleType::UInt8},      {"uint8", SampleType::UInt8},     {"int8", SampleType::Int8},
      {"uint16", SampleType::UInt16},   {"int16", SampleType::Int16},     {"uint32", SampleType::UInt32},
      {"int32", SampleType::Int32},     {"uint64", SampleType::UInt32},   {"int64", SampleType::Int32},
      {"float16", SampleType::Float32}, {"float32", SampleType::Float32}, {"float64", SampleType::Float64}};
  for (int version : {2, 3})
    for (bool isBigEndian : {false, true})
      for (auto [type, expected] : types) {
        SCOPED_TRACE(std::string(type) + std::to_string(version) + (isBigEndian ? "big" : "little"));
        ZarrFile file = plainFile(folder / (type + std::to_string(version) + (isBigEndian ? "b" : "l")));
        file.version = version;
        file.type = type;
        file.isBigEndian = isBigEndian;
        bool isSigned = type[0] == 'i' || type[0] == 'f';
        if (isSigned) file.value = [](const Sizes& i) { return mixed(i) / 2 - 60 - std::fmod(mixed(i) / 2, 1.0); };
        if (file.type == "bool") file.value = [](const Sizes& i) { return double(int(mixed(i)) % 2); };
        file.write();
        Volume v = read(file.folder);
        EXPECT_EQ(v.type, expected);
        expectValues(v, file);
      }
}

TEST(Zarr, NumbersOf64BitsThatDoNotFitAreRefusedInWords) {
  TempFolder folder;
  ZarrFile file = plainFile(folder / "a.zarr");
  file.type = "uint64";
  file.value = [](const Sizes&) { return 1e15; };
  file.write();
  expectClearError(file.folder);
}

TEST(Zarr, ShardsAreReadWithTheirIndexAtEitherEnd) {
  TempFolder folder;
  for (bool isIndexAtStart : {false, true}) {
    ZarrFile file = plainFile(folder / (isIndexAtStart ? "start" : "end"));
    file.shard = {4, 8, 4};
    file.codec = "zstd";
    file.isIndexAtStart = isIndexAtStart;
    file.write();
    expectValues(read(file.folder), file);
    EXPECT_EQ(openImage(file.folder, "")->levels().front().brickSize, glm::ivec3(4, 4, 2)) << "bricks are inner chunks";
  }
}

TEST(Zarr, SamplesOfAnyOrderInTheirChunksComeToTheirPlaces) {
  TempFolder folder;
  ZarrFile file = plainFile(folder / "f");
  file.version = 2;
  file.isOrderF = true;
  file.write();
  expectValues(read(file.folder), file);
  for (auto order : std::vector<std::vector<std::size_t>>{{2, 1, 0}, {1, 2, 0}, {0, 2, 1}}) {
    ZarrFile turned = plainFile(folder / ("t" + std::to_string(order[0]) + std::to_string(order[1])));
    turned.transpose = order;
    turned.write();
    expectValues(read(turned.folder), turned);
  }
}

TEST(Zarr, ChunksThatAreMissingHoldTheFillValue) {
  TempFolder folder;
  for (bool isSharded : {false, true})
    for (int version : {2, 3}) {
      if (isSharded && version == 2) continue;
      ZarrFile file = plainFile(folder / (std::to_string(version) + (isSharded ? "s" : "")));
      file.version = version;
      file.fill = 300;
      if (isSharded) file.shard = {4, 4, 8};
      file.isThere = [](const Sizes& chunk) { return (chunk[0] + chunk[1] + chunk[2]) % 2 == 0; };
      file.write();
      Volume v = read(file.folder);
      file.value = [&](const Sizes& i) { return file.isThere({i[0] / 2, i[1] / 4, i[2] / 4}) ? mixed(i) : 300; };
      expectValues(v, file);
    }
}

TEST(Zarr, AxesOfAnyOrderBecomeChannelsAndTimeSteps) {
  TempFolder folder;
  for (std::string names : {"tczyx", "ctzyx", "czyx", "tzyx", "zyx", "yx", "cyx", "xyz"}) {
    SCOPED_TRACE(names);
    auto sizeOf = [](char name) {
      return std::uint64_t(name == 't' ? 2 : name == 'c' ? 3 : name == 'z' ? 4 : name == 'y' ? 5 : 6);
    };
    auto root = folder / (names + ".zarr");
    ZarrFile file;
    file.folder = root / "0";
    for (char name : names)
      file.shape.push_back(sizeOf(name)), file.chunk.push_back(name == 't' || name == 'y' ? 2 : 3);
    auto digits = [&](const Sizes& i) {
      double value = 0;
      for (char name : std::string("tczyx"))
        value = value * 6 + (names.find(name) == names.npos ? 0 : double(i[names.find(name)]));
      return value;
    };
    file.value = digits;
    file.write();
    writeGroup(root, 3,
               {{"multiscales",
                 {{{"axes", axesOf(names)}, {"datasets", {levelAt("0", std::vector<double>(names.size(), 1.0))}}}}}});
    Volume v = read(root);
    bool has[5];
    for (int i = 0; i < 5; ++i) has[i] = names.find("tczyx"[i]) != names.npos;
    ASSERT_EQ(v.dims, glm::ivec3(6, 5, has[2] ? 4 : 1));
    ASSERT_EQ(v.channels, has[1] ? 3 : 1);
    ASSERT_EQ(v.timeSteps, has[0] ? 2 : 1);
    for (int t = 0; t < v.timeSteps; ++t)
      for (int c = 0; c < v.channels; ++c)
        for (int z = 0; z < v.dims.z; ++z)
          for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 6; ++x) ASSERT_EQ(valueAt(v, {x, y, z}, c, t), (((t * 6 + c) * 6 + z) * 6 + y) * 6 + x);
  }
}

/// An image of two levels, the coarser one half as fine along each axis.
std::filesystem::path writePyramid(const std::filesystem::path& root, int version, const std::vector<double>& coarseAt,
                                   Json more = Json::object()) {
  for (int level : {0, 1}) {
    ZarrFile file = plainFile(root / std::to_string(level));
    file.version = version;
    if (level == 1) file.shape = {3, 4, 5};
    file.write();
  }
  more["multiscales"] = {{{"version", "0.4"},
                          {"name", "cells"},
                          {"axes", axesOf("zyx")},
                          {"datasets", {levelAt("0", {4, 2, 2}), levelAt("1", {8, 4, 4}, coarseAt)}}}};
  writeGroup(root, version, more);
  return root;
}

TEST(Zarr, PlacesAreThoseOfVoxelCentres) {
  TempFolder folder;
  auto source = openImage(writePyramid(folder / "a.zarr", 3, {2, 1, 1}), "");
  ASSERT_EQ(source->levels().size(), 2u);
  EXPECT_FALSE(source->facts().isAlignedByBorders);
  auto fine = source->levels()[0].worldFromVoxel, coarse = source->levels()[1].worldFromVoxel;
  EXPECT_EQ(source->head().name, "cells");
  EXPECT_EQ(source->head().modality, Modality::Microscopy);
  EXPECT_NEAR(fine[0][0], 0.002, 1e-12);
  EXPECT_NEAR(fine[2][2], 0.004, 1e-12);
  // The centre of the first 2 x 2 x 2 voxels.
  glm::dvec4 a = fine * glm::dvec4(0.5, 0.5, 0.5, 1), b = coarse * glm::dvec4(0, 0, 0, 1);
  EXPECT_NEAR(glm::length(glm::dvec3(a - b)), 0, 1e-12);
}

TEST(Zarr, LevelsWithoutPlacesLieBorderOnBorder) {
  TempFolder folder;
  auto source = openImage(writePyramid(folder / "a.zarr", 2, {}), "");
  EXPECT_TRUE(source->facts().isAlignedByBorders);
  glm::dvec4 a = source->levels()[0].worldFromVoxel * glm::dvec4(-0.5, -0.5, -0.5, 1),
             b = source->levels()[1].worldFromVoxel * glm::dvec4(-0.5, -0.5, -0.5, 1);
  EXPECT_NEAR(glm::length(glm::dvec3(a - b)), 0, 1e-12);
}

TEST(Zarr, ALevelIsReadWhereItIsAskedForAndThatIsSaid) {
  TempFolder folder;
  scene::Source source;
  source.path = writePyramid(folder / "a.zarr", 2, {}).string();
  Progress progress;
  EXPECT_EQ(readVolume(source, progress).dims, glm::ivec3(9, 7, 5));
  EXPECT_EQ(warningWith(readVolume(source, progress), "level"), "");
  source.level = 1;
  Volume v = readVolume(source, progress);
  EXPECT_EQ(v.dims, glm::ivec3(5, 4, 3));
  EXPECT_NE(warningWith(v, "level 1 of 0 to 1"), "");
  EXPECT_NE(warningWith(v, "border on border"), "");
  source.level = 2;
  EXPECT_THROW(readVolume(source, progress), InputError);
}

TEST(Zarr, ChannelsHaveTheNamesColoursAndWindowsOfTheFile) {
  TempFolder folder;
  ZarrFile file = plainFile(folder / "a.zarr/0");
  file.shape = {2, 3, 4, 5};
  file.chunk = {1, 3, 4, 5};
  file.write();
  Json channels = {
      {{"label", "actin"}, {"color", "00FF00"}, {"window", {{"start", 3}, {"end", 200}, {"min", 0}, {"max", 255}}}},
      {{"label", ""}, {"color", "8000ff"}, {"window", {{"start", 0}, {"end", 100}}}}};
  writeGroup(folder / "a.zarr", 3,
             {{"multiscales", {{{"axes", axesOf("czyx")}, {"datasets", {levelAt("0", {1, 1, 1, 1})}}}}},
              {"omero", {{"channels", channels}}}});
  auto source = openImage(folder / "a.zarr", "");
  EXPECT_EQ(source->head().channelNames, (std::vector<std::string>{"actin", "Channel 1"}));
  EXPECT_EQ(source->head().channelColors[0], glm::vec3(0, 1, 0));
  EXPECT_EQ(source->channelWindows(), (std::vector<glm::dvec2>{{3, 200}, {0, 100}}));
}

TEST(Zarr, LabelsAreListedAndOpenWithTheirNamesAndColours) {
  TempFolder folder;
  auto root = writePyramid(folder / "a.zarr", 3, {});
  ZarrFile file = plainFile(root / "labels/nuclei/0");
  file.type = "int64";
  file.value = [](const Sizes& i) { return double(i[2] / 3); };
  file.write();
  writeGroup(root / "labels", 3, {{"labels", {"nuclei"}}});
  writeGroup(root / "labels/nuclei", 3,
             {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {4, 2, 2})}}}}},
              {"image-label",
               {{"colors", {{{"label-value", 2}, {"rgba", {255, 0, 0, 255}}}}},
                {"properties", {{{"label-value", 2}, {"name", "big one"}}}}}}});
  Progress progress;
  auto series = listSeries(root, progress);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[1].uid, "labels/nuclei");
  EXPECT_TRUE(series[1].isSegmentation);
  EXPECT_EQ(series[1].referencedSeries, series[0].uid);
  scene::Source source;
  source.path = root.string();
  source.series = "labels/nuclei";
  auto voxels = readVoxels(source, progress);
  ASSERT_TRUE(std::holds_alternative<LabelVolume>(voxels));
  const auto& labels = std::get<LabelVolume>(voxels);
  EXPECT_EQ(labels.at({8, 1, 1}), 2);
  ASSERT_EQ(labels.table.size(), 2u);
  EXPECT_EQ(labels.table[1].name, "big one");
  EXPECT_EQ(labels.table[1].color, glm::vec3(1, 0, 0));
  EXPECT_TRUE(looksLikeLabels(root / "labels/nuclei"));
  EXPECT_FALSE(looksLikeLabels(root));
}

TEST(Zarr, SeriesAndWellsAreListed) {
  TempFolder folder;
  for (const char* name : {"0", "1"}) writePyramid(folder / "s.zarr" / name, 2, {});
  writeText(folder / "s.zarr/.zgroup", R"({"zarr_format": 2})");
  writeText(folder / "s.zarr/.zattrs", R"({"bioformats2raw.layout": 3})");
  auto series = imagesIn(folder / "s.zarr");
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[1].key, "1");
  EXPECT_NE(warningWith(read(folder / "s.zarr"), "2 images"), "");
  writePyramid(folder / "p.zarr/B/3/0", 3, {});
  writeGroup(folder / "p.zarr/B/3", 3, {{"well", {{"images", {{{"path", "0"}}}}}}});
  writeGroup(folder / "p.zarr", 3, {{"plate", {{"wells", {{{"path", "B/3"}, {"rowIndex", 0}, {"columnIndex", 0}}}}}}});
  auto wells = imagesIn(folder / "p.zarr");
  ASSERT_EQ(wells.size(), 1u);
  EXPECT_EQ(wells[0].key, "B/3/0");
  expectValues(read(folder / "p.zarr"), plainFile({}));
}

}  // namespace
}  // namespace velum::io
