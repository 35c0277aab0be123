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

/// How much memory volumes of any size may take. The user chooses it for the program, as it is a matter of the machine
/// and of no scene.
struct MemoryBudget {
  double wholeBytes = 512.0 * (1 << 20);  ///< volumes with levels of detail that have no more are read whole
  double brickBytes = 0;                  ///< of the bricks of a streamed volume; 0: an eighth of the machine's memory
  double gpuBrickBytes = 0;               ///< of those on the GPU; 0: a quarter of the GPU's memory, 2 GiB at most
  bool operator==(const MemoryBudget&) const = default;
};

/// The budget that counts for what is opened and drawn from now on. Any thread.
MemoryBudget memoryBudget();
void setMemoryBudget(const MemoryBudget& budget);
/// Bytes for the bricks of a streamed volume by that budget: 64 MiB at least, half of the machine's memory at most. Any
/// thread.
double brickBudget();

}  // namespace velum
