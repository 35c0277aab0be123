#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "core/Task.h"
#include "scene/SceneFwd.h"

namespace velum::render {

/// Which voxels of a grid the cuts of a scene leave: 1 or 0 by each voxel's middle, [z][y][x]. Sheets of membranes are
/// as their shapes in the scene say. Decided by the same function as in drawing. All cores, no GL. Any thread. @throw
/// Cancelled
std::vector<std::uint8_t> keptVoxels(const scene::Scene& scene, glm::ivec3 dims, const glm::dmat4& worldFromVoxel,
                                     Progress& progress);

}  // namespace velum::render
