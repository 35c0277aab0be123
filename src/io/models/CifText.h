#pragma once
#include <string>
#include <vector>

#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"

namespace velum::io {

/// Text CIF, read by gemmi. @return blocks with what isWanted()  @throw InputError
std::vector<CifBlock> parseCifText(const std::string& text, const Path& path);

}  // namespace velum::io
