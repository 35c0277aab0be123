#include "session/bar/Dial.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace velum::session {

CountRange& CountRange::operator+=(const Dial& dial) {
  least += dial.always;
  most += dial.always + dial.candidates.size();
  total += dial.total;
  return *this;
}

DialGap gapFor(const Dial& dial, std::uint64_t staying) {
  std::size_t count = dial.candidates.size();
  if (staying == 0 || count == 0) return {};
  std::vector<float> from(count);
  std::transform(dial.candidates.begin(), dial.candidates.end(), from.begin(),
                 [](const Candidate& candidate) { return candidate.from; });
  if (staying >= count)
    return {count, *std::max_element(from.begin(), from.end()), std::numeric_limits<float>::infinity()};
  auto place = from.begin() + std::ptrdiff_t(staying - 1);
  std::nth_element(from.begin(), place, from.end());
  float last = *place, next = *std::min_element(place + 1, from.end());
  if (last < next) return {staying, last, next};
  auto before = std::uint64_t(std::count_if(from.begin(), from.end(), [last](float f) { return f < last; }));
  auto upTo = std::uint64_t(std::count_if(from.begin(), from.end(), [last](float f) { return f <= last; }));
  return gapFor(dial, staying - before <= upTo - staying ? before : upTo);
}

std::vector<std::uint64_t> apportion(const std::vector<std::uint64_t>& weights, std::uint64_t count) {
  std::vector<std::uint64_t> parts(weights.size(), 0), rests(weights.size(), 0);
  std::uint64_t all = std::accumulate(weights.begin(), weights.end(), std::uint64_t(0)), given = 0;
  count = std::min(count, all);
  if (all == 0) return parts;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    std::uint64_t product = count * weights[i];
    parts[i] = product / all, rests[i] = product % all;
    given += parts[i];
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return rests[a] > rests[b]; });
  for (std::size_t i = 0; given < count; ++i, ++given) ++parts[order[i]];
  return parts;
}

std::string wordsFor(const Solved& solved, const CountRange& range, const std::string& left, const std::string& wanted,
                     const DialReasons& reasons) {
  if (solved.wanted == solved.reached) return left;
  if (solved.wanted > range.total && solved.reached == range.total) return fmt::format("{}: there are no more", left);
  if (solved.cuts.empty()) return fmt::format("{}: {}", left, reasons.noCut);
  if (solved.wanted < range.least) return fmt::format("{}, not fewer: {}", left, reasons.notFewer);
  if (solved.wanted > range.most) return fmt::format("{}, not more: {}", left, reasons.notMore);
  return fmt::format("{}, the nearest to {}: several come and go at once", left, wanted);
}

}  // namespace velum::session
