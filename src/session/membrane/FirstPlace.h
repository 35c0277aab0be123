#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/Task.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// This share of what is protected is to be kept; where less is kept, the user is told.
inline constexpr double kEnoughKept = 0.9;

/// A new membrane as a key press hangs it: across the direction to the eye, protecting what the scene shows most, in
/// the place and with the reach of placedToKeep(). Where hands have moved the crosshair the membrane hangs there
/// instead, and only the reach is looked for. Some tenths of a second. @throw Cancelled. Any thread.
scene::Cut newMembrane(const scene::Scene& scene, Progress& progress);

/// The membrane at the place along its axis where its sheet keeps what it protects, with the shortest reach by which
/// the sheet does so. From the front of what is protected inwards this is the first place at which nine tenths of it
/// stay, and at which the sheet spares about as much as anywhere and has to cut little. Where so much can be kept
/// nowhere, it is the place where most is kept. Found by least cuts of a coarse look at the data (about 50 places along
/// each edge): a tenth of a second for each reach that is tried.
/// @param cut  a membrane with its field and its frame; where the frame lies along its axis does not count
/// @param isReachFree  false: the membrane keeps its reach
/// @return nothing where nothing is protected, or by the gradient alone
/// @throw Cancelled. Any thread.
std::optional<scene::Cut> placedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress,
                                       bool isReachFree = true);

/// The membrane in its place with the shortest reach by which nine tenths of what it protects are kept. Tries its own
/// reach and reaches up to some times as deep; where none of them keeps so much, the membrane stays as it is.
/// @throw Cancelled. Any thread.
scene::Cut deepenedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
