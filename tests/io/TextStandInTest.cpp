// Scenes in pictures that take no memory of the library's.
#include "io/images/TextStandIn.h"

#include <gtest/gtest.h>

#include "TestFiles.h"
#include "core/Memory.h"
#include "io/images/ImageFile.h"

namespace velum::io {
namespace {

Image small() {
  Image image{8, 6, {"R", "G", "B"}, {}};
  for (int i = 0; i < 8 * 6 * 3; ++i) image.pixels.push_back(float(i % 17) / 16.0f);
  return image;
}

/// As the scene of a frame.
std::string sceneText(int frame, std::size_t size) {
  std::string text = "{\"frame\":" + std::to_string(10'000 + frame) + ",\"name\":\"caf\xc3\xa9\",\"points\":[";
  for (int i = frame; text.size() + 8 < size; ++i) text += std::to_string(i * 17) + ", ";
  return text + "0]}\n";
}

TEST(TextStandIn, TheFileIsAsTheLibraryWouldWriteIt) {
  TempFolder folder;
  for (const char* name : {"a.tif", "a.exr"})
    for (std::size_t size : {2'000u, 20'001u, 300'000u}) {
      std::string text = sceneText(3, size), crosses(text.size(), 'x');  // crosses are written as they are
      writeImage(small(), folder / name, text);
      std::string got = bytesOf(folder / name);
      EXPECT_EQ(readImageDescription(folder / name), text) << name;
      EXPECT_EQ(readImage(folder / name).channels, small().channels);
      writeImage(small(), folder / name, crosses);
      std::string expected = bytesOf(folder / name);
      std::size_t at = expected.find(crosses);
      ASSERT_NE(at, expected.npos) << name;
      expected.replace(at, text.size(), text);
      EXPECT_TRUE(got == expected) << name;
      EXPECT_EQ(expected.find("xxxxxxxx"), expected.npos) << name << ": the text stands there once";
    }
}

TEST(TextStandIn, ManyTextsTakeNoMemory) {
  TempFolder folder;
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    std::size_t before = 0;
    for (int frame = 0; frame < 100; ++frame) {
      std::string text = sceneText(frame, 20'000);
      writeImage(small(), folder / name, text);
      if (frame % 40 == 0) {
        EXPECT_NE(bytesOf(folder / name).find(text), std::string::npos) << name;
      }
      if (frame == 20) before = allocatedBytes();
    }
    EXPECT_LT(double(allocatedBytes()), double(before) + 300e3) << name << ": 79 texts of 20 KB are 1.6 MB";
  }
}

}  // namespace
}  // namespace velum::io
