#include <fmt/chrono.h>
#include <fmt/format.h>

#include <filesystem>

#include "app/Verbs.h"
#include "core/Error.h"
#include "core/Log.h"
#include "session/document/Folders.h"
#include "session/document/Open.h"
#include "session/document/Recovery.h"

namespace velum::app {

namespace {

namespace fs = std::filesystem;

struct RecoverOptions {
  Common common;
  std::string name, output;
  bool list = false, discard = false;
};

std::string localTime(std::chrono::system_clock::time_point when) {
  return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::localtime(std::chrono::system_clock::to_time_t(when)));
}

std::string sayProblem(const session::LostWork& work) {
  if (work.isReadable && work.isWhole) return {};
  return fmt::format("  {}, in {}: {}", work.isReadable ? "what came later cannot be read" : "it cannot be read",
                     work.folder.string(), work.whyNot);
}

void printList(const std::vector<session::LostWork>& lost, bool json) {
  Json rows = Json::array();
  for (const auto& work : lost) {
    std::string name = work.folder.filename().string();
    rows.push_back({{"name", name},
                    {"title", work.title},
                    {"scene", work.scenePath},
                    {"lastChange", work.label},
                    {"time", localTime(work.when)},
                    {"readable", work.isReadable},
                    {"whole", work.isWhole},
                    {"problem", work.whyNot},
                    {"folder", work.folder.string()}});
    if (json) continue;
    fmt::print("{}  {}  {}{}{}\n", name, localTime(work.when), work.isReadable ? work.title : "unreadable",
               work.label.empty() ? "" : fmt::format(" ({})", work.label), sayProblem(work));
  }
  if (json)
    printJson({{"work", rows}});
  else if (lost.empty())
    fmt::print("no unsaved work was left behind\n");
}

const session::LostWork& choose(const std::vector<session::LostWork>& lost, const std::string& name) {
  for (const auto& work : lost) {
    if (!name.empty() && work.folder.filename() != name) continue;
    if (!work.isReadable || !work.isWhole)
      log::warning(fmt::format("{} of {}{}", work.folder.filename().string(), localTime(work.when), sayProblem(work)));
    if (!name.empty() || work.isReadable) return work;
  }
  if (name.empty() && !lost.empty())
    throw InputError("recover: of the unsaved work that was left behind none can be read");
  if (name.empty()) throw InputError("recover: no unsaved work was left behind");
  throw InputError(fmt::format("recover: there is no unsaved work '{}'; see velum-batch recover --list", name));
}

int run(const RecoverOptions& options) {
  if (!options.list && !options.discard && options.output.empty())
    throw ArgumentError("recover: give --list, -o FILE or --discard");
  if (options.discard && options.name.empty())
    throw ArgumentError("recover: name what to discard; see velum-batch recover --list");
  auto lost = session::findLostWork(session::recoveryFolder());
  if (options.list) {
    printList(lost, options.common.json);
    return 0;
  }
  session::WorkClaim claim(choose(lost, options.name).folder);
  if (!options.output.empty()) session::saveScene(claim.readScene(), options.output);
  if (options.discard) claim.remove();
  return 0;
}

}  // namespace

Run registerRecover(CLI::App& verb) {
  auto options = std::make_shared<RecoverOptions>();
  addCommon(verb, options->common);
  verb.add_option("name", options->name, "which work, as --list names it; default: the newest");
  verb.add_flag("--list", options->list, "list the unsaved work of sessions that have died");
  verb.add_option("-o,--output", options->output, "scene file to write it to; the work stays until --discard");
  verb.add_flag("--discard", options->discard, "delete the named work (with -o: once it is written)");
  return [options] { return run(*options); };
}

}  // namespace velum::app
