#include "session/lettering/Spacing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace velum::session {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Neighbours that touch, and move together.
struct Pool {
  double sum = 0.0;
  int count = 0;
  double mean() const { return sum / count; }
};

}  // namespace

std::optional<std::vector<double>> spaceOut(std::span<const Spaced> things, double gap, double low, double high) {
  // From each middle its distance from the first one's is taken when all touch: what is left must not fall.
  std::vector<double> offsets;
  for (std::size_t i = 0; i < things.size(); ++i)
    offsets.push_back(i == 0 ? things[0].size / 2 : offsets.back() + (things[i - 1].size + things[i].size) / 2 + gap);
  if (things.empty()) return offsets;
  double most = high - offsets.back() - things.back().size / 2;
  if (most < low) return std::nullopt;
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < things.size(); ++i) {
    Pool pool{things[i].wanted - offsets[i], 1};
    for (; !pools.empty() && pools.back().mean() >= pool.mean(); pools.pop_back()) {
      pool.sum += pools.back().sum;
      pool.count += pools.back().count;
    }
    pools.push_back(pool);
  }
  // What is best without ends is best with them where it is brought between them.
  std::vector<double> middles;
  for (const Pool& pool : pools)
    for (int i = 0; i < pool.count; ++i)
      middles.push_back(std::clamp(pool.mean(), low, most) + offsets[middles.size()]);
  return middles;
}

std::optional<std::vector<double>> spaceOut(std::span<const Spaced> things, double gap,
                                            std::span<const glm::dvec2> stretches) {
  if (stretches.size() == 1) return spaceOut(things, gap, stretches[0].x, stretches[0].y);
  // costs[i]: of the first i things in the stretches so far; firsts[k][i]: from which of them on they are in stretch k.
  std::size_t count = things.size();
  std::vector<double> costs(count + 1, kNever);
  costs[0] = 0.0;
  std::vector<std::vector<std::size_t>> firsts;
  for (glm::dvec2 stretch : stretches) {
    std::vector<double> next = costs;
    std::vector<std::size_t>& first = firsts.emplace_back(count + 1);
    for (std::size_t i = 0; i <= count; ++i) first[i] = i;
    for (std::size_t i = 0; i < count; ++i) {
      double filled = -gap, cost = costs[i];
      for (std::size_t j = i; j < count && cost < kNever; ++j) {
        filled += things[j].size + gap;
        if (filled > stretch.y - stretch.x) break;
        double half = things[j].size / 2;
        double at = std::clamp(things[j].wanted, stretch.x + half, stretch.y - half);
        cost += std::abs(at - things[j].wanted);
        if (cost >= next[j + 1]) continue;
        next[j + 1] = cost;
        first[j + 1] = i;
      }
    }
    costs = next;
  }
  if (costs[count] == kNever) return std::nullopt;
  std::vector<double> middles(count);
  std::size_t end = count;
  for (std::size_t k = stretches.size(); k-- > 0;) {
    std::size_t from = firsts[k][end];
    auto some = spaceOut(things.subspan(from, end - from), gap, stretches[k].x, stretches[k].y);
    if (!some) return std::nullopt;
    std::copy(some->begin(), some->end(), middles.begin() + std::ptrdiff_t(from));
    end = from;
  }
  return middles;
}

}  // namespace velum::session
