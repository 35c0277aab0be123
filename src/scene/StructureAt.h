#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "core/LabelCover.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// The structures of a scene whose borders lie where the volume's values leave a range: what was grown by one range,
/// not up to a gradient. Looks at some of the volume's values: milliseconds. Any thread.
std::vector<ValueBorder> valueBordersOf(const Scene& scene);

/// Whose places are in a scene that has labels. As long as somebody holds the last one, whoever asks of the same labels
/// gets it, and of others what has not changed since: who asks of many places holds it. Any thread.
std::shared_ptr<const StructureField> structureFieldOf(const Scene& scene);

/// Whose a place of the world is, and how far inside it lies: what the picture says, and everybody else. Nobody's where
/// no labels are shown. Any thread.
StructurePlace structureAt(const Scene& scene, glm::dvec3 world);

}  // namespace velum::scene
