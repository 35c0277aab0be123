#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/LabelCover.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// The structures of a scene whose borders lie where the volume's values leave a range: those that were grown by one
/// range, and not up to a gradient. Looks at some of the volume's values: milliseconds. Any thread.
std::vector<ValueBorder> valueBordersOf(const Scene& scene);

/// The field that tells to which structures the places of a scene with labels belong. As long as some caller holds the
/// last field, calls for the same labels return that field, and a field for other labels takes over the bricks that
/// have not changed. So callers that ask about many places should hold on to it. Any thread.
std::shared_ptr<const StructureField> structureFieldOf(const Scene& scene);

/// The structure that a place of the world belongs to, and how far inside the structure it lies. Pictures and all other
/// code agree with this. Id 0 where no labels are shown. Any thread.
StructurePlace structureAt(const Scene& scene, glm::dvec3 world);

}  // namespace velum::scene
