#pragma once
#include <vector>

#include "gpu/Program.h"

namespace velum::model {

/// Every program that this module can ask for, for the tests that compile them all.
std::vector<gpu::ProgramSource> allPrograms();

}  // namespace velum::model
