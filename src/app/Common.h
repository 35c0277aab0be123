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

/// What the verbs share: options that all of them take, opening what they name, progress and reports.
namespace velum::app {

using Json = nlohmann::ordered_json;

/// What every verb takes.
struct Common {
  bool json = false;
  bool verbose = false;
  gpu::ContextKind context = gpu::ContextKind::Auto;
};

void addCommon(CLI::App& verb, Common& common);
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
