#pragma once
#include <map>
#include <memory>

#include "membrane/sheet/SheetIndex.h"

namespace velum::render {

/// Sheets of enabled membranes as a solver has them, by the id of the cut. One that is missing, empty, or made for a
/// frame of another size is made as `Cut::membrane` says.
using SheetIndices = std::map<int, std::shared_ptr<const membrane::SheetIndex>>;

}  // namespace velum::render
