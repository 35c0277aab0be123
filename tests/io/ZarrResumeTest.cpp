#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "GeneratedSource.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// All files below a folder, with their bytes.
std::map<std::string, std::string> filesIn(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder)] = bytesOf(entry.path());
  return files;
}

GeneratedSource source() { return {{300, 280, 200}, {100, 280, 7}, noisy}; }

/// So small that slabs are single shards.
StoreOptions smallSlabs(OmeVersion version = OmeVersion::V05) {
  StoreOptions options;
  options.version = version;
  options.slabBytes = 1 << 20;
  return options;
}

void writeTo(const VoxelSource& from, const fs::path& path, const StoreOptions& options = smallSlabs()) {
  Progress progress;
  writeStore(from, path, options, progress);
}

std::string complaintOf(const fs::path& path) {
  try {
    read(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ZarrResume, GoesOnWithWhatIsWholeAndGivesTheSameBytes) {
  TempFolder folder;
  for (OmeVersion version : {OmeVersion::V05, OmeVersion::V04}) {
    std::string name = version == OmeVersion::V05 ? "5" : "4";
    GeneratedSource whole = source();
    writeTo(whole, folder / ("whole" + name + ".zarr"), smallSlabs(version));
    GeneratedSource torn = source();
    torn.failAfter(whole.reads * 2 / 3);
    EXPECT_THROW(writeTo(torn, folder / ("torn" + name + ".zarr"), smallSlabs(version)), InputError);
    EXPECT_NE(complaintOf(folder / ("torn" + name + ".zarr")).find("is not whole"), std::string::npos);
    GeneratedSource again = source();
    writeTo(again, folder / ("torn" + name + ".zarr"), smallSlabs(version));
    EXPECT_LT(again.reads, whole.reads * 2 / 3) << "what was whole was not asked for again";
    EXPECT_TRUE(filesIn(folder / ("torn" + name + ".zarr")) == filesIn(folder / ("whole" + name + ".zarr")));
  }
}

TEST(ZarrResume, ShardsThatAreCutOffAreWrittenAgain) {
  TempFolder folder;
  writeTo(source(), folder / "whole.zarr");
  auto expected = filesIn(folder / "whole.zarr");
  GeneratedSource torn = source();
  torn.failAfter(100);
  EXPECT_THROW(writeTo(torn, folder / "torn.zarr"), InputError);
  fs::path shard = folder / "torn.zarr/0/c/0/0/0";
  ASSERT_TRUE(fs::exists(shard));
  fs::resize_file(shard, fs::file_size(shard) / 2);
  writeTo(source(), folder / "torn.zarr");
  EXPECT_TRUE(filesIn(folder / "torn.zarr") == expected);
}

TEST(ZarrResume, ArchivesGoOnToo) {
  TempFolder folder;
  writeTo(source(), folder / "whole.ozx");
  EXPECT_FALSE(fs::exists(unfinishedFolder(folder / "whole.ozx")));
  GeneratedSource torn = source();
  torn.failAfter(60);
  EXPECT_THROW(writeTo(torn, folder / "torn.ozx"), InputError);
  EXPECT_FALSE(fs::exists(folder / "torn.ozx"));
  EXPECT_TRUE(fs::exists(unfinishedFolder(folder / "torn.ozx")));
  writeTo(source(), folder / "torn.ozx");
  EXPECT_TRUE(bytesOf(folder / "torn.ozx") == bytesOf(folder / "whole.ozx"));
  EXPECT_FALSE(fs::exists(unfinishedFolder(folder / "torn.ozx")));
}

TEST(ZarrResume, ArchivesAreStoredWithTheRootsMetadataFirst) {
  TempFolder folder;
  writeTo(source(), folder / "a.ozx");
  std::string bytes = bytesOf(folder / "a.ozx");
  EXPECT_EQ(bytes.substr(30, 9), "zarr.json");
  EXPECT_EQ(bytes.substr(8, 2), std::string(2, '\0')) << "members are stored";
  EXPECT_TRUE(bytes.ends_with(R"({"ome":{"version":"0.5"}})"));
  Progress progress;
  writeTo(source(), folder / "a.zarr");
  auto archive = openImage(folder / "a.ozx", ""), tree = openImage(folder / "a.zarr", "");
  for (int level = 0; level < int(tree->levels().size()); ++level)
    EXPECT_TRUE(readLevel(*archive, level, progress).voxels == readLevel(*tree, level, progress).voxels) << level;
  if (std::system("unzip -v > /dev/null 2>&1") == 0) {
    EXPECT_EQ(std::system(("unzip -qt " + (folder / "a.ozx").string() + " > /dev/null").c_str()), 0);
  }
}

TEST(ZarrResume, WhatIsCancelledReadsAsNothingWhole) {
  TempFolder folder;
  for (double when : {0.0, 0.3, 0.9, 0.999}) {
    fs::path path = folder / (std::to_string(when) + ".zarr");
    Progress* cancelled = nullptr;
    Progress progress([&](double fraction, const std::string&) {
      if (fraction >= when) cancelled->cancel();
    });
    cancelled = &progress;
    EXPECT_THROW(writeStore(source(), path, smallSlabs(), progress), Cancelled);
    if (fs::exists(path)) {
      std::string message = complaintOf(path);
      EXPECT_NE(message.find("is not whole"), std::string::npos) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos);
    }
    writeTo(source(), path);
    EXPECT_EQ(complaintOf(path), "");
  }
}

TEST(ZarrResume, NothingElseIsOverwritten) {
  TempFolder folder;
  GeneratedSource torn = source(), other({300, 280, 200}, {100, 280, 7}, [](glm::ivec3 p) { return p.x; });
  torn.failAfter(50);
  EXPECT_THROW(writeTo(torn, folder / "a.zarr"), InputError);
  EXPECT_THROW(writeTo(other, folder / "a.zarr"), InputError) << "another volume's";
  writeTo(source(), folder / "a.zarr");
  auto before = filesIn(folder / "a.zarr");
  EXPECT_THROW(writeTo(other, folder / "a.zarr"), InputError) << "a whole store";
  EXPECT_TRUE(filesIn(folder / "a.zarr") == before);
  fs::create_directory(folder / "b.zarr");
  writeText(folder / "b.zarr/mine.txt", "mine");
  EXPECT_THROW(writeTo(other, folder / "b.zarr"), InputError) << "some folder";
  EXPECT_EQ(bytesOf(folder / "b.zarr/mine.txt"), "mine");
  EXPECT_THROW(writeTo(other, folder / "none/c.zarr"), InputError);
}

/// The most memory that the process has held, in bytes, since the last call of forgetPeak().
double peakBytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024;
  return 0;
}
bool forgetPeak() {
  std::ofstream file("/proc/self/clear_refs");
  file << "5";
  file.flush();
  return bool(file);
}

TEST(ZarrResume, MemoryDoesNotGrowWithTheVolume) {
  TempFolder folder;
  if (!forgetPeak()) GTEST_SKIP() << "the system does not count anew";
  double before = peakBytes();
  // 402 MB of the finest level, of which a slab is 32 MB; a shard of 16 million voxels a core is 32 MB, packed less.
  StoreOptions options;
  options.slabBytes = 32 << 20;
  writeTo(GeneratedSource({1024, 1024, 192}, {1024, 1024, 4}, [](glm::ivec3 p) { return std::uint16_t(p.x ^ p.y); }),
          folder / "a.zarr", options);
  EXPECT_LT(peakBytes() - before, 160e6) << "slab, a brick of the source, bricks and shards of some cores";
}

}  // namespace
}  // namespace velum::io
