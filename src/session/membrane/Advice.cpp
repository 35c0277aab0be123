#include "velum/session/membrane/Advice.h"

#include <algorithm>
#include <map>
#include <vector>

#include "CoarseLook.h"
#include "velum/core/Volume.h"
#include "velum/session/membrane/MembraneEdit.h"

namespace velum::session {

namespace {

/// A step has to bring the share that is cut down to so much of what it was.
constexpr double kHelps = 0.8;
/// Where so much of the data is protected, that is what is wrong: in front of all of it a sheet removes nothing.
constexpr double kTooMuch = 0.4;

double shareOf(const CoarseLook& look, const scene::Cut& cut, Progress& progress) {
  CoarseLook::Pairs pairs = look.pairsOf(cut, progress);
  return pairs.plane > 0.0 ? pairs.sheet / pairs.plane : 1.0;
}

/// Without the structure that takes up most room; nothing where it is the only one.
std::optional<scene::Membrane> withoutLargest(scene::Membrane membrane, const membrane::Potential& potential,
                                              const CoarseLook& look) {
  const Shared<LabelVolume>& labels = potential.labels();
  if (!labels || membrane.field.byLabel.size() < 2) return std::nullopt;
  std::map<int, int> voxels;
  for (const auto& one : membrane.field.byLabel) voxels[one.id] = 0;
  glm::dmat4 labelFromVoxel = glm::inverse(labels->worldFromVoxel()) * potential.worldFromVoxel();
  look.forEachProtected([&](glm::ivec3 voxel, glm::dvec3) {
    glm::ivec3 at(glm::round(glm::dvec3(labelFromVoxel * glm::dvec4(voxel, 1.0))));
    if (auto found = voxels.find(labels->at(at)); found != voxels.end()) ++found->second;
  });
  auto largest = std::max_element(voxels.begin(), voxels.end(), [](auto& a, auto& b) { return a.second < b.second; });
  protectStructure(membrane, largest->first, 0.0);
  return membrane;
}

/// The half of the protected values that lies farther from what most of the data has.
std::optional<scene::Membrane> withHalfTheValues(scene::Membrane membrane, const scene::Scene& scene,
                                                 const CoarseLook& look) {
  if (!scene.volume.data || membrane.field.byValue.empty()) return std::nullopt;
  const Volume& volume = *scene.volume.data;
  std::vector<double> values;
  look.forEachProtected([&](glm::ivec3 voxel, glm::dvec3) { values.push_back(valueAt(volume, voxel)); });
  if (values.size() < 2) return std::nullopt;
  std::sort(values.begin(), values.end());
  double middle = values[values.size() / 2], low = values.front(), high = values.back();
  bool keepsBright = volume.range.y - high < low - volume.range.x;
  keepsBright ? protectValues(membrane, std::min(low, volume.range.x), middle, 0.0)
              : protectValues(membrane, middle, std::max(high, volume.range.y), 0.0);
  return membrane;
}

}  // namespace

std::string_view reasonOf(AdviceStep step) {
  switch (step) {
    case AdviceStep::DeepenReach:
      return "The reach is short.";
    case AdviceStep::MoveInFront:
      return "The frame goes through solid material.";
    case AdviceStep::ProtectLess:
      return "Too much is protected.";
  }
  return {};
}

std::optional<Advice> adviseMembrane(const membrane::Potential& potential, const scene::Scene& scene,
                                     const scene::Cut& cut, Progress& progress) {
  if (!scene::hasData(scene)) return std::nullopt;
  CoarseLook look(potential, cut.membrane->field, progress);
  double now = shareOf(look, cut, progress);
  std::vector<Advice> steps;
  scene::Cut deeper = cut;
  deeper.size.z *= 2.0;
  steps.push_back({AdviceStep::DeepenReach, deeper, shareOf(look, deeper, progress)});
  if (auto place = firstPlaceOf(look, cut, progress)) {
    scene::Cut moved = cut;
    moved.centre = *place;
    steps.push_back({AdviceStep::MoveInFront, moved, shareOf(look, moved, progress)});
  }
  auto less = withoutLargest(*cut.membrane, potential, look);
  if (!less) less = withHalfTheValues(*cut.membrane, scene, look);
  if (less) {
    scene::Cut spared = cut;
    spared.membrane = *less;
    steps.push_back({AdviceStep::ProtectLess, spared, shareOf({potential, less->field, progress}, spared, progress)});
  }
  bool isTooMuch = look.share() > kTooMuch && less && steps.back().cutShare <= kHelps * now;
  if (isTooMuch) return steps.back();
  auto best = std::min_element(steps.begin(), steps.end(), [](auto& a, auto& b) { return a.cutShare < b.cutShare; });
  if (best->cutShare > kHelps * now) return std::nullopt;
  return *best;
}

}  // namespace velum::session
