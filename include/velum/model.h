#pragma once
#include "core/Model.h"
#include "io/models/ReadModel.h"
#include "io/models/WriteModel.h"

/// Model: molecules of a cell, and where they stand; and the files they are in.
namespace velum {

using io::readModel;
using io::writeModel;

}  // namespace velum
