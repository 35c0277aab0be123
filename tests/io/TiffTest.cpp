#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "read/FileNames.h"
#include "velum/core/Error.h"
#include "velum/io/volumes/ReadVolume.h"
#include "volumes/Readers.h"
#include "volumes/TiffDescription.h"

namespace velum::io {
namespace {

/// Pages of uint16 with sample = 1000 * page + index, written by OpenImageIO.
void writePages(const std::filesystem::path& path, int width, int height, int samples, int pages,
                const std::string& description, const char* compression = "zip", float resolution = 0) {
  std::vector<OIIO::ImageSpec> specs;
  for (int p = 0; p < pages; ++p) {
    OIIO::ImageSpec spec(width, height, samples, OIIO::TypeDesc::UINT16);
    spec.attribute("compression", compression);
    if (!description.empty() && p == 0) spec.attribute("ImageDescription", description);
    if (resolution > 0) {
      spec.attribute("XResolution", resolution), spec.attribute("YResolution", resolution);
      spec.attribute("ResolutionUnit", "in");
    }
    specs.push_back(spec);
  }
  auto out = OIIO::ImageOutput::create("tiff");
  ASSERT_TRUE(out->open(path.string(), pages, specs.data())) << out->geterror();
  for (int p = 0; p < pages; ++p) {
    if (p > 0) {
      ASSERT_TRUE(out->open(path.string(), specs[std::size_t(p)], OIIO::ImageOutput::AppendSubimage));
    }
    std::vector<std::uint16_t> pixels(std::size_t(width * height * samples));
    for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] = std::uint16_t(1000 * p + int(i));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT16, pixels.data()));
  }
  out->close();
}

Volume read(const std::filesystem::path& path, glm::dvec3 spacing = glm::dvec3(0.0)) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  source.spacing = spacing;
  return readVolume(source, progress);
}

TEST(Tiff, PagesAreSlices) {
  TempFolder folder;
  for (const char* compression : {"none", "zip", "lzw", "packbits"}) {
    writePages(folder / "a.tif", 6, 5, 1, 7, "", compression);
    Volume v = read(folder / "a.tif");
    ASSERT_EQ(v.dims, glm::ivec3(6, 5, 7));
    EXPECT_EQ(v.type, SampleType::UInt16);
    EXPECT_EQ(valueAt(v, {2, 3, 4}), 4000 + 3 * 6 + 2);
    EXPECT_FALSE(v.isSpacingKnown);
    EXPECT_EQ(v.warnings.size(), 1u);
  }
}

TEST(Tiff, ResolutionTagsAloneAreNotSpacing) {
  TempFolder folder;
  writePages(folder / "a.tif", 4, 4, 1, 2, "", "zip", 72);
  Volume v = read(folder / "a.tif");
  EXPECT_FALSE(v.isSpacingKnown);
  EXPECT_EQ(spacingOf(v), glm::dvec3(1.0));
  Volume given = read(folder / "a.tif", {0.5, 0.5, 2});
  EXPECT_TRUE(given.isSpacingKnown);
  EXPECT_EQ(spacingOf(given), glm::dvec3(0.5, 0.5, 2));
  EXPECT_TRUE(given.warnings.empty());
}

TEST(Tiff, ColourPagesAreColour) {
  TempFolder folder;
  writePages(folder / "a.tif", 4, 4, 3, 2, "");
  Volume v = read(folder / "a.tif");
  EXPECT_EQ(v.channels, 3);
  EXPECT_TRUE(v.isColor);
  EXPECT_EQ(valueAt(v, {1, 0, 1}, 2), 1000 + 5);
}

TEST(Tiff, OmeChannelsFramesAndSpacing) {
  TempFolder folder;
  // Order XYZCT: z fastest, then channel, then time.
  writePages(
      folder / "a.ome.tif", 4, 3, 1, 12,
      "<?xml version=\"1.0\"?><OME xmlns=\"http://www.openmicroscopy.org/Schemas/OME/2016-06\"><Image ID=\"Image:0\">"
      "<Pixels ID=\"Pixels:0\" DimensionOrder=\"XYZCT\" Type=\"uint16\" SizeX=\"4\" SizeY=\"3\" SizeZ=\"3\" "
      "SizeC=\"2\" SizeT=\"2\" "
      "PhysicalSizeX=\"0.5\" PhysicalSizeY=\"250\" PhysicalSizeYUnit=\"nm\" PhysicalSizeZ=\"0.002\" "
      "PhysicalSizeZUnit=\"mm\" "
      "TimeIncrement=\"3\"><Channel ID=\"Channel:0:0\" Name=\"DAPI\"/><Channel ID=\"Channel:0:1\" "
      "Name=\"GFP\"/><TiffData/></Pixels></Image></OME>");
  Volume v = read(folder / "a.ome.tif");
  EXPECT_EQ(v.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(v.channels, 2);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_FALSE(v.isColor);
  EXPECT_EQ(v.channelNames, (std::vector<std::string>{"DAPI", "GFP"}));
  EXPECT_EQ(v.timeStepSeconds, 3.0);
  EXPECT_TRUE(v.isSpacingKnown);
  EXPECT_NEAR(spacingOf(v).x, 5e-4, 1e-12);
  EXPECT_NEAR(spacingOf(v).y, 2.5e-4, 1e-12);
  EXPECT_NEAR(spacingOf(v).z, 2e-3, 1e-12);
  for (int t = 0; t < 2; ++t)
    for (int c = 0; c < 2; ++c)
      for (int z = 0; z < 3; ++z) EXPECT_EQ(valueAt(v, {1, 2, z}, c, t), 1000 * ((t * 2 + c) * 3 + z) + 9);
}

TEST(Tiff, ImageJHyperstack) {
  TempFolder folder;
  writePages(folder / "a.tif", 4, 3, 1, 6,
             "ImageJ=1.53t\nimages=6\nchannels=2\nslices=3\nhyperstack=true\nunit=micron\nspacing=2.5\nloop=false\n",
             "none", 4);
  Volume v = read(folder / "a.tif");
  EXPECT_EQ(v.dims, glm::ivec3(4, 3, 3));
  EXPECT_EQ(v.channels, 2);
  EXPECT_EQ(valueAt(v, {1, 2, 2}, 1), 5009);
  EXPECT_NEAR(spacingOf(v).x, 0.25e-3, 1e-9);
  EXPECT_NEAR(spacingOf(v).z, 2.5e-3, 1e-9);
}

TEST(Tiff, APromiseOfPagesThatAreNotThereIsRefused) {
  TempFolder folder;
  writePages(
      folder / "a.tif", 4, 3, 1, 2,
      "<OME><Pixels SizeX=\"4\" SizeY=\"3\" SizeZ=\"9999999\" SizeC=\"9999999\" SizeT=\"9999999\"></Pixels></OME>");
  EXPECT_THROW(read(folder / "a.tif"), InputError);
}

TEST(Tiff, EveryCutIsRefusedAndNoneCrashes) {
  TempFolder folder;
  for (const char* compression : {"none", "lzw"}) {
    writePages(folder / "a.tif", 40, 30, 1, 5, "", compression);
    std::ifstream file(folder / "a.tif", std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    for (std::size_t keep = 0; keep + 64 < bytes.size(); keep += 97) {
      std::ofstream(folder / "b.tif", std::ios::binary) << bytes.substr(0, keep);
      EXPECT_THROW(read(folder / "b.tif"), InputError) << keep;
    }
  }
}

TEST(TiffDescription, OmeTiffDataSaysWhichPageIsWhich) {
  auto layout = parseTiffDescription(
      "<OME><Pixels DimensionOrder=\"XYCZT\" SizeZ=\"2\" SizeC=\"1\" SizeT=\"1\"><TiffData IFD=\"1\" FirstZ=\"0\" "
      "PlaneCount=\"1\"/>"
      "<TiffData IFD=\"0\" FirstZ=\"1\" PlaneCount=\"1\"/></Pixels></OME>",
      "a.tif");
  auto planes = placePlanes(layout, 1, 2);
  ASSERT_EQ(planes.size(), 2u);
  EXPECT_EQ(planes[0].z, 1u);
  EXPECT_EQ(planes[1].z, 0u);
}

TEST(NaturalOrder, NumbersCompareAsNumbers) {
  EXPECT_TRUE(naturalLess("quarter.2", "quarter.10"));
  EXPECT_TRUE(naturalLess("a2b", "a10a"));
  EXPECT_TRUE(naturalLess("a01", "a2"));
  EXPECT_FALSE(naturalLess("a10", "a9"));
  EXPECT_TRUE(naturalLess("a1", "b0"));
  EXPECT_TRUE(naturalLess("01", "1") != naturalLess("1", "01"));
  EXPECT_FALSE(naturalLess("x7", "x7"));
}

}  // namespace
}  // namespace velum::io
