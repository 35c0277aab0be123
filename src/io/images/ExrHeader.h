#pragma once
#include "read/FileBytes.h"

namespace velum::io {

/// True when the attributes of an OpenEXR file lie within it. The library allocates what one claims before it reads, so
/// that four bytes ask for two gigabytes.
bool isSoundExr(const FileBytes& file);

}  // namespace velum::io
