#pragma once
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// Reads BinaryCIF: MessagePack whose columns are stored by a chain of encodings (S. Bittrich et al., 2020).
/// @param bytes  of the file, inflated @return the blocks, with the columns that isWanted() names @throw InputError
std::vector<CifBlock> parseBinaryCif(const std::string& bytes, const Path& path);

}  // namespace velum::io
