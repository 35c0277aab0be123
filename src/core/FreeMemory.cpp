#include "velum/core/FreeMemory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace velum {

void releaseFreeMemory() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace velum
