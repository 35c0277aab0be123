#pragma once
#include <cstdint>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

// Results of stayingShares() for instances that stay, or go, whatever the share.
constexpr float kStaysAlways = -1.0f;
constexpr float kStaysNever = 2.0f;

/// For each instance of some types, copy by copy: the share of some cuts at which the instance begins to stay, 0 to
/// before 1. At larger shares all cuts together leave the instance. The value is kStaysAlways or kStaysNever where the
/// share does not matter. This is [VE] 3 inverted: the formulas of shaders/shared/instance.h are solved for the share,
/// and the results of several cuts are joined as in shaders/shared/cuts.h. Values are exact up to the rounding of
/// floats: between values that are nearly equal, keptInstances() decides. Clearing for a view is ignored. All cores, no
/// GL. Any thread.
/// @param scene  each of `cuts` must have a TypeSpare with share 1 for the path of each type; a cut whose ranges of
/// mass or number leave a type out spares none of its instances, whatever the share
/// @param cuts  ids of the cuts that have the common share; other cuts keep their own shares
/// @param types  their indices in Model::types
std::vector<std::vector<float>> stayingShares(const scene::Scene& scene, const std::vector<int>& cuts,
                                              const std::vector<std::uint32_t>& types, const SheetIndices& sheets = {});

}  // namespace velum::render
