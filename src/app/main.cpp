#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "app/Verbs.h"
#include "core/Error.h"
#include "core/GuardWrites.h"
#include "core/Log.h"
#include "core/NearestName.h"
#include "core/Text.h"
#include "gpu/SoftwareDriver.h"
#include "scene/Scene.h"

namespace {

using Verbs = std::vector<std::pair<CLI::App*, velum::app::Run>>;

/// The error for a first word that is no verb; empty where the word is a verb, or an option.
std::string unknownVerb(int argc, char** argv, const Verbs& verbs) {
  std::string word = argc > 1 ? argv[1] : "";
  std::vector<std::string> names;
  for (const auto& [verb, run] : verbs) names.push_back(verb->get_name());
  if (word.empty() || word[0] == '-' || std::find(names.begin(), names.end(), word) != names.end()) return {};
  std::string meant = velum::nearestName(word, names);
  return fmt::format("there is no verb '{}'{}; verbs are {}", velum::printable(word),
                     meant.empty() ? "" : fmt::format(" (is '{}' meant?)", meant), fmt::join(names, ", "));
}

struct Row {
  const char* name;
  const char* doc;
  velum::app::Run (*registerVerb)(CLI::App&);
};
constexpr Row kVerbs[] = {
    {"info", "say what a file is", velum::app::registerInfo},
    {"render", "make a picture", velum::app::registerRender},
    {"film", "make a film: a video, or pictures that several machines draw", velum::app::registerFilm},
    {"each", "the same picture or table of many data sets, on many machines", velum::app::registerEach},
    {"membrane", "settle the membranes of a scene and report", velum::app::registerMembrane},
    {"grow", "grow a structure out of a volume, and report", velum::app::registerGrow},
    {"count", "say how much of a model or of structures shows, is hidden, is cut away", velum::app::registerCount},
    {"measure", "lengths, areas, volumes and values of marks and structures, as a table", velum::app::registerMeasure},
    {"bench", "turn the camera and time frames", velum::app::registerBench},
    {"compare", "picture against picture", velum::app::registerCompare},
    {"sample", "make a phantom with ground truth", velum::app::registerSample},
    {"convert", "between formats of volumes and labels; labels to surfaces", velum::app::registerConvert},
    {"recover", "unsaved work of sessions that have died", velum::app::registerRecover},
    {"run", "a script of commands", velum::app::registerRunScript},
    {"help", "the commands of scripts", velum::app::registerHelp},
    {"view", "a bare window", velum::app::registerView},
    {"completion", "what a shell needs to complete these words", velum::app::registerCompletion}};

/// What draws in a window begins once more where its driver is too old; pictures and counts see to it by themselves.
int runOnSomeDriver(const velum::app::Run& run, char* const* arguments) {
  try {
    return run();
  } catch (const velum::gpu::TooOld& error) {
    velum::gpu::startOnSoftware(error, arguments);
  }
}

}  // namespace

/// velum-batch: every verb of Velum without a display. Errors are one line on stderr; exit codes are those of ExitCode.
int main(int argc, char** argv) {
  using namespace velum;
  guardWrites();
  CLI::App program("velum-batch: volumes, cut open. Not a medical device.");
  program.set_version_flag("--version", VELUM_VERSION);
  program.footer(
      "Each verb says its options: velum-batch VERB --help. A file that is called - is standard input.\n"
      "Exit codes: 0 done, 1 the command line is wrong, 2 an input cannot be read or an output not be written,\n"
      "3 there is no graphics driver that will do, 4 pictures differ (compare), 128 and more: stopped by a signal\n"
      "(142: after --timeout).");
  program.require_subcommand(1);
  Verbs verbs;
  for (const Row& row : kVerbs) {
    CLI::App* verb = program.add_subcommand(row.name, row.doc);
    verbs.emplace_back(verb, row.registerVerb(*verb));
    app::finiteNumbersOnly(*verb);
  }
  // Their options: help and version are no errors.
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);
    std::string_view what = error.what();
    std::string stranger = unknownVerb(argc, argv, verbs);
    log::say(fmt::format("velum-batch: {}; see velum-batch --help",
                         stranger.empty() ? what.substr(0, what.find('\n')) : stranger));
    return static_cast<int>(ExitCode::Usage);
  }
  // The one that was asked for; every error becomes one line and its exit code.
  app::stopOnSignals();
  try {
    for (auto& [verb, run] : verbs) {
      if (!verb->parsed()) continue;
      if (auto* verbose = verb->get_option_no_throw("--verbose"); verbose && verbose->count() > 0)
        log::setVerbose(true);
      int code = runOnSomeDriver(run, argv);
      if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw InputError("standard output: cannot be written; check the free space");
      return code;
    }
  } catch (const Cancelled&) {
    bool isTimeout = app::stopSignal() == SIGALRM;
    log::say(fmt::format("velum-batch: stopped{}", isTimeout ? " after the time that --timeout allows" : ""));
    return 128 + app::stopSignal();
  } catch (const Error& error) {
    log::say(fmt::format("velum-batch: {}", error.what()));
    return static_cast<int>(error.exitCode());
  } catch (const std::bad_alloc&) {
    log::say("velum-batch: the machine has no memory left for this; use a smaller volume or picture");
    return static_cast<int>(ExitCode::Input);
  } catch (const std::exception& error) {
    log::say(fmt::format("velum-batch: {}", error.what()));
    return static_cast<int>(ExitCode::Input);
  }
  return 0;
}
