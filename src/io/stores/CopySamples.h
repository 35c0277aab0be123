#pragma once
#include "core/VoxelSource.h"
#include "io/stores/ChunkType.h"

namespace velum::io {

/// Bytes from a stored sample to the next one along each axis; 0 where it is the same one again and again.
struct SampleSteps {
  std::ptrdiff_t x = 0, y = 0, z = 0, channel = 0, timeStep = 0;
};

/// Brings the samples of a box, of which only the size counts, into a volume's type and the machine's byte order; false
/// when one is a whole number that 32 bits cannot hold. @param first  the sample at the box's origin
bool copySamples(ChunkType type, const std::byte* first, const SampleSteps& steps, const BrickBox& box,
                 const SampleTarget& target);

/// Refuses whole numbers that 32 bits cannot hold. @throw InputError always
[[noreturn]] void refuseWideNumbers(ChunkType type, const std::string& path);

}  // namespace velum::io
