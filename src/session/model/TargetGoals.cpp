#include "session/model/TargetGoals.h"

#include <algorithm>

#include "scene/Shown.h"

namespace velum::session::detail {

Tier makeTier(std::vector<int> cuts, std::vector<TypeDial> dials) {
  Tier tier{std::move(cuts), std::move(dials), {}, 0};
  for (TypeDial& dial : tier.dials) {
    std::sort(dial.candidates.begin(), dial.candidates.end(), [](const Candidate& a, const Candidate& b) {
      return a.from != b.from ? a.from < b.from : a.thing < b.thing;
    });
    tier.showed.emplace_back(dial.candidates.size(), false);
    tier.all += dial.candidates.size();
  }
  return tier;
}

Count leastOf(const Goal& goal) { return goal.tiers.empty() ? 0 : rangeOf(goal.tiers.front().dials).least; }
Count mostOf(const Goal& goal) { return goal.tiers.empty() ? 0 : rangeOf(goal.tiers.back().dials).most; }

Count totalOf(const scene::Scene& scene, const TypeNumbers& types) {
  Count total = 0;
  for (std::uint32_t type : types)
    total += Count(scene.model.data->types[type].instanceCount) * Count(scene::copyCount(scene.model));
  return total;
}

namespace {

/// Calls visit(instance) for all of some types.
template <class Visit>
void forInstancesOf(const scene::ModelLayer& layer, const TypeNumbers& types, Visit&& visit) {
  for (std::size_t copy = 0; copy < std::size_t(scene::copyCount(layer)); ++copy)
    for (std::uint32_t type : types) {
      std::size_t first = copy * layer.data->instances.size() + layer.data->types[type].firstInstance;
      for (std::size_t i = first; i < first + layer.data->types[type].instanceCount; ++i) visit(i);
    }
}

}  // namespace

Reached reachedIn(const scene::Scene& scene, const TypeNumbers& types, const render::InstanceBits& bits) {
  Count rendered = 0, visible = 0;
  forInstancesOf(scene.model, types, [&](std::size_t i) {
    rendered += !bits.isRemoved(i);
    visible += bits.isShown(i);
  });
  return {rendered, visible};
}

Count stayingFor(const Goal& goal, std::int64_t wanted) {
  if (wanted <= 0) return 0;
  std::vector<std::vector<std::vector<Count>>> showing;  // of the first so many of each dial of each tier
  for (const Tier& tier : goal.tiers) {
    auto& ofTier = showing.emplace_back();
    for (const std::vector<bool>& showed : tier.showed) {
      std::vector<Count>& sums = ofTier.emplace_back(1, 0);
      for (bool shows : showed) sums.push_back(sums.back() + shows);
    }
  }
  auto show = [&](Count staying) {
    Count sum = 0;
    std::size_t at = 0;
    forTiers(goal, staying, [&](const Tier& tier, Count here) {
      std::vector<Count> parts = splitAmong(tier.dials, here);
      for (std::size_t i = 0; i < parts.size(); ++i) sum += showing[at][i][parts[i]];
      ++at;
    });
    return sum;
  };
  Count low = 0, high = goal.all;
  while (low < high) {
    Count middle = (low + high) / 2;
    if (show(middle) >= Count(wanted))
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace velum::session::detail
