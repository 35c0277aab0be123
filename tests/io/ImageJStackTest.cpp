// Stacks of ImageJ: one page, and raw planes behind it that no directory names.
#include <algorithm>
#include <fstream>

#include "SameByBricks.h"

namespace velum::io {
namespace {

namespace fs = std::filesystem;

/// A TIFF file with one page of 16 bits, low bytes first, whose planes follow each other at its end.
std::string onePage(glm::ivec2 size, const std::string& description) {
  auto number = [](std::uint32_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += char(value >> (8 * i));
    return text;
  };
  std::string words = description + std::string(1, '\0');
  std::uint32_t entries = 9, behind = 8 + 2 + entries * 12 + 4;
  auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    return number(tag, 2) + number(type, 2) + number(count, 4) + number(value, 4);
  };
  auto bytes = std::uint32_t(size.x * size.y * 2), text = std::uint32_t(words.size());
  return std::string("II*\0", 4) + number(8, 4) + number(entries, 2) + entry(256, 4, 1, std::uint32_t(size.x)) +
         entry(257, 4, 1, std::uint32_t(size.y)) + entry(258, 3, 1, 16) + entry(259, 3, 1, 1) + entry(262, 3, 1, 1) +
         entry(270, 2, text, behind) + entry(273, 4, 1, behind + text) + entry(278, 4, 1, std::uint32_t(size.y)) +
         entry(279, 4, 1, bytes) + number(0, 4) + words;
}

TEST(ImageJStack, ChannelsAndTimeStepsBehindOnePageAreTheSame) {
  TempFolder folder;
  std::string planes(40 * 30 * 2 * 24, '\0');
  for (std::size_t i = 0; i < planes.size(); ++i) planes[i] = char(i * 7 + i / 4000);
  std::string head = onePage({40, 30}, "ImageJ=1.53t\nimages=24\nchannels=2\nslices=3\nframes=4\nhyperstack=true\n");
  writeText(folder / "a.tif", head + planes);
  EXPECT_TRUE(expectSameByBricks(sourceOf(folder / "a.tif")));
  Volume v = read(folder / "a.tif");
  ASSERT_EQ(v.dims, glm::ivec3(40, 30, 3));
  ASSERT_EQ(v.channels, 2);
  ASSERT_EQ(v.timeSteps, 4);
  for (int t = 0; t < 4; ++t)
    for (int z = 0; z < 3; ++z)
      for (int c = 0; c < 2; ++c) {
        std::size_t at = (std::size_t((t * 3 + z) * 2 + c) * 40 * 30 + 7 * 40 + 11) * 2;
        EXPECT_EQ(valueAt(v, {11, 7, z}, c, t), std::uint8_t(planes[at]) + 256 * std::uint8_t(planes[at + 1]));
      }
  writeText(folder / "b.tif", (head + planes).substr(0, head.size() + planes.size() - 1));
  EXPECT_THROW(openSource(sourceOf(folder / "b.tif")), InputError) << "cut short";
}

TEST(ImageJStack, PlanesBeyondFourGigabytesAreRead) {
  TempFolder folder;
  const glm::ivec2 size(2048, 2048);
  std::string head = onePage(size, "ImageJ=1.53t\nimages=600\nslices=600\n");
  fs::path path = folder / "a.tif";
  writeText(path, head);
  constexpr std::uint64_t kPlane = 2048ull * 2048 * 2;
  fs::resize_file(path, head.size() + 600 * kPlane);  // nothing is written of what is not filled
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(std::streamoff(head.size() + 599 * kPlane + 2 * (5 * 2048 + 3)));
  file << "AB";
  file.close();
  auto source = openSource(sourceOf(path));
  ASSERT_EQ(source->head().dims, glm::ivec3(2048, 2048, 600));
  BrickAddress address{0, {0, 0, 599}};
  BrickBox box = boxOf(*source, address);
  ASSERT_EQ(box.origin.z, 599);
  std::vector<std::uint16_t> samples(std::size_t(box.size.x) * std::size_t(box.size.y));
  SampleTarget target{reinterpret_cast<std::byte*>(samples.data()), 2, 2 * box.size.x, 0, 2, 0};
  source->read(address, target);
  EXPECT_EQ(samples[5 * 2048 + 3], 'A' + 256 * 'B');
  EXPECT_EQ(std::count(samples.begin(), samples.end(), 0), std::ptrdiff_t(samples.size()) - 1);
}

}  // namespace
}  // namespace velum::io
