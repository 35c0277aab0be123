#include "session/membrane/MembraneEdit.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/Error.h"
#include "membrane/forces/Kernels.h"
#include "scene/Shown.h"
#include "session/membrane/TissueInNoise.h"

#include "scene/Scene.h"
#include "session/look/ValueHistogram.h"
#include "session/model/ModelScale.h"

namespace velum::session {

namespace {

using Curve = std::vector<scene::StrengthPoint>;

constexpr double kSpreads = 3.0;  ///< of noise to either side of a tissue's middle
constexpr double kEnd = 0.1;      ///< share of the data beyond which there is nothing else worth telling apart

/// The curve with a stretch of one strength, its ends as steep as can be.
Curve withStretch(const Curve& old, double low, double high, double strength) {
  Curve out;
  double before = membrane::strengthAt(old, std::nextafter(low, -1e300));
  double after = membrane::strengthAt(old, std::nextafter(high, 1e300));
  for (const auto& point : old)
    if (point.value < low) out.push_back(point);
  if (!out.empty()) out.push_back({low, before});
  out.push_back({low, strength});
  out.push_back({high, strength});
  bool goesOn = std::any_of(old.begin(), old.end(), [&](const auto& p) { return p.value > high; });
  if (goesOn) out.push_back({high, after});
  for (const auto& point : old)
    if (point.value > high) out.push_back(point);
  return out;
}

struct ValueRange {
  double low, high;
};

/// What is protected with a material: as far as its noise goes, but not beyond halfway to what is beside it; at an end
/// of the data's values all that is brighter, or darker, too. Less than materialRangeAt(), which takes what hangs
/// together only.
ValueRange valuesOf(const Tissue& tissue, const scene::VolumeLayer& layer) {
  double low = tissue.value - kSpreads * tissue.spread, high = tissue.value + kSpreads * tissue.spread;
  const Volume& volume = *layer.data;
  int channel = scene::shownChannel(layer);
  Histogram histogram = valueHistogram(volume, channel, scene::shownTimeStep(layer));
  // At an end of the data's values thin and blurred parts count too, as far as halfway to what is beside.
  if (tissue.value > quantile(histogram, 1.0 - kEnd)) {
    high = volume.range.y;
    low = tissue.low.value_or(low);
  } else if (tissue.value < quantile(histogram, kEnd)) {
    low = volume.range.x;
    high = tissue.high.value_or(high);
  } else {
    low = std::max(low, tissue.low.value_or(low));
    high = std::min(high, tissue.high.value_or(high));
  }
  return {low, high};
}

}  // namespace

void protectValues(scene::Membrane& membrane, double low, double high, double strength) {
  if (!(low < high)) return;
  membrane.field.byValue = withStretch(membrane.field.byValue, low, high, strength);
}

std::optional<Tissue> protectTissue(scene::Membrane& membrane, const scene::VolumeLayer& layer, glm::dvec3 world,
                                    double strength) {
  std::optional<Tissue> tissue = measureTissue(layer, world);
  if (!tissue) return tissue;
  if (auto inNoise = measureTissueInNoise(layer, world)) {
    tissue = inNoise;
    membrane.field.denoise = true;
  }
  auto [low, high] = valuesOf(*tissue, layer);
  protectValues(membrane, low, high, strength);
  return tissue;
}

void setRule(scene::Membrane& membrane, scene::KernelRule rule) {
  if (membrane.field.rule == rule) return;
  membrane.field.rule = rule;
  const scene::Cloth loose;
  auto& cloth = membrane.cloth;
  bool isPaper = rule == scene::KernelRule::Paper;
  cloth.stretch = isPaper ? 0.8 : loose.stretch;
  cloth.restoring = isPaper ? 20.0 : loose.restoring;
  cloth.damping = isPaper ? 6.0 : loose.damping;
}

void protectStructure(scene::Membrane& membrane, int id, double strength) {
  if (id <= 0) return;
  auto& list = membrane.field.byLabel;
  auto found = std::find_if(list.begin(), list.end(), [&](const auto& one) { return one.id == id; });
  if (found != list.end()) list.erase(found);
  if (strength != 0.0) list.push_back({id, strength});
}

void protectType(scene::Membrane& membrane, const std::string& path, double strength) {
  auto& list = membrane.field.byType;
  std::erase_if(list, [&](const auto& one) { return one.path == path; });
  // A compartment may have given it another strength.
  if (scene::strengthOf(membrane.field, path) != strength) list.push_back({path, strength});
}

std::vector<Protectable> protectables(const scene::Scene& scene, const scene::ForceField& field) {
  std::vector<Protectable> rows;
  for (const scene::Structure& structure : scene.labels.structures) {
    Protectable& row = rows.emplace_back();
    row.structure = structure.id;
    row.name = structure.name;
    row.color = structure.color;
    auto own = [&](const auto& one) { return one.id == structure.id; };
    auto found = std::find_if(field.byLabel.begin(), field.byLabel.end(), own);
    if (found != field.byLabel.end()) row.strength = found->strength;
  }
  if (!scene.model.data) return rows;
  const Model& model = *scene.model.data;
  std::vector<glm::vec3> colors = scene::typeColors(scene.model);
  for (std::size_t t = 0; t < model.types.size(); ++t) {
    Protectable& row = rows.emplace_back();
    row.type = pathOf(model, model.types[t]);
    row.name = scene::shownName(scene.model, row.type, model.types[t].name);
    row.color = colors[t];
    row.strength = scene::strengthOf(field, row.type);
  }
  return rows;
}

std::vector<std::string> protectableTypes(const Model& model, std::string_view path) {
  std::vector<std::string> paths;
  // Whole names between dots: "caps" is no part of "capsid".
  std::string wanted = "." + std::string(path) + ".";
  for (const MoleculeType& type : model.types) {
    std::string own = pathOf(model, type);
    if (!path.empty() && ("." + own + ".").find(wanted) != std::string::npos) paths.push_back(std::move(own));
  }
  return paths;
}

void expectModelInReach(const scene::Scene& scene) {
  if (!scene.model.data) throw ArgumentError("there is no model whose types a membrane could go around");
  if (isOutOfScale(scene) || !membrane::Potential(scene).holdsModel())
    throw ArgumentError(
        "the model is of another scale than the data beside it, by whose grid sheets go; bring it to size first "
        "(model.bringToSize)");
}

}  // namespace velum::session
