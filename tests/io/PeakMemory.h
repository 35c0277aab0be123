#pragma once
#include <cstddef>
#include <fstream>
#include <string>

namespace velum::io {

/// A number of /proc/self/status ("VmRSS", "VmHWM") in bytes; 0 where there is none.
inline std::size_t statusBytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stoul(line.substr(key.size() + 1)) * 1024;
  return 0;
}

/// How many bytes more than before were resident at a time while @p work ran. 0 under AddressSanitizer, which keeps
/// what was freed.
template <class Work>
std::size_t peakGrowth(Work&& work) {
  std::ofstream("/proc/self/clear_refs") << "5";  // sets the high-water mark back
  std::size_t before = statusBytes("VmRSS");
  work();
#ifdef __SANITIZE_ADDRESS__
  return 0;
#endif
  std::size_t peak = statusBytes("VmHWM");
  return peak > before ? peak - before : 0;
}

}  // namespace velum::io
