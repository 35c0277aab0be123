#include "gpu/GpuError.h"

#include <fmt/format.h>

#include <atomic>

#include "core/Log.h"

namespace velum::gpu {

std::string softwareInstead(const std::string& tooOld) {
  return fmt::format(
      "{}, and OpenGL 4.5 is needed: Mesa's software driver draws instead, which is slower; install or update the "
      "graphics "
      "driver to draw with the card",
      tooOld);
}

std::string nothingInstead(const std::string& tooOld, const std::string& otherwise) {
  return fmt::format(
      "{}; OpenGL 4.5 is needed: install or update the graphics driver; Mesa's software driver will do, too{}", tooOld,
      otherwise.empty() ? "" : " (it was tried: " + otherwise + ")");
}

void warnOfSoftware(const std::string& tooOld) {
  static std::atomic<bool> isSaid{false};
  if (!isSaid.exchange(true)) log::warning(softwareInstead(tooOld));
}

}  // namespace velum::gpu
