#include <gtest/gtest.h>

#include "Damage.h"
#include "ZarrRamp.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// The refusal of an array whose metadata has been changed.
std::string refusalWith(const fs::path& folder, const std::function<void(Json&)>& change, int version = 3) {
  ZarrFile file = ramp(folder / "a.zarr");
  file.version = version;
  fs::remove_all(file.folder);
  file.write();
  Json metadata = file.metadata();
  change(metadata);
  writeText(file.folder / (version == 2 ? ".zarray" : "zarr.json"), metadata.dump());
  return refusalOf(file.folder);
}

TEST(ZarrDamage, EveryCutAndEveryDamageOfAChunkIsRefusedOrRead) {
  TempFolder folder;
  for (const char* codec : {"raw", "gzip", "zlib", "zstd", "lz4", "blosc", "crc32c", "shards"}) {
    SCOPED_TRACE(codec);
    ZarrFile file = ramp(folder / (std::string(codec) + ".zarr"));
    file.codec = codec;
    file.hasCrc = file.codec == "crc32c";
    if (file.hasCrc) file.codec = "raw";
    if (file.codec == "shards") file.codec = "zstd", file.shard = {4, 6, 8};
    file.write();
    fs::path chunk = file.folder / "c/0/0/0";
    std::string good = bytesOf(chunk);
    for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 64) {
      writeText(chunk, good.substr(0, size));
      EXPECT_NE(refusalOf(file.folder), "") << "cut to " << size;
    }
    expectReadOrRefused(good, chunk, 60, [&] { read(file.folder); });
    writeText(chunk, good + good);
    if (file.codec == "raw") {
      EXPECT_NE(refusalOf(file.folder), "") << "too long";
    }
  }
}

TEST(ZarrDamage, LyingShapesAreRefusedInOneLine) {
  TempFolder folder;
  auto shaped = [&](const Json& shape) {
    return refusalWith(folder.path(), [&](Json& metadata) { metadata["shape"] = shape; });
  };
  EXPECT_NE(shaped({1000000, 1000000, 1000000}), "");
  EXPECT_NE(shaped({2000000000, 2000000000, 2000000000}), "");
  EXPECT_NE(shaped({4, 6, 1e30}), "");
  EXPECT_NE(shaped({4, 6, std::uint64_t(1) << 61}), "");
  EXPECT_NE(shaped({4, 6, -8}), "");
  EXPECT_NE(shaped({4, 6, 0}), "");
  EXPECT_NE(shaped({4, 6.5, 8}), "");
  EXPECT_NE(shaped({4, 6}), "");
  EXPECT_NE(shaped("4"), "");
  EXPECT_NE(shaped(Json::array()), "");
  auto chunked = [&](const Json& chunk) {
    return refusalWith(folder.path(),
                       [&](Json& metadata) { metadata["chunk_grid"]["configuration"]["chunk_shape"] = chunk; });
  };
  EXPECT_NE(chunked({0, 3, 4}), "");
  EXPECT_NE(chunked({100000, 100000, 100000}), "");
  EXPECT_NE(chunked({std::uint64_t(1) << 40, std::uint64_t(1) << 40, 1}), "");
  EXPECT_NE(chunked({2, 3}), "");
}

TEST(ZarrDamage, WhatIsNotKnownIsNamed) {
  TempFolder folder;
  auto has = [](const std::string& message, const char* word) { return message.find(word) != message.npos; };
  auto with = [&](const std::function<void(Json&)>& change, int version = 3) {
    return refusalWith(folder.path(), change, version);
  };
  EXPECT_TRUE(has(with([](Json& m) { m["codecs"].push_back({{"name", "zfp"}}); }), "zfp"));
  EXPECT_TRUE(has(with([](Json& m) { m["compressor"] = {{"id", "lzma"}}; }, 2), "lzma"));
  EXPECT_TRUE(has(with([](Json& m) { m["filters"] = {{{"id", "delta"}}}; }, 2), "delta"));
  EXPECT_TRUE(has(with([](Json& m) { m["data_type"] = "complex64"; }), "complex64"));
  EXPECT_TRUE(has(with([](Json& m) { m["dtype"] = "|S7"; }, 2), "S7"));
  EXPECT_TRUE(has(with([](Json& m) { m["chunk_grid"]["name"] = "rectilinear"; }), "rectilinear"));
  EXPECT_TRUE(has(with([](Json& m) { m["magic"] = 1; }), "magic"));
  EXPECT_EQ(with([](Json& m) { m["magic"] = {{"must_understand", false}}; }), "");
  EXPECT_EQ(with([](Json& m) {
              m["codecs"][0] = "bytes";
              m["data_type"] = "uint16";
            }),
            "");
  EXPECT_TRUE(has(with([](Json& m) { m["fill_value"] = "much"; }), "fill_value"));
  EXPECT_TRUE(has(with([](Json& m) { m["codecs"] = Json::array(); }), "codecs"));
}

TEST(ZarrDamage, MetadataOfAnyKindIsReadOrRefused) {
  TempFolder folder;
  ZarrFile file = ramp(folder / "a.zarr/0");
  file.write();
  writeGroup(folder / "a.zarr", 3,
             {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {1, 2, 3})}}}}}});
  for (const char* name : {"zarr.json", "0/zarr.json"}) {
    fs::path path = folder / "a.zarr" / name;
    std::string good = bytesOf(path);
    expectReadOrRefused(good, path, 300, [&] { read(folder / "a.zarr"); });
    writeText(path, std::string(200'000, '['));
    EXPECT_NE(refusalOf(folder / "a.zarr"), "");
    writeText(path, std::string(100'000, '[') + std::string(100'000, ']'));
    EXPECT_NE(refusalOf(folder / "a.zarr"), "");
    writeText(path, good);
  }
  EXPECT_EQ(refusalOf(folder / "a.zarr"), "");
}

TEST(ZarrDamage, PathsThatLeadOutOfTheStoreAndArraysThatAreMissingAreRefused) {
  TempFolder folder;
  ramp(folder / "0").write();
  fs::path root = folder / "a.zarr";
  for (const char* path : {"../0", "/etc", "x/../../0", "missing", ""}) {
    writeGroup(root, 3, {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt(path, {1, 1, 1})}}}}}});
    EXPECT_NE(refusalOf(root), "") << path;
  }
  scene::Source source;
  source.path = (folder / "0").string();
  source.series = "../a.zarr";
  Progress progress;
  EXPECT_THROW(readVolume(source, progress), InputError);
}

}  // namespace
}  // namespace velum::io
