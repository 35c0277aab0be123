#pragma once
#include <memory>

#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::io {

/// The level of a pyramid that readVolume() reads: the one that is asked for, or else the finest that fits into an
/// eighth of the machine's memory. @throw InputError when there is no such level, or it is too large
int levelToRead(const VoxelSource& of, const scene::Source& source);

/// Reads the level that levelToRead() chooses, and notes which it was where it is not the finest.
/// @param isAlignedByBorders  the file does not say where coarser levels lie, which is noted, too
/// @throw InputError when there is no such level, it is too large or cannot be read; Cancelled
Volume readFitting(std::unique_ptr<VoxelSource> pyramid, const scene::Source& source, bool isAlignedByBorders,
                   Progress& progress);

}  // namespace velum::io
