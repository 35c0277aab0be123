#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "core/Task.h"
#include "scene/Cut.h"
#include "scene/SceneFwd.h"

namespace velum::session {

/// So much of what is protected is to be kept; where it is less, that is said.
inline constexpr double kEnoughKept = 0.9;

/// A new membrane as a key press hangs it: across the direction to the eye, protecting what the scene shows most, in
/// the place and with the reach of placedToKeep(); where hands have put the crosshair it hangs there, and the reach
/// alone is looked for. Some tenths of a second. @throw Cancelled. Any thread.
scene::Cut newMembrane(const scene::Scene& scene, Progress& progress);

/// The membrane where along its axis its sheet keeps what it protects, with the shortest reach by which it does: from
/// the front of what is protected inwards, the first place at which nine tenths of that stay and the sheet spares about
/// as much as anywhere and has to cut little. Where nowhere so much can be kept, the place where most is. By least cuts
/// of a coarse look at the data (about 50 places along each edge): a tenth of a second for each reach that is tried.
/// @param cut  a membrane with its field and its frame; only its axis, reach and side count, and what lies across
/// @param isReachFree  else it keeps its reach
/// @return nothing where nothing is protected, or by the gradient alone
/// @throw Cancelled. Any thread.
std::optional<scene::Cut> placedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress,
                                       bool isReachFree = true);

/// The membrane in its place with the shortest reach by which nine tenths are kept, of those up to some times its own;
/// as it is where none does. @throw Cancelled. Any thread.
scene::Cut deepenedToKeep(const scene::Scene& scene, const scene::Cut& cut, Progress& progress);

}  // namespace velum::session
