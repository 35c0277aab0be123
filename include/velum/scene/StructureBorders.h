#pragma once
#include <vector>

#include "velum/core/LabelCover.h"
#include "velum/scene/Scene.h"

namespace velum::scene {

/// The structures of a scene whose borders lie where the volume's values leave a range: what was grown by one range,
/// not up to a gradient. Looks at some of the volume's values: milliseconds. Any thread.
std::vector<ValueBorder> valueBordersOf(const Scene& scene);

}  // namespace velum::scene
