#pragma once
#include <string>
#include <vector>

#include "CifTable.h"
#include "ModelParts.h"

namespace velum::io {

/// Text CIF, read by gemmi. @return blocks with what isWanted()  @throw InputError
std::vector<CifBlock> parseCifText(const std::string& text, const Path& path);

}  // namespace velum::io
