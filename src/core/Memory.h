#pragma once
#include <cstddef>

namespace velum {

/// Gives freed memory back to the system; to be called after something large was freed. Otherwise the allocator keeps
/// that memory, for each thread that ever ran, and a long session seems to grow. Any thread; milliseconds.
void releaseFreeMemory();

/// Bytes that this program and its libraries have allocated and not freed; 0 where the C library does not tell. Code,
/// stacks and memory that the allocator holds in reserve are not counted. Any thread; milliseconds.
std::size_t allocatedBytes();

/// Bytes of the machine's memory. Any thread.
double machineBytes();

}  // namespace velum
