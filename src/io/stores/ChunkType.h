#pragma once
#include <cstddef>
#include <string>

#include "core/Volume.h"

/// The types of samples in stores, and what becomes of them here.
namespace velum::io {

/// How a sample is stored.
struct ChunkType {
  enum class Kind { Bool, Unsigned, Signed, Float };
  Kind kind = Kind::Unsigned;
  int bytes = 1;  ///< 1, 2, 4 or 8
  bool isBigEndian = false;
  bool operator==(const ChunkType&) const = default;
};

/// What a volume holds such samples as: as they are, but half floats as floats, and whole numbers of 64 bits in 32.
SampleType sampleTypeOf(ChunkType type);

/// "uint16", "float16", as Zarr calls it.
std::string nameOf(ChunkType type);

/// Brings a row of samples into a volume's type and the machine's byte order; false when one is a whole number that 32
/// bits cannot hold. The steps are the bytes from each sample to the next; fromStep 0: the same one again and again.
using RowConverter = bool (*)(const std::byte* from, std::ptrdiff_t fromStep, std::byte* to, std::ptrdiff_t toStep,
                              int count);
RowConverter rowConverter(ChunkType type);

}  // namespace velum::io
