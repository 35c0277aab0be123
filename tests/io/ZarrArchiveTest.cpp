#include "Damage.h"
#include "ZarrRamp.h"

namespace velum::io {
namespace {

/// An archive of all files of a folder. @param isWide  with the numbers of ZIP64
std::string archiveOf(const fs::path& folder, bool isDeflated, bool isWide, const std::string& root) {
  std::string bytes, directory;
  std::uint64_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    ++count;
    std::string name = root + fs::relative(entry.path(), folder).string(), data = io::bytesOf(entry.path()),
                packed = data;
    if (isDeflated) {
      packed = packedBy("zlib", data, 1);
      packed = packed.substr(2, packed.size() - 6);  // without the frame of zlib
    }
    auto number16 = [](std::size_t n) { return bytesOfNumber(std::uint16_t(n)); };
    auto number32 = [](std::size_t n) { return bytesOfNumber(std::uint32_t(n)); };
    std::string extra;
    if (isWide)
      extra = number16(1) + number16(24) + bytesOfNumber(std::uint64_t(data.size())) +
              bytesOfNumber(std::uint64_t(packed.size())) + bytesOfNumber(std::uint64_t(bytes.size()));
    std::size_t all = 0xffffffffu;
    std::string common = number16(isDeflated ? 8 : 0) + std::string(8, '\0') + number32(isWide ? all : packed.size()) +
                         number32(isWide ? all : data.size()) + number16(name.size());
    directory += "PK\x01\x02" + number16(45) + number16(45) + number16(0) + common + number16(extra.size()) +
                 number16(0) + std::string(8, '\0') + number32(isWide ? all : bytes.size()) + name + extra;
    bytes += "PK\x03\x04" + number16(45) + number16(0) + common + number16(0) + name + packed;
  }
  std::uint64_t at = bytes.size(), size = directory.size();
  bytes += directory;
  if (isWide) {
    std::uint64_t end64 = bytes.size();
    bytes += "PK\x06\x06" + bytesOfNumber(std::uint64_t(44)) + std::string(12, '\0') + bytesOfNumber(count) +
             bytesOfNumber(count) + bytesOfNumber(size) + bytesOfNumber(at);
    bytes += "PK\x06\x07" + std::string(4, '\0') + bytesOfNumber(end64) + bytesOfNumber(std::uint32_t(1));
  }
  auto low = [&](std::uint64_t n) { return bytesOfNumber(std::uint32_t(isWide ? 0xffffffffu : n)); };
  std::string counts = bytesOfNumber(std::uint16_t(isWide ? 0xffffu : count));
  std::string comment = R"({"ome": {"version": "0.5"}})";
  return bytes + "PK\x05\x06" + std::string(4, '\0') + counts + counts + low(size) + low(at) +
         bytesOfNumber(std::uint16_t(comment.size())) + comment;
}

fs::path writeImage(const fs::path& root) {
  ZarrFile file = ramp(root / "0");
  file.shard = {4, 6, 4};
  file.codec = "zstd";
  file.write();
  writeGroup(root, 3, {{"multiscales", {{{"axes", axesOf("zyx")}, {"datasets", {levelAt("0", {1, 2, 3})}}}}}});
  return root;
}

TEST(ZarrArchive, IsReadAsTheFolderIs) {
  TempFolder folder;
  fs::path root = writeImage(folder / "a.zarr");
  Volume expected = read(root);
  for (bool isDeflated : {false, true})
    for (bool isWide : {false, true})
      for (const char* within : {"", "a.zarr/"})
        for (const char* name : {"a.ozx", "a.zarr.zip", "a.zip"}) {
          SCOPED_TRACE(std::string(name) + within + (isDeflated ? " deflated" : "") + (isWide ? " wide" : ""));
          writeText(folder / name, archiveOf(root, isDeflated, isWide, within));
          Volume v = read(folder / name);
          EXPECT_TRUE(v.voxels == expected.voxels);
          EXPECT_EQ(v.worldFromVoxel, expected.worldFromVoxel);
        }
}

TEST(ZarrArchive, IsReadOrRefusedWhateverIsDamaged) {
  TempFolder folder;
  fs::path root = writeImage(folder / "a.zarr"), archive = folder / "a.ozx";
  for (bool isDeflated : {false, true}) {
    std::string good = archiveOf(root, isDeflated, isDeflated, "");
    constexpr std::size_t kComment = 28;  // nobody misses its end
    for (std::size_t size = 0; size + kComment < good.size(); size += 7) {
      writeText(archive, good.substr(0, size));
      EXPECT_NE(refusalOf(archive), "") << size;
    }
    expectReadOrRefused(good, archive, 400, [&] { read(archive); });
  }
}

}  // namespace
}  // namespace velum::io
