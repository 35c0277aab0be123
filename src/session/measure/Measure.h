#pragma once
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"
#include "session/measure/Profile.h"
#include "session/measure/Quantity.h"

namespace velum::scene {
struct Mark;
}

/// What marks measure. World positions are in the scene's unit.
namespace velum::session {

/// What a mark measures.
struct Measured {
  std::string text;     ///< as written on the picture, behind Mark::text, lines parted by '\n'; empty: the mark
                        ///< measures nothing
  std::string problem;  ///< why there is nothing to measure, one line for people; then `text` and all else are empty
  std::vector<Quantity> quantities;    ///< the one that names the mark comes first
  std::vector<ProfileSample> profile;  ///< Profile: half the smallest voxel apart; else empty
  std::vector<glm::dvec3> way;         ///< alongSurface: the way that was measured, from point to point, world, to be
                                       ///< drawn; else empty
  bool operator==(const Measured&) const = default;
};
/// A quantity by its name; null where there is none.
const Quantity* findQuantity(const Measured& measured, std::string_view name);

/// True where measure() costs microseconds and looks at no voxels: it may then be called for each picture.
bool isMeasuredAtOnce(const scene::Mark& mark);

/// Measures a mark of a scene, whether the mark is in the scene or not: at the time step and channel that are shown,
/// and of structures what the cuts leave, membranes as their shapes in the scene say (see Session::settled()). Arrows,
/// labels and names measure nothing. Straight kinds are done at once; others take from milliseconds to seconds, on all
/// cores, and read a streamed volume brick by brick.
/// @return with `problem` where the scene lacks what the mark is about: no volume, no such structure, no surface
/// @throw Cancelled; InputError when a brick cannot be read. Any thread.
Measured measure(const scene::Scene& scene, const scene::Mark& mark, Progress& progress);

}  // namespace velum::session
