#include <cstdlib>
#include <set>

#include "ZarrRamp.h"
#include "core/VoxelSource.h"
#include "io/stores/OmeImage.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

TEST(ZarrReal, ImagesOfOtherProgramsAreRead) {
  fs::path data = testData() / "pyramids";
  if (testData().empty() || !fs::exists(data)) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
  auto pyramid = openImage(data / "pyramid_v4.zarr.zip", "");
  ASSERT_EQ(pyramid->levels().size(), 3u);
  EXPECT_EQ(pyramid->levels()[2].dims, glm::ivec3(250, 250, 250));
  EXPECT_EQ(pyramid->levels()[0].brickSize, glm::ivec3(250, 250, 125));
  EXPECT_TRUE(pyramid->facts().isAlignedByBorders);
  Volume five = read(data / "5d_dataset_v5.ome.zarr.zip"), four = read(data / "5d_dataset_v4.ome.zarr.zip");
  EXPECT_EQ(five.channels, 3);
  EXPECT_EQ(five.timeSteps, 4);
  EXPECT_EQ(five.channelNames, four.channelNames);
  EXPECT_TRUE(five.voxels == four.voxels);
  EXPECT_EQ(read(data / "image-02.zarr.zip").dims.z, 1);
  EXPECT_EQ(imagesIn(data / "plate-01.zarr.zip").size(), 4u);
  scene::Source source;
  source.path = (data / "zarr.zr.zip").string();
  Progress progress;
  source.series = "raw";
  Volume raw = readVolume(source, progress);
  for (const char* codec : {"gzip", "zlib", "blosc"}) {
    std::set<std::string> names;
    source.series = codec;
    std::error_code error;
    try {
      EXPECT_TRUE(readVolume(source, progress).voxels == raw.voxels) << codec;
    } catch (const InputError& refusal) {
      // Of blosc the archive has a folder a way of packing.
      EXPECT_EQ(std::string(codec), "blosc") << refusal.what();
    }
  }
}

/// Unpacks an archive of test data. @return its folder; empty where there is none
fs::path unpacked(const TempFolder& folder, const std::string& name) {
  fs::path archive = testData() / "pyramids" / (name + ".zip");
  if (testData().empty() || !fs::exists(archive)) return {};
  std::string line = "cd '" + folder.path().string() + "' && python3 -m zipfile -e '" + archive.string() + "' " + name;
  return std::system(line.c_str()) == 0 ? folder / name : fs::path();
}

TEST(ZarrReal, WhatMustBeRefusedIs) {
  TempFolder folder;
  fs::path root = unpacked(folder, "invalid");
  if (root.empty()) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
  for (const auto& entry : fs::directory_iterator(root / "invalid/invalid"))
    EXPECT_NE(refusalOf(entry.path()), "") << entry.path();
}

TEST(ZarrReal, ImagesKeepOrBreakTheRulesAsTheSpecificationSays) {
  TempFolder folder;
  fs::path root = unpacked(folder, "ngff-spec");
  if (root.empty()) GTEST_SKIP() << "set VELUM_TEST_DATA to the folder of test volumes";
  // What takes nothing from a picture is passed over.
  const std::set<std::string> kHarmless = {"invalid_axis_type.ome.zarr", "invalid_channels_color.ome.zarr",
                                           "invalid_channels_window.ome.zarr", "invalid_path.ome.zarr"};
  // Its scale has two numbers, and it three axes: only the schema lets it pass.
  const std::string broken = "mismatch_axes_units.ome.zarr";
  int tried = 0;
  for (const char* kind : {"valid", "invalid"})
    for (const auto& entry : fs::directory_iterator(root / "ngff-spec/tests/zarr/spec" / kind / "image")) {
      std::string name = entry.path().filename().string();
      auto store = openStore(entry.path());
      bool isRead = true;
      try {
        isRead = readOmeImage(*store, "").has_value();
      } catch (const InputError& error) {
        isRead = false;
        EXPECT_TRUE(std::string(kind) != "valid" || name == broken) << error.what();
      }
      if (!kHarmless.contains(name) && name != broken) {
        EXPECT_EQ(isRead, std::string(kind) == "valid") << entry.path();
      }
      ++tried;
    }
  EXPECT_GT(tried, 25);
}

TEST(ZarrOracle, ZarrPythonWritesWhatIsReadHere) {
  TempFolder folder;
  std::string script = R"(
import sys, numpy, zarr, numcodecs
root = sys.argv[1]
a = (numpy.arange(11 * 13 * 17).reshape(11, 13, 17) * 37 % 65521).astype('<u2')
a.tofile(root + '/plain')
packers = {'zstd': numcodecs.Zstd(3), 'lz4': numcodecs.LZ4(), 'gzip': numcodecs.GZip(5), 'zlib': numcodecs.Zlib(5), 'raw': None}
for name in ('blosclz', 'lz4', 'lz4hc', 'zlib', 'zstd'):
    for shuffle in (0, 1, 2):
        packers['blosc-%s-%d' % (name, shuffle)] = numcodecs.Blosc(name, 5, shuffle)
for name, packer in packers.items():
    for order in 'CF':
        for typed in ('<u2', '>u2'):
            zarr.open_array('%s/%s-%s-%s.zarr' % (root, name, order, typed[0] == '>'), mode='w', shape=a.shape, chunks=(4, 5, 6),
                            dtype=typed, order=order, compressor=packer)[:] = a
)";
  writeText(folder / "make.py", script);
  if (std::system("/usr/bin/python3 -c 'import zarr, numcodecs' 2>/dev/null") != 0)
    GTEST_SKIP() << "install python3-zarr and python3-numcodecs";
  ASSERT_EQ(std::system(
                ("/usr/bin/python3 '" + (folder / "make.py").string() + "' '" + folder.path().string() + "'").c_str()),
            0);
  std::string plain = bytesOf(folder / "plain");
  int tried = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (!entry.is_directory()) continue;
    Volume v = read(entry.path());
    EXPECT_EQ(v.dims, glm::ivec3(17, 13, 11));
    EXPECT_TRUE(v.voxels.size() == plain.size() && std::memcmp(v.voxels.data(), plain.data(), plain.size()) == 0)
        << entry.path();
    ++tried;
  }
  EXPECT_EQ(tried, 80);
}

}  // namespace
}  // namespace velum::io
