#include "render/upload/TransferTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/Assert.h"
#include "scene/Scene.h"
#include "shared/frame.h"

namespace velum::render {

namespace {

/// Extinction, 1/length, of a material that covers `opacity` of what is behind `unit` of it. Fully opaque is 0.999, as
/// infinity has no sums.
double extinction(double opacity, double unit) { return -std::log(1.0 - std::clamp(opacity, 0.0, 0.999)) / unit; }

}  // namespace

MixTable makeMixTable(const scene::VolumeLayer& layer) {
  VELUM_ASSERT(layer.channels.size() == std::size_t(layer.data->channels), "each channel has its look");
  MixTable table;
  table.domain = layer.data->range;
  if (!(table.domain.y > table.domain.x)) table.domain.y = table.domain.x + 1.0;
  for (const auto& look : layer.channels) {
    auto& entries = table.channels.emplace_back(MixTable::kSize, glm::vec4(0.0f));
    if (!look.visible) continue;
    double largest = 0;
    for (int i = 0; i < MixTable::kSize; ++i) {
      double value = glm::mix(table.domain.x, table.domain.y, double(i) / (MixTable::kSize - 1));
      double sigma = extinction(scene::opacityAt(look.transfer.opacities, value), look.transfer.unitDistance);
      entries[std::size_t(i)] = glm::vec4(glm::dvec4(scene::colorAt(look.transfer.colors, value) * sigma, sigma));
      largest = std::max(largest, sigma);
    }
    table.largestExtinction += largest;
    table.largestOfOne = std::max(table.largestOfOne, largest);
  }
  for (auto& entries : table.channels)
    for (auto& entry : entries) entry /= float(std::max(table.largestExtinction, 1e-12));
  return table;
}

namespace {

/// Where in a table, in entries from its beginning, the lowest value lies at which it changes. All values below, as
/// air's are below a curve's first point, are the first entry's, which has nothing of what begins there: neither a
/// ramp, of which the lowest value itself has nothing, nor a step, which it has. With room for how positions are
/// rounded.
constexpr double kRampAt = 0.875, kStepAt = 1.125;

/// Extinction by table position 0..1, for volumes whose channels are mixed.
/// Nothing below half a step of the texels' eight bits: else no cell of a mixed volume would be empty.
double mixedExtinction(double alpha, double largest) { return alpha < 0.5 / 255.0 ? 0.0 : alpha * alpha * largest; }

/// Values that the table spans: those of its points, or of the window.
glm::dvec2 spannedValues(const scene::Scene& scene) {
  const auto& transfer = scene.volume.transfer;
  glm::dvec2 window = scene::effectiveWindow(scene.volume);
  bool showsPoints = !scene::usesWindow(scene) && !(transfer.opacities.empty() && transfer.colors.empty());
  double low = std::numeric_limits<double>::infinity(), high = -low;
  auto include = [&](double value) { low = std::min(low, value), high = std::max(high, value); };
  if (!showsPoints) include(window.x - 0.5 * window.y), include(window.x + 0.5 * window.y);
  for (const auto& p : transfer.opacities) include(p.value);
  for (const auto& p : transfer.colors) include(p.value);
  if (scene.rayCast.mode == scene::RenderMode::Iso) include(scene.rayCast.isoValue);
  // Nothing of the table is spent on values that the data does not have.
  if (scene.volume.data) {
    glm::dvec2 range = scene.volume.data->range;
    double margin = 0.01 * (range.y - range.x);
    if (low < range.x - margin && high > range.x) low = range.x - margin;
    if (high > range.y + margin && low < range.y) high = range.y + margin;
  }
  return {low, high > low ? high : low + 1.0};
}

double below(double value) { return std::nextafter(value, -std::numeric_limits<double>::infinity()); }

/// Colour and extinction between each two table positions.
std::vector<glm::dvec4> entriesOf(const scene::TransferFunction& transfer, TransferTable& table) {
  constexpr int n = shared::kTransferSize;
  auto materialAt = [&](double value) {
    double sigma = extinction(scene::opacityAt(transfer.opacities, value), transfer.unitDistance);
    return glm::dvec4(scene::colorAt(transfer.colors, value) * sigma, sigma);
  };
  double low = table.domain.x, first = low;
  const double high = table.domain.y;
  bool isStep = scene::opacityAt(transfer.opacities, first) != scene::opacityAt(transfer.opacities, below(first));
  double firstAt = isStep ? kStepAt : kRampAt;
  low -= (high - low) * firstAt / (n - 1 - firstAt);
  table.domain.x = low;
  std::vector<glm::dvec4> entries{materialAt(below(first))};
  glm::dvec4 before = materialAt(first);
  for (int i = 2; i <= n; ++i) {
    double value = low + std::min(1.0, double(i) / (n - 1)) * (high - low);
    glm::dvec4 here = materialAt(value);
    entries.push_back(0.5 * (before + here));
    before = here;
  }
  return entries;
}

/// The same of volumes whose channels are mixed.
std::vector<glm::dvec4> mixedEntries(double largest) {
  constexpr int n = shared::kTransferSize;
  std::vector<glm::dvec4> entries;
  double before = 0.0;
  for (int i = 1; i <= n; ++i) {
    double here = mixedExtinction(std::min(1.0, double(i) / (n - 1)), largest);
    entries.emplace_back(0.5 * (before + here));
    before = here;
  }
  return entries;
}

/// Their sums over the table: the difference of two sums is an exact integral.
void sumUp(const std::vector<glm::dvec4>& entries, TransferTable& table) {
  constexpr int n = shared::kTransferSize;
  double total = 0.0;
  for (const auto& entry : entries) total += entry.w;
  // Fixed point: the whole sum is half of what 32 bits hold, and material that is there at all counts at least one.
  table.extinctionUnit = std::max(total, 1e-300) / 2147483648.0;
  glm::uvec4 sum(0);
  table.sums.push_back(sum);
  for (const auto& entry : entries) {
    glm::dvec4 units = glm::floor(entry / table.extinctionUnit + 0.5);
    if (entry.w > 0) units.w = std::max(units.w, 1.0);
    sum += glm::uvec4(units);
    table.sums.push_back(sum);
  }
  for (const auto& s : table.sums) table.extinctionSums.push_back(s.w);
  // Between which positions anything shows.
  table.shownFrom = n;
  for (int i = 0; i < n; ++i) {
    if (table.extinctionSums[std::size_t(i)] == table.extinctionSums[std::size_t(i) + 1]) continue;
    table.shownFrom = std::min(table.shownFrom, i);
    table.shownTo = i + 1;
  }
}

}  // namespace

TransferTable makeTransferTable(const scene::Scene& scene) {
  constexpr int n = shared::kTransferSize;
  const auto& transfer = scene.volume.transfer;
  TransferTable table;
  if (scene::mixesChannels(scene.volume)) {
    MixTable mix = makeMixTable(scene.volume);
    if (mix.largestExtinction > 0) table.mixedWhite = std::sqrt(mix.largestOfOne / mix.largestExtinction);
    sumUp(mixedEntries(mix.largestExtinction), table);
    table.gradientFactors.assign(n, 1.0f);
    return table;
  }
  table.domain = spannedValues(scene);
  sumUp(entriesOf(transfer, table), table);
  if (!transfer.gradientOpacities.empty()) table.gradientMax = std::max(1e-12, transfer.gradientOpacities.back().value);
  // The factor by gradient magnitude.
  for (int i = 0; i < n; ++i)
    table.gradientFactors.push_back(
        transfer.gradientOpacities.empty()
            ? 1.0f
            : float(scene::opacityAt(transfer.gradientOpacities, double(i) / (n - 1) * table.gradientMax)));
  return table;
}

}  // namespace velum::render
