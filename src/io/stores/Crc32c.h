#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

namespace velum::io {

/// CRC-32C (Castagnoli) as Zarr's codec `crc32c` stores it.
std::uint32_t crc32c(std::span<const std::byte> bytes);

/// The same without the processor's instruction, for processors that lack it, and for tests.
std::uint32_t crc32cByTable(std::span<const std::byte> bytes);

}  // namespace velum::io
