#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "render/Counts.h"
#include "scene/Scene.h"
#include "session/model/TypeDials.h"
#include "session/model/TypesAt.h"

/// What a TargetSolver holds of each of its targets.
namespace velum::session::detail {

using Count = std::uint64_t;

/// The dials of a goal in cuts whose numbers are one.
struct Tier {
  std::vector<int> cuts;
  std::vector<TypeDial> dials;            ///< with the candidates in the order in which they begin to stay
  std::vector<std::vector<bool>> showed;  ///< whether each candidate showed when it was last drawn
  Count all = 0;                          ///< how many candidates there are
};

/// A target, and what pictures have told about it.
struct Goal {
  TypesAt place;
  std::optional<Count> rendered, visible;
  TypeNumbers own;  ///< the types that no target further down in the tree has
  DialField field = DialField::Share;
  std::vector<Tier> tiers;  ///< of what shows: those first whose candidates begin to stay first
  Count staying = 0;        ///< how many of the candidates are to stay, all tiers together
  Count all = 0;            ///< how many candidates there are
  // Where a goal is alone: numbers of staying candidates with which too few, and too many, instances showed.
  std::optional<Count> tooFew, tooMany;
};

/// A picture's numbers of a goal.
struct Reached {
  Count rendered = 0;
  std::optional<Count> visible;
};

/// @param dials  their candidates are put in order here
Tier makeTier(std::vector<int> cuts, std::vector<TypeDial> dials);

/// Calls visit(tier, how many of its candidates stay) for all tiers of a goal, of whose candidates so many are to stay.
template <class Visit>
void forTiers(const Goal& goal, Count staying, Visit&& visit) {
  for (const Tier& tier : goal.tiers) {
    Count here = std::min(staying, tier.all);
    visit(tier, here);
    staying -= here;
  }
}

/// How many of a goal's types stay at least and at most, over all numbers of its dials.
Count leastOf(const Goal& goal);
Count mostOf(const Goal& goal);

/// How many instances types have, in all copies.
Count totalOf(const scene::Scene& scene, const TypeNumbers& types);
Reached reachedIn(const scene::Scene& scene, const TypeNumbers& types, const render::InstanceBits& bits);

/// The least number of candidates that must stay so that `wanted` of them show, by what is known of each candidate.
Count stayingFor(const Goal& goal, std::int64_t wanted);

}  // namespace velum::session::detail
