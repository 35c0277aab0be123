#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

namespace velum {

/// What a shell's command writes to its standard output, bytes and all; empty where it fails.
inline std::string outputOf(const std::string& command) {
  std::string out;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  if (!pipe) return out;
  char part[4096];
  for (std::size_t count; (count = std::fread(part, 1, sizeof part, pipe)) > 0;) out.append(part, count);
  return ::pclose(pipe) == 0 ? out : std::string();
}

/// ffmpeg and ffprobe are there: Debian's package ffmpeg.
inline bool hasFfmpeg() {
  return std::system("ffmpeg -version >/dev/null 2>&1 && ffprobe -version >/dev/null 2>&1") == 0;
}

}  // namespace velum
