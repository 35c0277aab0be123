#pragma once
#include <chrono>

namespace velum {

/// What we measure time with. It never enters a picture.
using Clock = std::chrono::steady_clock;

/// Milliseconds from @p start to now. Any thread.
inline double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace velum
