#pragma once
#include <cstddef>

namespace velum {

/// Gives what was freed back to the system: to be called when something large has gone. The allocator keeps it else for
/// each thread that there was, and a long session seems to grow. Any thread; milliseconds.
void releaseFreeMemory();

/// Bytes that this program and its libraries have allocated and not freed; 0 where the C library does not tell. Code,
/// stacks and what the allocator holds beyond it are not in it. Any thread; milliseconds.
std::size_t allocatedBytes();

}  // namespace velum
