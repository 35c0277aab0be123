#pragma once
#include <optional>
#include <string_view>

#include "velum/core/Fields.h"
#include "velum/core/Task.h"
#include "velum/membrane/forces/Kernels.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// Why a sheet cuts much, and what would help.
enum class AdviceStep {
  DeepenReach,  ///< the reach is short
  MoveInFront,  ///< the frame goes through solid material
  ProtectLess   ///< too much is protected
};

/// One step that lets a membrane cut less.
struct Advice {
  AdviceStep step = AdviceStep::DeepenReach;
  scene::Cut cut;         ///< as it would be
  double cutShare = 1.0;  ///< of what its plane would cut then, by a coarse look
};

/// Where a sheet cuts more than this of what its plane would cut, it is worth asking for advice.
inline constexpr double kMuchCut = 0.6;

/// The step that helps most, among a reach twice as deep, the place that firstPlaceOf() finds, and protecting the half
/// of it that differs most from the rest; nothing where none helps by a fifth. A few tenths of a second.
/// @param potential  of the scene  @throw Cancelled. Any thread.
std::optional<Advice> adviseMembrane(const membrane::Potential& potential, const scene::Scene& scene,
                                     const scene::Cut& cut, Progress& progress);

/// Why, in a sentence: "The reach is short."
std::string_view reasonOf(AdviceStep step);

}  // namespace velum::session

template <>
struct velum::EnumNames<velum::session::AdviceStep> {
  static constexpr std::string_view kNames[] = {"deepenReach", "moveInFront", "protectLess"};
};
