#pragma once
#include <vector>

#include "velum/gpu/Program.h"

namespace velum::mesoscale {

/// Every program that this module can ask for, for the tests that compile them all.
std::vector<gpu::ProgramSource> allPrograms();

}  // namespace velum::mesoscale
