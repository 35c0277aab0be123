#pragma once
#include <optional>
#include <vector>

#include "io/labels/LabelBricks.h"
#include "io/labels/LabelGrid.h"
#include "scene/Source.h"

namespace velum::io {

/// Labels of one layer, whose ids may be of any size, read brick by brick.
/// @param head   of the source, where it lies in the world, with its name
/// @param how    its place, path and budget are filled in
/// @param named  names and colours; empty: there are none
/// @throw InputError, Cancelled
LabelVolume labelsByBricks(const VoxelSource& from, const Volume& head, LabelBrickOptions how,
                           std::vector<LabelInfo> named, Progress& progress);

/// Reads labels of a store, or of a file that is larger than wholeBudget() and can be read piece by piece; nothing for
/// all else. @param known  ids that a scene has for those of the file  @throw InputError, Cancelled
std::optional<LabelVolume> readLargeLabels(const scene::Source& source, const std::optional<LabelGrid>& scan,
                                           const KnownIds& known, Progress& progress);

}  // namespace velum::io
