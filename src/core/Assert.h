#pragma once

/// VELUM_ASSERT(condition, "what holds"): for a mistake of ours that would otherwise be a wrong picture, never for what
/// a file or a user may do wrong. A condition that does not hold ends the program with place, condition and text.
///
/// Checked wherever NDEBUG is not defined (presets dev, ci, asan, tidy) and in fuzz targets. The release preset leaves
/// it out, so a condition may stand in an inner loop, and must not change anything.
#if !defined(NDEBUG) || defined(VELUM_ASSERTS)
#define VELUM_ASSERT(condition, what) \
  ((condition) ? void(0) : ::velum::detail::assertFailed(__FILE__, __LINE__, #condition, what))
#else
#define VELUM_ASSERT(condition, what) void(sizeof(!(condition)))
#endif

namespace velum::detail {

/// Prints to the standard error and aborts. Any thread.
[[noreturn]] void assertFailed(const char* file, int line, const char* condition, const char* what);

}  // namespace velum::detail
