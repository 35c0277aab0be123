#include "session/extrusion/Populations.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace velum::session {

namespace {

/// Bins of the density, and how far it is smoothed to either side, twice.
constexpr int kBins = 512, kSmooth = 4;
/// Of the values so many lie beyond either end of the density.
constexpr double kEnds = 1e-3;
/// Two peaks are two where the density between them falls below this share of the lower one.
constexpr double kValleyDepth = 0.6;
/// A population is no smaller than this share, and no narrower than this share of all values' stretch: beside a spike
/// of one value lie others of the same material, in 8 bits as in air.
constexpr double kLeastShare = 0.05, kLeastSpread = 1.0 / 60.0;
/// A population reaches so many times its spread to either side of its middle.
constexpr double kPeakSpreads = 2.5;

using Density = std::array<double, kBins>;

Density smoothed(const Density& in) {
  std::array<double, kBins + 1> sum{};
  for (int i = 0; i < kBins; ++i) sum[std::size_t(i) + 1] = sum[std::size_t(i)] + in[std::size_t(i)];
  Density out{};
  for (int i = 0; i < kBins; ++i) {
    auto end = std::size_t(std::min(i + kSmooth + 1, kBins)), first = std::size_t(std::max(i - kSmooth, 0));
    out[std::size_t(i)] = (sum[end] - sum[first]) / (2 * kSmooth + 1);
  }
  return out;
}

/// A stretch of bins that climb to one peak.
struct Hill {
  int first, peak, last;  ///< included
};

/// From each valley to the next; those whose valley is shallow become one, the shallowest first.
std::vector<Hill> hillsOf(const Density& density) {
  auto at = [&](int i) { return density[std::size_t(i)]; };
  std::vector<Hill> hills;
  for (int i = 0; i < kBins; ++i) {
    bool isUp = hills.empty() || (at(i) > at(i - 1) && hills.back().peak < i - 1 && at(i - 1) < at(hills.back().peak));
    if (isUp) hills.push_back({i, i, i});
    hills.back().last = i;
    if (at(i) > at(hills.back().peak)) hills.back().peak = i;
  }
  while (hills.size() > 1) {
    // How deep the valley before the i-th is, beside the lower of its two peaks.
    auto depth = [&](std::size_t i) {
      double lower = std::min(at(hills[i - 1].peak), at(hills[i].peak));
      return lower > 0.0 ? std::min(at(hills[i].first), at(hills[i - 1].last)) / lower : 1.0;
    };
    std::size_t shallowest = 1;
    for (std::size_t i = 2; i < hills.size(); ++i)
      if (depth(i) > depth(shallowest)) shallowest = i;
    if (depth(shallowest) <= kValleyDepth) break;
    Hill &one = hills[shallowest - 1], &other = hills[shallowest];
    if (at(other.peak) > at(one.peak)) one.peak = other.peak;
    one.last = other.last;
    hills.erase(hills.begin() + std::ptrdiff_t(shallowest));
  }
  return hills;
}

/// Bins from the peak to where the density has fallen to half, by the flank that falls sooner.
double halfWidth(const Density& density, const Hill& hill) {
  double half = 0.5 * density[std::size_t(hill.peak)];
  for (int away = 1; away < kBins; ++away)
    for (int i : {hill.peak - away, hill.peak + away})
      if (i >= 0 && i < kBins && density[std::size_t(i)] <= half) return away - 0.5;
  return kBins;
}

}  // namespace

double Population::upperEnd() const { return middle + kPeakSpreads * spread; }
double Population::lowerEnd() const { return middle - kPeakSpreads * spread; }

std::vector<Population> populationsOf(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double low = values[std::size_t(kEnds * double(values.size() - 1))];
  double high = values[std::size_t((1.0 - kEnds) * double(values.size() - 1))];
  if (!(high > low)) return {{low, 0.0, 1.0}};
  double width = (high - low) / kBins;
  Density density{};
  for (double value : values)
    density[std::size_t(std::clamp(int((value - low) / width), 0, kBins - 1))] += 1.0 / double(values.size());
  density = smoothed(smoothed(density));
  // What smoothing has added to the variance, in bins; half of a normal distribution's height is 1.177 of it away.
  constexpr double kAdded = 2.0 * ((2 * kSmooth + 1) * (2 * kSmooth + 1) - 1) / 12.0, kHalf = 1.177;
  std::vector<Population> populations;
  for (const Hill& hill : hillsOf(density)) {
    double share = 0.0;
    for (int i = hill.first; i <= hill.last; ++i) share += density[std::size_t(i)];
    if (share < kLeastShare) continue;
    double deviation = halfWidth(density, hill) / kHalf;
    double spread = width * std::sqrt(std::max(deviation * deviation - kAdded, 0.0));
    populations.push_back({low + (hill.peak + 0.5) * width, std::max(spread, kLeastSpread * (high - low)), share});
  }
  return populations;
}

}  // namespace velum::session
