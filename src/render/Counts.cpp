#include "render/Counts.h"

#include <algorithm>
#include <bit>

namespace velum::render {

namespace {

/// Bits of a range that are set in all of some words. @param word  by the number of a word
template <class Word>
std::uint64_t countBits(std::uint64_t first, std::uint64_t end, const Word& word) {
  std::uint64_t count = 0;
  for (std::uint64_t i = first; i < end;) {
    std::uint64_t next = std::min(end, (i / 32 + 1) * 32);
    std::uint32_t mask = ~0u << (i % 32);
    if (next % 32 != 0) mask &= ~(~0u << (next % 32));
    count += std::uint64_t(std::popcount(word(i / 32) & mask));
    i = next;
  }
  return count;
}

}  // namespace

std::vector<Counts> countTypes(const Model& model, const InstanceBits& bits) {
  std::vector<Counts> counts(model.types.size());
  std::uint64_t copy = model.instances.size();
  for (std::uint64_t before = 0; copy > 0 && before + copy <= bits.count; before += copy)
    for (std::size_t t = 0; t < counts.size(); ++t) {
      std::uint64_t first = before + model.types[t].firstInstance, end = first + model.types[t].instanceCount;
      std::uint64_t clipped = countBits(first, end, [&](std::uint64_t w) { return bits.removed[w]; });
      std::uint64_t visible = countBits(first, end, [&](std::uint64_t w) { return bits.shown[w] & ~bits.removed[w]; });
      Counts& count = counts[t];
      count[CountOf::Clipped] += clipped;
      count[CountOf::Visible] += visible;
      count[CountOf::Hidden] += end - first - clipped - visible;
    }
  return counts;
}

std::vector<Counts> countCompartments(const Model& model, const std::vector<Counts>& types) {
  std::vector<Counts> sums(model.compartments.size());
  for (std::size_t t = 0; t < types.size(); ++t) sums[model.types[t].compartment] += types[t];
  for (std::size_t c = sums.size(); c-- > 0;)
    if (model.compartments[c].parent >= 0) sums[std::size_t(model.compartments[c].parent)] += sums[c];
  return sums;
}

}  // namespace velum::render
