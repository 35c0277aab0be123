#include "session/membrane/Advice.h"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "core/Volume.h"
#include "scene/Scene.h"
#include "session/membrane/CoarseLook.h"
#include "session/membrane/FirstPlace.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::session {

namespace {

/// A step helps where it brings what is lost, or cut, down to this share of what it was.
constexpr double kHelps = 0.8;
/// Where more than this share of the data is protected, just that is what is wrong: in front of all of it a sheet
/// removes nothing.
constexpr double kTooMuch = 0.4;
/// Up to so many times the reach, deepening the reach comes before moving the frame.
constexpr double kLittleDeeper = 2.01;

Advice adviceOf(AdviceStep step, const Placed& placed) {
  return {step, placed.cut, placed.outlook.fate, placed.outlook.cutShare()};
}

bool helps(const Advice& advice, const CoarseLook::Outlook& now) {
  return 1.0 - advice.fate.kept <= kHelps * (1.0 - now.fate.kept) || advice.cutShare <= kHelps * now.cutShare();
}

/// How many of the places that are protected lie in each number of a grid.
std::map<int, int> placesByNumber(const LabelVolume& grid, const membrane::Potential& potential,
                                  const CoarseLook& look) {
  std::map<int, int> places;
  glm::dmat4 gridFromVoxel = glm::inverse(grid.worldFromVoxel()) * potential.worldFromVoxel();
  look.forEachProtected([&](glm::ivec3 voxel, glm::dvec3) {
    glm::ivec3 at(glm::round(glm::dvec3(gridFromVoxel * glm::dvec4(voxel, 1.0))));
    ++places[grid.at(at)];
  });
  return places;
}

/// The membrane without the structure, or type, that takes up most room; nothing where it is the only one.
std::optional<scene::Membrane> withoutLargest(scene::Membrane membrane, const membrane::Potential& potential,
                                              const scene::Scene& scene, const CoarseLook& look, Progress& progress) {
  const scene::ForceField field = membrane.field;
  std::map<int, int> ofLabels, ofTypes;
  if (potential.labels() && !field.byLabel.empty()) ofLabels = placesByNumber(*potential.labels(), potential, look);
  if (Shared<LabelVolume> types = field.byType.empty() ? Shared<LabelVolume>() : potential.types(progress))
    ofTypes = placesByNumber(*types, potential, look);
  int most = -1, count = 0, type = 0;
  std::optional<Protectable> largest;
  for (const Protectable& one : protectables(scene, field)) {
    if (one.structure == 0) ++type;  // a model's types follow each other by their numbers
    if (one.strength == 0.0) continue;
    ++count;
    int places = one.structure ? ofLabels[one.structure] : ofTypes[type];
    if (places > most) most = places, largest = one;
  }
  if (count < 2) return std::nullopt;
  largest->structure ? protectStructure(membrane, largest->structure, 0.0) : protectType(membrane, largest->type, 0.0);
  return membrane;
}

/// The membrane with only that half of its protected values that differs more from the values of most of the data.
std::optional<scene::Membrane> withHalfTheValues(scene::Membrane membrane, const scene::Scene& scene,
                                                 const CoarseLook& look) {
  if (!scene.volume.data || membrane.field.byValue.empty()) return std::nullopt;
  const Volume& volume = *scene.volume.data;
  std::vector<double> values;
  look.forEachProtected([&](glm::ivec3 voxel, glm::dvec3) {
    values.push_back(valueAt(volume, voxel, scene.volume.channel, scene.volume.timeStep));
  });
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
    case AdviceStep::MoveToKeep:
      return "The frame stands where it cannot keep more.";
    case AdviceStep::ProtectLess:
      return "Too much is protected.";
  }
  return {};
}

bool wantsAdvice(const membrane::KeptWhole& figures, const scene::Cut& cut) {
  bool isToBeKept = cut.membrane->field.side != scene::MembraneSide::Remove && !scene::isInlay(cut);
  bool isLittle = figures.fate.isOfSomething && figures.fate.kept < kEnoughKept;
  return (isToBeKept && isLittle) || membrane::sharesOf(figures, cut).cut > kMuchCut;
}

std::vector<Advice> adviseMembrane(const membrane::Potential& potential, const scene::Scene& scene,
                                   const scene::Cut& cut, Progress& progress) {
  if (!scene::hasData(scene)) return {};
  CoarseLook look(potential, cut.membrane->field, progress);
  CoarseLook::Outlook now = look.outlookOf(cut, progress);
  std::vector<Advice> steps;
  auto less = withoutLargest(*cut.membrane, potential, scene, look, progress);
  if (!less) less = withHalfTheValues(*cut.membrane, scene, look);
  if (less) {
    Placed spared{cut, {}};
    spared.cut.membrane = *less;
    spared.outlook = CoarseLook(potential, less->field, progress).outlookOf(spared.cut, progress);
    steps.push_back(adviceOf(AdviceStep::ProtectLess, spared));
    if (look.share() > kTooMuch && steps.back().cutShare <= kHelps * now.cutShare()) return steps;
  }
  if (auto moved = placedToKeep(look, cut, progress))
    steps.insert(steps.begin(), adviceOf(AdviceStep::MoveToKeep, *moved));
  if (auto deeper = deepenedToKeep(look, cut, progress); deeper && deeper->cut.size.z > cut.size.z) {
    bool isFirst = deeper->cut.size.z <= kLittleDeeper * cut.size.z || steps.empty();
    steps.insert(steps.begin() + (isFirst ? 0 : 1), adviceOf(AdviceStep::DeepenReach, *deeper));
  }
  std::erase_if(steps, [&](const Advice& step) { return !helps(step, now); });
  bool isOtherThanLess = !steps.empty() && steps.front().step != AdviceStep::ProtectLess;
  if (isOtherThanLess) std::erase_if(steps, [](const Advice& one) { return one.step == AdviceStep::ProtectLess; });
  return steps;
}

}  // namespace velum::session
