#pragma once
#include "core/VoxelSource.h"

namespace velum::io {

/// Bytes of the samples of a box.
std::size_t bytesOf(const BrickBox& box, SampleType type);

/// Where the samples of a box lie that are stored as readBox() does.
SampleTarget targetIn(std::byte* samples, const BrickBox& box, SampleType type);

/// The samples of a box of a level, shape [time][channel][z][y][x], whatever bricks they lie in; each of these is read
/// once, on all cores.
/// @param box  inside the level  @throw InputError when a brick cannot be read; Cancelled
Bytes readBox(const VoxelSource& source, int level, const BrickBox& box, const Progress& progress);
/// The same into bytes that are used again and again: new memory costs as much as what is done with it.
void readBoxInto(Bytes& samples, const VoxelSource& source, int level, const BrickBox& box, const Progress& progress);

}  // namespace velum::io
