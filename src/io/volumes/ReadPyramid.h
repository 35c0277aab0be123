#pragma once
#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::io {

/// Reads the level that levelToRead() chooses, and notes which it was where it is not the finest.
/// @param isAlignedByBorders  the file does not say where coarser levels lie, which is noted, too
/// @throw InputError when there is no such level, it is too large or cannot be read; Cancelled
Volume readPyramid(const VoxelSource& of, const scene::Source& source, bool isAlignedByBorders, Progress& progress);

}  // namespace velum::io
