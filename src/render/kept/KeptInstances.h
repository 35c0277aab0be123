#pragma once
#include <cstdint>
#include <vector>

#include "core/Model.h"
#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// Width by height of a picture whose size is not known.
constexpr double kUsualAspect = 16.0 / 9.0;

/// What the cuts do with an instance.
enum class InstanceState : std::uint8_t {
  Kept,
  Removed,  ///< because of its place
  Cleared   ///< because it hides something that a cut keeps in view (scene::Focus)
};

/// What the cuts do with each instance of a scene's model, copy by copy; hidden types are treated like others, except
/// that they hide nothing. Decided by the same functions as in drawing. All cores, no GL. Any thread.
/// @param aspect  width by height of the picture; only views onto a focus depend on it
/// @param types  those whose instances are asked about, others counting as kept; empty: all. A handle asks again and
/// again about few
std::vector<InstanceState> instanceStates(const scene::Scene& scene, const SheetIndices& sheets = {},
                                          double aspect = kUsualAspect, const std::vector<std::uint32_t>& types = {});

/// For each instance 1 where the cuts leave it, else 0, by instanceStates().
std::vector<std::uint8_t> keptInstances(const scene::Scene& scene, const SheetIndices& sheets = {},
                                        double aspect = kUsualAspect, const std::vector<std::uint32_t>& types = {});

/// A copy of a scene's model with only the instances that show: those of the first copy that the cuts leave and whose
/// types are not hidden. Types and molecules without instances are left out. @param kept  keptInstances()
Model shownModel(const scene::Scene& scene, const std::vector<std::uint8_t>& kept);

}  // namespace velum::render
