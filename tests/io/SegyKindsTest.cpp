#include <gtest/gtest.h>

#include "SegyBytes.h"

/// Headers of every revision, and what is no stack.
namespace velum::io {
namespace {

/// Text headers behind the binary one. @param count  what the file claims of them
std::string withTexts(std::string bytes, int revision, int count, const std::vector<std::string>& texts) {
  Writer w{bytes.substr(0, 3600)};
  w.put(3500, std::uint64_t(revision) << 8, 2), w.put(3504, std::uint16_t(count), 2);
  for (std::string text : texts) {
    text.resize(3200, text.back());
    w.bytes += text;
  }
  return w.bytes + bytes.substr(3600);
}

/// In EBCDIC: blanks, and the stanza ((SEG: EndText)) in the last.
const std::string kBlank = "\xc3\xf1\x40",
                  kEnd = "\x4d\x4d\xe2\xc5\xc7\x7a\x40\xc5\x95\x84\xe3\x85\xa7\xa3\x5d\x5d\x40";

TEST(Segy, ExtendedTextHeadersArePassedWhateverTheRevision) {
  std::string bytes = makeSegy(5, false, cube(5, 4), 9);
  Volume plain = readBytes(bytes);
  for (int revision : {0, 1, 2}) {
    for (const auto& [count, texts] : {std::pair<int, std::vector<std::string>>{1, {kBlank}},
                                       {3, {kBlank, "C 1 of ASCII ", kBlank}},
                                       {-1, {kBlank, kEnd}},
                                       {-1, {"((SEG: EndText)) "}}}) {
      Volume v = readBytes(withTexts(bytes, revision, count, texts));
      EXPECT_TRUE(v.voxels == plain.voxels) << revision << " " << count;
      EXPECT_EQ(v.warnings, plain.warnings);
    }
  }
}

TEST(Segy, TextHeadersThatAreNotThereAreNotPassed) {
  std::string bytes = makeSegy(5, false, cube(5, 4), 9);
  Volume plain = readBytes(bytes);
  // In revision 0 the bytes are anybody's.
  for (int count : {1, 7, 20000, -1, -300})
    EXPECT_TRUE(readBytes(withTexts(bytes, 0, count, {})).voxels == plain.voxels);
  Volume v = readBytes(withTexts(bytes, 1, 2, {}));
  EXPECT_TRUE(v.voxels == plain.voxels);
  EXPECT_TRUE(v.warnings[0].find("not there") != std::string::npos) << v.warnings[0];
  EXPECT_THROW(readBytes(withTexts(bytes, 1, -1, {kBlank})), InputError);
}

TEST(Segy, RevisionTwoSaysWhereTracesBeginAndHowLongTheyAre) {
  std::string bytes = makeSegy(5, false, cube(5, 4), 9);
  Volume plain = readBytes(bytes);
  // A second trace header each, a gap in front, a trailer behind, and the numbers of old zero.
  Writer w{bytes.substr(0, 3600)};
  w.put(3500, 2, 1), w.put(3220, 0, 2), w.put(3268, 9, 4), w.put(3506, 1, 4), w.put(3520, 3700, 8), w.put(3528, 1, 4);
  w.bytes += std::string(100, '\7');
  constexpr std::size_t kTrace = 240 + 9 * 4;
  for (std::size_t at = 3600; at < bytes.size(); at += kTrace)
    w.bytes += bytes.substr(at, 240) + std::string(240, '\5') + bytes.substr(at + 240, kTrace - 240);
  Volume v = readBytes(w.bytes + std::string(3200, ' '));
  EXPECT_TRUE(v.voxels == plain.voxels);
  EXPECT_EQ(v.warnings, plain.warnings);
}

std::string refusalOf(const std::string& bytes) {
  try {
    readBytes(bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

/// Sets a number of four bytes of each trace header, by its standard's number.
template <class Number>
std::string withNumbers(std::string bytes, int samples, std::size_t number, Number numberOf) {
  Writer w{std::move(bytes)};
  std::size_t i = 0, trace = 240 + std::size_t(samples) * 4;
  for (std::size_t at = 3600; at < w.bytes.size(); at += trace) w.put(at + number - 1, std::uint32_t(numberOf(i++)), 4);
  return w.bytes;
}

TEST(Segy, GathersOfShotsAreRefusedWithWords) {
  std::vector<Trace> traces(24, Trace{0, 0, 0, 0});
  std::string bare = makeSegy(5, false, traces, 4);
  auto offset = [](std::size_t i) { return 100 + 25 * int(i % 12); };
  auto shot = [](std::size_t i) { return 1 + int(i / 12); };
  auto midpoint = [](std::size_t i) { return 500 + int(i / 12) * 2 + int(i % 12); };
  std::string shots = withNumbers(bare, 4, 9, shot);
  Writer w{bare};
  w.put(3228, 5, 2);
  for (const std::string& bytes : {withNumbers(bare, 4, 37, offset), withNumbers(shots, 4, 37, offset), shots,
                                   withNumbers(withNumbers(shots, 4, 37, offset), 4, 21, midpoint),
                                   withNumbers(withNumbers(bare, 4, 37, offset), 4, 21, midpoint), w.bytes}) {
    std::string words = refusalOf(bytes);
    EXPECT_NE(words.find("before stacking"), std::string::npos) << words;
    EXPECT_NE(words.find("189/193"), std::string::npos) << words;
  }
  EXPECT_NE(refusalOf(withNumbers(bare, 4, 37, offset)).find("offsets from 100 to 375"), std::string::npos);
}

TEST(Segy, StacksByOldLineNumbersAreNoGathers) {
  std::vector<Trace> traces(12, Trace{0, 0, 0, 0});
  std::string bytes = makeSegy(5, false, traces, 4);
  bytes = withNumbers(bytes, 4, 9, [](std::size_t i) { return 1 + int(i / 4); });
  bytes = withNumbers(bytes, 4, 21, [](std::size_t i) { return 1 + int(i % 4); });
  EXPECT_EQ(readBytes(bytes).dims, glm::ivec3(3, 4, 4));
}

TEST(Segy, TheFirstOffsetOfAGridIsShownAndSaid) {
  auto traces = cube(4, 3);
  auto twice = traces;
  twice.insert(twice.end(), traces.begin(), traces.end());
  std::string bytes = withNumbers(makeSegy(5, false, twice, 4), 4, 37, [](std::size_t i) { return int(i / 12); });
  Volume v = readBytes(bytes);
  EXPECT_EQ(v.dims, glm::ivec3(4, 3, 4));
  EXPECT_NE(v.warnings[0].find("prestack"), std::string::npos);
}

TEST(Segy, TracesOfSeveralLengthsAreRefused) {
  auto withLength = [](std::string bytes, std::size_t trace, int samples) {
    Writer w{std::move(bytes)};
    w.put(3600 + trace * (240 + 4 * 4) + 114, std::uint64_t(samples), 2);
    return w.bytes;
  };
  std::string bytes = makeSegy(5, false, cube(4, 4), 4);
  // Where all fit the header is wrong, and that is said.
  Volume v = readBytes(withLength(bytes, 2, 9));
  EXPECT_NE(v.warnings[0].find("1 of 16 traces claims"), std::string::npos) << v.warnings[0];
  EXPECT_NE(refusalOf(withLength(bytes, 15, 9) + std::string(20, '\1')).find("several lengths"), std::string::npos);
}

}  // namespace
}  // namespace velum::io
