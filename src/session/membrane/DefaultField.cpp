#include "session/membrane/DefaultField.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/Scene.h"
#include "scene/Shown.h"
#include "session/look/ValueHistogram.h"
#include "session/membrane/MembraneEdit.h"
#include "session/structure/StructureSizes.h"

namespace velum::session {

namespace {

/// Of what protects most of the data a sheet can keep nothing whole. Tried on head, chest and abdomen, angiograms and
/// phantoms: bones are 4 to 8 % of a body's voxels, vessels 1 to 3 %.
constexpr double kLargestShare = 0.12;
/// Of labelled voxels, in structures taken from the smallest on.
constexpr double kLargestLabelledShare = 0.35;

/// How much of the data each bin holds, and how opaque it is shown.
struct Bin {
  double value = 0, share = 0, opacity = 0;
};

std::vector<Bin> binsOf(const scene::VolumeLayer& layer) {
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer), timeStep = scene::shownTimeStep(layer);
  Histogram histogram = valueHistogram(volume, channel, timeStep);
  const scene::TransferFunction& transfer = scene::currentTransfer(layer);
  double total = 0;
  for (auto count : histogram.counts) total += double(count);
  std::vector<Bin> bins(histogram.counts.size());
  double width = (histogram.range.y - histogram.range.x) / double(std::max<std::size_t>(bins.size(), 1));
  for (std::size_t i = 0; i < bins.size(); ++i) {
    double value = histogram.range.x + (double(i) + 0.5) * width;
    bins[i] = {value, double(histogram.counts[i]) / std::max(total, 1.0), scene::opacityAt(transfer.opacities, value)};
  }
  return bins;
}

/// The lowest opacity above which there is a small part of the data; nothing where even the most opaque is too much.
double opacityFrom(const std::vector<Bin>& bins) {
  std::map<double, double, std::greater<>> shares;
  for (const auto& bin : bins)
    if (bin.share > 0 && bin.opacity > 0) shares[bin.opacity] += bin.share;
  if (shares.empty()) return 0.0;
  double most = shares.begin()->first, sum = 0, from = 2.0;
  for (auto [opacity, share] : shares) {
    sum += share;
    if (sum > kLargestShare || opacity < 0.5 * most) break;
    from = opacity;
  }
  return from;
}

/// A trapezoid over the values from one to another.
void protect(std::vector<scene::StrengthPoint>& curve, double low, double high, double ramp) {
  curve.push_back({low - ramp, 0.0});
  curve.push_back({low, kProtectStrength});
  curve.push_back({high, kProtectStrength});
  curve.push_back({high + ramp, 0.0});
}

/// The brightest part of the data, where the opacity tells nothing apart.
void protectBrightest(scene::ForceField& field, const std::vector<Bin>& bins) {
  double sum = 0;
  std::size_t first = bins.size();
  while (first > 1 && sum + bins[first - 1].share <= 0.5 * kLargestShare) sum += bins[--first].share;
  if (first == bins.size()) --first;
  double half = bins.size() > 1 ? 0.5 * (bins[1].value - bins[0].value) : 0.5;
  protect(field.byValue, bins[first].value - half, bins.back().value + 2.0 * half, 0.0);
}

void protectOpaque(scene::ForceField& field, const scene::VolumeLayer& layer) {
  std::vector<Bin> bins = binsOf(layer);
  if (bins.empty()) return;
  double from = opacityFrom(bins), width = bins.size() > 1 ? bins[1].value - bins[0].value : 1.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    if (!(from > 0) || bins[i].opacity < from) continue;
    std::size_t first = i;
    while (i + 1 < bins.size() && bins[i + 1].opacity >= from) ++i;
    // A curve ends below its last value; the data's largest one belongs to it.
    double beyond = i + 1 == bins.size() ? width : 0.5 * width;
    protect(field.byValue, bins[first].value - 0.5 * width, bins[i].value + beyond, 0.0);
  }
  if (field.byValue.empty()) protectBrightest(field, bins);
}

void protectStructures(scene::ForceField& field, const scene::LabelLayer& labels) {
  Progress progress;
  auto sizes = measureStructures(*labels.data, progress);
  double total = 0;
  std::vector<std::pair<double, int>> shown;
  for (const auto& structure : labels.structures) {
    auto found = sizes.find(structure.id);
    if (found == sizes.end()) continue;
    total += double(found->second.voxels);
    if (structure.visible && structure.opacity > 0.2) shown.emplace_back(double(found->second.voxels), structure.id);
  }
  std::sort(shown.begin(), shown.end());
  double sum = 0;
  for (auto [voxels, id] : shown) {
    sum += voxels;
    if (sum > kLargestLabelledShare * total && !field.byLabel.empty()) break;
    field.byLabel.push_back({id, kProtectStrength});
  }
  std::sort(field.byLabel.begin(), field.byLabel.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
}

/// Compartments from the one with the least mass on: the capsid rather than the plasma around it.
void protectCompartments(scene::ForceField& field, const Model& model) {
  std::map<std::uint32_t, double> masses;
  double total = 0, sum = 0;
  for (const MoleculeType& type : model.types) {
    double mass = type.mass * type.instanceCount;
    masses[type.compartment] += mass;
    total += mass;
  }
  std::vector<std::pair<double, std::uint32_t>> ordered;
  for (auto [compartment, mass] : masses) ordered.emplace_back(mass, compartment);
  std::sort(ordered.begin(), ordered.end());
  for (auto [mass, compartment] : ordered) {
    sum += mass;
    if (sum > kLargestLabelledShare * total && !field.byType.empty()) break;
    for (const MoleculeType& type : model.types)
      if (type.compartment == compartment) field.byType.push_back({pathOf(model, type), kProtectStrength});
  }
}

}  // namespace

scene::ForceField defaultField(const scene::Scene& scene) {
  scene::ForceField field;
  bool isModelAlone = scene.model.data && !scene.volume.data && !scene.labels.data;
  if (isModelAlone) protectCompartments(field, *scene.model.data);
  if (scene.labels.data && scene.labels.visible) protectStructures(field, scene.labels);
  if (field.byLabel.empty() && scene.volume.data) protectOpaque(field, scene.volume);
  return field;
}

}  // namespace velum::session
