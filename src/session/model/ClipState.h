#pragma once
#include "scene/SceneFwd.h"

namespace velum::session {

/// How a scene's model is cut ([VE] fig. 4).
enum class ClipState {
  Whole,   ///< S1: no cut that is on removes anything
  Cut,     ///< S2: where an instance is decides, or its type
  Thinned  ///< S3: of some types a share stays, and lots decide which
};

ClipState clipState(const scene::Scene& scene);

/// Turns all cuts off: the model is whole.
void showWhole(scene::Scene& scene);
/// Gives up what is left to lots: shares between none and all, and falloffs, leave nothing where the cut has a region,
/// and all where it is everywhere. Cuts are turned on where all were off.
void showCut(scene::Scene& scene);

}  // namespace velum::session
