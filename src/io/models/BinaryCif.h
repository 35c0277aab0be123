#pragma once
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// BinaryCIF: MessagePack with columns that went through a chain of encodings (S. Bittrich et al., 2020).
/// @param bytes  inflated  @return blocks with what isWanted()  @throw InputError
std::vector<CifBlock> parseBinaryCif(const std::string& bytes, const Path& path);

}  // namespace velum::io
