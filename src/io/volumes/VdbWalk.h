#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "io/read/FileBytes.h"

namespace velum::io {

/// A metadata value of a grid, as its bytes stand in the file.
struct VdbNote {
  std::string type;  ///< "string", "vec3i", "bool", ...
  std::string bytes;
};

/// The first grid of floats or doubles of a .vdb.
struct VdbGrid {
  std::uint32_t fileVersion = 0, libraryMajor = 0, libraryMinor = 0;
  std::uint32_t compression = 0;  ///< OpenVDB's flags.
  bool isHalf = false;            ///< Values are stored in 16 bits.
  bool isDouble = false;
  int gridsInFile = 1;
  std::map<std::string, VdbNote> notes;
  std::uint64_t transformAt = 0;  ///< Offset in the file of the transform, which the tree follows.
};

/// Walks from the file's first byte to the end of the first grid of floats or doubles, and checks all lengths, counts
/// and blocks against the file, without allocating by them. OpenVDB itself allocates by lengths and counts that it has
/// just read, and hands blocks to their codec unchecked; so this check comes before.
/// @throw InputError when something does not fit, or the file has no such grid
VdbGrid walkVdb(const FileBytes& file);

}  // namespace velum::io
