#pragma once
#include "io/read/FileBytes.h"

namespace velum::io {

/// True when the attributes of an OpenEXR file lie within the file and have the sizes that their types require. The
/// library allocates the size that an attribute claims before it reads, so that four bytes could ask for two gigabytes.
/// It reads some attributes by their type, so that after a wrong size it would take other bytes for attributes.
bool isSoundExr(const FileBytes& file);

}  // namespace velum::io
