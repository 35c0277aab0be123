#pragma once
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Why little is kept, and what would help.
enum class AdviceStep {
  DeepenReach,  ///< the reach is short
  MoveToKeep,   ///< the frame stands where what is protected cannot be kept
  ProtectLess   ///< too much is protected
};

/// One step that lets a membrane keep more. Its figures are those of a coarse look.
struct Advice {
  AdviceStep step = AdviceStep::DeepenReach;
  scene::Cut cut;         ///< as it would be
  membrane::Fate fate;    ///< of what is protected, then
  double cutShare = 1.0;  ///< of what its plane would cut then
};

/// Where a sheet cuts more than this of what its plane would cut, it is worth asking for advice; as it is where less
/// than kEnoughKept of what is protected stays, but where that is what was asked for.
inline constexpr double kMuchCut = 0.6;
bool wantsAdvice(const membrane::KeptWhole& figures, const scene::Cut& cut);

/// What helps, the best first: the shortest reach by which nine tenths are kept, the place along the axis (and the
/// reach) where they are, and, where too much is protected or neither helps, protecting the half that differs most from
/// the rest. A reach up to twice as deep comes before a move. Empty where nothing helps by a fifth of what is lost.
/// A few tenths of a second. @param potential  of the scene  @throw Cancelled. Any thread.
std::vector<Advice> adviseMembrane(const membrane::Potential& potential, const scene::Scene& scene,
                                   const scene::Cut& cut, Progress& progress);

/// Why, in a sentence: "The reach is short."
std::string_view reasonOf(AdviceStep step);

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::AdviceStep> {
  static constexpr std::string_view kNames[] = {"deepenReach", "moveToKeep", "protectLess"};
};
