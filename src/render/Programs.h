#pragma once
#include <vector>

#include "gpu/Program.h"

namespace velum::render {

/// Every program that a frame can ask for, for the tests that compile them all. Those that are compiled for their
/// frame's flags are there for some of the sets of flags: all of them, each flag alone, and sets that come up together.
std::vector<gpu::ProgramSource> allPrograms();

}  // namespace velum::render
