#pragma once
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/Task.h"
#include "gpu/Context.h"
#include "scene/SceneFwd.h"
#include "session/Session.h"
#include "session/command/Command.h"

/// What the verbs share: options that all of them take, opening what they name, progress and reports.
namespace velum::app {

using Json = nlohmann::ordered_json;

/// What every verb takes.
struct Common {
  bool json = false;
  bool verbose = false;
  gpu::ContextKind context = gpu::ContextKind::Auto;
};

/// What verbs that open data take.
struct InputOptions {
  std::vector<std::string> inputs;
  std::vector<std::string> sets;  ///< path=value
  std::string series, preset, finish, transfer, view, labels;
  bool hidesTable = false, makesSurface = false;
  std::vector<double> spacing;
  std::optional<bool> smooth;
  std::string raw;  ///< "XxYxZ:type[:be][:+header]"
};

void addCommon(CLI::App& verb, Common& common);
void addInput(CLI::App& verb, InputOptions& input, bool withScene);
/// The first input's source, with the reading options applied.
scene::Source firstSource(const InputOptions& input);
/// Opens all inputs in a session and runs the commands that the options stand for: preset, transfer function, surface,
/// table, view, finish and --set, in this order; then lets all that grows come to rest. Shows progress on a terminal.
/// @param aspect  of the picture that is to hold what is opened
void openInputs(session::Session& session, const InputOptions& input, double aspect);
/// With which words of a command an error begins, and the option that was meant.
using Words = std::vector<std::pair<std::string, std::string>>;
/// Runs a command and says what there is to say of it. @throw as session::run(), in the words of the options
void run(session::Session& session, const session::Call& call, Words options = {});
/// Refuses an output that cannot be written, before the work for it begins. @param path  empty: none is asked for; -:
/// standard output  @param expectFormat  of its extension, as io::expectImageFormat()  @throw InputError
void expectOutput(const std::string& path, void (*expectFormat)(const std::filesystem::path&) = nullptr);
/// A progress that writes one line to a terminal's stderr, and is cancelled by stopOnSignals().
Progress& consoleProgress();
/// From now on SIGINT, SIGTERM and SIGHUP cancel the progress, so that what is half done is put away; the second ends
/// the process at once.
void stopOnSignals();
/// The one that stopped it; SIGALRM: stopAfter() did.
int stopSignal();
/// The same after so many seconds; 0: never.
void stopAfter(double seconds);
/// So many numbers with commas between them. @param form  for people, as "x,y,z"  @throw ArgumentError
std::vector<double> numbersOf(const char* option, const std::string& text, std::size_t count, const char* form);
/// Lets no option of a verb be NaN or infinite.
void finiteNumbersOnly(CLI::App& verb);
/// Each as a line "warning: PATH: ..." on stderr.
void printWarnings(const std::string& path, const std::vector<std::string>& warnings);
/// Bytes that are not UTF-8, as paths may hold, become the replacement character. @param to  stdout or stderr
void printJson(const Json& json, std::FILE* to = stdout);

}  // namespace velum::app
