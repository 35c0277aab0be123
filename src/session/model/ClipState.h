#pragma once
#include "scene/SceneFwd.h"

namespace velum::session {

/// How much the cuts of a scene take from its model ([VE] fig. 4).
enum class ClipState {
  Whole,   ///< S1: no cut that is on removes anything
  Cut,     ///< S2: whether an instance stays depends only on its place, or its type
  Thinned  ///< S3: of some types only a share stays, and lots decide which instances
};

ClipState clipState(const scene::Scene& scene);

/// Turns all cuts off: the model is whole.
void showWhole(scene::Scene& scene);
/// Turns off what lots decide: shares between none and all, and falloffs, become none for a cut that has a region, and
/// all for a cut that is everywhere. Turns all cuts on where none was on.
void showCut(scene::Scene& scene);

}  // namespace velum::session
