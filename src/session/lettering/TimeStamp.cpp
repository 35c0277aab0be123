#include "session/lettering/TimeStamp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/Scene.h"

namespace velum::session {

namespace {

constexpr double kLongestInSeconds = 120.0, kLongestInMinutes = 7200.0;
constexpr double kLeastStep = 0.01;  // in a unit; of shorter steps the next smaller unit is taken
constexpr double kLongest = 1e12;    // seconds; longer ones come of damage
constexpr int kMostDecimals = 3;

/// Decimals by which multiples of a number are told apart, and shown exactly where one more does that.
int decimalsOf(double step) {
  int decimals = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, kMostDecimals);
  double digits = step * std::pow(10.0, decimals);
  bool isExact = std::abs(digits - std::round(digits)) < 1e-6 * digits;
  return std::min(decimals + (isExact ? 0 : 1), kMostDecimals);
}

/// "2:05.4 min" or "1:02:05 h". @param withHours  whether all steps have hours
std::string clockText(double time, int decimals, bool withHours) {
  double part = std::pow(10.0, decimals), rounded = std::round(time * part) / part;
  auto minutes = std::uint64_t((rounded + 0.1 / part) / 60.0);
  double seconds = std::max(0.0, rounded - 60.0 * double(minutes));
  std::string tail = fmt::format("{:0{}.{}f}", seconds, decimals == 0 ? 2 : 3 + decimals, decimals);
  if (!withHours) return fmt::format("{}:{} min", minutes, tail);
  return fmt::format("{}:{:02}:{} h", minutes / 60, minutes % 60, tail);
}

}  // namespace

std::string timeText(int step, int steps, double seconds) {
  double end = seconds * std::max(steps - 1, step), time = seconds * step;
  if (end > kLongestInSeconds && seconds >= kLeastStep)
    return clockText(time, decimalsOf(seconds), end >= kLongestInMinutes);
  double unit = 1.0;
  const char* name = "s";
  for (const char* smaller : {"ms", "\u00b5s", "ns"}) {
    if (seconds >= kLeastStep * unit) break;
    unit *= 1e-3, name = smaller;
  }
  return fmt::format("{:.{}f} {}", time / unit, decimalsOf(seconds / unit), name);
}

std::optional<TimeStamp> timeStampOf(const scene::Scene& scene) {
  const auto& volume = scene.volume.data;
  if (!volume || volume->timeSteps < 2) return std::nullopt;
  int steps = volume->timeSteps, step = std::clamp(scene.volume.timeStep, 0, steps - 1);
  double seconds = volume->timeStepSeconds;
  auto textOf = [&](int of) {
    bool isKnown = seconds > 0.0 && seconds * steps < kLongest;
    return isKnown ? timeText(of, steps, seconds) : fmt::format("step {} of {}", of + 1, steps);
  };
  return TimeStamp{textOf(step), textOf(steps - 1)};
}

}  // namespace velum::session
