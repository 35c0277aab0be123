#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "velum/core/Task.h"
#include "velum/scene/Scene.h"

namespace velum::session {

/// Where a new membrane hangs along its axis: from the front of what it protects inwards, the first place at which its
/// sheet spares about as much as anywhere and has to cut little. By least cuts of a coarse look at the data (about 50
/// places along each edge): a tenth of a second.
/// @param cut  a membrane with its field and its frame; only its axis, reach and side count
/// @return the centre, world; nothing where nothing is protected, or by the gradient alone
/// @throw Cancelled. Any thread.
std::optional<glm::dvec3> firstPlaceOf(const scene::Scene& scene, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
