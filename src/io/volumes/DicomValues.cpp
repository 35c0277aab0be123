#include "io/volumes/DicomValues.h"

#include <fmt/format.h>

#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "io/volumes/DicomTags.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

using Words = std::pair<std::string_view, std::string_view>;

/// What stands for a code; the code itself where nothing does.
std::string wordFor(const std::string& code, std::span<const Words> words) {
  for (auto [known, word] : words)
    if (code == known) return std::string(word);
  return code;
}

/// The entries of a table of numbers. @param what  the table, for people
std::vector<std::uint16_t> entriesOf(std::span<const std::uint16_t> descriptor, std::span<const std::uint16_t> data,
                                     std::string_view what, std::string& flaw) {
  std::vector<std::uint16_t> entries;
  if (descriptor.size() != 3 || descriptor[2] < 8 || descriptor[2] > 16) {
    flaw =
        fmt::format("its {} is damaged: it is not described by three numbers of which the last is 8 to 16 bits", what);
    return entries;
  }
  std::size_t count = descriptor[0] == 0 ? 65536 : descriptor[0];
  // Entries of 8 bits come one a word, or two, the first in the low byte.
  bool isPacked = descriptor[2] == 8 && data.size() < count;
  if (data.size() * (isPacked ? 2 : 1) < count) {
    flaw = fmt::format("its {} is cut off: {} words for {} entries", what, data.size(), count);
    return entries;
  }
  for (std::size_t i = 0; i < count; ++i)
    entries.push_back(isPacked ? std::uint16_t(data[i / 2] >> (i % 2 * 8) & 0xff) : data[i]);
  return entries;
}

int firstOf(std::uint16_t number, bool isSigned) { return isSigned ? int(std::int16_t(number)) : int(number); }

}  // namespace

DicomTable modalityTableOf(const DataSet& set, bool isSigned, std::string& flaw) {
  DicomTable table;
  auto item = firstItem(set, Tag(0x0028, 0x3000));
  if (!item) return table;
  auto descriptor = wordsOf(*item, Tag(0x0028, 0x3002));
  table.entries = entriesOf(descriptor, wordsOf(*item, Tag(0x0028, 0x3006)), "Modality LUT", flaw);
  if (table.entries.empty()) return table;
  table.first = firstOf(descriptor[1], isSigned);
  table.unit = unitOfRescaleType(textOf(*item, Tag(0x0028, 0x3004)));
  return table;
}

DicomPalette paletteOf(const DataSet& set, bool isSigned, std::string& flaw) {
  DicomPalette palette, none;
  constexpr std::uint16_t kDescriptor = 0x1101, kData = 0x1201, kSegmented = 0x1221;
  for (std::uint16_t i = 0; i < 3; ++i) {
    auto descriptor = wordsOf(set, Tag(0x0028, std::uint16_t(kDescriptor + i)));
    if (set.FindDataElement(Tag(0x0028, std::uint16_t(kSegmented + i)))) {
      flaw = "its palette comes in segments, which is not supported";
      return none;
    }
    palette.entries[i] = entriesOf(descriptor, wordsOf(set, Tag(0x0028, std::uint16_t(kData + i))), "palette", flaw);
    if (palette.entries[i].empty()) return none;
    if (palette.entries[i].size() != palette.entries[0].size()) {
      flaw = "its palette is damaged: red, green and blue differ in length";
      return none;
    }
    palette.first = firstOf(descriptor[1], isSigned);
    palette.bits = descriptor[2] == 8 ? 8 : 16;
  }
  return palette;
}

std::string unitOfRescaleType(const std::string& type) {
  constexpr Words kWords[] = {{"US", ""},     {"OD", "mOD"},        {"MGML", "mg/ml"},     {"PCT", "%"},
                              {"Z_EFF", "Z"}, {"ED", "10^23 e/ml"}, {"EDW", "e of water"}, {"HU_MOD", "HU (modified)"}};
  return wordFor(type, kWords);
}

std::string unitOfPet(const DataSet& set) {
  constexpr Words kWords[] = {{"NONE", ""},
                              {"CNTS", "counts"},
                              {"PROPCNTS", "of counts"},
                              {"CPS", "counts/s"},
                              {"PROPCPS", "of counts/s"},
                              {"BQML", "Bq/ml"},
                              {"GML", "g/ml"},
                              {"CM2", "cm2"},
                              {"CM2ML", "cm2/ml"},
                              {"PCNT", "%"},
                              {"MGMINML", "mg/min/ml"},
                              {"UMOLMINML", "umol/min/ml"},
                              {"UMOLML", "umol/ml"},
                              {"MLMING", "ml/min/g"},
                              {"MLMINML", "ml/min/ml"},
                              {"MLG", "ml/g"},
                              {"MLML", "ml/ml"},
                              {"1CM", "1/cm"},
                              {"STDDEV", "standard deviations"}};
  constexpr Words kUptakes[] = {{"", "SUVbw"},          {"BW", "SUVbw"},   {"LBM", "SUVlbm"}, {"LBMJAMES128", "SUVlbm"},
                                {"LBMJANMA", "SUVlbm"}, {"BSA", "SUVbsa"}, {"IBW", "SUVibw"}};
  std::string units = textOf(set, Tag(0x0054, 0x1001)), uptake = textOf(set, Tag(0x0054, 0x1006));
  // Without a type, g/ml are by body weight.
  if (units == "GML" || (units == "CM2ML" && uptake == "BSA")) return wordFor(uptake, kUptakes);
  return wordFor(units, kWords);
}

std::vector<double> doseOffsetsOf(const DataSet& set, int planes, double firstZ, double normalZ, std::string& flaw,
                                  std::string& warning) {
  const Tag kOffsets(0x3004, 0x000c);
  if (planes == 1 || !set.FindDataElement(kOffsets)) return {};
  auto offsets = numbersOf(set, kOffsets);
  bool isSound = std::all_of(offsets.begin(), offsets.end(), [](double x) { return std::isfinite(x); });
  if (!isSound || offsets.size() != std::size_t(planes)) {
    flaw = fmt::format("its grid frame offsets are damaged: {} for {} planes", offsets.size(), planes);
    return {};
  }
  // They count from the first plane, or they are the patient's z, which only axial planes have.
  double first = offsets.front();
  bool isPlace = first != 0 && std::abs(first - firstZ) < 0.01, isAxial = std::abs(std::abs(normalZ) - 1) < 1e-4;
  if (first != 0 && !(isPlace && isAxial))
    warning = fmt::format("the offsets of the dose's planes begin at {:.6g} mm and not at 0; they are taken from there",
                          first);
  for (double& offset : offsets) offset = (offset - first) * (isPlace && isAxial && normalZ < 0 ? -1 : 1);
  return offsets;
}

}  // namespace velum::io
