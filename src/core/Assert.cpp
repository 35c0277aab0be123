#include "core/Assert.h"

#include <cstdio>
#include <cstdlib>

namespace velum::detail {

void assertFailed(const char* file, int line, const char* condition, const char* what) {
  std::fprintf(stderr, "%s:%d: this must hold: %s (%s)\n", file, line, what, condition);
  std::abort();
}

}  // namespace velum::detail
