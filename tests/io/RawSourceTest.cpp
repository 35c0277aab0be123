// Files that hold samples as they are: read brick by brick they are what they are when read whole.
#include <algorithm>
#include <chrono>

#include "Damage.h"
#include "SameByBricks.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

constexpr SampleType kTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16,  SampleType::Int16,
                                 SampleType::UInt32, SampleType::Int32, SampleType::Float32, SampleType::Float64};

/// Samples of any layout, in both byte orders.
std::string samplesOf(const Volume& v, bool bigEndian) {
  std::string bytes(reinterpret_cast<const char*>(v.voxels.data()), v.voxels.size());
  std::size_t size = sampleSize(v.type);
  for (std::size_t at = 0; bigEndian && at < bytes.size(); at += size)
    std::reverse(bytes.begin() + std::ptrdiff_t(at), bytes.begin() + std::ptrdiff_t(at + size));
  return bytes;
}

TEST(RawSource, OurOwnFilesAreTheSameByBricks) {
  TempFolder folder;
  for (SampleType type : kTypes)
    for (const char* ending : {".nrrd", ".nii"})
      for (int channels : {1, 3}) {
        Volume v = rampVolume(type, {67, 41, 23}, channels, 2);
        v.worldFromVoxel = obliqueMatrix(true, true);
        v.channelNames = channels == 3 ? std::vector<std::string>{"a", "b", "c"} : std::vector<std::string>{};
        fs::path path = folder / (std::string(enumName(type)) + std::to_string(channels) + ending);
        write(v, path);
        // Our NRRD files are packed.
        if (std::string(ending) == ".nrrd") {
          EXPECT_EQ(openSource(sourceOf(path)), nullptr) << path;
          std::string head = bytesOf(path);
          head = head.substr(0, head.find("\n\n") + 2);
          head.replace(head.find("gzip"), 4, "raw");
          writeText(path, head + samplesOf(v, false));
        }
        EXPECT_TRUE(expectSameByBricks(sourceOf(path)));
      }
}

TEST(RawSource, DetachedHeadersAndListsOfFilesAreTheSame) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt16, {31, 17, 40});
  std::string bytes = samplesOf(v, true);
  for (int i = 0; i < 40; ++i)
    writeText(folder / ("p" + std::to_string(i) + ".raw"),
              "skip" + bytes.substr(std::size_t(i) * 31 * 17 * 2, 31 * 17 * 2));
  writeText(folder / "all.raw", "skip" + bytes);
  std::string head =
      "NRRD0004\ntype: ushort\ndimension: 3\nsizes: 31 17 40\nspacings: 1 2 3\nencoding: raw\n"
      "endian: big\nbyte skip: 4\n";
  writeText(folder / "all.nhdr", head + "data file: all.raw\n");
  writeText(folder / "list.nhdr", head + "data file: p%d.raw 0 39 1\n");
  std::string meta =
      "ObjectType = Image\nNDims = 3\nDimSize = 31 17 40\nElementType = MET_USHORT\nBinaryDataByteOrderMSB = "
      "True\nElementSpacing = 1 2 3\nHeaderSize = -1\nElementDataFile = ";
  writeText(folder / "all.mhd", meta + "all.raw\n");
  writeText(folder / "list.mhd", meta + "p%d.raw 0 39 1\n");
  for (const char* name : {"all.nhdr", "list.nhdr", "all.mhd", "list.mhd"})
    EXPECT_TRUE(expectSameByBricks(sourceOf(folder / name))) << name;
  Progress progress;
  EXPECT_TRUE(readLevel(*openSource(sourceOf(folder / "list.mhd")), 0, progress).voxels == v.voxels);
}

TEST(RawSource, HeaderlessFilesAndFoldersAreTheSame) {
  TempFolder folder;
  for (bool bigEndian : {false, true})
    for (SampleType type : kTypes) {
      Volume v = rampVolume(type, {19, 8, 11}, 3);
      scene::RawLayout layout{v.dims, type, 3, bigEndian, 5};
      writeText(folder / "a.raw", "12345" + samplesOf(v, bigEndian));
      EXPECT_TRUE(expectSameByBricks(sourceOf(folder / "a.raw", layout)));
      fs::create_directories(folder / "slices");
      std::size_t plane = 19 * 8 * 3 * sampleSize(type);
      for (std::size_t z = 0; z < 11; ++z)
        writeText(folder / "slices" / std::to_string(z), "12345" + samplesOf(v, bigEndian).substr(z * plane, plane));
      EXPECT_TRUE(expectSameByBricks(sourceOf(folder / "slices", layout)));
    }
}

TEST(RawSource, BricksAreStretchesOfTheFileOfAboutAMegabyte) {
  TempFolder folder;
  struct Case {
    glm::ivec3 dims, brick;
    SampleType type;
  };
  for (const Case& one :
       {Case{{512, 512, 40}, {512, 512, 4}, SampleType::UInt8},
        Case{{3000, 1000, 3}, {3000, 256, 1}, SampleType::UInt8},
        Case{{1 << 21, 2, 2}, {1 << 20, 1, 1}, SampleType::UInt8},
        Case{{1 << 21, 2, 2}, {1 << 19, 1, 1}, SampleType::UInt16}, Case{{9, 5, 3}, {9, 5, 3}, SampleType::UInt8}}) {
    Volume v = rampVolume(one.type, one.dims);
    writeText(folder / "a.raw", samplesOf(v, false));
    scene::Source source = sourceOf(folder / "a.raw", {one.dims, one.type, 1, false, 0});
    EXPECT_EQ(openSource(source)->levels().front().brickSize, one.brick);
    EXPECT_TRUE(expectSameByBricks(source));
  }
}

TEST(RawSource, WhatIsPackedIsReadWhole) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::Int16, {9, 8, 7});
  write(v, folder / "a.nii.gz");
  write(v, folder / "a.vti");
  EXPECT_EQ(openSource(sourceOf(folder / "a.nii.gz")), nullptr);
  EXPECT_EQ(openSource(sourceOf(folder / "a.vti")), nullptr);
  EXPECT_EQ(openSource(sourceOf(folder.path())), nullptr);
  writeText(folder / "wide.nhdr",
            "NRRD0004\ntype: int64\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nendian: little\n"
            "data file: wide.raw\n");
  writeText(folder / "wide.raw", std::string(64, 'a'));
  EXPECT_EQ(openSource(sourceOf(folder / "wide.nhdr")), nullptr);
  EXPECT_THROW(openSource(sourceOf(folder / "none.nrrd")), InputError);
}

TEST(RawSource, TheSpacingThatIsGivenIsTaken) {
  TempFolder folder;
  writeText(folder / "a.raw", std::string(60, 'a'));
  scene::Source source = sourceOf(folder / "a.raw", {{5, 4, 3}, SampleType::UInt8, 1, false, 0});
  source.spacing = {0.5, 0.25, 2};
  EXPECT_TRUE(expectSameByBricks(source));
  EXPECT_EQ(spacingOf(openSource(source)->head()), source.spacing);
}

TEST(RawSource, AFileThatShrinksOrGoesWhileItIsOpenGivesWords) {
  TempFolder folder;
  std::string bytes(std::size_t(1) << 22, 'a');
  fs::path path = folder / "a.raw";
  writeText(path, bytes);
  auto source = openSource(sourceOf(path, {{1024, 1024, 4}, SampleType::UInt8, 1, false, 0}));
  Progress progress;
  fs::resize_file(path, bytes.size() / 2);
  try {
    readLevel(*source, 0, progress);
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("a.raw: the file is cut short"), std::string::npos) << error.what();
  }
  for (int i = 0; i < 20; ++i) writeText(folder / ("p" + std::to_string(i) + ".raw"), "abcd");
  writeText(folder / "list.nhdr",
            "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 20\nencoding: raw\n"
            "data file: p%d.raw 0 19 1\n");
  auto list = openSource(sourceOf(folder / "list.nhdr"));
  fs::remove(folder / "p7.raw");
  EXPECT_THROW(readLevel(*list, 0, progress), InputError);
}

TEST(RawSource, EveryCutIsRefusedWhenItIsOpened) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt16, {9, 8, 7});
  write(v, folder / "a.nii");
  std::string bytes = bytesOf(folder / "a.nii");
  for (std::size_t keep = 0; keep < bytes.size(); keep += 13) {
    writeText(folder / "b.nii", bytes.substr(0, keep));
    EXPECT_THROW(openSource(sourceOf(folder / "b.nii")), InputError) << keep;
  }
}

TEST(RawSource, DamagedFilesAreReadOrRefused) {
  TempFolder folder;
  std::string head =
      "NRRD0004\ntype: short\ndimension: 4\nsizes: 2 9 8 3\nkinds: vector space space space\n"
      "encoding: raw\nendian: big\n\n";
  expectReadOrRefused(head + std::string(2 * 9 * 8 * 3 * 2, 'x'), folder / "a.nrrd", 400, [&] {
    Progress progress;
    auto source = openSource(sourceOf(folder / "a.nrrd"));
    if (source && levelBytes(*source, 0) < 1e6) readLevel(*source, 0, progress);
  });
}

TEST(RawSource, RealFilesAreTheSameByBricks) {
  VELUM_NEED_TEST_DATA();
  int count = 0;
  for (const char* sub : {"volumes", "malformed"})
    for (const auto& entry : fs::directory_iterator(testData() / sub)) {
      if (!entry.is_regular_file()) continue;
      try {
        count += expectSameByBricks(sourceOf(entry.path()));
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      }
    }
  EXPECT_GE(count, 12);
  scene::RawLayout tooth{{103, 94, 161}, SampleType::UInt8, 1, false, 0};
  if (fs::file_size(testData() / "volumes/tooth.raw") == 103 * 94 * 161) {
    EXPECT_TRUE(expectSameByBricks(sourceOf(testData() / "volumes/tooth.raw", tooth)));
  }
}

/// What was written of a store before it was stopped goes on with the same file only.
TEST(RawSource, AStoreGoesOnWithTheSameFileOnly) {
  TempFolder folder;
  fs::path raw = folder / "a.raw";
  Volume v = rampVolume(SampleType::UInt8, {300, 200, 150});
  writeText(raw, samplesOf(v, false));
  scene::Source source = sourceOf(raw, {v.dims, v.type, 1, false, 0});
  StoreOptions options;
  options.slabBytes = 1 << 20;
  auto stopAt = [&](double when) {
    Progress* cancelled = nullptr;
    Progress progress([&](double fraction, const std::string&) {
      if (fraction >= when) cancelled->cancel();
    });
    cancelled = &progress;
    EXPECT_THROW(writeStore(*openSource(source), folder / "a.zarr", options, progress), Cancelled);
  };
  stopAt(0.5);
  // Another voxel, which none of the few bricks holds that are looked at, and a later time.
  auto changed = fs::last_write_time(raw);
  std::fstream file(raw, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(300 * 200 * 7 + 11);
  file << "!";
  file.close();
  fs::last_write_time(raw, changed + std::chrono::seconds(2));
  Progress progress;
  EXPECT_THROW(writeStore(*openSource(source), folder / "a.zarr", options, progress), InputError);
  fs::remove_all(folder / "a.zarr");
  stopAt(0.5);
  writeStore(*openSource(source), folder / "a.zarr", options, progress);
  Volume whole = readVolume(source, progress);
  EXPECT_TRUE(readLevel(*openImage(folder / "a.zarr", ""), 0, progress).voxels == whole.voxels);
}

TEST(RawSource, AStoreGoesOnWithTheSameVolumeInMemoryOnly) {
  TempFolder folder;
  Volume v = rampVolume(SampleType::UInt8, {300, 200, 150}), other = v;
  // One voxel far from those bricks that a source on disk is known by.
  other.voxels[(150 * 200 * 300) / 2 + 12345] ^= std::byte(1);
  StoreOptions options;
  options.slabBytes = 1 << 20;
  Progress* cancelled = nullptr;
  Progress stopped([&](double fraction, const std::string&) {
    if (fraction >= 0.5) cancelled->cancel();
  });
  cancelled = &stopped;
  Progress progress;
  EXPECT_THROW(writeStore(VolumeSource(v), folder / "a.zarr", options, stopped), Cancelled);
  EXPECT_THROW(writeStore(VolumeSource(other), folder / "a.zarr", options, progress), InputError);
  writeStore(VolumeSource(v), folder / "a.zarr", options, progress);
}

}  // namespace
}  // namespace velum::io
