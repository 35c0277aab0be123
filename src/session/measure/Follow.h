#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "core/Task.h"
#include "scene/Mark.h"
#include "scene/SceneFwd.h"

/// Points of marks that go with what the scene shows.
namespace velum::session {

/// A mark as it stands now: points that follow an instance or a structure in its middle, all others where they are. A
/// point stays where what it follows is not there. The rim of a circle goes with its middle. Whoever draws, measures
/// or takes hold of a mark asks this first. Any thread; microseconds, but milliseconds where labels have changed, see
/// middleOfVoxels().
scene::Mark followed(const scene::Scene& scene, const scene::Mark& mark);
/// A point of the mark follows something.
bool isFollowing(const scene::Mark& mark, std::size_t point);
/// Any of its points does.
bool isFollowing(const scene::Mark& mark);

/// The mean place of a structure's voxels, world; it may lie outside of the structure. None where it has no voxels.
/// Remembers sums of bricks of the labels for all structures at once, so that many structures cost one pass, and an
/// edit the bricks that it changed. The first call looks at all voxels of bricks that are not uniform. Any thread, also
/// under locks.
std::optional<glm::dvec3> middleOfVoxels(const scene::Scene& scene, int structure);

/// Most instances that following() looks at for one point: for a second or so. Of more points each as many fewer.
constexpr std::uint64_t kMostSearched = 4'000'000'000;
/// A mark each of whose points follows what is there: the instance whose ball holds the point, of several that whose
/// middle is next, else the structure in which it lies. Points where nothing is stay. Looks once at all instances of a
/// copy of the model for each copy in whose box points lie. Any thread.
/// @throw ArgumentError where these are more than kMostSearched for all points together; Cancelled
scene::Mark following(const scene::Scene& scene, scene::Mark mark, const Progress& progress);
/// The mark where it stands now, following nothing.
scene::Mark fixed(const scene::Scene& scene, const scene::Mark& mark);

}  // namespace velum::session
