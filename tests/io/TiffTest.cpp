#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <fstream>

#include "TempFolder.h"
#include "core/Error.h"
#include "io/read/FileNames.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/Readers.h"
#include "io/volumes/TiffDescription.h"

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

TEST(Tiff, OmeChannelsHaveTheirColours) {
  TempFolder folder;
  auto write = [&](const char* file, const std::string& first, const std::string& second) {
    writePages(folder / file, 4, 3, 1, 2,
               "<OME><Image><Pixels DimensionOrder=\"XYZCT\" Type=\"uint16\" SizeX=\"4\" SizeY=\"3\" SizeZ=\"1\" "
               "SizeC=\"2\" SizeT=\"1\"><Channel Name=\"a\" " +
                   first + "/><Channel Name=\"b\" " + second + "/><TiffData/></Pixels></Image></OME>");
    return read(folder / file).channelColors;
  };
  // Red, green, blue, alpha from the highest byte down, of a signed number.
  auto colors = write("red-green.ome.tif", "Color=\"-16776961\"", "Color=\"16711935\"");
  EXPECT_EQ(colors, (std::vector<glm::vec3>{{1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(write("white.ome.tif", "Color=\"-1\"", "Color=\"-1\"").empty()) << "these tell nothing apart";
  EXPECT_TRUE(write("one.ome.tif", "Color=\"-16776961\"", "").empty());
  EXPECT_TRUE(write("odd.ome.tif", "Color=\"red\"", "Color=\"1e300\"").empty());
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

TEST(Tiff, ChannelsThatAreColourKeepTheirSamples) {
  TempFolder folder;
  writePages(folder / "a.tif", 4, 3, 3, 4, "ImageJ=1.53t\nimages=4\nchannels=2\nslices=2\nhyperstack=true\n");
  Volume v = read(folder / "a.tif");
  EXPECT_EQ(v.dims, glm::ivec3(4, 3, 2));
  ASSERT_EQ(v.channels, 6);
  for (int z = 0; z < 2; ++z)
    for (int channel = 0; channel < 6; ++channel)
      EXPECT_EQ(valueAt(v, {1, 2, z}, channel), 1000 * (2 * z + channel / 3) + 3 * 9 + channel % 3);
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

/// One plane of a type, whose pixels are `first`, `first` + 1, ...
template <class T>
void writePlane(const std::filesystem::path& path, int width, int height, OIIO::TypeDesc type, T first) {
  OIIO::ImageSpec spec(width, height, 1, type);
  auto out = OIIO::ImageOutput::create(path.string());
  ASSERT_TRUE(out && out->open(path.string(), spec)) << OIIO::geterror();
  std::vector<T> pixels;
  for (int i = 0; i < width * height; ++i) pixels.push_back(T(first + T(i)));
  ASSERT_TRUE(out->write_image(type, pixels.data()));
  out->close();
}

TEST(Tiff, EveryTypeKeepsItsValues) {
  TempFolder folder;
  writePlane<std::uint8_t>(folder / "a.tif", 3, 2, OIIO::TypeDesc::UINT8, 250);
  writePlane<std::int16_t>(folder / "b.tif", 3, 2, OIIO::TypeDesc::INT16, -32768);
  writePlane<std::uint32_t>(folder / "c.tif", 3, 2, OIIO::TypeDesc::UINT32, 4294967290u);
  writePlane<float>(folder / "d.tif", 3, 2, OIIO::TypeDesc::FLOAT, -1.25f);
  writePlane<double>(folder / "e.tif", 3, 2, OIIO::TypeDesc::DOUBLE, 1e9 + 0.5);
  struct Row {
    const char* name;
    SampleType type;
    double first;
  };
  for (auto [name, type, first] : {Row{"a.tif", SampleType::UInt8, 250},
                                   {"b.tif", SampleType::Int16, -32768},
                                   {"c.tif", SampleType::UInt32, 4294967290.0},
                                   {"d.tif", SampleType::Float32, -1.25},
                                   {"e.tif", SampleType::Float64, 1e9 + 0.5}}) {
    Volume v = read(folder / name);
    EXPECT_EQ(v.type, type) << name;
    EXPECT_EQ(v.dims, glm::ivec3(3, 2, 1)) << name;
    EXPECT_EQ(valueAt(v, {0, 0, 0}), first) << name;
    EXPECT_EQ(valueAt(v, {2, 1, 0}), first + 5) << name;
  }
}

TEST(Tiff, PlanesOfAFolderAreSlicesInNaturalOrder) {
  TempFolder folder;
  for (const char* ending : {".tif", ".png"}) {
    std::filesystem::remove_all(folder / "planes");
    std::filesystem::create_directories(folder / "planes");
    std::ofstream(folder / "planes" / "notes.txt") << "not a plane";
    for (int i = 1; i <= 11; ++i)
      writePlane<std::uint16_t>(folder / "planes" / ("z" + std::to_string(i) + ending), 3, 2, OIIO::TypeDesc::UINT16,
                                std::uint16_t(1000 * i));
    Volume v = read(folder / "planes", {0.04, 0.04, 0.05});
    ASSERT_EQ(v.dims, glm::ivec3(3, 2, 11)) << ending;
    for (int z = 0; z < 11; ++z) EXPECT_EQ(valueAt(v, {2, 1, z}), 1000 * (z + 1) + 5) << ending;
    EXPECT_NEAR(spacingOf(v).z, 0.05, 1e-12);
    EXPECT_TRUE(v.isSpacingKnown);
    EXPECT_FALSE(v.isOrientationKnown);
    EXPECT_EQ(v.modality, Modality::Microscopy) << "of 16 bits: what else has such a camera";
    EXPECT_FALSE(read(folder / "planes").isSpacingKnown);
  }
}

TEST(Tiff, PlanesThatDoNotAgreeAreRefusedByName) {
  TempFolder folder;
  writePlane<std::uint16_t>(folder / "a.tif", 3, 2, OIIO::TypeDesc::UINT16, 0);
  writePlane<std::uint16_t>(folder / "b.tif", 3, 3, OIIO::TypeDesc::UINT16, 0);
  for (int i = 0; i < 2; ++i) {
    try {
      read(folder.path());
      ADD_FAILURE() << "opened";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("b.tif"), std::string::npos) << error.what();
    }
    writePlane<std::uint8_t>(folder / "b.tif", 3, 2, OIIO::TypeDesc::UINT8, 0);  // then of another type
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
