// Voxels without a header: what the layout says is what is read, or nothing.
#include <algorithm>
#include <random>

#include "TestFiles.h"
#include "io/volumes/RawGuess.h"

namespace velum::io {
namespace {

Volume readRawAs(const std::filesystem::path& path, const scene::RawLayout& layout) {
  Progress progress;
  scene::Source source;
  source.path = path.string();
  source.raw = layout;
  return readVolume(source, progress);
}

template <class T>
void expectType(SampleType type, std::initializer_list<double> values) {
  TempFolder folder;
  for (bool bigEndian : {false, true})
    for (bool isPacked : {false, true}) {
      SCOPED_TRACE(std::string(enumName(type)) + (bigEndian ? ", big endian" : "") + (isPacked ? ", gzipped" : ""));
      std::string bytes = "head";
      for (double value : values) {
        T sample = T(value);
        char raw[sizeof(T)];
        std::memcpy(raw, &sample, sizeof(T));
        if (bigEndian) std::reverse(raw, raw + sizeof(T));
        bytes.append(raw, sizeof(T));
      }
      auto path = folder / (isPacked ? "a.raw.gz" : "a.raw");
      if (isPacked)
        writeGzip(path, bytes);
      else
        writeText(path, bytes);
      Volume v = readRawAs(path, {{2, 1, 2}, type, 1, bigEndian, 4});
      EXPECT_EQ(v.type, type);
      int i = 0;
      for (double value : values) {
        EXPECT_EQ(valueAt(v, {i % 2, 0, i / 2}), value);
        ++i;
      }
      EXPECT_FALSE(v.isSpacingKnown || v.isOrientationKnown);
    }
}

TEST(Raw, EveryTypeInBothByteOrdersBehindAHeader) {
  expectType<std::uint8_t>(SampleType::UInt8, {0, 1, 128, 255});
  expectType<std::int8_t>(SampleType::Int8, {-128, -1, 1, 127});
  expectType<std::uint16_t>(SampleType::UInt16, {0, 258, 40000, 65535});
  expectType<std::int16_t>(SampleType::Int16, {-32768, -2, 258, 32767});
  expectType<std::uint32_t>(SampleType::UInt32, {0, 66051, 3e9, 4294967295.0});
  expectType<std::int32_t>(SampleType::Int32, {-2147483648.0, -2, 66051, 2147483647.0});
  expectType<float>(SampleType::Float32, {-1.5, 0.25, 3, 1e6});
  expectType<double>(SampleType::Float64, {-1.1, 1e-300, 3, 1e300});
}

TEST(Raw, ChannelsLieTogetherAndBytesOfThreeAreColour) {
  TempFolder folder;
  writeText(folder / "a.raw", "abcdef");
  Volume v = readRawAs(folder / "a.raw", {{2, 1, 1}, SampleType::UInt8, 3, false, 0});
  EXPECT_TRUE(v.isColor);
  EXPECT_EQ(valueAt(v, {1, 0, 0}, 2), 'f');
  EXPECT_EQ(valueAt(v, {0, 0, 0}, 1), 'b');
}

TEST(Raw, NumberedFilesOfAFolderAreItsSlicesInNaturalOrder) {
  TempFolder folder;
  std::filesystem::create_directories(folder / "head");
  for (int i = 1; i <= 12; ++i) writeText(folder / "head" / ("quarter." + std::to_string(i)), std::string(4, char(i)));
  scene::RawLayout layout{{2, 2, 12}, SampleType::UInt8, 1, false, 0};
  Volume v = readRawAs(folder / "head", layout);
  for (int z = 0; z < 12; ++z) EXPECT_EQ(valueAt(v, {1, 1, z}), z + 1);
  layout.dims.z = 11;
  EXPECT_THROW(readRawAs(folder / "head", layout), InputError) << "a file too many";
  layout.dims = {2, 3, 12};
  EXPECT_THROW(readRawAs(folder / "head", layout), InputError) << "slices of another size";
  layout = {{1, 2, 12}, SampleType::UInt8, 1, false, 2};
  EXPECT_EQ(readRawAs(folder / "head", layout).dims, glm::ivec3(1, 2, 12)) << "each has its header";
}

TEST(Raw, ALayoutThatMakesNoSenseIsRefusedWithWhatToGive) {
  TempFolder folder;
  writeText(folder / "a.raw", "abcdef");
  for (scene::RawLayout layout : {scene::RawLayout{},
                                  scene::RawLayout{{6, 1, 1}, SampleType::UInt8, 0, false, 0},
                                  {{6, 1, 1}, SampleType::UInt8, 1, false, -1}}) {
    try {
      readRawAs(folder / "a.raw", layout);
      ADD_FAILURE() << "opened";
    } catch (const InputError& error) {
      std::string words = error.what();
      bool saysWhat = words.find("raw.") != words.npos || words.find("give its size") != words.npos;
      EXPECT_TRUE(saysWhat) << words;
    }
  }
}

/// Something like tissue: a bright shell round a darker core with folds in it, before air, with soft borders and noise.
double tissueAt(glm::dvec3 place, std::mt19937& random, double noise) {
  double radius = glm::length(place - glm::dvec3(0.5));
  double inner = 0.5 + 0.25 * std::sin(19 * place.x + 7 * place.y * place.z);
  double shell = glm::smoothstep(0.30, 0.36, radius), outside = glm::smoothstep(0.38, 0.46, radius);
  double value = glm::mix(glm::mix(inner, 0.95, shell), 0.03, outside);
  return std::clamp(value + noise * std::normal_distribution<double>(0, 1)(random), 0.0, 1.0);
}

template <class T>
void appendSamples(std::string& bytes, const scene::RawLayout& layout, glm::dvec2 range, double noise) {
  std::mt19937 random(7);
  for (int z = 0; z < layout.dims.z; ++z)
    for (int y = 0; y < layout.dims.y; ++y)
      for (int x = 0; x < layout.dims.x; ++x) {
        double share = tissueAt((glm::dvec3(x, y, z) + 0.5) / glm::dvec3(layout.dims), random, noise);
        T sample = T(range.x + share * (range.y - range.x));
        char raw[sizeof(T)];
        std::memcpy(raw, &sample, sizeof(T));
        if (layout.bigEndian) std::reverse(raw, raw + sizeof(T));
        bytes.append(raw, sizeof(T));
      }
}

/// A file of that layout, and its place among the guesses: 0 is the first one, -1 that it is none of them.
int rankOfGuess(const scene::RawLayout& layout, glm::dvec2 range, double noise, const std::string& name = "a.raw") {
  TempFolder folder;
  std::string bytes(std::size_t(layout.headerBytes), 'h');
  if (layout.type == SampleType::UInt8) appendSamples<std::uint8_t>(bytes, layout, range, noise);
  if (layout.type == SampleType::Int8) appendSamples<std::int8_t>(bytes, layout, range, noise);
  if (layout.type == SampleType::UInt16) appendSamples<std::uint16_t>(bytes, layout, range, noise);
  if (layout.type == SampleType::Int16) appendSamples<std::int16_t>(bytes, layout, range, noise);
  if (layout.type == SampleType::Float32) appendSamples<float>(bytes, layout, range, noise);
  writeText(folder / name, bytes);
  EXPECT_TRUE(needsLayout(folder / name));
  EXPECT_EQ(bytesOf(layout), double(bytes.size()));
  Progress progress;
  auto guesses = guessLayouts(folder / name, progress);
  auto found = std::find(guesses.begin(), guesses.end(), layout);
  return found == guesses.end() ? -1 : int(found - guesses.begin());
}

TEST(RawGuess, TheFirstGuessIsRightForUsualFiles) {
  struct Kind {
    SampleType type;
    glm::dvec2 range;
  };
  const Kind kinds[] = {{SampleType::UInt8, {0, 255}},      {SampleType::Int8, {-128, 127}},
                        {SampleType::UInt16, {0, 4095}},    {SampleType::UInt16, {0, 60000}},
                        {SampleType::Int16, {-1024, 3071}}, {SampleType::Float32, {-0.2, 1.4}}};
  for (const Kind& kind : kinds)
    for (glm::ivec3 dims :
         {glm::ivec3(64), glm::ivec3(128, 96, 24), glm::ivec3(256, 256, 12), glm::ivec3(100, 100, 37)})
      for (bool bigEndian : {false, true})
        for (double noise : {0.0, 0.05}) {
          if (bigEndian ? sampleSize(kind.type) == 1 || noise == 0.0 : noise > 0.0 && dims.x != 128) continue;
          scene::RawLayout layout{dims, kind.type, 1, bigEndian, noise > 0 ? 512 : 0};
          EXPECT_EQ(rankOfGuess(layout, kind.range, noise), 0)
              << enumName(kind.type) << " to " << kind.range.y << ", " << dims.x << " " << dims.y << " " << dims.z
              << (bigEndian ? ", big endian" : "") << ", noise " << noise;
        }
}

TEST(RawGuess, ANameThatSaysTheSizeIsBelieved) {
  scene::RawLayout layout{{37, 41, 29}, SampleType::Int16, 1, false, 100};
  EXPECT_EQ(rankOfGuess(layout, {-1024, 3071}, 0.02, "foot_37x41x29.raw"), 0);
  EXPECT_EQ(rankOfGuess(layout, {-1024, 3071}, 0.02), -1) << "nothing else says it";
}

TEST(RawGuess, WhatHasAHeaderNeedsNoLayout) {
  TempFolder folder;
  EXPECT_FALSE(needsLayout(folder / "none.raw"));
  writeText(folder / "empty.raw", "");
  EXPECT_FALSE(needsLayout(folder / "empty.raw"));
  writeText(folder / "notes.txt", "a text");
  EXPECT_FALSE(needsLayout(folder / "notes.txt"));
  EXPECT_FALSE(needsLayout(folder.path()));
}

TEST(RawGuess, APlaneIsReadWhereItLies) {
  TempFolder folder;
  writeText(folder / "a.raw",
            "hh"
            "abcdef"
            "ghijkl");
  scene::Source source;
  source.path = (folder / "a.raw").string();
  source.raw = {{3, 2, 2}, SampleType::UInt8, 1, false, 2};
  Volume plane = readRawPlane(source, 1);
  EXPECT_EQ(plane.dims, glm::ivec3(3, 2, 1));
  EXPECT_EQ(valueAt(plane, {2, 1, 0}), 'l');
  EXPECT_THROW(readRawPlane(source, 2), InputError);
}

}  // namespace
}  // namespace velum::io
