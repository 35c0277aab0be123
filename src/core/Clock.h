#pragma once
#include <chrono>

namespace velum {

/// The clock with which we measure how long work takes. Its times never influence a picture.
using Clock = std::chrono::steady_clock;

/// Milliseconds from @p start to now. Any thread.
inline double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace velum
