#pragma once
#include "io/read/FileBytes.h"

namespace velum::io {

/// True when the attributes of an OpenEXR file lie within it and are as large as their types. The library allocates
/// what one claims before it reads, so that four bytes ask for two gigabytes, and reads some by their type, so that a
/// wrong size makes other attributes of what follows.
bool isSoundExr(const FileBytes& file);

}  // namespace velum::io
