#include "session/film/FrameFolder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "FilmFrames.h"

namespace velum::session {
namespace {

namespace fs = std::filesystem;

constexpr int kCount = 12;

class FrameFolderTest : public testing::Test {
 protected:
  FilmReport make(FilmOutput output, FrameFolder::Old old = {}, Part part = {}) {
    output.old = old;
    output.part = part;
    mAsked.clear();
    return makeFilm(smallFilm(kCount, &mAsked), output, kSmallFilm, mProgress);
  }
  /// The frames that were drawn by the last make().
  std::vector<int> drawn() const {
    std::vector<int> frames;
    for (const auto& [frame, share] : mAsked) frames.push_back(frame);
    return frames;
  }
  std::string refusal(const FilmOutput& output, const FilmIdentity& film, int count, FrameFolder::Old old = {}) {
    FilmOutput wanted = output;
    wanted.old = old;
    try {
      makeFilm(smallFilm(count), wanted, film, mProgress);
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }

  TempFolder mFolder;
  FilmOutput mOutput = outputTo(mFolder / "frames");
  Progress mProgress;
  std::vector<std::pair<int, double>> mAsked;
};

TEST(Part, PartsAreTheWholeInOrderAndOfOneSize) {
  for (int parts = 1; parts <= 16; ++parts)
    for (int frames : {1, 2, 7, 15, 16, 17, 100, 240, 9999, 1'000'000}) {
      int next = 0, least = frames, most = 0;
      for (int k = 1; k <= parts; ++k) {
        Part part{k, parts};
        ASSERT_EQ(part.firstOf(frames), next) << k << "/" << parts << " of " << frames;
        next = part.endOf(frames);
        least = std::min(least, next - part.firstOf(frames));
        most = std::max(most, next - part.firstOf(frames));
      }
      EXPECT_EQ(next, frames);
      EXPECT_LE(most - least, 1);
    }
}

TEST(Part, IsReadAsPeopleWriteIt) {
  EXPECT_EQ(parsePart("3/16"), (Part{3, 16}));
  for (const char* text : {"", "3", "0/4", "5/4", "a/b", "1/0", "1.5/3", "-1/2", "1/2/3", "/"})
    EXPECT_THROW(parsePart(text), ArgumentError) << text;
}

TEST(FrameNames, AFolderHasFramesAPictureHasNumbers) {
  TempFolder folder;
  EXPECT_EQ(FrameNames("a/frames/").frame(7), "a/frames/frame-00007.png");
  EXPECT_EQ(FrameNames("frames").manifest({}), "frames/film.jsonl");
  EXPECT_EQ(FrameNames("a/turn.exr").frame(7), "a/turn-0007.exr");
  EXPECT_EQ(FrameNames("turn.png").manifest({3, 16}), "turn-3-of-16.jsonl");
  fs::create_directory(folder / "head.png");
  EXPECT_TRUE(FrameNames(folder / "head.png").isFolder());
  for (const char* name : {"turn.jsonl", "turn-1-of-2.jsonl", "turn-of-2.jsonl", "turner.jsonl", "turn-x-of-y.jsonl"})
    std::ofstream(folder / name) << "x";
  EXPECT_EQ(FrameNames(folder / "turn.png").manifests(),
            (std::vector<fs::path>{folder / "turn-1-of-2.jsonl", folder / "turn.jsonl"}));
}

TEST(FilmManifest, ComesBackWholeAndPassesOverTornLines) {
  TempFolder folder;
  FilmManifest manifest{
      {{"renderer", "a \"b\" \xff"}, {"scene", "c"}},
      9,
      29.97,
      {{3, 1.5, {{"a.png", 5'000'000'000, 4'000'000'000}, {"a.depth.png", 1, 0}}, {}}, {4, 0.25, {}, "no\nroom"}}};
  std::string text = manifestText(manifest);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  std::ofstream(folder / "a", std::ios::binary) << text;
  auto back = readManifest(folder / "a");
  ASSERT_TRUE(back);
  EXPECT_EQ(back->film[1], manifest.film[1]);
  EXPECT_EQ(back->frames, 9);
  EXPECT_EQ(back->framesPerSecond, 29.97);
  EXPECT_EQ(back->records, manifest.records);
  // Cut anywhere it tells what its whole lines tell, or is none.
  std::size_t first = text.find('\n'), second = text.find('\n', first + 1);
  for (std::size_t length = 0; length < text.size(); ++length) {
    std::ofstream(folder / "a", std::ios::binary) << text.substr(0, length);
    auto cut = readManifest(folder / "a");
    ASSERT_EQ(bool(cut), length >= first) << length;
    if (cut) {
      EXPECT_EQ(cut->records.size(), length < second ? 0u : length < text.size() - 1 ? 1u : 2u) << length;
    }
  }
  // What is not ours, or leads elsewhere.
  for (const char* line : {"{\"frame\":9,\"ms\":1}", "{\"frame\":-1,\"ms\":1}", "[]", "7", "{\"frame\":\"1\",\"ms\":1}",
                           "{\"frame\":1,\"ms\":1,\"files\":[{\"name\":\"../a\",\"bytes\":1,\"crc32c\":1}]}"}) {
    std::ofstream(folder / "a", std::ios::binary) << text.substr(0, first + 1) << line << "\n";
    EXPECT_TRUE(readManifest(folder / "a")->records.empty()) << line;
  }
}

TEST_F(FrameFolderTest, ResumeDrawsWhatIsMissingCutOrChanged) {
  ASSERT_EQ(make(mOutput).drawn, kCount);
  auto whole = framesOf(mOutput.path, kCount);
  EXPECT_EQ(make(mOutput, {true}).kept, kCount);
  EXPECT_TRUE(drawn().empty());

  FrameNames names(mOutput.path);
  fs::remove(names.frame(2));
  fs::resize_file(names.frame(5), fs::file_size(names.frame(5)) - 1);
  std::string changed = whole[7];
  changed[changed.size() / 2] ^= 1;
  std::ofstream(names.frame(7), std::ios::binary) << changed;
  FilmReport report = make(mOutput, {true});
  EXPECT_EQ(drawn(), (std::vector<int>{2, 5, 7}));
  EXPECT_EQ(report.kept, kCount - 3);
  EXPECT_EQ(framesOf(mOutput.path, kCount), whole);
  // Without it all are drawn anew, and so they are where no manifest tells of them.
  EXPECT_EQ(make(mOutput).drawn, kCount);
  fs::remove(names.manifest({}));
  EXPECT_EQ(make(mOutput, {true}).drawn, kCount);
}

TEST_F(FrameFolderTest, AManifestThatIsCutAnywhereCostsTheFramesOfItsLostLines) {
  make(mOutput);
  auto whole = framesOf(mOutput.path, kCount);
  fs::path manifest = FrameNames(mOutput.path).manifest({});
  std::string text = bytesOf(manifest);
  std::size_t head = text.find('\n') + 1;
  std::mt19937 random(5);
  for (int turn = 0; turn < 12; ++turn) {
    std::size_t length = head + random() % (text.size() - head);
    std::ofstream(manifest, std::ios::binary) << text.substr(0, length);
    int lines = int(std::count(text.begin(), text.begin() + std::ptrdiff_t(length), '\n')) - 1;
    EXPECT_EQ(make(mOutput, {true}).drawn, kCount - lines - (text[length] == '\n')) << length;
    EXPECT_EQ(make(mOutput, {true}).drawn, 0) << length;
  }
  EXPECT_EQ(framesOf(mOutput.path, kCount), whole);
}

TEST_F(FrameFolderTest, PartsDrawTheWholeInAnyOrder) {
  make(mOutput);
  auto whole = framesOf(mOutput.path, kCount);
  FilmOutput parts = outputTo(mFolder / "parts.png");
  for (int k : {3, 1, 5, 2, 4}) {
    FilmReport report = make(parts, {}, {k, 5});
    EXPECT_EQ(report.frames, report.drawn);
  }
  EXPECT_EQ(framesOf(parts.path, kCount), whole);
  // A part of other parts, and the whole, know what they have drawn.
  EXPECT_EQ(make(parts, {true}, {2, 3}).drawn, 0);
  EXPECT_EQ(make(parts, {true}).kept, kCount);
  fs::remove(FrameNames(parts.path).frame(4));
  EXPECT_EQ(make(parts, {true}, {1, 2}).drawn, 1);
  EXPECT_EQ(drawn(), std::vector<int>{4});
  auto there = findFrames(FrameNames(parts.path), {}, mProgress);
  ASSERT_TRUE(there);
  EXPECT_EQ(there->pictures[11], "parts-0011.png");
}

TEST_F(FrameFolderTest, AnotherFilmIsRefusedUntilItMayBeWrittenOver) {
  make(mOutput);
  std::string before = bytesOf(FrameNames(mOutput.path).manifest({}));
  FilmIdentity other{{"renderer", "none"}, {"scene", "a square"}};
  for (bool resume : {false, true}) {
    EXPECT_NE(refusal(mOutput, other, kCount, {resume}).find("scene a dot, not a square"), std::string::npos);
    EXPECT_NE(refusal(mOutput, kSmallFilm, kCount + 1, {resume}).find("12 frames, not 13"), std::string::npos);
  }
  EXPECT_EQ(bytesOf(FrameNames(mOutput.path).manifest({})), before);
  EXPECT_EQ(refusal(mOutput, other, kCount, {true, true}), "");
  EXPECT_NE(refusal(mOutput, kSmallFilm, kCount), "");
  // A file of somebody else is never written over.
  FilmOutput turn = outputTo(mFolder / "turn.png");
  std::ofstream(mFolder / "turn.jsonl") << "{\"mine\": 1}\n";
  EXPECT_NE(refusal(turn, kSmallFilm, kCount, {false, true}).find("is no list of frames"), std::string::npos);
  EXPECT_EQ(bytesOf(mFolder / "turn.jsonl"), "{\"mine\": 1}\n");
}

TEST_F(FrameFolderTest, LayersBelongToTheirFrame) {
  mOutput.picture.layers = true;
  FrameSource source = smallFilm(3, &mAsked);
  source.draw = [draw = source.draw](int frame, double share, Progress& progress) {
    FilmFrame out = draw(frame, share, progress);
    Image& image = out.image;
    image.channels = {"R",        "G",        "B",        "A",          "Z",          "id",        "instance",
                      "normal.X", "normal.Y", "normal.Z", "position.X", "position.Y", "position.Z"};
    std::vector<float> pixels;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
      pixels.insert(pixels.end(), image.pixels.begin() + std::ptrdiff_t(i),
                    image.pixels.begin() + std::ptrdiff_t(i) + 4);
      pixels.insert(pixels.end(), {float(i), 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f});
    }
    image.pixels = pixels;
    return out;
  };
  makeFilm(source, mOutput, kSmallFilm, mProgress);
  fs::path depth = mOutput.path / "frame-00001.depth.png";
  ASSERT_TRUE(fs::exists(depth));
  fs::resize_file(depth, 30);
  mAsked.clear();
  mOutput.old.resume = true;
  EXPECT_EQ(makeFilm(source, mOutput, kSmallFilm, mProgress).drawn, 1);
  EXPECT_EQ(drawn(), std::vector<int>{1});
  EXPECT_GT(fs::file_size(depth), 30u);
}

TEST(FrameRanges, AreSaidAsPeopleSayThem) {
  EXPECT_EQ(rangesOf({}), "");
  EXPECT_EQ(rangesOf({4}), "4");
  EXPECT_EQ(rangesOf({4, 5, 6, 9}), "4-6 and 9");
  EXPECT_EQ(rangesOf({1, 3, 4, 8}), "1, 3-4 and 8");
  std::vector<int> many;
  for (int i = 0; i < 100; i += 2) many.push_back(i);
  EXPECT_EQ(rangesOf(many), "0, 2, 4, 6, 8, 10, 12, 14 and others");
}

}  // namespace
}  // namespace velum::session
