#pragma once
#include "app/Text.h"
#include "core/Model.h"

namespace velum::app {

/// Counts what the files of a model hold; molecules that were made from curves, or to complete them, are listed apart.
Json describeModel(const Model& model);

}  // namespace velum::app
