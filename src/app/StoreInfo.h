#pragma once
#include "app/Text.h"
#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::app {

/// Size, spacing, place and bytes of a level.
Json describeLevel(const VoxelSource& source, int number);

/// What is known of a store of chunked voxels without reading any of them: all levels and how they are stored.
/// @throw InputError
Json describeStore(const scene::Source& source);

}  // namespace velum::app
