#include "io/labels/LabelNumbers.h"

#include <algorithm>
#include <tuple>

#include "io/stores/WideIds.h"

namespace velum::io {

LabelNumbers::LabelNumbers(KnownIds known, const std::vector<std::uint64_t>& chosen) : mKnown(std::move(known)) {
  for (std::uint64_t number : chosen) take(number);
  mIsClosed = true;
}

std::uint16_t LabelNumbers::take(std::uint64_t number) {
  std::lock_guard lock(mGuard);
  if (auto found = mIds.find(number); found != mIds.end()) return found->second;
  if (mIsClosed) return 0;
  if (mNumbers.size() >= kLargestLabel) throw TooManyIds{};
  mNumbers.push_back(number);
  return mIds[number] = std::uint16_t(mNumbers.size());
}

std::vector<std::uint16_t> LabelNumbers::settle() const {
  std::vector<bool> isTaken(kLargestLabel + 1, false);
  std::vector<std::uint16_t> ids(mNumbers.size() + 1, 0);
  std::vector<std::pair<std::uint64_t, std::size_t>> wide;  // with their places
  for (std::size_t i = 0; i < mNumbers.size(); ++i)
    if (mNumbers[i] <= kLargestLabel)
      isTaken[ids[i + 1] = std::uint16_t(mNumbers[i])] = true;
    else
      wide.emplace_back(mNumbers[i], i + 1);
  // Those that a scene knows stay what they are there, unless a number of the file is that.
  for (auto [number, place] : wide)
    if (auto found = mKnown.find(number); found != mKnown.end() && found->second != 0 && !isTaken[found->second])
      isTaken[ids[place] = found->second] = true;
  std::sort(wide.begin(), wide.end());
  std::uint16_t next = 1;
  for (auto [number, place] : wide) {
    if (ids[place] != 0) continue;
    while (isTaken[next]) ++next;
    isTaken[ids[place] = next] = true;
  }
  return ids;
}

std::vector<LabelInfo> LabelNumbers::table() const {
  auto ids = settle();
  std::vector<LabelInfo> table;
  for (std::size_t i = 0; i < mNumbers.size(); ++i)
    if (mNumbers[i] > kLargestLabel) {
      std::uint16_t id = ids[i + 1];
      table.push_back({id, segmentName(mNumbers[i]), defaultLabelColor(id), 1.0f, mNumbers[i]});
    }
  std::sort(table.begin(), table.end(), [](const LabelInfo& a, const LabelInfo& b) { return a.id < b.id; });
  return table;
}

std::vector<std::uint64_t> mostFrequent(const NumberCounts& counts, const KnownIds& known) {
  struct One {
    bool isKnown;
    std::uint64_t voxels, number;
  };
  std::vector<One> all;
  for (auto [number, voxels] : counts) all.push_back({known.contains(number), voxels, number});
  std::size_t most = std::min<std::size_t>(all.size(), kLargestLabel);
  std::partial_sort(all.begin(), all.begin() + std::ptrdiff_t(most), all.end(), [](const One& a, const One& b) {
    return std::tuple(b.isKnown, b.voxels, a.number) < std::tuple(a.isKnown, a.voxels, b.number);
  });
  std::vector<std::uint64_t> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(all[i].number);
  return chosen;
}

}  // namespace velum::io
