#pragma once
#include <cstddef>
#include <span>

#include "core/Volume.h"
#include "io/read/Refuse.h"

namespace velum::io {

/// Bytes of dims x channels x frames samples, checked for overflow and against `mostBytes`.
/// @param dims, channels, frames  as the header says: any numbers
/// @param sampleBytes  of one sample in the file
/// @param mostBytes  bytes that the file can hold
/// @throw InputError naming both byte counts when the file cannot hold so much, or a dimension is < 1
std::size_t checkedBytes(const Path& path, glm::dvec3 dims, double channels, double frames, std::size_t sampleBytes,
                         double mostBytes);

/// Reverses the bytes of each sample of `sampleBytes` (1, 2, 4 or 8).
void swapBytes(std::span<std::byte> bytes, std::size_t sampleBytes);
/// Brings samples into the machine's byte order.
void toMachineOrder(std::span<std::byte> bytes, std::size_t sampleBytes, bool isBigEndian);

}  // namespace velum::io
