#include <gtest/gtest.h>

#include "Damage.h"
#include "Hdf5Files.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

TEST(Imaris, TimePointsAndChannelsOfEachPackingAreRead) {
  TempFolder folder;
  fs::path path = folder / "a.ims";
  for (const std::vector<std::string>& filters :
       {std::vector<std::string>{}, {"gzip"}, {"shuffle", "gzip"}, {"lz4"}, {"shuffle", "lz4"}}) {
    writeImaris(path, filters);
    Volume v = read(path);
    ASSERT_EQ(v.dims, glm::ivec3(7, 6, 5)) << "the padding of chunks is no part of the image";
    ASSERT_EQ(v.channels, 2);
    ASSERT_EQ(v.timeSteps, 2);
    for (int time = 0; time < 2; ++time)
      for (int channel = 0; channel < 2; ++channel)
        for (int z = 0; z < 5; ++z)
          for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 7; ++x)
              ASSERT_EQ(valueAt(v, {x, y, z}, channel, time), (time * 10 + channel) * 1000 + z * 42 + y * 7 + x);
  }
}

TEST(Imaris, ExtentsAreTheBordersOfTheBoxAtEachLevel) {
  TempFolder folder;
  writeImaris(folder / "a.ims", {"gzip"});
  auto image = openImage(folder / "a.ims", "");
  ASSERT_EQ(image->levels().size(), 2u);
  EXPECT_EQ(image->levels()[1].dims, glm::ivec3(3, 3, 5));
  for (const VoxelLevel& level : image->levels()) {
    glm::dvec3 dims(level.dims), low(level.worldFromVoxel * glm::dvec4(-0.5, -0.5, -0.5, 1)),
        high(level.worldFromVoxel * glm::dvec4(dims - 0.5, 1));
    EXPECT_LT(glm::length(low - glm::dvec3(10, 20, 30) * 1e-3), 1e-12);
    EXPECT_LT(glm::length(high - glm::dvec3(13.5, 23, 40) * 1e-3), 1e-12);
  }
}

TEST(Imaris, ColoursWindowsNamesAndTimesAreThoseOfTheFile) {
  TempFolder folder;
  writeImaris(folder / "a.ims", {"gzip"});
  auto image = openImage(folder / "a.ims", "");
  EXPECT_EQ(image->head().channelNames.front(), "nuclei");
  ASSERT_EQ(image->head().channelColors.size(), 2u);
  EXPECT_EQ(image->head().channelColors[1], glm::vec3(0, 1, 0.5f));
  ASSERT_EQ(image->channelWindows().size(), 2u);
  EXPECT_EQ(image->channelWindows()[0], glm::dvec2(5, 200));
  EXPECT_NEAR(image->head().timeStepSeconds, 30.5, 1e-9);
  EXPECT_EQ(image->head().modality, Modality::Microscopy);
}

TEST(Imaris, MissingArraysAreZeroAndOthersAreRefused) {
  TempFolder folder;
  fs::path path = folder / "a.ims";
  writeImaris(path, {"gzip"}, [](Hdf5Data& data) {
    if (data.name.find("TimePoint 1/Channel 1") != data.name.npos) data.shape.clear();
  });
  EXPECT_EQ(valueAt(read(path), {1, 1, 1}, 1, 1), 0);
  writeImaris(path, {"gzip"}, [](Hdf5Data& data) {
    if (data.name.find("TimePoint 1/Channel 1") != data.name.npos) data.type = "float32";
  });
  EXPECT_NE(refusalOf(path).find("type"), std::string::npos);
  writeImaris(path, {"gzip"}, [](Hdf5Data& data) { data.shape = {2, 2, 2}; });
  EXPECT_NE(refusalOf(path), "") << "it is smaller than is said";
  writeImaris(path, {"gzip"}, [](Hdf5Data& data) { data.shape.clear(); });
  EXPECT_NE(refusalOf(path).find("missing"), std::string::npos);
}

TEST(Imaris, ALevelThatIsAskedForIsReadAndSaid) {
  TempFolder folder;
  writeImaris(folder / "a.ims", {"lz4"});
  scene::Source source;
  source.path = (folder / "a.ims").string();
  source.level = 1;
  Progress progress;
  Volume v = readVolume(source, progress);
  EXPECT_EQ(v.dims, glm::ivec3(3, 3, 5));
  EXPECT_NE(warningWith(v, "level 1"), "");
  source.level = 2;
  EXPECT_THROW(readVolume(source, progress), InputError);
}

TEST(Imaris, AFileOfAnotherProgramIsRead) {
  VELUM_NEED_TEST_DATA();
  fs::path path = testData() / "pyramids/Minimal_IMS_File.ims";
  if (!fs::exists(path)) GTEST_SKIP() << path << " is not there";
  Volume v = read(path);
  EXPECT_EQ(v.dims, glm::ivec3(128, 128, 1));
  EXPECT_EQ(v.type, SampleType::UInt16);
  EXPECT_NEAR(spacingOf(v).x, 7e-3 / 128, 1e-12);
  EXPECT_NEAR(spacingOf(v).z, 1e-4, 1e-12);
  EXPECT_NEAR(v.worldFromVoxel[3].x, 3e-3 + 3.5e-3 / 128, 1e-12);
  EXPECT_LT(v.range.x, v.range.y);
}

}  // namespace
}  // namespace velum::io
