// TIFF files read tile by tile and strip by strip: the same as whole, level on level, whatever is wrong with them.
#include "Damage.h"
#include "SameByBricks.h"
#include "TiffFiles.h"
#include "io/Plugins.h"
#include "io/read/Placement.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// The file's source, and the reader, give what OpenImageIO reads.
/// @return whether it has a source
bool expectSameAsLibrary(const fs::path& path) {
  scene::Source source = sourceOf(path);
  Progress progress;
  Volume whole = loaded<OiioPlugin>().readTiff(source, progress);
  completeHead(whole, source);
  auto opened = openSource(source);
  if (opened) expectGives(*opened, whole);
  return expectSameByBricks(source);
}

TEST(TiffSource, TilesAndStripsOfEveryPackingAreTheSame) {
  TempFolder folder;
  constexpr SampleType kTypes[] = {SampleType::UInt8,  SampleType::Int8,  SampleType::UInt16, SampleType::Int16,
                                   SampleType::UInt32, SampleType::Int32, SampleType::Float32};
  for (const char* mode : {"wl", "wb8", "w8"})
    for (int tile : {0, 32})
      for (int packing :
           {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS, COMPRESSION_ZSTD})
        for (SampleType type : kTypes) {
          TiffMaking how;
          how.mode = mode;
          how.tile = tile;
          how.packing = std::uint16_t(packing);
          ASSERT_TRUE(writeTiff(folder / "a.tif", {75, 41}, 5, type, how, anySamples(type, 1)));
          SCOPED_TRACE(std::string(mode) + " " + std::to_string(tile) + " " + std::to_string(packing) + " " +
                       std::string(enumName(type)));
          EXPECT_TRUE(expectSameAsLibrary(folder / "a.tif"));
        }
}

TEST(TiffSource, DoublesKeepAllTheirDigits) {
  TempFolder folder;
  for (int tile : {0, 32}) {
    TiffMaking how;
    how.tile = tile;
    PageSamples samples = anySamples(SampleType::Float64, 1);
    ASSERT_TRUE(writeTiff(folder / "a.tif", {75, 41}, 1, SampleType::Float64, how, samples));
    EXPECT_TRUE(read(folder / "a.tif").voxels == samples(0, 0, {75, 41})) << tile;
  }
}

TEST(TiffSource, ColoursAreTheSameTogetherAndInPlanes) {
  TempFolder folder;
  for (bool isPlanar : {false, true})
    for (int tile : {0, 16})
      for (int packing : {COMPRESSION_NONE, COMPRESSION_LZW}) {
        TiffMaking how;
        how.samples = 3;
        how.photometric = PHOTOMETRIC_RGB;
        how.isPlanar = isPlanar;
        how.tile = tile;
        how.packing = std::uint16_t(packing);
        ASSERT_TRUE(writeTiff(folder / "a.tif", {35, 41}, 3, SampleType::UInt8, how, anySamples(SampleType::UInt8, 3)));
        EXPECT_TRUE(expectSameAsLibrary(folder / "a.tif")) << isPlanar << tile << packing;
        EXPECT_TRUE(openSource(sourceOf(folder / "a.tif"))->head().isColor);
      }
}

std::string omeOf(glm::ivec3 dims, int channels, int times, const std::string& order, const std::string& inside) {
  return "<OME><Image><Pixels DimensionOrder=\"XY" + order + "\" SizeX=\"" + std::to_string(dims.x) + "\" SizeY=\"" +
         std::to_string(dims.y) + "\" SizeZ=\"" + std::to_string(dims.z) + "\" SizeC=\"" + std::to_string(channels) +
         "\" SizeT=\"" + std::to_string(times) +
         "\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"0.25\" PhysicalSizeZ=\"2\">" + inside + "</Pixels></Image></OME>";
}

TEST(TiffSource, OmeOrdersChannelsAndTimeStepsAreTheSame) {
  TempFolder folder;
  for (const char* order : {"ZCT", "CZT", "TCZ", "CTZ"})
    for (int samples : {1, 3}) {
      TiffMaking how;
      how.tile = 16;
      how.samples = samples;
      how.photometric = samples == 3 ? PHOTOMETRIC_RGB : PHOTOMETRIC_MINISBLACK;
      how.description = omeOf({40, 30, 3}, 2 * samples, 4, order, "<TiffData/>");
      ASSERT_TRUE(writeTiff(folder / "a.ome.tif", {40, 30}, 24, SampleType::UInt16, how,
                            anySamples(SampleType::UInt16, samples)));
      EXPECT_TRUE(expectSameAsLibrary(folder / "a.ome.tif")) << order;
    }
  TiffMaking how;
  how.description = omeOf({40, 30, 2}, 1, 1, "ZCT",
                          "<TiffData IFD=\"1\" FirstZ=\"0\" PlaneCount=\"1\"/><TiffData IFD=\"0\" FirstZ=\"1\" "
                          "PlaneCount=\"1\"/>");
  ASSERT_TRUE(writeTiff(folder / "a.ome.tif", {40, 30}, 2, SampleType::UInt16, how, anySamples(SampleType::UInt16, 1)));
  EXPECT_TRUE(expectSameAsLibrary(folder / "a.ome.tif")) << "pages that say which plane they are";
}

/// A plane of space, whose mean over a block is its value in the block's middle.
double slopeAt(glm::dvec3 voxel) { return 3 * voxel.x + 7 * voxel.y + 100 * voxel.z; }

Bytes meansOfBlocks(glm::ivec2 size, glm::ivec2 finest, int z, int level) {
  int edge = 1 << level;
  Bytes bytes(std::size_t(size.x) * std::size_t(size.y) * sizeof(float));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      double sum = 0;
      int count = 0;
      for (int j = y * edge; j < std::min(finest.y, (y + 1) * edge); ++j)
        for (int i = x * edge; i < std::min(finest.x, (x + 1) * edge); ++i, ++count) sum += slopeAt({i, j, z});
      float mean = float(sum / count);
      std::memcpy(bytes.data() + std::size_t(y * size.x + x) * sizeof(float), &mean, sizeof(mean));
    }
  return bytes;
}

TEST(TiffSource, LevelsOfAPyramidLieOnEachOther) {
  TempFolder folder;
  const glm::ivec2 size(203, 150);
  for (bool isChained : {false, true})
    for (int tile : {0, 32}) {
      TiffMaking how;
      how.levels = 4;
      how.isChained = isChained;
      how.tile = tile;
      how.description = omeOf({size, 3}, 1, 1, "ZCT", "<TiffData/>");
      ASSERT_TRUE(writeTiff(folder / "a.ome.tif", size, 3, SampleType::Float32, how,
                            [&](int page, int level, glm::ivec2 at) { return meansOfBlocks(at, size, page, level); }));
      EXPECT_TRUE(expectSameAsLibrary(folder / "a.ome.tif"));
      auto source = openSource(sourceOf(folder / "a.ome.tif"));
      ASSERT_EQ(source->levels().size(), 4u);
      Progress progress;
      for (int number = 0; number < 4; ++number) {
        Volume level = readLevel(*source, number, progress);
        ASSERT_EQ(level.dims, glm::ivec3(sizeAt(size, number), 3));
        glm::dmat4 finestFromLevel = glm::inverse(source->head().worldFromVoxel) * level.worldFromVoxel;
        // The last blocks are cut by the border: their mean lies elsewhere.
        for (int z = 0; z < 3; ++z)
          for (int y = 0; y + 1 < level.dims.y; ++y)
            for (int x = 0; x + 1 < level.dims.x; ++x) {
              glm::dvec3 place = finestFromLevel * glm::dvec4(x, y, z, 1);
              EXPECT_NEAR(valueAt(level, {x, y, z}), slopeAt(place), 0.01 * 3) << "less than 0.01 voxel";
            }
      }
    }
}

TEST(TiffSource, TheLevelThatIsAskedForIsRead) {
  TempFolder folder;
  TiffMaking how;
  how.levels = 3;
  how.tile = 32;
  ASSERT_TRUE(writeTiff(folder / "a.tif", {200, 100}, 2, SampleType::UInt8, how, anySamples(SampleType::UInt8, 1)));
  scene::Source source = sourceOf(folder / "a.tif");
  Progress progress;
  source.level = 2;
  Volume v = readVolume(source, progress);
  EXPECT_EQ(v.dims, glm::ivec3(50, 25, 2));
  EXPECT_NE(warningWith(v, "level 2 of 0 to 2"), "");
  source.level = 3;
  EXPECT_THROW(readVolume(source, progress), InputError);
}

TEST(TiffSource, ThumbnailsAreNoLevels) {
  TempFolder folder;
  TiffMaking how;
  how.tile = 32;
  // A reduced page of another shape behind the page, and one behind one page only.
  TIFF* file = TIFFOpen((folder / "a.tif").c_str(), "w8");
  for (int page = 0; page < 3; ++page) {
    glm::ivec2 size = page == 1 ? glm::ivec2(50, 50) : glm::ivec2(200, 100);
    setPage(file, how, size, SampleType::UInt8);
    if (page == 1) TIFFSetField(file, TIFFTAG_SUBFILETYPE, FILETYPE_REDUCEDIMAGE);
    writeSamples(file, how, size, SampleType::UInt8, anySamples(SampleType::UInt8, 1)(page, 0, size));
    TIFFWriteDirectory(file);
    if (page != 1) continue;
    TIFFClose(file);
    EXPECT_TRUE(expectSameAsLibrary(folder / "a.tif"));
    EXPECT_EQ(openSource(sourceOf(folder / "a.tif"))->levels().size(), 1u);
    file = TIFFOpen((folder / "a.tif").c_str(), "a8");
  }
  TIFFClose(file);
  EXPECT_TRUE(expectSameAsLibrary(folder / "a.tif"));
  EXPECT_EQ(openSource(sourceOf(folder / "a.tif"))->levels().size(), 1u);
}

TEST(TiffSource, WhatMustBeConvertedIsReadWhole) {
  TempFolder folder;
  TiffMaking how;
  how.photometric = PHOTOMETRIC_MINISWHITE;
  ASSERT_TRUE(writeTiff(folder / "white.tif", {20, 10}, 2, SampleType::UInt8, how, anySamples(SampleType::UInt8, 1)));
  EXPECT_EQ(openSource(sourceOf(folder / "white.tif")), nullptr);
}

TEST(TiffSource, EveryCutIsRefusedAndNoneCrashes) {
  TempFolder folder;
  Progress progress;
  for (int packing : {COMPRESSION_NONE, COMPRESSION_LZW})
    for (int tile : {0, 32}) {
      TiffMaking how;
      how.packing = std::uint16_t(packing);
      how.tile = tile;
      ASSERT_TRUE(writeTiff(folder / "a.tif", {75, 41}, 3, SampleType::UInt8, how, anySamples(SampleType::UInt8, 1)));
      std::string bytes = bytesOf(folder / "a.tif");
      for (std::size_t keep = 0; keep + 300 < bytes.size(); keep += 61) {
        writeText(folder / "b.tif", bytes.substr(0, keep));
        EXPECT_THROW(readLevel(*openSource(sourceOf(folder / "b.tif")), 0, progress), InputError) << keep;
      }
    }
}

TEST(TiffSource, DamagedFilesAreReadOrRefused) {
  TempFolder folder;
  for (bool isChained : {false, true}) {
    TiffMaking how;
    how.levels = 3;
    how.isChained = isChained;
    how.tile = 16;
    ASSERT_TRUE(writeTiff(folder / "a.tif", {40, 41}, 2, SampleType::UInt8, how, anySamples(SampleType::UInt8, 1)));
    expectReadOrRefused(bytesOf(folder / "a.tif"), folder / "b.tif", 500, [&] {
      Progress progress;
      auto source = openSource(sourceOf(folder / "b.tif"));
      for (int level = 0; source && level < int(source->levels().size()); ++level)
        if (levelBytes(*source, level) < 1e7) readLevel(*source, level, progress);
    });
  }
}

TEST(TiffSource, AFileThatShrinksWhileItIsOpenGivesWords) {
  TempFolder folder;
  Progress progress;
  for (int packing : {COMPRESSION_NONE, COMPRESSION_LZW}) {
    TiffMaking how;
    how.packing = std::uint16_t(packing);
    ASSERT_TRUE(writeTiff(folder / "a.tif", {300, 200}, 30, SampleType::UInt8, how, anySamples(SampleType::UInt8, 1)));
    auto source = openSource(sourceOf(folder / "a.tif"));
    fs::resize_file(folder / "a.tif", fs::file_size(folder / "a.tif") / 3);
    try {
      readLevel(*source, 0, progress);
      ADD_FAILURE() << "read";
    } catch (const InputError& error) {
      std::string words = error.what();
      EXPECT_NE(words.find("a.tif"), std::string::npos) << words;
      EXPECT_EQ(words.find('\n'), std::string::npos) << words;
    }
  }
}

TEST(TiffSource, AStoreIsMadeOfItsTiles) {
  TempFolder folder;
  TiffMaking how;
  how.tile = 64;
  ASSERT_TRUE(writeTiff(folder / "a.tif", {300, 210}, 70, SampleType::UInt16, how, anySamples(SampleType::UInt16, 1)));
  Progress progress;
  writeStore(*openSource(sourceOf(folder / "a.tif")), folder / "a.zarr", {}, progress);
  EXPECT_TRUE(readLevel(*openImage(folder / "a.zarr", ""), 0, progress).voxels == read(folder / "a.tif").voxels);
}

}  // namespace
}  // namespace velum::io
