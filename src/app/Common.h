#pragma once
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "gpu/Context.h"

/// What the verbs share: the options that every verb takes, checks of the outputs that they name, progress and reports.
namespace velum::app {

using Json = nlohmann::ordered_json;
/// Does a verb's work and returns the exit code.
using Run = std::function<int()>;

/// The options that every verb takes.
struct Common {
  bool json = false;
  bool verbose = false;
  gpu::ContextKind context = gpu::ContextKind::Auto;
};

void addCommon(CLI::App& verb, Common& common);
/// Refuses an output that cannot be written, before the work for it begins. @param path  of the output; empty: no
/// output is asked for; "-": standard output  @param expectFormat  checks the path's extension, as
/// io::expectImageFormat() does; null: no check  @throw InputError
void expectOutput(const std::string& path, void (*expectFormat)(const std::filesystem::path&) = nullptr);
/// A progress that writes one line to a terminal's stderr, and is cancelled by stopOnSignals().
Progress& consoleProgress();
/// From now on SIGINT, SIGTERM, SIGHUP and the alarm of --timeout cancel consoleProgress(), so that half-done outputs
/// are put away; a second signal of the same kind ends the process at once.
void stopOnSignals();
/// The signal that cancelled the progress; SIGALRM means that --timeout did.
int stopSignal();
/// Adds the option --timeout. @return the work, which is cancelled after so many seconds as a signal does it
Run withTimeout(CLI::App& verb, Run work);
/// Reads `count` numbers with commas between them from an option's text. @param form  how they are to be written, for
/// the error: "x,y,z"  @throw ArgumentError
std::vector<double> numbersOf(const char* option, const std::string& text, std::size_t count, const char* form);
/// Lets no option of a verb be NaN or infinite.
void finiteNumbersOnly(CLI::App& verb);
/// Prints each warning as a line "warning: PATH: ..." on stderr.
void printWarnings(const std::string& path, const std::vector<std::string>& warnings);
/// Bytes that are not UTF-8, as paths may hold, become the replacement character. @param to  stdout or stderr
void printJson(const Json& json, std::FILE* to = stdout);

}  // namespace velum::app
