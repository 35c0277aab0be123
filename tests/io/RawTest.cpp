// Voxels without a header: what the layout says is what is read, or nothing.
#include <algorithm>

#include "TestFiles.h"

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

}  // namespace
}  // namespace velum::io
