#include <gtest/gtest.h>

#include "Damage.h"
#include "N5Files.h"
#include "io/stores/OpenStore.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

void writeRoot(const fs::path& folder, Json attributes = Json::object()) {
  fs::create_directories(folder);
  attributes["n5"] = "4.0.0";
  writeBytes(folder / "attributes.json", attributes.dump());
}

void expectRamp(const Volume& v, const std::function<double(const glm::ivec3&)>& value) {
  for (int z = 0; z < v.dims.z; ++z)
    for (int y = 0; y < v.dims.y; ++y)
      for (int x = 0; x < v.dims.x; ++x) ASSERT_EQ(valueAt(v, {x, y, z}), value({x, y, z})) << x << y << z;
}

TEST(N5, EveryTypeCodecAndModeGivesWhatWasWritten) {
  TempFolder folder;
  for (const char* type :
       {"uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float32", "float64"})
    for (const char* codec : {"raw", "gzip", "zlib", "bzip2", "xz", "lz4", "blosc", "zstd"})
      for (bool tellsCount : {false, true}) {
        SCOPED_TRACE(std::string(type) + " " + codec);
        N5File file = n5Ramp(folder / "a.n5");
        fs::remove_all(file.folder);
        file.type = type;
        file.codec = codec;
        file.tellsCount = tellsCount;
        bool isSigned = type[0] != 'u';
        file.value = [=](const Sizes& i) {
          double value = double((i[2] * 42 + i[1] * 7 + i[0]) % 128);
          return isSigned && i[0] % 2 ? -value : value;
        };
        file.write();
        Volume v = read(file.folder);
        ASSERT_EQ(v.dims, glm::ivec3(7, 6, 5));
        expectRamp(v, [&](const glm::ivec3& at) {
          return file.value({std::uint64_t(at.x), std::uint64_t(at.y), std::uint64_t(at.z)});
        });
      }
}

TEST(N5, MissingBlocksAreZero) {
  TempFolder folder;
  N5File file = n5Ramp(folder / "a.n5");
  file.isThere = [](const Sizes& index) { return index[0] != 1; };
  file.write();
  expectRamp(read(file.folder),
             [](const glm::ivec3& at) { return at.x < 4 ? double(at.z * 42 + at.y * 7 + at.x) : 0.0; });
  std::vector<std::uint16_t> samples(18, 77);  // 3 x 3 x 2 at the far border
  SampleTarget target{reinterpret_cast<std::byte*>(samples.data()), 2, 6, 18, 0, 0};
  openImage(file.folder, "")->read({0, {1, 0, 0}}, target);
  EXPECT_EQ(samples, std::vector<std::uint16_t>(18, 0)) << "whatever was there";
}

TEST(N5, BlocksThatAreSmallerThanSaidAreZeroBeyond) {
  TempFolder folder;
  N5File file = n5Ramp(folder / "a.n5");
  file.write();
  file.shape = {2, 2, 2};  // as a writer that trims blocks to what is not empty
  writeBytes(file.folder / "0/0/0", file.blockBytes({0, 0, 0}));
  Volume v = read(file.folder);
  EXPECT_EQ(valueAt(v, {1, 1, 1}), 50);
  EXPECT_EQ(valueAt(v, {3, 1, 1}), 0);
  EXPECT_EQ(valueAt(v, {4, 1, 1}), 53);
}

TEST(N5, LevelsLieOnEachOther) {
  TempFolder folder;
  writeRoot(folder / "a.n5", {{"pixelResolution", {{"unit", "um"}, {"dimensions", {0.5, 0.5, 2}}}}});
  N5File fine = n5Ramp(folder / "a.n5/s0"), coarse = n5Ramp(folder / "a.n5/s1");
  fine.write();
  coarse.shape = {3, 3, 5};
  coarse.more = {{"downsamplingFactors", {2, 2, 1}}};
  coarse.write();
  auto image = openImage(folder / "a.n5", "");
  ASSERT_EQ(image->levels().size(), 2u);
  EXPECT_EQ(image->head().lengthUnit, LengthUnit::Millimetre);
  EXPECT_TRUE(image->head().isSpacingKnown);
  EXPECT_EQ(image->head().modality, Modality::Microscopy);
  EXPECT_NEAR(image->levels()[0].worldFromVoxel[2][2], 2e-3, 1e-15);
  // Its first voxel is the mean of four: its centre lies between theirs.
  glm::dvec4 first = image->levels()[1].worldFromVoxel * glm::dvec4(0, 0, 0, 1),
             mean = image->levels()[0].worldFromVoxel * glm::dvec4(0.5, 0.5, 0, 1);
  EXPECT_LT(glm::length(first - mean), 1e-15);
  EXPECT_EQ(image->facts().levels[1].key, "s1");
  // Without factors they follow from the sizes.
  coarse.more = Json::object();
  coarse.write();
  expectSameMatrix(openImage(folder / "a.n5", "")->levels()[1].worldFromVoxel, image->levels()[1].worldFromVoxel,
                   1e-15);
}

TEST(N5, PlacesOfOtherProgramsAreRead) {
  TempFolder folder;
  N5File file = n5Ramp(folder / "a.n5");
  file.more = {{"transform",
                {{"axes", {"z", "y", "x"}},
                 {"scale", {5.24, 4.0, 4.0}},
                 {"translate", {1.0, 2.0, 3.0}},
                 {"units", {"nm", "nm", "nm"}}}}};
  file.write();
  glm::dmat4 world = openImage(file.folder, "")->head().worldFromVoxel;
  EXPECT_NEAR(world[2][2], 5.24e-6, 1e-18);
  EXPECT_NEAR(world[3][0], 3e-6, 1e-18);
  file.more = {{"resolution", {4, 4, 40}}, {"units", {"nm", "nm", "nm"}}};
  file.write();
  EXPECT_NEAR(openImage(file.folder, "")->head().worldFromVoxel[2][2], 4e-5, 1e-18);
  file.more = Json::object();
  file.write();
  EXPECT_FALSE(openImage(file.folder, "")->head().isSpacingKnown);
}

TEST(N5, FurtherAxesAreChannelsAndTime) {
  TempFolder folder;
  N5File file = n5Ramp(folder / "a.n5");
  file.shape = {7, 6, 5, 3, 2};
  file.block = {4, 3, 2, 2, 1};
  file.value = [](const Sizes& i) { return double(i[4] * 1000 + i[3] * 300 + i[2] * 42 + i[1] * 7 + i[0]); };
  file.write();
  Volume v = read(file.folder);
  EXPECT_EQ(v.channels, 3);
  EXPECT_EQ(v.timeSteps, 2);
  for (int t = 0; t < 2; ++t)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(valueAt(v, {6, 5, 4}, c, t), t * 1000 + c * 300 + 4 * 42 + 5 * 7 + 6);
}

TEST(N5, ImagesInGroupsAreListed) {
  TempFolder folder;
  fs::path root = folder / "a.n5";
  writeRoot(root);
  n5Ramp(root / "em/raw/s0").write();
  n5Ramp(root / "em/raw/s1").write();
  n5Ramp(root / "labels").write();
  auto images = imagesIn(root);
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[0].key, "em/raw");
  EXPECT_EQ(images[1].key, "labels");
  EXPECT_EQ(openImage(root, "em/raw")->levels().size(), 2u);
  EXPECT_NE(warningWith(openImage(root, "")->head(), "2 images"), "");
  EXPECT_THROW(openImage(root, "none"), InputError);
  EXPECT_THROW(openImage(root, "../a.n5"), InputError);
  EXPECT_TRUE(isStore(root / "em/raw")) << "a group may be given as well";
}

TEST(N5, EveryDamageOfABlockOrOfAttributesIsRefusedOrRead) {
  TempFolder folder;
  for (const char* codec : {"raw", "gzip", "bzip2", "xz", "lz4", "blosc", "zstd"}) {
    SCOPED_TRACE(codec);
    N5File file = n5Ramp(folder / (std::string(codec) + ".n5"));
    file.codec = codec;
    file.write();
    fs::path block = file.folder / "0/0/0";
    std::string good = bytesOf(block);
    for (std::size_t size = 0; size + 1 < good.size(); size += 1 + good.size() / 64) {
      // Java's LZ4 and bzip2 end with some bytes that hold nothing.
      bool mayBeWhole = size + 25 > good.size();
      writeText(block, good.substr(0, size));
      if (!mayBeWhole) {
        EXPECT_NE(refusalOf(file.folder), "") << "cut to " << size;
      }
    }
    expectReadOrRefused(good, block, 60, [&] { read(file.folder); });
    writeText(block, good);
    fs::path attributes = file.folder / "attributes.json";
    expectReadOrRefused(bytesOf(attributes), attributes, 60, [&] { read(file.folder); });
  }
}

TEST(N5, LiesAndStrangersAreRefusedInOneLine) {
  TempFolder folder;
  auto with = [&](const char* name, const Json& value) {
    N5File file = n5Ramp(folder / "a.n5");
    fs::remove_all(file.folder);
    file.more = {{name, value}};
    file.write();
    return refusalOf(file.folder);
  };
  auto has = [](const std::string& message, const char* word) { return message.find(word) != message.npos; };
  EXPECT_NE(with("dimensions", {1000000, 1000000, 1000000}), "");
  EXPECT_NE(with("dimensions", {4, 6, 1e30}), "");
  EXPECT_NE(with("dimensions", {4, 6, -8}), "");
  EXPECT_NE(with("dimensions", {4, 6}), "");
  EXPECT_NE(with("dimensions", {1, 1, 1, 1, 1, 1}), "");
  EXPECT_NE(with("blockSize", {0, 3, 4}), "");
  EXPECT_NE(with("blockSize", {100000, 100000, 100000}), "");
  EXPECT_TRUE(has(with("compression", {{"type", "jpeg"}}), "jpeg"));
  EXPECT_TRUE(has(with("dataType", "object"), "object"));
  EXPECT_NE(with("blockSize", {2, 3, 4}), "") << "the blocks are larger than said";
  fs::create_directories(folder / "empty.n5");
  EXPECT_TRUE(has(refusalOf(folder / "empty.n5"), "no image"));
}

}  // namespace
}  // namespace velum::io
