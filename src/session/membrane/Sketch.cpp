// From the values under strokes to a curve of strengths.
#include "session/membrane/Sketch.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "scene/Scene.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/StrokeSamples.h"

namespace velum::session {

namespace {

using Density = std::vector<double>;

constexpr double kAvoidWeight = 2.0;  ///< where both kinds of strokes lie over the same material, avoiding wins
constexpr double kLeastShare = 0.05;  ///< of the samples, below which a stretch is what the brush has spilled over
constexpr double kTail = 0.01;        ///< of what the volume has in a stretch: so little beyond it is its noise
constexpr double kReach = 3.0;        ///< of a Gaussian, in standard deviations

double totalOf(const std::vector<std::uint64_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), 0.0, [](double sum, auto n) { return sum + double(n); });
}

/// Width in bins of the shortest stretch that holds half of the samples: of a heap among several its own, where the
/// standard deviation would be that of all together.
double shortestHalf(const std::vector<std::uint64_t>& counts, double total) {
  std::size_t end = 0, best = counts.size();
  double held = 0;
  for (std::size_t first = 0; first < counts.size(); ++first) {
    while (end < counts.size() && held < 0.5 * total) held += double(counts[end++]);
    if (held < 0.5 * total) break;
    best = std::min(best, end - first);
    held -= double(counts[first]);
  }
  return double(best) - 1.0;
}

/// Standard deviation, in bins, of the kernels of a density estimate, by Silverman's rule of thumb for the spread of
/// the largest heap. At least a bin.
double bandwidthOf(const std::vector<std::uint64_t>& counts) {
  double total = totalOf(counts);
  constexpr double kNormalHalf = 1.349;  // the middle half of a normal distribution, in standard deviations
  return std::max(1.0, 0.9 * shortestHalf(counts, total) / kNormalHalf * std::pow(std::max(total, 1.0), -0.2));
}

/// Sums to 1, or to 0 where nothing was counted.
Density smoothed(const std::vector<std::uint64_t>& counts, double bandwidth) {
  Density out(counts.size(), 0.0);
  double total = totalOf(counts);
  if (!(total > 0)) return out;
  int reach = int(std::ceil(kReach * bandwidth)), last = int(counts.size()) - 1;
  std::vector<double> kernel;
  for (int i = -reach; i <= reach; ++i) kernel.push_back(std::exp(-0.5 * (i / bandwidth) * (i / bandwidth)));
  double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0) * total;
  for (int bin = 0; bin <= last; ++bin) {
    if (counts[std::size_t(bin)] == 0) continue;
    double weight = double(counts[std::size_t(bin)]) / sum;
    for (int i = std::max(-reach, -bin); i <= std::min(reach, last - bin); ++i)
      out[std::size_t(bin + i)] += weight * kernel[std::size_t(i + reach)];
  }
  return out;
}

/// Bins, both included.
struct Bins {
  int first = 0, last = 0;
};

double sharesIn(const std::vector<std::uint64_t>& counts, int first, int last) {
  double sum = 0;
  for (int i = std::max(first, 0); i <= std::min(last, int(counts.size()) - 1); ++i)
    sum += double(counts[std::size_t(i)]);
  return sum / std::max(totalOf(counts), 1.0);
}

/// Stretches where the samples win, without the flicker of few samples: gaps that the smoothing cannot tell from noise
/// are closed unless the others are in them.
std::vector<Bins> winningBins(const Density& samples, const Density& others, const Density& whole, double bandwidth) {
  std::vector<Bins> stretches;
  int free = 0;  // the first bin after the last in which the others are strong
  for (int i = 0; i < int(samples.size()); ++i) {
    auto at = std::size_t(i);
    bool isOthers = others[at] > 0 && samples[at] <= kAvoidWeight * others[at];
    if (isOthers) free = i + 1;
    if (isOthers || !(samples[at] > whole[at])) continue;
    bool joins =
        !stretches.empty() && stretches.back().last + 1 >= free && i - stretches.back().last <= 2.0 * bandwidth;
    if (joins)
      stretches.back().last = i;
    else
      stretches.push_back({i, i});
  }
  return stretches;
}

/// To the ends of the data's range where hardly anything lies beyond a stretch: the tail of its own noise.
void takeTails(std::vector<Bins>& stretches, const Histogram& others, const Histogram& whole) {
  if (stretches.empty()) return;
  int end = int(whole.counts.size()) - 1;
  Bins &low = stretches.front(), &high = stretches.back();
  auto isTail = [&](int first, int last, const Bins& of) {
    return sharesIn(whole.counts, first, last) <= kTail * sharesIn(whole.counts, of.first, of.last) &&
           sharesIn(others.counts, first, last) <= kTail;
  };
  if (isTail(0, low.first - 1, low)) low.first = 0;
  if (isTail(high.last + 1, end, high)) high.last = end;
}

void addTrapezoid(std::vector<scene::StrengthPoint>& curve, const ValueStretch& stretch, double rampMost) {
  double ramp = std::min(rampMost, 0.25 * (stretch.high - stretch.low));
  if (!stretch.isFirst) curve.push_back({stretch.low, 0.0});
  curve.push_back({stretch.isFirst ? stretch.low : stretch.low + ramp, kProtectStrength});
  curve.push_back({stretch.isLast ? stretch.high : stretch.high - ramp, kProtectStrength});
  if (!stretch.isLast) curve.push_back({stretch.high, 0.0});
}

}  // namespace

std::vector<ValueStretch> typicalStretches(const Histogram& samples, const Histogram& others, const Histogram& whole) {
  std::vector<ValueStretch> out;
  int bins = int(whole.counts.size());
  if (bins == 0 || samples.counts.size() != whole.counts.size() || !(totalOf(samples.counts) > 0)) return out;
  double bandwidth = bandwidthOf(samples.counts);
  Density otherShares(whole.counts.size(), 0.0);
  if (others.counts.size() == whole.counts.size()) otherShares = smoothed(others.counts, bandwidth);
  auto stretches =
      winningBins(smoothed(samples.counts, bandwidth), otherShares, smoothed(whole.counts, bandwidth), bandwidth);
  std::erase_if(stretches, [&](const Bins& b) { return sharesIn(samples.counts, b.first, b.last) < kLeastShare; });
  takeTails(stretches, others, whole);
  double width = (whole.range.y - whole.range.x) / bins;
  for (const Bins& b : stretches)
    out.push_back({whole.range.x + b.first * width,
                   b.last == bins - 1 ? whole.range.y : whole.range.x + (b.last + 1) * width, b.first == 0,
                   b.last == bins - 1});
  return out;
}

std::vector<scene::StrengthPoint> fitStrokes(const Histogram& keep, const Histogram& avoid, const Histogram& whole) {
  std::vector<scene::StrengthPoint> curve;
  double width = (whole.range.y - whole.range.x) / double(std::max<std::size_t>(whole.counts.size(), 1));
  double ramp = 2.0 * bandwidthOf(keep.counts) * width;
  for (const auto& stretch : typicalStretches(keep, avoid, whole)) addTrapezoid(curve, stretch, ramp);
  return curve;
}

std::vector<glm::dvec3> simplifiedPath(std::span<const glm::dvec3> path, double tolerance) {
  if (path.size() < 3) return {path.begin(), path.end()};
  glm::dvec3 along = path.back() - path.front();
  double length2 = glm::dot(along, along), farthest = -1;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    double t = length2 > 0 ? std::clamp(glm::dot(path[i] - path.front(), along) / length2, 0.0, 1.0) : 0.0;
    double away = glm::distance(path[i], path.front() + along * t);
    if (away > farthest) farthest = away, at = i;
  }
  if (farthest <= tolerance) return {path.front(), path.back()};
  std::vector<glm::dvec3> out = simplifiedPath(path.first(at + 1), tolerance);
  std::vector<glm::dvec3> rest = simplifiedPath(path.subspan(at), tolerance);
  out.insert(out.end(), rest.begin() + 1, rest.end());
  return out;
}

void setStrokes(scene::ForceField& field, std::vector<scene::Stroke> strokes, const scene::VolumeLayer& layer,
                const Histogram& whole) {
  if (field.strokes == strokes) return;
  if (field.strokes.empty()) field.byValueBefore = field.byValue;
  field.strokes = std::move(strokes);
  if (field.strokes.empty()) {
    field.byValue = std::move(field.byValueBefore);
    field.byValueBefore.clear();
    return;
  }
  Histogram keep = strokeHistogram(layer, field.strokes, false, whole);
  Histogram avoid = strokeHistogram(layer, field.strokes, true, whole);
  if (totalOf(keep.counts) > 0) {
    field.byValue = fitStrokes(keep, avoid, whole);
    return;
  }
  scene::Membrane carved;
  carved.field.byValue = field.byValueBefore;
  for (const auto& stretch : typicalStretches(avoid, {}, whole)) protectValues(carved, stretch.low, stretch.high, 0.0);
  field.byValue = std::move(carved.field.byValue);
}

}  // namespace velum::session
