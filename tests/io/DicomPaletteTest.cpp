#include <cstring>

#include "DicomParts.h"
#include "TestFiles.h"

/// Samples that are numbers of colours. Expected colours are those of the palette.
namespace velum::io {
namespace {

using gdcm::DataSet;
using gdcm::Tag;
using gdcm::VR;

struct Palette {
  std::vector<std::uint16_t> descriptor;
  std::vector<std::uint16_t> red, green, blue;
};

void putPalette(DataSet& set, const Palette& palette) {
  putText(set, Tag(0x0028, 0x0004), VR::CS, "PALETTE COLOR");
  for (std::uint16_t i = 0; i < 3; ++i)
    putWords(set, Tag(0x0028, std::uint16_t(0x1101 + i)), VR::US, palette.descriptor);
  putWords(set, Tag(0x0028, 0x1201), VR::OW, palette.red);
  putWords(set, Tag(0x0028, 0x1202), VR::OW, palette.green);
  putWords(set, Tag(0x0028, 0x1203), VR::OW, palette.blue);
}

/// A row of samples of 8 or 16 bits, which a palette colours.
template <class Sample>
DicomImage imageOf(const std::vector<Sample>& samples, const Palette& palette) {
  DicomImage image;
  image.modality = "US";
  image.columns = int(samples.size());
  image.rows = 1;
  image.bits = image.stored = int(sizeof(Sample)) * 8;
  image.pixels = pixelBytes(samples);
  if (image.pixels.size() % 2) image.pixels += '\0';
  putPalette(image.set, palette);
  return image;
}

template <class Channel>
std::vector<int> colours(const DicomImage& image) {
  TempFolder folder;
  EXPECT_TRUE(writeDicom(folder / "a.dcm", image));
  Volume v = read(folder / "a.dcm");
  EXPECT_EQ(v.channels, 3);
  EXPECT_TRUE(v.isColor);
  EXPECT_EQ(sampleSize(v.type), sizeof(Channel));
  std::vector<Channel> found(v.voxels.size() / sizeof(Channel));
  std::memcpy(found.data(), v.voxels.data(), v.voxels.size());
  return {found.begin(), found.end()};
}

std::string refusalOf(const DicomImage& image) {
  TempFolder folder;
  EXPECT_TRUE(writeDicom(folder / "a.dcm", image));
  try {
    read(folder / "a.dcm");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DicomPalette, ColoursComeFromItsEntriesAndAreHeldAtBothEnds) {
  Palette palette{{3, 2, 16}, {100, 200, 65535}, {1, 2, 3}, {7, 8, 9}};
  std::vector<int> expected{100, 1, 7, 100, 1, 7, 200, 2, 8, 65535, 3, 9, 65535, 3, 9};
  EXPECT_EQ(colours<std::uint16_t>(imageOf<std::uint8_t>({0, 2, 3, 4, 255}, palette)), expected);
  EXPECT_EQ(colours<std::uint16_t>(imageOf<std::uint16_t>({0, 2, 3, 4, 65535}, palette)), expected);
}

TEST(DicomPalette, EntriesOfEightBitsComeTwoAWordOrOne) {
  Palette packed{{3, 0, 8}, {10 | 11 << 8, 12}, {20 | 21 << 8, 22}, {30 | 31 << 8, 32}};
  Palette apart{{3, 0, 8}, {10, 11, 12}, {20, 21, 22}, {30, 31, 32}};
  std::vector<int> expected{11, 21, 31, 10, 20, 30, 12, 22, 32};
  EXPECT_EQ(colours<std::uint8_t>(imageOf<std::uint8_t>({1, 0, 2}, packed)), expected);
  EXPECT_EQ(colours<std::uint8_t>(imageOf<std::uint8_t>({1, 0, 2}, apart)), expected);
}

TEST(DicomPalette, ADamagedOneIsRefusedByWhatIsWrong) {
  Palette whole{{2, 0, 16}, {1, 2}, {3, 4}, {5, 6}}, cutOff = whole, nameless = whole;
  cutOff.green = {3};
  nameless.descriptor = {2, 0};
  for (const Palette& palette : {cutOff, nameless})
    EXPECT_NE(refusalOf(imageOf<std::uint8_t>({0, 1}, palette)).find("palette"), std::string::npos);
  // Named, but nothing of it there: the library ends the program over this one (found by fuzzing).
  for (const char* name : {"PALETTE COLOR", "PALETTE COLO", "PALETTE"}) {
    DicomImage image;
    image.pixels = std::string(16, '\0');
    putText(image.set, Tag(0x0028, 0x0004), VR::CS, name);
    EXPECT_NE(refusalOf(image).find("palette"), std::string::npos) << name;
  }
  DicomImage segments = imageOf<std::uint8_t>({0, 1}, whole);
  putWords(segments.set, Tag(0x0028, 0x1221), VR::OW, {0, 1, 5});
  EXPECT_NE(refusalOf(segments).find("segments"), std::string::npos);
}

TEST(DicomPalette, AnIconWithADamagedOneHarmsNothing) {
  DicomImage image;
  image.pixels = pixelBytes(std::vector<std::uint16_t>{1, 2, 3, 4, 5, 6, 7, 8});
  DataSet icon;
  for (std::uint16_t tag : {0x0010, 0x0011, 0x0100, 0x0101}) putShort(icon, Tag(0x0028, tag), 8);
  putText(icon, Tag(0x0028, 0x0004), VR::CS, "PALETTE COLOR");
  putSequence(image.set, Tag(0x0088, 0x0200), sequenceWith(icon));
  TempFolder folder;
  ASSERT_TRUE(writeDicom(folder / "a.dcm", image));
  EXPECT_EQ(valueAt(read(folder / "a.dcm"), {3, 1, 0}), 8);
}

}  // namespace
}  // namespace velum::io
