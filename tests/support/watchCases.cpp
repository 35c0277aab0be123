// A case that takes longer than any does hangs: it ends its program, with its name.
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>

namespace velum {
namespace {

/// Of any case, also where a sanitizer makes it ten times slower.
constexpr unsigned kLongestS = 300;

std::string& lastWords() {
  static std::string words;
  return words;
}

extern "C" void endProgram(int) {
  const std::string& words = lastWords();
  if (::write(STDERR_FILENO, words.data(), words.size()) < 0) _exit(2);
  _exit(1);
}

class WatchCases : public testing::EmptyTestEventListener {
  void OnTestStart(const testing::TestInfo& info) override {
    lastWords() = std::string(info.test_suite_name()) + "." + info.name() + " hangs: it has run for " +
                  std::to_string(kLongestS) + " s\n";
    std::signal(SIGALRM, endProgram);
    ::alarm(kLongestS);
  }
  void OnTestEnd(const testing::TestInfo&) override { ::alarm(0); }
};

[[maybe_unused]] const bool kIsWatched = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new WatchCases);
  return true;
}();

}  // namespace
}  // namespace velum
