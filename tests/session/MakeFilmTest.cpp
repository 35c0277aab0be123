#include "session/film/MakeFilm.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <random>

#include "FilmFrames.h"
#include "core/Clock.h"
#include "core/Memory.h"
#include "io/images/ImageFile.h"
#include "runProgram.h"
#include "session/film/JoinFrames.h"
#include "session/film/SubFrames.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kChannels{"R", "G", "B", "A", "Z", "id", "front.R", "front.G", "front.B", "front.A"};

Image randomImage(std::mt19937& random) {
  Image image{5, 3, kChannels, {}};
  for (std::size_t i = 0; i < 15 * kChannels.size(); ++i) image.pixels.push_back(float(random() % 1001) / 1000.0f);
  for (std::size_t i = 3; i < image.pixels.size(); i += 2 * kChannels.size()) image.pixels[i] = 0.0f;
  return image;
}

TEST(SubFrames, AreOpenAroundTheFramesOwnMoment) {
  EXPECT_EQ(subFrameShare(0, 1, 0.7), 0.0);
  for (int n = 1; n <= 9; ++n)
    for (double shutter : {0.0, 0.3, 0.5, 1.0}) {
      double sum = 0.0;
      for (int k = 0; k < n; ++k) {
        double share = subFrameShare(k, n, shutter);
        sum += share;
        EXPECT_LE(std::abs(share), shutter / 2 + 1e-12);
        if (k > 0) {
          EXPECT_NEAR(share - subFrameShare(k - 1, n, shutter), shutter / n, 1e-12);
        }
      }
      EXPECT_NEAR(sum, 0.0, 1e-12);
      if (n % 2) {
        EXPECT_EQ(subFrameShare(middleSubFrame(n), n, shutter), 0.0);
      }
    }
  // A whole shutter leaves no time out: the last picture of a frame and the first of the next are as far apart as
  // others.
  EXPECT_NEAR(subFrameShare(0, 4, 1.0) + 1.0 - subFrameShare(3, 4, 1.0), 0.25, 1e-12);
}

TEST(SubFrames, ColoursAreTheMeanOfWhatIsSeenAndNumbersThoseOfTheMiddle) {
  std::mt19937 random(7);
  for (int n : {2, 3, 8}) {
    std::vector<Image> all;
    MeanImage mean;
    for (int k = 0; k < n; ++k) {
      all.push_back(randomImage(random));
      mean.add(all.back(), k == middleSubFrame(n));
    }
    Image got = mean.mean();
    ASSERT_EQ(got.channels, kChannels);
    for (std::size_t i = 0; i < got.pixels.size(); i += kChannels.size()) {
      for (std::size_t layer : {0u, 6u}) {
        double alpha = 0.0, color[3] = {};
        for (const Image& image : all) {
          double a = image.pixels[i + layer + 3];
          alpha += a / n;
          for (std::size_t c = 0; c < 3; ++c) color[c] += image.pixels[i + layer + c] * a / n;
        }
        EXPECT_NEAR(got.pixels[i + layer + 3], alpha, 1e-6);
        for (std::size_t c = 0; c < 3; ++c)
          EXPECT_NEAR(got.pixels[i + layer + c], alpha > 0.0 ? color[c] / alpha : 0.0, 1e-6);
      }
      const Image& middle = all[std::size_t(middleSubFrame(n))];
      for (std::size_t c : {4u, 5u}) EXPECT_EQ(got.pixels[i + c], middle.pixels[i + c]);
    }
  }
}

TEST(SubFrames, WhatStandsStillStaysAsItIs) {
  std::mt19937 random(9);
  Image image = randomImage(random);
  for (std::size_t i = 3; i < image.pixels.size(); i += kChannels.size()) image.pixels[i] = 1.0f;
  MeanImage one, many;
  one.add(image, true);
  EXPECT_EQ(one.mean().pixels, image.pixels);
  for (int k = 0; k < 16; ++k) many.add(image, k == 8);
  Image mean = many.mean();
  for (std::size_t i = 0; i < image.pixels.size(); ++i) EXPECT_NEAR(mean.pixels[i], image.pixels[i], 1e-6);
}

TEST(MakeFilm, AsksForMomentsInTheirOrder) {
  TempFolder folder;
  std::vector<std::pair<int, double>> asked;
  FilmOutput output = outputTo(folder / "a");
  output.blur = 3;
  output.shutter = 0.9;
  Progress progress;
  makeFilm(smallFilm(5, &asked), output, kSmallFilm, progress);
  ASSERT_EQ(asked.size(), 15u);
  for (int i = 0; i < 15; ++i) {
    EXPECT_EQ(asked[std::size_t(i)].first, i / 3);
    EXPECT_NEAR(asked[std::size_t(i)].second, (i % 3 - 1) * 0.3, 1e-12);
  }
  EXPECT_TRUE(std::is_sorted(asked.begin(), asked.end()));
}

TEST(MakeFilm, ABlurredFrameIsTheMeanInItsFileToo) {
  TempFolder folder;
  FilmOutput output = outputTo(folder / "a.png");
  output.blur = 4;
  output.picture.bits = 16;
  FrameSource source{2, [](int, double share, Progress&) {
                       return FilmFrame{{1, 1, {"R", "G", "B", "A"}, {float(share + 0.5), 0.1f, 0.2f, 1.0f}}, {}};
                     }};
  Progress progress;
  makeFilm(source, output, kSmallFilm, progress);
  Image image = io::readImage(folder / "a-0001.png");
  EXPECT_NEAR(image.pixels[0], 0.5, 1.0 / 65535);
  EXPECT_NEAR(image.pixels[1], 0.1, 1.0 / 65535);
}

TEST(MakeFilm, AFrameThatFailsIsNotedAndTheOthersGoOn) {
  TempFolder folder;
  for (const char* name : {"frames", "a.mp4"}) {
    if (io::isVideo(name) && !hasFfmpeg()) continue;
    FrameSource source = smallFilm(6);
    bool fails = true;
    source.draw = [&, draw = source.draw](int frame, double share, Progress& progress) {
      if (fails && frame == 2) throw InputError("heart.nrrd: is gone");
      return draw(frame, share, progress);
    };
    FilmOutput output = outputTo(folder / name);
    Progress progress;
    FilmReport report = makeFilm(source, output, kSmallFilm, progress);
    EXPECT_EQ(report.drawn, 5);
    ASSERT_EQ(report.failed.size(), 1u);
    EXPECT_EQ(report.failed[0], (std::pair<int, std::string>(2, "heart.nrrd: is gone")));
    if (io::isVideo(name)) {
      std::string command = "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of default=nw=1:nk=1 ";
      EXPECT_EQ(outputOf(command + (folder / name).string()), "6\n");
      continue;
    }
    EXPECT_NE(bytesOf(FrameNames(output.path).manifest({})).find("heart.nrrd: is gone"), std::string::npos);
    fails = false;
    output.old.resume = true;
    EXPECT_EQ(makeFilm(source, output, kSmallFilm, progress).drawn, 1);
  }
}

TEST(MakeFilm, CancelKeepsWhatIsThere) {
  TempFolder folder;
  for (const char* name : {"frames", "a.mp4"}) {
    if (io::isVideo(name) && !hasFfmpeg()) continue;
    FrameSource source = smallFilm(100);
    Progress progress;
    source.draw = [&, draw = source.draw](int frame, double share, Progress& quiet) {
      if (frame == 7) progress.cancel();
      return draw(frame, share, quiet);
    };
    FilmOutput output = outputTo(folder / name);
    FilmReport report = makeFilm(source, output, kSmallFilm, progress);
    EXPECT_TRUE(report.isStopped);
    EXPECT_EQ(report.drawn, 7);
    if (io::isVideo(name)) {
      std::string command = "ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of default=nw=1:nk=1 ";
      EXPECT_EQ(outputOf(command + (folder / name).string()), "7\n");
    } else {
      output.old.resume = true;
      Progress again;
      EXPECT_EQ(makeFilm(smallFilm(100), output, kSmallFilm, again).kept, 7);
    }
  }
  // Before a frame is there, there is no video.
  if (!hasFfmpeg()) return;
  Progress progress;
  progress.cancel();
  EXPECT_TRUE(makeFilm(smallFilm(3), outputTo(folder / "b.mp4"), kSmallFilm, progress).isStopped);
  EXPECT_FALSE(fs::exists(folder / "b.mp4"));
}

TEST(MakeFilm, SaysHowFarItIsAndHowLongItTakes) {
  TempFolder folder;
  FilmOutput output = outputTo(folder / "a");
  std::vector<std::string> said;
  std::vector<double> fractions;
  Progress progress([&](double fraction, const std::string& what) {
    said.push_back(what);
    fractions.push_back(fraction);
  });
  FrameSource slow = smallFilm(4);
  slow.draw = [draw = slow.draw](int frame, double share, Progress& quiet) {
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    return draw(frame, share, quiet);
  };
  output.part = {2, 2};
  makeFilm(slow, output, kSmallFilm, progress);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0], "Frame 3 of 4");
  EXPECT_EQ(said[1], "Frame 4 of 4, 1 s left");
  EXPECT_EQ(fractions, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(sayTime(0.2), "1 s");
  EXPECT_EQ(sayTime(42.4), "42 s");
  EXPECT_EQ(sayTime(170.0), "3 min");
  EXPECT_EQ(sayTime(7800.0), "2 h 10 min");
}

TEST(MakeFilm, WhatCannotBeIsRefusedBeforeAFrameIsDrawn) {
  TempFolder folder;
  auto refused = [&](auto change) {
    FilmOutput output = outputTo(folder / "a.mp4");
    change(output);
    EXPECT_THROW(expectFilmOutput(output), ArgumentError);
  };
  refused([](FilmOutput& output) { output.path = "-"; });
  refused([](FilmOutput& output) { output.blur = 0; });
  refused([](FilmOutput& output) { output.shutter = 1.5; });
  refused([](FilmOutput& output) { output.part = {1, 2}; });
  refused([](FilmOutput& output) { output.old.resume = true; });
  refused([](FilmOutput& output) { output.picture.layers = true; });
  refused([](FilmOutput& output) { output.picture.bits = 16; });
  refused([](FilmOutput& output) { output.picture.transparent = true; });
  EXPECT_THROW(expectFilmOutput(outputTo(folder / "a.avi")), InputError);
  EXPECT_THROW(expectFilmOutput(outputTo(folder / "nowhere" / "a.png")), InputError);
  Progress progress;
  EXPECT_THROW(makeFilm(smallFilm(2), outputTo(folder / "nowhere" / "frames"), kSmallFilm, progress), InputError);
}

TEST(JoinFrames, AVideoHasTheFramesThatManyHaveDrawn) {
  if (!hasFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed: apt install ffmpeg";
  TempFolder folder;
  FilmOutput output = outputTo(folder / "frames");
  output.framesPerSecond = 12.0;
  Progress progress;
  for (int k : {1, 2, 3}) {
    output.part = {k, 3};
    makeFilm(smallFilm(20), output, kSmallFilm, progress);
  }
  auto names = namesInFolder(output.path);
  ASSERT_TRUE(names);
  EXPECT_EQ(joinFrames(*names, folder / "joined.mp4", {0.0}, progress), 20);
  FilmOutput video = outputTo(folder / "direct.mp4");
  video.framesPerSecond = 12.0;
  makeFilm(smallFilm(20), video, kSmallFilm, progress);
  EXPECT_EQ(bytesOf(folder / "joined.mp4"), bytesOf(folder / "direct.mp4"));
  // What is missing is said, and nothing is written.
  fs::remove(names->frame(3));
  fs::resize_file(names->frame(9), 20);
  try {
    joinFrames(*names, folder / "b.mp4", {0.0}, progress);
    ADD_FAILURE() << "frames are missing";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("2 of 20 frames missing or broken: 3 and 9"), std::string::npos)
        << error.what();
  }
  EXPECT_FALSE(fs::exists(folder / "b.mp4"));
  EXPECT_FALSE(namesInFolder(folder.path()));
  makeFilm(smallFilm(2), outputTo(folder / "a.png"), kSmallFilm, progress);
  EXPECT_EQ(joinFrames(*namesInFolder(folder.path()), folder / "a.gif", {0.0}, progress), 2);
  makeFilm(smallFilm(2), outputTo(folder / "b.png"), kSmallFilm, progress);
  EXPECT_THROW(namesInFolder(folder.path()), InputError);
}

// Run by itself: VELUM_LONG_FILM=10000.
TEST(MakeFilm, TimeAndMemoryAreTheSameForEachFrame) {
  const char* count = std::getenv("VELUM_LONG_FILM");
  int frames = count ? std::atoi(count) : 300;
  TempFolder folder;
  FilmOutput output = outputTo(folder / "frames");
  FrameSource source = smallFilm(frames);
  std::vector<double> blocks, cpu;
  std::size_t bytesEarly = 0, bytesLate = 0;
  auto start = Clock::now();
  auto cpuMs = [] { return double(std::clock()) * 1e3 / CLOCKS_PER_SEC; };
  double cpuStart = cpuMs();
  source.draw = [&, draw = source.draw](int frame, double share, Progress& progress) {
    if (frame == frames / 5) bytesEarly = allocatedBytes();
    if (frame == frames - 1) bytesLate = allocatedBytes();
    if (frame > 0 && frame % (frames / 10) == 0) {
      blocks.push_back(msSince(start)), start = Clock::now();
      cpu.push_back(cpuMs() - cpuStart), cpuStart = cpuMs();
    }
    return draw(frame, share, progress);
  };
  Progress progress;
  EXPECT_EQ(makeFilm(source, output, kSmallFilm, progress).drawn, frames);
  for (std::size_t i = 0; i < blocks.size(); ++i)
    std::printf("%.4f ms a frame, %.4f of the processor\n", blocks[i] / (frames / 10), cpu[i] / (frames / 10));
  std::printf("bytes %zu then %zu\n", bytesEarly, bytesLate);
  if (bytesEarly > 0) {
    EXPECT_LT(double(bytesLate), double(bytesEarly) + 64e3);
  }
}

}  // namespace
}  // namespace velum::session
