#pragma once
#include <memory>

#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::io {

/// What readVolume() reads of a pyramid.
struct LevelPlan {
  int level = 0;            ///< that is in memory
  bool isStreamed = false;  ///< finer ones are read brick by brick as they are seen
};

/// Bytes of voxels up to which volumes with levels of detail are read whole: MemoryBudget::wholeBytes, before which
/// goes the variable VELUM_WHOLE_MB, and half of the memory at most.
double wholeBudget();

/// The level that is asked for; or else the finest, where it is small or there is no other; or else one that is read in
/// a second, over which the finer ones are streamed. wholeBudget() says what is small.
/// @throw InputError when there is no such level, or it is too large
LevelPlan planLevel(const VoxelSource& of, const scene::Source& source);

/// The level of a file that comes nearest to a wanted one: it is there, and no larger than half of the memory; -1 for a
/// file without levels of detail, or where nothing fits. Headers are read. @throw InputError when they cannot be
int levelNear(const scene::Source& source, int wanted);

/// Opens a file or an image of a store that has levels of detail; null for all others. @throw InputError
std::unique_ptr<VoxelSource> openPyramid(const scene::Source& source);

/// Reads the level that planLevel() chooses, and notes which it was where it is not the finest.
/// @param isAlignedByBorders  the file does not say where coarser levels lie, which is noted, too
/// @throw InputError when there is no such level, it is too large or cannot be read; Cancelled
Volume readFitting(std::unique_ptr<VoxelSource> pyramid, const scene::Source& source, bool isAlignedByBorders,
                   Progress& progress);

/// Widens the range of a volume that knows finer levels, whose means show less than there is: by a few bricks of the
/// finest level, those where the volume has its largest and its smallest values.
/// @param volume  with its own range
void widenRange(Volume& volume);

}  // namespace velum::io
