#pragma once
#include "core/Model.h"
#include "io/models/ReadModel.h"
#include "io/models/WriteModel.h"

/// Model: the molecules of a cell and where each stands. Also reads and writes files of models.
namespace velum {

using io::readModel;
using io::writeModel;

}  // namespace velum
