#pragma once
#include "io/read/FileBytes.h"

namespace velum::io {

/// True when the chunks of a PNG file lie within it, up to the last. The library allocates what one claims before it
/// reads, so that four bytes ask for two gigabytes.
bool isSoundPng(const FileBytes& file);

}  // namespace velum::io
