#pragma once
#include "scene/SceneFwd.h"

namespace velum::session {

/// How far a structure can stand out of a cut: to the farthest of its voxels in what the cut removes, or, where it may
/// still grow or has no labels, to the end of the data. Scene units; 0: no part of the structure lies there. O(bricks
/// of the structure).
double pulledEnd(const scene::Scene& scene, const scene::Cut& cut, int structure);

}  // namespace velum::session
