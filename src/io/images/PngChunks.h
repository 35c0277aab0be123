#pragma once
#include "io/read/FileBytes.h"

namespace velum::io {

/// True when all chunks of a PNG file, up to the last, lie within the file. The library allocates the size that a chunk
/// claims before it reads, so that four bytes could ask for two gigabytes.
bool isSoundPng(const FileBytes& file);

}  // namespace velum::io
