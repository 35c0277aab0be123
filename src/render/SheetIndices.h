#pragma once
#include <map>
#include <memory>

#include "membrane/sheet/SheetIndex.h"

namespace velum::render {

/// A solver's present sheets of enabled membranes, by the id of the cut. Where a sheet is missing, empty, or made for a
/// frame of another size, it is made as `Cut::membrane` says.
using SheetIndices = std::map<int, std::shared_ptr<const membrane::SheetIndex>>;

}  // namespace velum::render
