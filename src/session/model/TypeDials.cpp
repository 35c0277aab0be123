#include "session/model/TypeDials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "core/Parallel.h"
#include "core/Text.h"
#include "render/kept/KeptInstances.h"
#include "render/kept/StayingShares.h"
#include "scene/Shown.h"
#include "session/cut/CutEdit.h"
#include "session/model/TypesAt.h"

namespace velum::session {

namespace {

bool isAmong(const std::vector<int>& cuts, const scene::Cut& cut) {
  return cut.enabled && std::find(cuts.begin(), cuts.end(), cut.id) != cuts.end();
}

/// True where `to` is the path itself, or the path of something below it.
bool leadsTo(std::string_view path, std::string_view to) {
  return to.starts_with(path) && (to.size() == path.size() || to[path.size()] == '.');
}

/// Calls visit(instance over all copies) for the instances of a type, copy by copy.
template <class Visit>
void forInstances(const scene::ModelLayer& layer, std::uint32_t type, Visit&& visit) {
  const MoleculeType& of = layer.data->types[type];
  for (std::size_t copy = 0; copy < std::size_t(scene::copyCount(layer)); ++copy)
    for (std::size_t i = 0; i < of.instanceCount; ++i)
      visit(std::uint32_t(copy * layer.data->instances.size() + of.firstInstance + i));
}

void addShareCandidates(TypeDial& dial, const scene::Scene& scene, std::uint32_t type, const std::vector<float>& shares,
                        const std::vector<render::InstanceState>& states) {
  std::size_t at = 0;
  forInstances(scene.model, type, [&](std::uint32_t instance) {
    float from = shares[at++];
    if (from == render::kStaysNever) return;
    if (!states.empty() && states[instance] == render::InstanceState::Cleared) return;
    if (from == render::kStaysAlways)
      ++dial.always;
    else
      dial.candidates.push_back({from, instance});
  });
}

void addViewCandidates(TypeDial& dial, const scene::Scene& scene, std::uint32_t type,
                       const std::vector<render::InstanceState>& closed,
                       const std::vector<render::InstanceState>& open) {
  forInstances(scene.model, type, [&](std::uint32_t instance) {
    if (closed[instance] == render::InstanceState::Kept)
      ++dial.always;
    else if (open[instance] == render::InstanceState::Kept)
      dial.candidates.push_back({randomOf(instance, 1), instance});
  });
}

/// A number between two floats, with as few digits as keep it off both of them: floats between them tell them apart.
double numberBetween(float below, float above) {
  double width = double(above) - below, middle = below + 0.5 * width;
  for (double steps = 100.0; steps < 1e8; steps *= 10.0) {
    double rounded = std::round(middle * steps) / steps;
    bool isOff = std::abs(rounded - middle) <= 0.25 * width;
    if (isOff && float(rounded) > below && float(rounded) <= above) return rounded;
  }
  return float(middle) > below ? double(float(middle)) : double(above);
}

}  // namespace

bool hasFocus(const scene::Scene& scene) {
  return std::ranges::any_of(scene::enabledOf(scene.cuts),
                             [](const scene::Cut& cut) { return cut.model.focus && !cut.model.focus->types.empty(); });
}

bool isCleared(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types) {
  const Model& model = *scene.model.data;
  return std::any_of(scene.cuts.begin(), scene.cuts.end(), [&](const scene::Cut& cut) {
    if (!isAmong(cuts, cut) || !cut.model.focus || cut.model.focus->types.empty()) return false;
    return std::none_of(types.begin(), types.end(), [&](std::uint32_t type) {
      std::string path = pathOf(model, model.types[type]);
      return std::any_of(cut.model.focus->types.begin(), cut.model.focus->types.end(),
                         [&](const scene::FocusType& focus) { return leadsTo(focus.type, path); });
    });
  });
}

std::vector<TypeDial> makeDials(const scene::Scene& scene, const std::vector<int>& cuts, const TypeNumbers& types,
                                DialField field, const render::SheetIndices& sheets, double aspect) {
  const Model& model = *scene.model.data;
  std::vector<bool> shown = visibleTypes(scene.model);
  // The scene with the numbers of all paths at their ends, 0 and 1.
  scene::Scene closed = scene, open = scene;
  for (std::uint32_t type : types) {
    std::string path = pathOf(model, model.types[type]);
    if (field == DialField::ViewShare) setDial(closed, cuts, path, field, 0.0);
    setDial(open, cuts, path, field, 1.0);
  }
  std::vector<render::InstanceState> openStates, closedStates;
  if (field == DialField::ViewShare) closedStates = render::instanceStates(closed, sheets, aspect, types);
  if (field == DialField::ViewShare || hasFocus(scene))
    openStates = render::instanceStates(open, sheets, aspect, types);
  std::vector<std::vector<float>> shares;
  if (field == DialField::Share) shares = render::stayingShares(open, cuts, types, sheets);
  std::vector<std::uint8_t> kept = render::keptInstances(scene, sheets, aspect, types);
  std::vector<TypeDial> dials;
  std::unordered_map<std::string, std::size_t> places;
  std::vector<std::vector<std::size_t>> rows;  // of the types of each dial
  for (std::size_t i = 0; i < types.size(); ++i) {
    std::uint32_t type = types[i];
    std::string path = pathOf(model, model.types[type]);
    auto [place, isNew] = places.try_emplace(path, dials.size());
    if (isNew) dials.push_back({{}, path, {}}), rows.emplace_back();
    TypeDial& dial = dials[place->second];
    dial.types.push_back(type);
    dial.total += std::uint64_t(model.types[type].instanceCount) * std::uint64_t(scene::copyCount(scene.model));
    rows[place->second].push_back(i);
  }
  parallelFor(std::size_t(0), dials.size(), [&](std::size_t d) {
    dials[d].candidates.reserve(std::size_t(dials[d].total));
    for (std::size_t i : rows[d]) {
      if (!shown[types[i]] || !scene.model.visible) continue;
      if (field == DialField::Share)
        addShareCandidates(dials[d], scene, types[i], shares[i], openStates);
      else
        addViewCandidates(dials[d], scene, types[i], closedStates, openStates);
    }
    for (const Candidate& candidate : dials[d].candidates) dials[d].now += kept[candidate.thing];
  });
  return dials;
}

CountRange rangeOf(const std::vector<TypeDial>& dials) {
  CountRange range;
  for (const TypeDial& dial : dials) range += dial;
  return range;
}

std::vector<std::uint64_t> splitAmong(const std::vector<TypeDial>& dials, std::uint64_t count) {
  std::vector<std::uint64_t> staying, going;
  for (const TypeDial& dial : dials) {
    staying.push_back(std::min<std::uint64_t>(dial.now, dial.candidates.size()));
    going.push_back(dial.candidates.size() - staying.back());
  }
  std::uint64_t now = std::accumulate(staying.begin(), staying.end(), std::uint64_t(0));
  if (count <= now) return apportion(staying, count);
  std::vector<std::uint64_t> more = apportion(going, count - now);
  for (std::size_t i = 0; i < more.size(); ++i) more[i] += staying[i];
  return more;
}

DialSetting settingFor(const Dial& dial, std::uint64_t staying) {
  DialGap gap = gapFor(dial, staying);
  if (gap.staying == 0) return {0.0, 0};
  return {gap.staying == dial.candidates.size() ? 1.0 : numberBetween(gap.last, gap.next), gap.staying};
}

void setDial(scene::Scene& scene, const std::vector<int>& cuts, const std::string& path, DialField field,
             double number) {
  for (scene::Cut& cut : scene.cuts) {
    if (!isAmong(cuts, cut)) continue;
    scene::TypeSpare& spare = ownTypeSpare(cut, path);
    (field == DialField::Share ? spare.share : spare.viewShare) = number;
  }
}

namespace {

/// Finds by trying the number of a path at which `staying` of its candidates stay: where rounding lets the drawing
/// disagree with the shares that were worked out.
void searchNumber(scene::Scene& scene, const std::vector<int>& cuts, const TypeDial& dial, DialField field,
                  std::uint64_t staying, const render::SheetIndices& sheets, double aspect) {
  auto distance = [&](std::uint64_t count) {
    std::uint64_t wanted = dial.always + staying;
    return count > wanted ? count - wanted : wanted - count;
  };
  std::uint64_t low = 0, high = dial.candidates.size(), least = ~std::uint64_t(0);
  double best = 0.0;
  while (low <= high && least > 0) {
    std::uint64_t middle = (low + high) / 2;
    double number = settingFor(dial, middle).number;
    setDial(scene, cuts, dial.path, field, number);
    std::uint64_t count = countRendered(scene, dial.types, sheets, aspect);
    if (distance(count) < least) least = distance(count), best = number;
    if (count < dial.always + staying)
      low = middle + 1;
    else if (middle == 0)
      break;
    else
      high = middle - 1;
  }
  setDial(scene, cuts, dial.path, field, best);
}

/// Rendered instances by dial.
std::vector<std::uint64_t> countDials(const scene::Scene& scene, const std::vector<TypeDial>& dials,
                                      const render::SheetIndices& sheets, double aspect) {
  TypeNumbers types;
  for (const TypeDial& dial : dials) types.insert(types.end(), dial.types.begin(), dial.types.end());
  std::vector<std::uint8_t> kept = render::keptInstances(scene, sheets, aspect, types);
  std::vector<bool> shown = visibleTypes(scene.model);
  std::vector<std::uint64_t> counts(dials.size(), 0);
  parallelFor(std::size_t(0), dials.size(), [&](std::size_t i) {
    std::uint64_t count = 0;
    for (std::uint32_t type : dials[i].types)
      if (shown[type] && scene.model.visible)
        forInstances(scene.model, type, [&](std::uint32_t instance) { count += kept[instance]; });
    counts[i] = count;
  });
  return counts;
}

constexpr int kMostRounds = 4;

std::uint64_t distanceOf(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : b - a; }

/// Where a cut keeps something in view, the dials change each other's counts: fewer instances of a focus clear less.
/// Every dial is asked for as many more as it lacks, a few times; the best round stands. @return the counts of that
/// round
std::vector<std::uint64_t> turnTogether(scene::Scene& scene, const std::vector<int>& cuts,
                                        const std::vector<TypeDial>& dials, DialField field,
                                        const std::vector<DialSetting>& settings, std::vector<std::uint64_t> counts,
                                        const render::SheetIndices& sheets, double aspect) {
  std::vector<std::uint64_t> asked, best = counts;
  for (const DialSetting& setting : settings) asked.push_back(setting.staying);
  scene::Scene bestScene = scene;
  auto offOf = [&](const std::vector<std::uint64_t>& of) {
    std::uint64_t off = 0;
    for (std::size_t i = 0; i < dials.size(); ++i) off += distanceOf(of[i], dials[i].always + settings[i].staying);
    return off;
  };
  for (int round = 0; round < kMostRounds && offOf(best) > 0; ++round) {
    for (std::size_t i = 0; i < dials.size(); ++i) {
      std::uint64_t wanted = dials[i].always + settings[i].staying;
      if (counts[i] == wanted) continue;
      auto more = std::int64_t(asked[i]) + std::int64_t(wanted) - std::int64_t(counts[i]);
      asked[i] = std::uint64_t(std::clamp<std::int64_t>(more, 0, std::int64_t(dials[i].candidates.size())));
      setDial(scene, cuts, dials[i].path, field, settingFor(dials[i], asked[i]).number);
    }
    counts = countDials(scene, dials, sheets, aspect);
    if (offOf(counts) < offOf(best)) best = counts, bestScene = scene;
  }
  scene = std::move(bestScene);
  return best;
}

}  // namespace

std::uint64_t countRendered(const scene::Scene& scene, const TypeNumbers& types, const render::SheetIndices& sheets,
                            double aspect) {
  return countDials(scene, {TypeDial{{}, {}, types}}, sheets, aspect).front();
}

std::uint64_t turnDials(scene::Scene& scene, const std::vector<int>& cuts, const std::vector<TypeDial>& dials,
                        DialField field, std::uint64_t count, const render::SheetIndices& sheets, double aspect) {
  std::vector<std::uint64_t> parts = splitAmong(dials, count);
  std::vector<DialSetting> settings;
  std::int64_t missing = 0;
  for (std::size_t i = 0; i < dials.size(); ++i) {
    settings.push_back(settingFor(dials[i], parts[i]));
    missing += std::int64_t(parts[i]) - std::int64_t(settings[i].staying);
  }
  // What some cannot have, as several of them begin to stay at once, others take.
  for (std::size_t i = 0; i < dials.size() && missing != 0; ++i) {
    auto other = std::int64_t(settings[i].staying) + missing;
    if (other < 0 || other > std::int64_t(dials[i].candidates.size())) continue;
    if (DialSetting setting = settingFor(dials[i], std::uint64_t(other)); setting.staying == std::uint64_t(other))
      settings[i] = setting, missing = 0;
  }
  for (std::size_t i = 0; i < dials.size(); ++i) setDial(scene, cuts, dials[i].path, field, settings[i].number);
  // What is drawn decides, not what was worked out.
  std::vector<std::uint64_t> counts = countDials(scene, dials, sheets, aspect);
  if (dials.size() > 1 && hasFocus(scene)) {
    counts = turnTogether(scene, cuts, dials, field, settings, counts, sheets, aspect);
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
  }
  bool isChanged = false;
  for (std::size_t i = 0; i < dials.size(); ++i) {
    if (counts[i] == dials[i].always + settings[i].staying) continue;
    searchNumber(scene, cuts, dials[i], field, settings[i].staying, sheets, aspect);
    isChanged = true;
  }
  if (isChanged) counts = countDials(scene, dials, sheets, aspect);
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t(0));
}

}  // namespace velum::session
