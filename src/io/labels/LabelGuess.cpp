#include "io/labels/LabelGuess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "io/read/FileNames.h"

namespace velum::io {

bool holdsAreasOfIds(const Volume& v) {
  bool isFloat = v.type == SampleType::Float32 || v.type == SampleType::Float64;
  if (v.channels != 1 || v.range.x < 0 || (isFloat && v.range.y > 65535)) return false;
  bool isWhole = true;
  std::size_t pairs = 0, equal = 0, row = std::size_t(v.dims.x), count = voxelCount(v);
  visitSamples(v, [&](const auto* samples) {
    double before = 0;
    for (std::size_t i = 0; i < count && isWhole; ++i) {
      double value = double(samples[i]) * v.scale + v.offset;
      isWhole = std::abs(value - std::round(value)) < kWhole;
      bool isPair = i % row != 0 && value != 0 && before != 0;
      pairs += isPair;
      equal += isPair && std::abs(value - before) < kWhole;
      before = value;
    }
  });
  return isWhole && 2 * equal >= pairs;
}

bool holdsNothingButIds(const Volume& v) {
  constexpr int kMostIds = 64;
  constexpr std::size_t kFewVoxels = 4096;
  bool isWhole = v.type == SampleType::UInt8 || v.type == SampleType::UInt16;
  if (!isWhole || v.channels != 1 || v.isColor || v.scale != 1 || v.offset != 0 || v.timeSteps != 1) return false;
  if (v.modality != Modality::Unknown || voxelCount(v) < kFewVoxels) return false;
  std::vector<bool> isUsed(65536, false);
  int ids = 0;
  std::size_t largest = 0;
  std::size_t pairs = 0, equal = 0, row = std::size_t(v.dims.x), count = voxelCount(v);
  visitSamples(v, [&](const auto* samples) {
    for (std::size_t i = 0; i < count && ids <= kMostIds; ++i) {
      auto id = std::size_t(samples[i]);
      if (id != 0 && !isUsed[id]) isUsed[id] = true, ++ids;
      largest = std::max(largest, id);
      if (i % row == 0 || id == 0 || samples[i - 1] == 0) continue;
      ++pairs;
      equal += samples[i] == samples[i - 1];
    }
  });
  return ids >= 2 && ids <= kMostIds && largest <= 2 * std::size_t(ids) && 20 * equal >= 19 * pairs;
}

bool nameSaysLabels(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 9> kWords{"label",         "labels", "labelmap", "seg",     "segmentation",
                                                   "segmentations", "mask",   "masks",    "totalseg"};
  std::string name = lowerCase(path.filename().string()), word;
  for (char c : name + ".") {
    if (c >= 'a' && c <= 'z') {
      word += c;
      continue;
    }
    if (std::find(kWords.begin(), kWords.end(), word) != kWords.end()) return true;
    word.clear();
  }
  return false;
}

}  // namespace velum::io
