#pragma once
#include <cstdint>
#include <vector>

#include "core/Model.h"
#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// Width by height of a picture that nobody has said the size of.
constexpr double kUsualAspect = 16.0 / 9.0;

/// What cuts do with an instance.
enum class InstanceState : std::uint8_t {
  Kept,
  Removed,  ///< by where it stands
  Cleared   ///< as it hides what a cut keeps in view (scene::Focus)
};

/// What the cuts do with each instance of a scene's model, copy by copy; types that are hidden count like others, but
/// for that they are in nobody's view and hide nothing. By the functions that draw them. All cores, no GL. Any thread.
/// @param aspect  width by height of the picture; only views onto a focus depend on it
std::vector<InstanceState> instanceStates(const scene::Scene& scene, const SheetIndices& sheets = {},
                                          double aspect = kUsualAspect);

/// Which instances the cuts leave, 1 or 0: instanceStates().
std::vector<std::uint8_t> keptInstances(const scene::Scene& scene, const SheetIndices& sheets = {},
                                        double aspect = kUsualAspect);

/// A copy of a scene's model with the instances that show alone: those that the cuts leave, of types that are not
/// hidden; of the first copy. What has no instance left is gone from it. @param kept  keptInstances()
Model shownModel(const scene::Scene& scene, const std::vector<std::uint8_t>& kept);

}  // namespace velum::render
