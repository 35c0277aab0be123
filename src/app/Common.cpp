#include "app/Common.h"

#include <fmt/format.h>
#include <sys/time.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <utility>

#include "core/Error.h"
#include "core/Log.h"
#include "core/ReplaceFile.h"
#include "core/Text.h"
#include "io/stores/WriteStore.h"

namespace velum::app {

void addCommon(CLI::App& verb, Common& common) {
  verb.add_flag("--json", common.json, "report as JSON on stdout");
  verb.add_flag("--verbose", common.verbose, "say what is being done, on stderr");
  static const std::map<std::string, gpu::ContextKind> kKinds{
      {"auto", gpu::ContextKind::Auto}, {"egl", gpu::ContextKind::Egl}, {"osmesa", gpu::ContextKind::OsMesa}};
  verb.add_option("--context", common.context, "how to draw without a display: auto, egl, osmesa")
      ->transform(CLI::CheckedTransformer(kKinds, CLI::ignore_case));
}

namespace {

bool isTerminal() {
  static bool terminal = isatty(STDERR_FILENO) != 0;
  return terminal;
}

/// Work that is asked to stop has so many seconds before the process is ended.
constexpr int kPatienceSeconds = 10;

volatile std::sig_atomic_t gSignal = 0;

void onStop(int signal) {
  gSignal = signal;
  consoleProgress().cancel();
}

}  // namespace

Progress& consoleProgress() {
  static Progress progress([](double fraction, const std::string& what) {
    if (!isTerminal()) return;
    std::fprintf(stderr, "\r%s %3.0f %%\x1b[K", printable(what).c_str(), fraction * 100.0);
    if (fraction >= 1.0) std::fprintf(stderr, "\r\x1b[K");
    std::fflush(stderr);
  });
  return progress;
}

void finiteNumbersOnly(CLI::App& verb) {
  CLI::Validator finite(
      [](const std::string& text) {
        auto number = numberIn(text);
        return number && std::isfinite(*number) ? std::string() : fmt::format("{} is not a number of use here", text);
      },
      "");
  for (CLI::Option* option : verb.get_options())
    if (option->get_type_name().find("FLOAT") != std::string::npos) option->check(finite);
}

namespace {

/// Cancels the progress, as a signal does; 0: never.
void stopAfter(double seconds) {
  if (seconds <= 0) return;
  itimerval timer{};
  timer.it_value.tv_sec = time_t(seconds);
  timer.it_value.tv_usec = suseconds_t((seconds - std::floor(seconds)) * 1e6);
  timer.it_interval.tv_sec = kPatienceSeconds;  // the second alarm ends the process
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

}  // namespace

Run withTimeout(CLI::App& verb, Run work) {
  auto seconds = std::make_shared<double>(0.0);
  verb.add_option("--timeout", *seconds, "give up after so many seconds, with exit code 142; 0: never")
      ->check(CLI::Range(0.0, 1e6));
  return [seconds, work = std::move(work)] {
    stopAfter(*seconds);
    return work();
  };
}

void stopOnSignals() {
  consoleProgress();  // made here, as a signal handler must not make it
  struct sigaction action {};
  action.sa_handler = onStop;
  action.sa_flags = int(SA_RESETHAND);  // a second signal ends the process at once
  for (int signal : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) {
    struct sigaction before {};
    ::sigaction(signal, &action, &before);
    // nohup, and shells for jobs in the background, want the signal to be ignored.
    if (before.sa_handler == SIG_IGN) ::sigaction(signal, &before, nullptr);
  }
}

int stopSignal() { return gSignal != 0 ? gSignal : SIGINT; }

void expectOutput(const std::string& path, void (*expectFormat)(const std::filesystem::path&)) {
  if (path.empty()) return;
  if (expectFormat) expectFormat(path);
  if (io::isStoreFormat(path))
    io::expectStoreWritable(path);
  else if (path != "-")
    expectReplaceable(path);
}

std::vector<double> numbersOf(const char* option, const std::string& text, std::size_t count, const char* form) {
  std::vector<double> numbers;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, ',');) {
    numbers.push_back(numberIn(part).value_or(std::nan("")));
    if (!std::isfinite(numbers.back())) numbers.resize(count + 1);
  }
  if (numbers.size() != count) throw ArgumentError(fmt::format("{} {}: give {}", option, text, form));
  return numbers;
}

void printWarnings(const std::string& path, const std::vector<std::string>& warnings) {
  for (const std::string& line : warnings) log::warning(fmt::format("{}: {}", path, line));
}

void printJson(const Json& json, std::FILE* to) {
  std::fprintf(to, "%s\n", json.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
}

}  // namespace velum::app
