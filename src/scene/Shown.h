#pragma once
#include <algorithm>
#include <cstdint>
#include <ranges>
#include <vector>

#include "scene/Scene.h"

/// Which parts of a scene are shown. Fields that come from files and commands may be out of their ranges; the results
/// of these functions never are.
namespace velum::scene {

/// @param layer  has data
inline int shownChannel(const VolumeLayer& layer) { return std::clamp(layer.channel, 0, layer.data->channels - 1); }
/// @param layer  has data
inline int shownTimeStep(const VolumeLayer& layer) { return std::clamp(layer.timeStep, 0, layer.data->timeSteps - 1); }

inline int copyCount(const ModelLayer& layer) { return std::max(1, layer.copies); }
/// The number of instances of all copies. @param layer  has data
inline std::uint64_t instanceCount(const ModelLayer& layer) {
  return std::uint64_t(layer.data->instances.size()) * std::uint64_t(copyCount(layer));
}

/// The cuts that are on.
inline auto enabledOf(const std::vector<Cut>& cuts) {
  return cuts | std::views::filter([](const Cut& cut) { return cut.enabled; });
}

}  // namespace velum::scene
