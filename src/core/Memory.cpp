#include "core/Memory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" std::size_t
__sanitizer_get_current_allocated_bytes();  // the compiler's package lacks the header that says it
#endif

#include <unistd.h>

#include <algorithm>
#include <mutex>

namespace velum {

double machineBytes() { return double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGESIZE)); }

namespace {

constexpr double kBrickShare = 0.125;              ///< of the machine's memory
constexpr double kLeastBricks = 64.0 * (1 << 20);  ///< views side by side would take each other's bricks

std::mutex gBudgetMutex;
MemoryBudget gBudget;

}  // namespace

MemoryBudget memoryBudget() {
  std::lock_guard lock(gBudgetMutex);
  return gBudget;
}

void setMemoryBudget(const MemoryBudget& budget) {
  std::lock_guard lock(gBudgetMutex);
  gBudget = budget;
}

double brickBudget() {
  double chosen = memoryBudget().brickBytes;
  return chosen > 0 ? std::min(std::max(chosen, kLeastBricks), machineBytes() / 2) : machineBytes() * kBrickShare;
}

void releaseFreeMemory() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

std::size_t allocatedBytes() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return __sanitizer_get_current_allocated_bytes();  // sanitizers have an allocator of their own
#elif defined(__GLIBC__)
  struct mallinfo2 info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  return 0;
#endif
}

}  // namespace velum
