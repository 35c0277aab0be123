#pragma once
#include <span>

#include "io/stores/Codecs.h"

/// The ways in which programs frame blocks of LZ4.
namespace velum::io {

/// @throw InputError that says that bytes of this codec are damaged
[[noreturn]] void refuseDamaged(const Path& path, std::string_view codec);

/// As numcodecs writes it: the size, 32 bits, low first, then one block. @param most  bytes that it may unpack to
/// @throw InputError for damaged bytes, as the others do
Bytes unpackLz4(std::span<const std::byte> from, std::uint64_t most, const Path& path);

/// As Java's LZ4BlockOutputStream writes it: blocks, each with a word, how it is packed, its sizes and a check sum,
/// which is not looked at; the last one is empty.
Bytes unpackLz4Java(std::span<const std::byte> from, std::uint64_t most, const Path& path);

/// As the filter 32004 of HDF5 writes it: the size, 64 bits, and that of a block, 32 bits, then blocks, each with its
/// packed size; one that could not be made smaller is stored as it is. Numbers are high first.
Bytes unpackLz4Hdf5(std::span<const std::byte> from, std::uint64_t most, const Path& path);

}  // namespace velum::io
