#include "io/stores/ReduceBlocks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace velum::io {

namespace {

/// The rows of finer samples that a row is made of.
template <class Sample>
struct Rows {
  const Sample* row[4];
  int count = 0;
};

template <class Sample>
Rows<Sample> rowsOf(const Sample* from, glm::ivec3 fromSize, glm::ivec3 factor, int y, int z) {
  Rows<Sample> rows{};
  for (int dz = 0; dz < factor.z; ++dz)
    for (int dy = 0; dy < factor.y; ++dy) {
      int fromY = std::min(y * factor.y + dy, fromSize.y - 1), fromZ = std::min(z * factor.z + dz, fromSize.z - 1);
      rows.row[rows.count++] =
          from + (std::size_t(fromZ) * std::size_t(fromSize.y) + std::size_t(fromY)) * std::size_t(fromSize.x);
    }
  return rows;
}

/// Of a block of 1, 2, 4 or 8 whole numbers, by their sum: halves go to the even number, so that means of means do not
/// creep upwards.
template <class Sample, class Sum>
void roundRow(const std::vector<Sum>& sums, int fromCount, int count, int factorX, int shift, Sample* to) {
  Sum half = shift > 0 ? (Sum(1) << (shift - 1)) - 1 : 0;
  auto rounded = [&](Sum sum) {
    return shift > 0 ? Sample((sum + half + ((sum >> shift) & 1)) >> shift) : Sample(sum);
  };
  if (factorX == 1) {
    for (int x = 0; x < count; ++x) to[x] = rounded(sums[std::size_t(x)]);
    return;
  }
  const Sum* sum = sums.data();
  int pairs = fromCount / 2;
  for (int x = 0; x < pairs; ++x) to[x] = rounded(sum[2 * x] + sum[2 * x + 1]);
  if (pairs < count) to[pairs] = rounded(2 * sum[2 * pairs]);
}

template <class Sample, class Sum>
void averageWholeRow(const Rows<Sample>& rows, int fromCount, int count, int factorX, std::vector<Sum>& sums,
                     Sample* to) {
  std::fill(sums.begin(), sums.end(), Sum(0));
  for (int r = 0; r < rows.count; ++r)
    for (int x = 0; x < fromCount; ++x) sums[std::size_t(x)] += Sum(rows.row[r][x]);
  int samples = rows.count * factorX, shift = samples == 8 ? 3 : samples == 4 ? 2 : samples == 2 ? 1 : 0;
  roundRow<Sample, Sum>(sums, fromCount, count, factorX, shift, to);
}

template <class Sample>
void averageFloatRow(const Rows<Sample>& rows, int fromCount, int count, int factorX, Sample* to) {
  for (int x = 0; x < count; ++x) {
    double sum = 0.0;
    int found = 0;
    for (int r = 0; r < rows.count; ++r)
      for (int dx = 0; dx < factorX; ++dx) {
        Sample sample = rows.row[r][std::min(x * factorX + dx, fromCount - 1)];
        if (std::isnan(sample)) continue;
        sum += double(sample);
        ++found;
      }
    to[x] = found > 0 ? Sample(sum / found) : std::numeric_limits<Sample>::quiet_NaN();
  }
}

template <class Sample>
Sample mostFrequent(const Sample* block, int count) {
  if (std::all_of(block + 1, block + count, [&](Sample other) { return other == block[0]; })) return block[0];
  Sample best = block[0];
  int bestCount = 0;
  for (int i = 0; i < count; ++i) {
    int found = int(std::count(block, block + count, block[i]));
    bool isBetter = block[i] != 0 && (best == 0 || block[i] < best);
    if (found < bestCount || (found == bestCount && !isBetter)) continue;
    best = block[i];
    bestCount = found;
  }
  return best;
}

template <class Sample>
void chooseRow(const Rows<Sample>& rows, int fromCount, int count, int factorX, Sample* to) {
  Sample block[8];
  for (int x = 0; x < count; ++x) {
    int found = 0;
    for (int r = 0; r < rows.count; ++r)
      for (int dx = 0; dx < factorX; ++dx) block[found++] = rows.row[r][std::min(x * factorX + dx, fromCount - 1)];
    to[x] = mostFrequent(block, found);
  }
}

/// Bits are all that ids are.
template <class Bits>
void choose(const std::byte* from, glm::ivec3 fromSize, glm::ivec3 size, glm::ivec3 factor, std::byte* to) {
  auto* out = reinterpret_cast<Bits*>(to);
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y, out += size.x)
      chooseRow(rowsOf(reinterpret_cast<const Bits*>(from), fromSize, factor, y, z), fromSize.x, size.x, factor.x, out);
}

template <class Sample>
void average(const Sample* from, glm::ivec3 fromSize, glm::ivec3 size, glm::ivec3 factor, Sample* to) {
  using Sum = std::conditional_t<sizeof(Sample) <= 2, std::int32_t, std::int64_t>;
  std::vector<Sum> sums(std::size_t(fromSize.x));
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y, to += size.x) {
      Rows<Sample> rows = rowsOf(from, fromSize, factor, y, z);
      if constexpr (std::is_floating_point_v<Sample>)
        averageFloatRow(rows, fromSize.x, size.x, factor.x, to);
      else
        averageWholeRow<Sample, Sum>(rows, fromSize.x, size.x, factor.x, sums, to);
    }
}

}  // namespace

void reduceBlocks(SampleType type, Reduction reduction, const std::byte* from, glm::ivec3 fromSize, glm::ivec3 size,
                  glm::ivec3 factor, std::byte* to) {
  if (reduction == Reduction::Majority) {
    switch (sampleSize(type)) {
      case 1:
        return choose<std::uint8_t>(from, fromSize, size, factor, to);
      case 2:
        return choose<std::uint16_t>(from, fromSize, size, factor, to);
      case 4:
        return choose<std::uint32_t>(from, fromSize, size, factor, to);
      default:
        return choose<std::uint64_t>(from, fromSize, size, factor, to);
    }
  }
  Volume typed;
  typed.type = type;
  visitSamples(typed, [&](auto* null) {
    using Sample = std::remove_const_t<std::remove_pointer_t<decltype(null)>>;
    average(reinterpret_cast<const Sample*>(from), fromSize, size, factor, reinterpret_cast<Sample*>(to));
  });
}

}  // namespace velum::io
