#include "io/video/VideoWriter.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "SmallDisk.h"
#include "TempFolder.h"
#include "core/Error.h"
#include "io/video/FedProgram.h"
#include "runProgram.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// Sixteen patches of one colour each: the corners of the cube of colours, greys, and some between.
constexpr glm::u8vec3 kPatches[16] = {{0, 0, 0},     {255, 255, 255}, {255, 0, 0},     {0, 255, 0},
                                      {0, 0, 255},   {255, 255, 0},   {0, 255, 255},   {255, 0, 255},
                                      {16, 16, 16},  {64, 64, 64},    {128, 128, 128}, {235, 235, 235},
                                      {200, 60, 30}, {30, 120, 200},  {90, 160, 70},   {180, 150, 210}};
constexpr int kPatch = 16;

/// Patches four by four, turned by so many; then `left` columns and `top` rows are cut off.
Image patches(int turn = 0, glm::ivec2 size = {4 * kPatch, 4 * kPatch}) {
  Image image{size.x, size.y, {"R", "G", "B", "A"}, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      glm::u8vec3 color = kPatches[(x / kPatch + y / kPatch * 4 + turn) % 16];
      for (int c = 0; c < 3; ++c) image.pixels.push_back(float(color[c]) / 255.0f);
      image.pixels.push_back(x < size.x / 2 ? 1.0f : 0.0f);
    }
  return image;
}

std::string bytesOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A field of the video's stream, or of its format, as ffprobe reads it.
std::string probe(const fs::path& path, const std::string& field) {
  std::string said =
      outputOf(fmt::format("ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                           "stream={}:stream_tags={} -of default=nw=1:nk=1 '{}'",
                           field, field, path.string()));
  return said.substr(0, said.find('\n'));
}

/// The frames as ffmpeg decodes them, by the tags that the file has, in RGB or RGBA.
std::string decoded(const fs::path& path, const char* decoder = "", const char* pixels = "rgb24") {
  return outputOf(
      fmt::format("ffmpeg -v error {} -i '{}' -vf scale=flags=accurate_rnd+full_chroma_int -vsync passthrough -f "
                  "rawvideo -pix_fmt {} -",
                  decoder, path.string(), pixels));
}

class VideoWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!hasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed: apt install ffmpeg";
  }
  void write(const fs::path& path, int frames, const VideoOptions& options = {},
             glm::ivec2 size = {4 * kPatch, 4 * kPatch}) {
    VideoWriter video(path, size, options);
    for (int i = 0; i < frames; ++i) video.write(patches(i, size));
    video.finish();
  }
  std::size_t filesThere() const { return std::size_t(std::distance(fs::directory_iterator(mFolder.path()), {})); }

  TempFolder mFolder;
};

TEST_F(VideoWriterTest, SaysWhatItIsToWhoeverPlaysIt) {
  for (const char* name : {"a.mp4", "a.webm"}) {
    fs::path path = mFolder / name;
    write(path, 7, {24.0});
    EXPECT_EQ(probe(path, "codec_name"), fs::path(name).extension() == ".mp4" ? "h264" : "vp9");
    EXPECT_EQ(probe(path, "pix_fmt"), "yuv420p") << name;
    for (const char* field : {"color_space", "color_transfer", "color_primaries"})
      EXPECT_EQ(probe(path, field), "bt709") << name << field;
    EXPECT_EQ(probe(path, "color_range"), "tv") << name;
    EXPECT_EQ(probe(path, "r_frame_rate"), "24/1") << name;
    EXPECT_EQ(probe(path, "nb_read_frames"), "7") << name;
    EXPECT_EQ(probe(path, "width"), "64") << name;
  }
  // The index stands before the frames, so that a browser can begin.
  std::string bytes = bytesOf(mFolder / "a.mp4");
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat"));
}

TEST_F(VideoWriterTest, ColoursComeBackWithinTwoOf255) {
  for (const char* name : {"a.mp4", "a.webm"}) {
    write(mFolder / name, 3, {25.0, 100});
    std::string pixels = decoded(mFolder / name);
    ASSERT_EQ(pixels.size(), std::size_t(3 * 64 * 64 * 3)) << name;
    for (int frame = 0; frame < 3; ++frame)
      for (int patch = 0; patch < 16; ++patch)
        for (int c = 0; c < 3; ++c) {
          // In the middle of a patch: chroma has half of the resolution.
          int x = patch % 4 * kPatch + kPatch / 2, y = patch / 4 * kPatch + kPatch / 2;
          int got = std::uint8_t(pixels[std::size_t(((frame * 64 + y) * 64 + x) * 3 + c)]);
          EXPECT_NEAR(got, kPatches[(patch + frame) % 16][c], 2) << name << " patch " << patch << " channel " << c;
        }
  }
}

TEST_F(VideoWriterTest, OddSidesGetTheirLastRowAndColumnTwice) {
  glm::ivec2 odd{63, 61};
  write(mFolder / "a.mp4", 2, {25.0, 100}, odd);
  EXPECT_EQ(probe(mFolder / "a.mp4", "width"), "64");
  EXPECT_EQ(probe(mFolder / "a.mp4", "height"), "62");
  std::string pixels = decoded(mFolder / "a.mp4");
  ASSERT_EQ(pixels.size(), std::size_t(2 * 64 * 62 * 3));
  for (int x : {8, 24, 40, 56})
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(std::uint8_t(pixels[std::size_t((61 * 64 + x) * 3 + c)]), kPatches[12 + x / kPatch][c], 3);
  write(mFolder / "a.gif", 2, {}, odd);
  EXPECT_EQ(probe(mFolder / "a.gif", "width"), "63");
}

TEST_F(VideoWriterTest, AlphaIsKeptWhereTheFormatHasIt) {
  VideoOptions options{25.0, 100, true};
  for (auto [name, decoder] : {std::pair("a.webm", "-c:v libvpx-vp9"), std::pair("a.gif", "")}) {
    write(mFolder / name, 2, options);
    std::string pixels = decoded(mFolder / name, decoder, "rgba");
    ASSERT_EQ(pixels.size(), std::size_t(2 * 64 * 64 * 4)) << name;
    for (int x = 4; x < 64; x += 8)
      EXPECT_NEAR(std::uint8_t(pixels[std::size_t((20 * 64 + x) * 4 + 3)]), x < 32 ? 255 : 0, 2) << name << x;
  }
  EXPECT_THROW(expectVideo("a.mp4", options), ArgumentError);
}

TEST_F(VideoWriterTest, AGifRepeatsForEverAtTheNearestRateThatItHas) {
  write(mFolder / "a.gif", 5, {20.0});
  EXPECT_EQ(probe(mFolder / "a.gif", "nb_read_frames"), "5");
  EXPECT_EQ(probe(mFolder / "a.gif", "r_frame_rate"), "20/1");
  std::string bytes = bytesOf(mFolder / "a.gif");
  std::size_t loop = bytes.find("NETSCAPE2.0");
  ASSERT_NE(loop, std::string::npos);
  EXPECT_EQ(bytes.substr(loop + 11, 4), std::string("\3\1\0\0", 4));  // 0: for ever
  EXPECT_EQ(videoNote("a.gif", {20.0}), "");
  EXPECT_NE(videoNote("a.gif", {30.0}).find("3 or 4"), std::string::npos);
  EXPECT_EQ(videoNote("a.mp4", {30.0}), "");
  EXPECT_THROW(expectVideo("a.gif", {60.0}), ArgumentError);
  // Colours of few patches are kept as they are.
  std::string pixels = decoded(mFolder / "a.gif");
  ASSERT_GE(pixels.size(), std::size_t(64 * 64 * 3));
  for (int patch = 0; patch < 16; ++patch)
    for (int c = 0; c < 3; ++c) {
      int x = patch % 4 * kPatch + kPatch / 2, y = patch / 4 * kPatch + kPatch / 2;
      EXPECT_NEAR(std::uint8_t(pixels[std::size_t((y * 64 + x) * 3 + c)]), kPatches[patch][c], 3) << patch;
    }
}

TEST_F(VideoWriterTest, TheSameFramesGiveTheSameBytes) {
  for (const char* ending : {".mp4", ".webm", ".gif"}) {
    write(mFolder / (std::string("a") + ending), 12);
    write(mFolder / (std::string("b") + ending), 12);
    EXPECT_EQ(bytesOf(mFolder / (std::string("a") + ending)), bytesOf(mFolder / (std::string("b") + ending))) << ending;
  }
}

TEST_F(VideoWriterTest, QualityCostsBytes) {
  for (const char* ending : {".mp4", ".webm"}) {
    write(mFolder / (std::string("low") + ending), 20, {25.0, 10});
    write(mFolder / (std::string("high") + ending), 20, {25.0, 100});
    EXPECT_LT(fs::file_size(mFolder / (std::string("low") + ending)),
              fs::file_size(mFolder / (std::string("high") + ending)));
  }
}

TEST_F(VideoWriterTest, WithoutFinishTheOldFileStaysAndNothingElse) {
  std::ofstream(mFolder / "a.mp4") << "old";
  {
    VideoWriter video(mFolder / "a.mp4", {64, 64}, {});
    for (int i = 0; i < 40; ++i) video.write(patches(i));
  }
  EXPECT_EQ(bytesOf(mFolder / "a.mp4"), "old");
  EXPECT_EQ(filesThere(), 1u);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

TEST_F(VideoWriterTest, AFrameThatIsRepeatedKeepsTheTime) {
  {
    VideoWriter video(mFolder / "a.mp4", {64, 64}, {25.0, 100});
    video.repeat();
    video.write(patches());
    video.repeat();
    video.finish();
  }
  std::string pixels = decoded(mFolder / "a.mp4");
  ASSERT_EQ(pixels.size(), std::size_t(3 * 64 * 64 * 3));
  auto at = [&](int frame) { return int(std::uint8_t(pixels[std::size_t(((frame * 64 + 8) * 64 + 40) * 3)])); };
  EXPECT_NEAR(at(0), 0, 2);
  EXPECT_NEAR(at(1), 255, 2);
  EXPECT_NEAR(at(2), 255, 2);
}

TEST_F(VideoWriterTest, NamesAreNamesWhateverTheyLookLike) {
  fs::create_directory(mFolder / "http:a %d 'b'");
  for (const char* name : {"-y.mp4", "a|b;c.mp4", "%03d.gif", "b.MP4"}) {
    fs::path path = mFolder / "http:a %d 'b'" / name;
    write(path, 2);
    EXPECT_GT(fs::file_size(path), 100u) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(mFolder / "http:a %d 'b'"), {}), 4);
}

TEST_F(VideoWriterTest, AMissingProgramIsNamedWithItsPackage) {
  std::string path = std::getenv("PATH");
  ::setenv("PATH", mFolder.path().c_str(), 1);
  std::string said;
  try {
    VideoWriter video(mFolder / "a.mp4", {64, 64}, {});
  } catch (const InputError& error) {
    said = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said, "ffmpeg is not installed: apt install ffmpeg");
  EXPECT_EQ(filesThere(), 0u);
}

TEST_F(VideoWriterTest, WhatFfmpegSaysLastIsTold) {
  // An ffmpeg that reads a little, says why and goes: the pipe breaks while frames are written.
  std::ofstream(mFolder / "ffmpeg")
      << "#!/bin/sh\nhead -c 10 >/dev/null\necho first >&2\necho 'the last word' >&2\nexit 3\n";
  fs::permissions(mFolder / "ffmpeg", fs::perms::owner_all);
  std::string path = std::getenv("PATH"), said;
  ::setenv("PATH", (mFolder.path().string() + ":" + path).c_str(), 1);
  try {
    VideoWriter video(mFolder / "a.mp4", {64, 64}, {});
    for (int i = 0; i < 1000; ++i) video.write(patches(i));
  } catch (const InputError& error) {
    said = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(said, (mFolder / "a.mp4").string() + ": ffmpeg has failed: the last word");
  EXPECT_EQ(filesThere(), 1u);  // the program itself
}

TEST_F(VideoWriterTest, AFullDiskIsToldAndLeavesTheOldFile) {
  std::ofstream(mFolder / "a.mp4") << "old";
  SmallDisk disk(4096);
  VideoWriter video(mFolder / "a.mp4", {64, 64}, {25.0, 100});
  EXPECT_THROW(
      {
        for (int i = 0; i < 200; ++i) video.write(patches(i));
        video.finish();
      },
      InputError);
  EXPECT_EQ(bytesOf(mFolder / "a.mp4"), "old");
}

TEST_F(VideoWriterTest, WhatCannotBeIsRefusedBeforeAnythingIsWritten) {
  EXPECT_THROW(expectVideo("a.avi", {}), InputError);
  EXPECT_THROW(expectVideo("a.mp4", {0.0}), ArgumentError);
  EXPECT_THROW(expectVideo("a.mp4", {std::nan("")}), ArgumentError);
  EXPECT_THROW(expectVideo("a.mp4", {25.0, 101}), ArgumentError);
  EXPECT_THROW(VideoWriter(mFolder / "nowhere" / "a.mp4", {64, 64}, {}), InputError);
  VideoWriter video(mFolder / "a.mp4", {64, 64}, {});
  EXPECT_THROW(video.write(patches(0, {32, 64})), InputError);
  EXPECT_THROW(video.write({64, 64, {"Y"}, std::vector<float>(64 * 64)}), InputError);
}

TEST(FedProgram, IsKilledWhereItDoesNotEnd) {
  { FedProgram program({"sleep", "1000"}, "coreutils"); }
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  FedProgram program({"sh", "-c", "cat >/dev/null; exit 0"}, "dash");
  EXPECT_TRUE(program.write(std::vector<std::byte>(1 << 20)));
  EXPECT_TRUE(program.end());
  EXPECT_FALSE(program.end());
}

}  // namespace
}  // namespace velum::io
