#include "io/images/ImageFile.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <thread>

#include "PeakMemory.h"
#include "TestFiles.h"
#include "core/Error.h"
#include "io/images/ImageCompare.h"

namespace velum::io {
namespace {

Image noise(int width, int height, std::vector<std::string> channels, bool eightBit) {
  Image image{width, height, std::move(channels), {}};
  std::mt19937 random(3);
  image.pixels.resize(std::size_t(width * height) * image.channels.size());
  for (auto& v : image.pixels) v = eightBit ? float(random() % 256) / 255.0f : float(random() % 10000) / 7000.0f - 0.2f;
  return image;
}

std::string longScene() {
  std::string text = "{\"version\":1,\"name\":\"caf\xc3\xa9\",\"points\":[";
  for (int i = 0; text.size() < 200'000; ++i) text += std::to_string(i * 17) + (i % 9 ? ", " : ",\n  ");
  return text + "0]}";
}

TEST(ImageFile, EightBitsSurvivePngAndTiff) {
  TempFolder folder;
  for (const char* name : {"a.png", "a.tif"})
    for (bool alpha : {false, true}) {
      Image image = noise(
          31, 17, alpha ? std::vector<std::string>{"R", "G", "B", "A"} : std::vector<std::string>{"R", "G", "B"}, true);
      writeImage(image, folder / name);
      Image back = readImage(folder / name);
      EXPECT_EQ(back.channels, image.channels) << name;
      EXPECT_EQ(compareImages(image, back, 0).maxDifference, 0.0) << name << alpha;
    }
}

TEST(ImageFile, SixteenBitsSurvivePngAndTiff) {
  TempFolder folder;
  for (const char* name : {"a.png", "a.tif"})
    for (std::size_t count : {1u, 3u, 4u}) {
      std::vector<std::string> all{"R", "G", "B", "A"};
      Image image =
          count == 1 ? noise(31, 17, {"Y"}, false) : noise(31, 17, {all.begin(), all.begin() + int(count)}, false);
      for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = float(i * 8191 % 65536) / 65535.0f;
      writeImage(image, folder / name, {}, 300, {}, 16);
      Image back = readImage(folder / name);
      ASSERT_EQ(back.pixels.size(), image.pixels.size()) << name;
      for (std::size_t i = 0; i < image.pixels.size(); ++i)
        ASSERT_EQ(std::lround(back.pixels[i] * 65535.0f), long(i * 8191 % 65536)) << name << count << " at " << i;
    }
}

TEST(ImageFile, ExrLayersAreFloatExact) {
  TempFolder folder;
  Image image = noise(13, 9, {"R", "G", "B", "A", "Z", "normal.X", "normal.Y", "normal.Z", "id"}, false);
  for (std::size_t i = 3; i < image.pixels.size(); i += 9) image.pixels[i] = 0.25f + 0.5f * float(i % 2);
  image.pixels[4] = std::numeric_limits<float>::infinity();
  image.pixels[9 + 8] = 16777215.0f;
  writeImage(image, folder / "a.exr");
  Image back = readImage(folder / "a.exr");
  ASSERT_EQ(back.channels.size(), image.channels.size());
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    auto to =
        std::size_t(std::find(back.channels.begin(), back.channels.end(), image.channels[c]) - back.channels.begin());
    ASSERT_LT(to, back.channels.size()) << image.channels[c];
    for (std::size_t i = 0; i < std::size_t(13 * 9); ++i) {
      float wrote = image.pixels[i * 9 + c], read = back.pixels[i * 9 + to];
      // Colour goes through the sRGB curve and alpha and comes back within float's rounding of them.
      if (c < 3)
        EXPECT_NEAR(wrote, read, 2e-6) << image.channels[c];
      else
        EXPECT_EQ(wrote, read) << image.channels[c];
    }
  }
}

TEST(ImageFile, ColourInExrIsLinearAndPremultipliedInEachLayer) {
  // As another program finds it.
  TempFolder folder;
  std::vector<std::string> channels{"R", "G", "B", "A", "front.R", "front.G", "front.B", "front.A", "normal.X"};
  Image image{1, 1, channels, {0.5f, 0.25f, 1.0f, 0.5f, 0.75f, 0.5f, 0.25f, 0.25f, 0.5f}};
  writeImage(image, folder / "a.exr");
  auto in = OIIO::ImageInput::open((folder / "a.exr").string());
  ASSERT_TRUE(in);
  std::vector<std::string> names = in->spec().channelnames;
  std::vector<float> values(names.size());
  ASSERT_TRUE(in->read_image(0, 0, 0, int(names.size()), OIIO::TypeDesc::FLOAT, values.data()));
  auto linear = [](double v) { return std::pow((v + 0.055) / 1.055, 2.4); };
  std::vector<double> expected{linear(0.5) * 0.5,  linear(0.25) * 0.5,  0.5,  0.5, linear(0.75) * 0.25,
                               linear(0.5) * 0.25, linear(0.25) * 0.25, 0.25, 0.5};
  for (std::size_t c = 0; c < channels.size(); ++c) {
    auto found = std::find(names.begin(), names.end(), channels[c]);
    ASSERT_NE(found, names.end()) << channels[c];
    EXPECT_NEAR(values[std::size_t(found - names.begin())], expected[c], 1e-5) << channels[c];
  }
}

TEST(ImageFile, ALongDescriptionSurvivesEveryFormat) {
  TempFolder folder;
  Image image = noise(5, 4, {"R", "G", "B", "A"}, true);
  std::string scene = longScene();
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    writeImage(image, folder / name, scene);
    EXPECT_TRUE(readImageDescription(folder / name) == scene) << name;
    writeImage(image, folder / name);
    EXPECT_EQ(readImageDescription(folder / name), "") << name;
  }
}

TEST(ImageFile, TheSamePictureGivesTheSameBytes) {
  TempFolder folder;
  Image image = noise(40, 30, {"R", "G", "B", "A"}, true);
  for (const char* name : {"a.png", "a.tif", "a.exr"}) writeImage(image, folder / name, "{}");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // a date in seconds would differ
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    writeImage(image, folder / (std::string("b") + name), "{}");
    EXPECT_TRUE(bytesOf(folder / name) == bytesOf(folder / (std::string("b") + name))) << name;
  }
}

TEST(ImageFile, NothingIsLeftBesideThePicture) {
  TempFolder folder;
  Image image = noise(4, 4, {"Z", "id"}, true);
  EXPECT_THROW(writeImage(image, folder / "a.png"), InputError);
  EXPECT_THROW(writeImage(image, folder / "a.jpg"), InputError);
  EXPECT_THROW(writeImage(image, folder / "none" / "a.exr"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(ImageFile, PngKeepsColourAndLeavesLayersOut) {
  TempFolder folder;
  Image image = noise(4, 4, {"Z", "R", "G", "B"}, true);
  writeImage(image, folder / "a.png");
  Image back = readImage(folder / "a.png");
  EXPECT_EQ(back.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(back.pixels[1], image.pixels[2]);
}

TEST(ImageFile, DamageIsAnInputError) {
  TempFolder folder;
  Image image = noise(64, 64, {"R", "G", "B"}, true);
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    writeImage(image, folder / name);
    std::string bytes = bytesOf(folder / name);
    for (std::size_t keep : {std::size_t(0), std::size_t(7), bytes.size() / 2}) {
      std::ofstream(folder / name, std::ios::binary) << bytes.substr(0, keep);
      EXPECT_THROW(readImage(folder / name), InputError) << name << keep;
    }
  }
  EXPECT_THROW(readImage(folder / "missing.png"), InputError);
  EXPECT_THROW(readImageDescription(folder.path()), InputError);
}

TEST(ImageFile, AttributesOfExrThatLieAllocateNothing) {
  TempFolder folder;
  writeImage(noise(4, 4, {"R", "G", "B"}, true), folder / "a.exr", "{}");
  const std::string good = bytesOf(folder / "a.exr");
  // Beyond the file; a list that ends before it ends, so that what follows is read as other attributes.
  for (auto [before, size] : {std::pair(std::string("velum:scene\0string\0", 19), "\xff\xff\xff\x7f"),
                              {std::string("channels\0chlist\0", 16), "\x38\x00\x00\x00"},
                              {std::string("dataWindow\0box2i\0", 17), "\x11\x00\x00\x00"}}) {
    std::string bytes = good;
    std::size_t at = bytes.find(before);
    ASSERT_NE(at, std::string::npos);
    bytes.replace(at + before.size(), 4, size, 4);
    std::ofstream(folder / "a.exr", std::ios::binary) << bytes;
    std::size_t growth = peakGrowth([&] {
      EXPECT_THROW(readImage(folder / "a.exr"), InputError);
      EXPECT_THROW(readImageDescription(folder / "a.exr"), InputError);
    });
    EXPECT_LT(growth, std::size_t(64) << 20);
  }
}

TEST(ImageFile, AChunkOfPngThatLiesIsRefusedBeforeTheLibrarySeesIt) {
  TempFolder folder;
  writeImage(noise(4, 4, {"R", "G", "B"}, true), folder / "a.png", "{}");
  const std::string good = bytesOf(folder / "a.png");
  std::size_t at = good.find("tEXt");
  ASSERT_NE(at, std::string::npos);
  std::string lies = good, cutOff = good.substr(0, good.size() - 12);
  lies.replace(at - 4, 4, "\x7b\x00\x00\x14", 4);
  for (const std::string& bytes : {lies, cutOff}) {
    std::ofstream(folder / "a.png", std::ios::binary) << bytes;
    for (auto read : {+[](const std::filesystem::path& path) { readImage(path); },
                      +[](const std::filesystem::path& path) { readImageDescription(path); }})
      try {
        read(folder / "a.png");
        FAIL();
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("cut short or damaged"), std::string::npos) << error.what();
      }
  }
}

TEST(ImageFile, TheLibrarySaysNothingOfItsOwnAboutDamage) {
  TempFolder folder;
  writeImage(noise(64, 64, {"R", "G", "B"}, true), folder / "a.png", longScene());
  const std::string good = bytesOf(folder / "a.png");
  for (const char* chunk : {"IHDR", "tEXt", "IDAT"}) {
    std::string bytes = good;
    bytes[bytes.find(chunk) + 9] ^= 0x55;  // what it holds; its check sum no longer fits
    std::ofstream(folder / "a.png", std::ios::binary) << bytes;
    for (auto read : {+[](const std::filesystem::path& path) { readImage(path); },
                      +[](const std::filesystem::path& path) { readImageDescription(path); }}) {
      std::string what;
      testing::internal::CaptureStderr();
      try {
        read(folder / "a.png");
      } catch (const InputError& error) {
        what = error.what();
      }
      EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << chunk;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
  }
}

TEST(ImageFile, AnUnknownFormatIsRefusedBeforeThereIsAPicture) {
  for (const char* name : {"a.png", "b.TIF", "c.tiff", "d.exr", "-"}) EXPECT_NO_THROW(expectImageFormat(name)) << name;
  for (const char* name : {"a.bmp", "a.jpg", "a", ".png.gz"}) EXPECT_THROW(expectImageFormat(name), InputError) << name;
}

TEST(ImageFile, OnlyOurThreeFormatsAreReadWhateverTheNameSays) {
  TempFolder folder;
  Image image = noise(4, 4, {"R", "G", "B"}, true);
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    std::ofstream(folder / name, std::ios::binary) << "P6\n1 1\n255\nabc";
    EXPECT_THROW(readImage(folder / name), InputError) << name;
    EXPECT_THROW(readImageDescription(folder / name), InputError) << name;
    writeImage(image, folder / name);
    std::filesystem::rename(folder / name, folder / "b.png");
    EXPECT_EQ(readImage(folder / "b.png").width, 4) << name;
  }
}

TEST(ImageCompare, DistanceLaws) {
  Image a = noise(10, 10, {"R", "G", "B"}, true), b = a;
  EXPECT_EQ(compareImages(a, b, 0).failingFraction, 0.0);
  b.pixels[30] = std::min(1.0f, b.pixels[30] - 10.0f / 255.0f);
  auto ab = compareImages(a, b, 5), ba = compareImages(b, a, 5);
  EXPECT_NEAR(ab.maxDifference, 10.0, 1e-4);
  EXPECT_NEAR(ab.failingFraction, 0.01, 1e-12);
  EXPECT_NEAR(ab.rms, 10.0 / std::sqrt(300.0), 1e-4);
  EXPECT_EQ(ab.maxDifference, ba.maxDifference);
  EXPECT_EQ(compareImages(a, b, 10).failingFraction, 0.0);
}

TEST(ImageCompare, ANanIsAsFarAsCanBe) {
  Image a = noise(2, 2, {"R", "G", "B"}, true), b = a;
  b.pixels[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(compareImages(a, b, 5).maxDifference, 255.0);
  EXPECT_EQ(compareImages(b, b, 5).maxDifference, 0.0);
}

TEST(ImageCompare, ChannelsMatchByName) {
  Image a = noise(3, 3, {"R", "G", "B"}, true), b = a;
  b.channels = {"B", "G", "R"};
  for (std::size_t i = 0; i < b.pixels.size(); i += 3) std::swap(b.pixels[i], b.pixels[i + 2]);
  EXPECT_EQ(compareImages(a, b, 0).maxDifference, 0.0);
}

TEST(ImageCompare, OtherShapesAreRefused) {
  Image a = noise(3, 3, {"R", "G", "B"}, true);
  EXPECT_THROW(compareImages(a, noise(3, 4, {"R", "G", "B"}, true), 5), InputError);
  EXPECT_THROW(compareImages(a, noise(3, 3, {"R", "G", "B", "A"}, true), 5), InputError);
}

TEST(ImageCompare, TheThresholdIsMidGrey) {
  Image a{2, 1, {"R", "G", "B", "A"}, {0, 0, 0, 1, 0, 0, 0, 1}}, b = a;
  b.pixels[0] = 5.0f / 255.0f;
  b.pixels[7] = 0.0f;
  Image d = differenceImage(a, b, 5);
  EXPECT_NEAR(d.pixels[0], 0.5f, 1e-5);
  EXPECT_EQ(d.pixels[1], 0.0f);
  EXPECT_EQ(d.pixels[3], 1.0f);
  EXPECT_EQ(d.pixels[4], 1.0f);  // alpha differs: shown in colour
}

}  // namespace
}  // namespace velum::io
