#pragma once
#include <glm/glm.hpp>
#include <optional>

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

/// The mean place of a structure's voxels, world; it may lie outside of the structure. None where it has no voxels.
/// Remembers sums of bricks of the labels, so that an edit costs the bricks that it changed. The first call looks at
/// all voxels of bricks that are not uniform. Any thread.
std::optional<glm::dvec3> middleOfVoxels(const scene::Scene& scene, int structure);

/// A mark each of whose points follows what is there: the instance whose ball holds the point, of several that whose
/// middle is next, else the structure in which it lies. Points where nothing is stay. Goes with all instances.
scene::Mark following(const scene::Scene& scene, scene::Mark mark);
/// The mark where it stands now, following nothing.
scene::Mark fixed(const scene::Scene& scene, const scene::Mark& mark);

}  // namespace velum::session
