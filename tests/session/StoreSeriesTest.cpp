#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "TempFolder.h"
#include "core/BrickCache.h"
#include "io/labels/LabelStore.h"
#include "io/phantoms/Sample.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "scene/Presets.h"
#include "session/document/Open.h"
#include "session/document/Series.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

/// A store as bioformats2raw writes it, of two images, the first with labels.
class StoreOfSeries : public testing::Test {
 protected:
  void SetUp() override {
    io::Sample sample = io::makeSample("two-spheres", 32, mProgress);
    fs::create_directories(store());
    for (const char* name : {"0", "1"}) {
      io::writeStore(VolumeSource(sample.volume), mFolder / "one.zarr", {}, mProgress);
      fs::rename(mFolder / "one.zarr", store() / name);
    }
    io::writeLabelStore(sample.labels, mFolder / "one.zarr", io::OmeVersion::V05, mProgress);
    fs::create_directories(store() / "0" / "labels");
    fs::rename(mFolder / "one.zarr", store() / "0" / "labels" / "balls");
    group(store(), R"("bioformats2raw.layout":3)");
    group(store() / "0" / "labels", R"("labels":["balls"])");
  }
  static void group(const fs::path& folder, const std::string& ome) {
    std::ofstream(folder / "zarr.json")
        << R"({"zarr_format":3,"node_type":"group","attributes":{"ome":{"version":"0.5",)" << ome << "}}}";
  }
  /// The same in one file.
  fs::path archive() {
    std::string command = "cd '" + store().string() +
                          "' && python3 -c \"import zipfile,os\nz=zipfile.ZipFile('../a.ozx'," +
                          "'w')\nfor r,d,f in os.walk('.'):\n  for n in f: z.write(os.path.join(r,n))\n\"";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return mFolder / "a.ozx";
  }
  fs::path store() const { return mFolder / "all.zarr"; }

  TempFolder mFolder;
  Progress mProgress;
};

TEST_F(StoreOfSeries, AreOfferedWithLabelsAndPictures) {
  for (const fs::path& path : {store(), archive()}) {
    SCOPED_TRACE(path);
    ASSERT_TRUE(mayHoldSeries(path));
    auto series = seriesIn(path, mProgress);
    ASSERT_EQ(series.size(), 2u);
    EXPECT_EQ(series[1].uid, "1");
    ASSERT_EQ(series[0].labels.size(), 1u);
    EXPECT_EQ(series[0].labels[0].name, "balls");
    EXPECT_TRUE(series[1].labels.empty());
    Image picture = seriesPicture(series[0], 16, mProgress);
    EXPECT_GT(picture.width, 8);
  }
}

TEST_F(StoreOfSeries, OpenWithTheLabelsThatAreChosen) {
  for (const fs::path& path : {store(), archive()}) {
    SCOPED_TRACE(path);
    Series chosen = seriesIn(path, mProgress).front();
    Loaded loaded = readSeries(path.string(), chosen.uid, chosen.labels.front(), mProgress, {});
    EXPECT_EQ(loaded.scene.volume.source.series, "0");
    ASSERT_TRUE(loaded.scene.labels.data);
    EXPECT_EQ(loaded.scene.labels.source.path, path.string());
    EXPECT_EQ(loaded.scene.labels.source.series, "0/labels/balls");
    // A path that leads into the store says the same.
    Loaded again = readPaths({(path / "0").string(), (path / "0/labels/balls").string()}, mProgress, {});
    EXPECT_TRUE(again.scene.volume.data && again.scene.labels.data);
  }
}

TEST(VanishedStore, IsSaidAndNotTakenForEmpty) {
  TempFolder folder;
  Progress progress;
  io::StoreOptions old;
  old.version = io::OmeVersion::V04;  // a file for each brick
  io::Sample sample = io::makeSample("two-spheres", 32, progress);
  io::writeStore(VolumeSource(sample.volume), folder / "a.zarr", old, progress);
  auto image = io::openImage(folder / "a.zarr", "");
  BrickCache bricks(std::move(image), 1 << 20);
  fs::rename(folder / "a.zarr", folder / "away");
  try {
    bricks.brick({});
    ADD_FAILURE() << "nothing is there";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is gone"), std::string::npos) << error.what();
  }
  fs::rename(folder / "away", folder / "a.zarr");
  EXPECT_FALSE(bricks.brick({})->empty()) << "it is there again";
}

TEST(ChannelWindows, AreTheFirstLookWhereTheyChooseSomething) {
  Volume volume;
  volume.dims = {8, 8, 8};
  volume.channels = 2;
  volume.voxels.resize(timeStepBytes(volume));
  for (std::size_t i = 0; i < volume.voxels.size(); ++i) volume.voxels[i] = std::byte(i % 251);
  computeRange(volume);
  volume.channelWindows = {{30.0, 90.0}, {0.0, 255.0}};
  scene::VolumeLayer layer;
  layer.data = Shared<Volume>(std::move(volume));
  EXPECT_FALSE(scene::fileWindow(*layer.data, 1)) << "all values: nobody chose them";
  scene::completeChannels(layer);
  ASSERT_EQ(layer.channels.size(), 2u);
  EXPECT_DOUBLE_EQ(layer.channels[0].windowLevel, 60.0);
  EXPECT_DOUBLE_EQ(layer.channels[0].windowWidth, 60.0);
  EXPECT_DOUBLE_EQ(layer.channels[0].transfer.opacities.back().value, 90.0);
}

}  // namespace
}  // namespace velum::session
