#pragma once
#include <vector>

#include "gpu/Program.h"

namespace velum::render {

/// Every program that a frame can ask for, for the tests that compile them all. Programs compiled for their frame's
/// flags are listed for some sets of flags: all flags, each flag alone, and sets that occur together.
std::vector<gpu::ProgramSource> allPrograms();

}  // namespace velum::render
