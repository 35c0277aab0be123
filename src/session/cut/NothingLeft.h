#pragma once
#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// What to say where cutsTakeAll() is true, for people.
inline constexpr const char* kNothingLeft =
    "The cuts leave nothing of what the scene shows: flip a cut, move it, or turn it off";

/// True when something would show and the cuts that are on leave none of it: a plane beyond the data, a flipped sphere.
/// A section that a cut shows on its face counts as something. Mostly a look at a thousandth of the voxels is enough to
/// say no; to say yes takes all of them. Membranes as their shapes are. Any thread. @throw Cancelled
bool cutsTakeAll(const scene::Scene& scene, Progress& progress);

}  // namespace velum::session
