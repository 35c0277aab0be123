#pragma once
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// Reads text CIF by gemmi's parser. @return the blocks, with the columns that isWanted() names @throw InputError
std::vector<CifBlock> parseCifText(const std::string& text, const Path& path);

}  // namespace velum::io
