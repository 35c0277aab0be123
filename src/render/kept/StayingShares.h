#pragma once
#include <cstdint>
#include <vector>

#include "render/SheetIndices.h"
#include "scene/SceneFwd.h"

namespace velum::render {

// What stayingShares() says of an instance that no share decides about.
constexpr float kStaysAlways = -1.0f;
constexpr float kStaysNever = 2.0f;

/// Of each of some types, for each instance of it, copy by copy, the share of some cuts at which it begins to stay, 0
/// to before 1: at larger ones all cuts together leave it; or kStaysAlways, or kStaysNever. [VE] 3 the other way round:
/// what the formulas of shaders/shared/instance.h say of a distance, solved for the share, and put together as
/// shaders/shared/cuts.h puts answers together. To the rounding of floats: where two lie close to each other,
/// keptInstances() has the last word. What cuts clear for a view is not asked. All cores, no GL. Any thread.
/// @param scene  with a row for the path of each of the types, of share 1, in those cuts; a cut whose mass or number
///   leaves a type out spares nothing of it whatever the share
/// @param cuts  their ids; all have one share, others have theirs
/// @param types  by their places in the model
std::vector<std::vector<float>> stayingShares(const scene::Scene& scene, const std::vector<int>& cuts,
                                              const std::vector<std::uint32_t>& types, const SheetIndices& sheets = {});

}  // namespace velum::render
