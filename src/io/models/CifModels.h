#pragma once
#include <vector>

#include "core/Task.h"
#include "io/models/CifTable.h"
#include "io/models/ModelParts.h"
#include "io/models/ReadModel.h"

/// Makes models from the blocks of a CIF, whether text or binary. modelOf() tells a block's flavour by its categories.
namespace velum::io {

/// @throw InputError
Model modelOf(const std::vector<CifBlock>& blocks, const Path& path, Progress& progress, const ModelReading& reading);

Model cellPackModel(const CifBlock& block, const Path& path, Progress& progress);
Model petWorldModel(const CifBlock& block, const Path& path, Progress& progress);
Model plainCifModel(const CifBlock& block, const Path& path, Progress& progress);

}  // namespace velum::io
