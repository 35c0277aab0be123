#pragma once
#include <cstdint>
#include <vector>

#include "velum/render/SheetIndices.h"
#include "velum/scene/Scene.h"

namespace velum::render {

/// Which instances of a scene's model the cuts leave, 1 or 0, copy by copy; types that are hidden count like others. By
/// the function that draws them. All cores, no GL. Any thread.
std::vector<std::uint8_t> keptInstances(const scene::Scene& scene, const SheetIndices& sheets = {});

/// A copy of a scene's model with the instances that show alone: those that the cuts leave, of types that are not
/// hidden; of the first copy. What has no instance left is gone from it. @param kept  keptInstances()
Model shownModel(const scene::Scene& scene, const std::vector<std::uint8_t>& kept);

}  // namespace velum::render
