#include "core/Log.h"

#include <atomic>
#include <cstdio>
#include <string>

#include "core/Text.h"

namespace velum::log {

namespace {
std::atomic<bool> isVerbose = false;
}

void setVerbose(bool verbose) { isVerbose = verbose; }
void info(std::string_view message) {
  if (isVerbose) say(message);
}
void say(std::string_view line) {
  std::string text = printable(line) + '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}
void warning(std::string_view message) { say("warning: " + std::string(message)); }

}  // namespace velum::log
