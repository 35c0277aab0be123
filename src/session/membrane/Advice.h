#pragma once
#include <string_view>
#include <vector>

#include "core/Fields.h"
#include "core/Task.h"
#include "membrane/forces/KeptWhole.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// Why a membrane keeps little of what it protects, and which step would help.
enum class AdviceStep {
  DeepenReach,  ///< the reach is short
  MoveToKeep,   ///< the frame stands where what is protected cannot be kept
  ProtectLess   ///< too much is protected
};

/// One step that lets a membrane keep more. Its figures come from a coarse look (CoarseLook).
struct Advice {
  AdviceStep step = AdviceStep::DeepenReach;
  scene::Cut cut;         ///< the membrane's cut after the step
  membrane::Fate fate;    ///< what would become of what is protected after the step
  double cutShare = 1.0;  ///< share that the sheet would cut of what its plane would cut, after the step
};

/// A membrane is worth asking for advice where its sheet cuts more than this share of what its plane would cut, or
/// where less than kEnoughKept of what is protected stays, unless the membrane is there to remove it.
inline constexpr double kMuchCut = 0.6;
bool wantsAdvice(const membrane::KeptWhole& figures, const scene::Cut& cut);

/// What helps a membrane, the best step first: the shortest reach by which nine tenths of what is protected are kept;
/// the place along the axis (and the reach) where they are kept; and, where too much is protected or neither of these
/// helps, protecting only the half that differs most from the rest. A reach up to twice as deep comes before a move.
/// Empty where nothing helps by a fifth of what is lost.
/// A few tenths of a second. @param potential  of the scene  @throw Cancelled. Any thread.
std::vector<Advice> adviseMembrane(const membrane::Potential& potential, const scene::Scene& scene,
                                   const scene::Cut& cut, Progress& progress);

/// Why a step is advised, in a sentence: "The reach is short."
std::string_view reasonOf(AdviceStep step);

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::AdviceStep> {
  static constexpr std::string_view kNames[] = {"deepenReach", "moveToKeep", "protectLess"};
};
