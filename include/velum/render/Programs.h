#pragma once
#include <vector>

#include "velum/gpu/Program.h"

namespace velum::render {

/// Every program that a frame can ask for, for the tests that compile them all. Those that software drivers compile for
/// their frame's flags are there without, and for some of the sets of flags: each flag alone, all of them, and sets
/// that come up together.
std::vector<gpu::ProgramSource> allPrograms();

}  // namespace velum::render
