#include <gtest/gtest.h>

#include "Damage.h"
#include "Hdf5Files.h"
#include "N5Files.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

const char* const kStraight = "0.5 0 0 0 0 0.5 0 0 0 0 2 0";

std::string sameForAll(const std::vector<std::string>& affines) {
  std::string xml;
  for (int time = 0; time < 2; ++time)
    for (int setup = 0; setup < 2; ++setup) xml += registration(time, setup, affines);
  return xml;
}

/// Two channels in HDF5 with their XML.
fs::path writeChannels(const fs::path& folder, const std::string& registrations) {
  writeBdv(folder / "a.h5");
  writeSpimData(folder / "a.xml", "hdf5", "a.h5", "<channel>1</channel><tile>0</tile>", registrations);
  return folder / "a.xml";
}

/// The same in N5.
fs::path writeChannelsInN5(const fs::path& folder, const std::string& registrations) {
  for (int setup = 0; setup < 2; ++setup) {
    fs::path group = folder / "a.n5" / ("setup" + std::to_string(setup));
    for (int time = 0; time < 2; ++time)
      for (int level = 0; level < 2; ++level) {
        N5File file = n5Ramp(group / ("timepoint" + std::to_string(time)) / ("s" + std::to_string(level)));
        if (level == 1) file.shape = {3, 3, 5};
        file.codec = "lz4";
        file.value = [=](const Sizes& i) {
          return double((time * 10 + setup) * 1000) + double(i[2] * 42 + i[1] * 7 + i[0]);
        };
        file.write();
      }
    writeBytes(group / "attributes.json",
               Json{{"downsamplingFactors", {{1, 1, 1}, {2, 2, 1}}}, {"dataType", "uint16"}}.dump());
  }
  writeBytes(folder / "a.n5/attributes.json", R"({"n5": "2.5.1"})");
  writeSpimData(folder / "a.xml", "n5", "a.n5", "<channel>1</channel><tile>0</tile>", registrations);
  return folder / "a.xml";
}

void expectChannels(const Volume& v) {
  ASSERT_EQ(v.dims, glm::ivec3(7, 6, 5));
  ASSERT_EQ(v.channels, 2);
  ASSERT_EQ(v.timeSteps, 2);
  EXPECT_EQ(v.type, SampleType::UInt16);
  for (int time = 0; time < 2; ++time)
    for (int channel = 0; channel < 2; ++channel)
      for (int z = 0; z < 5; ++z)
        for (int y = 0; y < 6; ++y)
          for (int x = 0; x < 7; ++x)
            ASSERT_EQ(valueAt(v, {x, y, z}, channel, time), (time * 10 + channel) * 1000 + z * 42 + y * 7 + x);
}

TEST(BigDataViewer, SetupsThatDifferInTheirChannelAreChannelsOfOneImage) {
  TempFolder folder;
  for (bool isN5 : {false, true}) {
    fs::path home = folder / (isN5 ? "n5" : "hdf5");
    fs::create_directories(home);
    fs::path xml =
        isN5 ? writeChannelsInN5(home, sameForAll({kStraight})) : writeChannels(home, sameForAll({kStraight}));
    for (const fs::path& path : {xml, home / (isN5 ? "a.n5" : "a.h5")}) {
      SCOPED_TRACE(path);
      EXPECT_TRUE(isStore(path));
      ASSERT_EQ(imagesIn(path).size(), 1u);
      Volume v = read(path);
      expectChannels(v);
      EXPECT_EQ(v.channelNames, (std::vector<std::string>{"GFP", "RFP"}));
      EXPECT_NEAR(spacingOf(v).z, 2e-3, 1e-12);
      EXPECT_EQ(v.modality, Modality::Microscopy);
      EXPECT_TRUE(v.warnings.empty()) << v.warnings.front();
    }
  }
}

TEST(BigDataViewer, LevelsLieOnEachOther) {
  TempFolder folder;
  auto image = openImage(writeChannels(folder.path(), sameForAll({kStraight})), "");
  ASSERT_EQ(image->levels().size(), 2u);
  glm::dvec4 first = image->levels()[1].worldFromVoxel * glm::dvec4(0, 0, 0, 1),
             mean = image->levels()[0].worldFromVoxel * glm::dvec4(0.5, 0.5, 0, 1);
  EXPECT_LT(glm::length(first - mean), 1e-15);
  glm::dvec4 last = image->levels()[1].worldFromVoxel * glm::dvec4(2, 2, 4, 1),
             lastMean = image->levels()[0].worldFromVoxel * glm::dvec4(4.5, 4.5, 4, 1);
  EXPECT_LT(glm::length(last - lastMean), 1e-15);
}

TEST(BigDataViewer, TheTransformationThatIsListedFirstIsAppliedLast) {
  TempFolder folder;
  // A translation of what was turned, and not the other way around.
  std::string move = "1 0 0 10 0 1 0 20 0 0 1 30", turn = "0 -0.5 0 0 0.5 0 0 0 0 0 2 0";
  auto image = openImage(writeChannels(folder.path(), sameForAll({move, turn})), "");
  glm::dvec3 place(image->head().worldFromVoxel * glm::dvec4(2, 0, 0, 1));
  EXPECT_LT(glm::length(place * 1000.0 - glm::dvec3(10, 21, 30)), 1e-9);
}

TEST(BigDataViewer, RegistrationsInVoxelsBecomeAsLargeAsTheVoxelSizeSays) {
  TempFolder folder;
  auto image = openImage(writeChannels(folder.path(), sameForAll({"1 0 0 4 0 1 0 0 0 0 4 0"})), "");
  EXPECT_NEAR(spacingOf(image->head()).x, 0.5e-3, 1e-12);
  EXPECT_NEAR(spacingOf(image->head()).z, 2e-3, 1e-12);
  EXPECT_NEAR(image->head().worldFromVoxel[3].x, 2e-3, 1e-12);
  EXPECT_NE(warningWith(image->head(), "voxel size"), "");
}

TEST(BigDataViewer, TilesAndSetupsOfOtherPlacesAreImagesOfTheirOwn) {
  TempFolder folder;
  fs::path xml = writeChannels(folder.path(), sameForAll({kStraight}));
  writeSpimData(xml, "hdf5", "a.h5", "<channel>1</channel><tile>1</tile>", sameForAll({kStraight}));
  auto images = imagesIn(xml);
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[0].name, "tile 0");
  EXPECT_EQ(images[1].key, "setup1");
  EXPECT_EQ(images[1].dims, glm::ivec3(7, 6, 5));
  scene::Source source;
  source.path = xml.string();
  source.series = "setup1";
  Progress progress;
  Volume v = readVolume(source, progress);
  EXPECT_EQ(v.channels, 1);
  EXPECT_EQ(valueAt(v, {0, 0, 0}, 0, 1), 11000);
  EXPECT_NE(warningWith(read(xml), "2 images"), "");
  std::string moved = registration(0, 0, {kStraight}) + registration(0, 1, {"0.5 0 0 9 0 0.5 0 0 0 0 2 0"});
  writeSpimData(xml, "hdf5", "a.h5", "<channel>1</channel><tile>0</tile>", moved);
  EXPECT_EQ(imagesIn(xml).size(), 2u);
}

TEST(BigDataViewer, EachImageThatIsOfferedHasAPictureOfItsOwn) {
  TempFolder folder;
  fs::path xml = writeChannels(folder.path(), sameForAll({kStraight}));
  writeSpimData(xml, "hdf5", "a.h5", "<channel>1</channel><tile>1</tile>", sameForAll({kStraight}));
  Progress progress;
  auto series = listSeries(xml, progress);
  ASSERT_EQ(series.size(), 2u);
  EXPECT_EQ(series[1].imageCount, 5);
  for (int i = 0; i < 2; ++i)
    EXPECT_GE(readSeriesImage(series[std::size_t(i)], progress).range.x, i * 1000.0) << "of the coarsest level";
}

TEST(BigDataViewer, MissingViewsAreZeroAndNumbersOfOldFilesHaveNoSign) {
  TempFolder folder;
  fs::path xml = writeChannels(folder.path(), sameForAll({kStraight}));
  writeBdv(folder / "a.h5", [](Hdf5Data& data) {
    if (data.name.starts_with("t00000/s01")) data.shape.clear();
    data.value = [](const Sizes&) { return 60000.0 - 65536.0; };
  });
  Volume v = read(xml);
  EXPECT_EQ(v.type, SampleType::UInt16);
  EXPECT_EQ(valueAt(v, {1, 1, 1}, 0, 0), 60000);
  EXPECT_EQ(valueAt(v, {1, 1, 1}, 1, 0), 0);
  EXPECT_EQ(valueAt(v, {1, 1, 1}, 1, 1), 60000);
}

TEST(BigDataViewer, ThePartsOfAFileMayLieInOthers) {
  TempFolder folder;
  writeBdv(folder / "part.h5");
  {
    Hdf5Out out(folder / "a.h5");
    for (const char* name : {"s00", "s01", "t00000", "t00001"}) out.link(name, "part.h5", std::string("/") + name);
  }
  writeSpimData(folder / "a.xml", "hdf5", "a.h5", "<channel>1</channel><tile>0</tile>", sameForAll({kStraight}));
  expectChannels(read(folder / "a.xml"));
  fs::remove(folder / "part.h5");
  EXPECT_NE(refusalOf(folder / "a.xml"), "");
}

TEST(BigDataViewer, VoxelsWithoutAnXmlAreReadAndThatIsSaid) {
  TempFolder folder;
  fs::remove(writeChannels(folder.path(), ""));
  Volume v = read(folder / "a.h5");
  EXPECT_EQ(v.channels, 1);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_FALSE(v.isSpacingKnown);
  EXPECT_NE(warningWith(v, "no XML"), "");
  EXPECT_EQ(imagesIn(folder / "a.h5").size(), 2u);
}

TEST(BigDataViewer, AnXmlThatLiesOrIsDamagedIsRefusedOrReadInOneLine) {
  TempFolder folder;
  fs::path xml = writeChannels(folder.path(), sameForAll({kStraight}));
  std::string good = bytesOf(xml);
  auto with = [&](const std::string& words, const std::string& instead) {
    std::string bad = good;
    for (std::size_t at = 0; (at = bad.find(words, at)) != bad.npos; at += instead.size())
      bad.replace(at, words.size(), instead);
    writeText(xml, bad);
    return refusalOf(xml);
  };
  auto has = [](const std::string& message, const char* word) { return message.find(word) != message.npos; };
  EXPECT_TRUE(has(with(">a.h5<", ">../a.h5<"), "outside"));
  EXPECT_TRUE(has(with(">a.h5<", ">b.h5<"), "missing"));
  EXPECT_TRUE(has(with("bdv.hdf5", "bdv.ome.zarr"), "open the .zarr"));
  EXPECT_TRUE(has(with("type=\"affine\"", "type=\"spline\""), "spline"));
  EXPECT_NE(with(kStraight, "1 2 3"), "");
  EXPECT_NE(with("<id>0</id>", "<id>none</id>"), "");
  EXPECT_EQ(with("0-1", "0-1:1"), "");
  EXPECT_NE(with("0-1", "7"), "") << "there are no such voxels";
  EXPECT_NE(with("</SpimData>", ""), "");
  EXPECT_TRUE(has(with("SpimData", "Sequences"), "no store"));
  expectReadOrRefused(good, xml, 150, [&] { read(xml); });
  fs::remove(xml);
  xml = writeChannelsInN5(folder.path(), sameForAll({kStraight}));
  good = bytesOf(xml);
  EXPECT_TRUE(has(with(">a.n5<", ">../a.n5<"), "beside"));
  EXPECT_TRUE(has(with(">a.n5<", ">b.n5<"), "missing"));
}

}  // namespace
}  // namespace velum::io
