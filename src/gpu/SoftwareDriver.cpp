#include "gpu/SoftwareDriver.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>

#include "core/Log.h"

namespace velum::gpu {

namespace {

/// Says to the program that it has been started once more, and why.
constexpr const char* kTooOld = "VELUM_TOO_OLD";
constexpr const char* kMesasEgl = "/usr/share/glvnd/egl_vendor.d/50_mesa.json";

}  // namespace

std::string softwareInstead(const std::string& tooOld) {
  return fmt::format(
      "{}, and OpenGL 4.5 is needed: Mesa's software driver draws instead, which is slower; install or update the "
      "graphics driver to draw with the card",
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

std::string softwareReason() {
  const char* reason = std::getenv(kTooOld);
  return reason ? reason : "";
}

void startOnSoftware(const TooOld& error, char* const* arguments) {
  if (std::string first = softwareReason(); !first.empty()) throw GpuError(nothingInstead(first, error.what()));
  ::setenv(kTooOld, error.what(), 1);
  ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  ::setenv("GALLIUM_DRIVER", "llvmpipe", 1);
  ::unsetenv("MESA_LOADER_DRIVER_OVERRIDE");
  // Where a driver of the card's maker stands beside Mesa's.
  ::setenv("__GLX_VENDOR_LIBRARY_NAME", "mesa", 1);
  if (::access(kMesasEgl, R_OK) == 0) ::setenv("__EGL_VENDOR_LIBRARY_FILENAMES", kMesasEgl, 1);
  const char* launcher = std::getenv("VELUM_LAUNCHER");  // where the program does not start by itself
  ::execv(launcher ? launcher : "/proc/self/exe", arguments);
  throw GpuError(nothingInstead(error.what(), {}));
}

}  // namespace velum::gpu
