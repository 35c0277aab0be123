#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <thread>

#include "app/EachPiece.h"
#include "app/TaskPart.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "core/SayCount.h"
#include "core/Text.h"
#include "io/stores/Crc32c.h"
#include "session/each/OutputLocks.h"
#include "session/each/PieceRecord.h"
#include "session/film/FrameNames.h"

namespace velum::app {

namespace {

/// So often a piece may end the process that makes it before it counts as failed.
constexpr int kMostDeaths = 3;
/// So often is asked for pieces that other processes make.
constexpr auto kAskAgainAfter = std::chrono::milliseconds(200);

std::string textOfFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read", path));
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What all pieces depend on besides their data.
session::FilmIdentity commonIdentity(const EachVerb& options) {
  session::FilmIdentity identity{{"version", VELUM_VERSION},
                                 {"words", fmt::format("{}", fmt::join(options.words, " "))}};
  for (const auto& [name, path] : {std::pair("scene", options.scene), {"transfer", options.input.transfer}}) {
    if (path.empty()) continue;
    std::string text = textOfFile(path);
    identity.emplace_back(name, fmt::format("{:08x}", io::crc32c(std::as_bytes(std::span(text)))));
  }
  return identity;
}

session::FilmIdentity identityOf(session::FilmIdentity common, const session::Piece& piece) {
  common.emplace_back("data", fmt::format("{}: {}", piece.data, session::dataStamp(piece.data)));
  if (!piece.labels.empty())
    common.emplace_back("labels", fmt::format("{}: {}", piece.labels, session::dataStamp(piece.labels)));
  return common;
}

/// Counts, for the end and the exit code.
struct Tally {
  int done = 0, kept = 0, failed = 0;
  std::string firstError;
};

/// An error that says in any case whose it is.
std::string withData(const session::Piece& piece, const std::string& error) {
  return error.starts_with(piece.data) ? error : fmt::format("{}: {}", piece.data, error);
}

/// A line of JSON a piece, as soon as it is known; else lines for people.
void tell(const EachVerb& options, const session::Piece& piece, const char* state, double ms,
          const std::string& error) {
  std::vector<std::string> outputs;
  for (const auto& path : piece.outputs) outputs.push_back(path.string());
  if (options.common.json) {
    Json json = {{"name", piece.name}, {"data", piece.data}, {"state", state}, {"outputs", outputs}};
    if (ms > 0.0) json["ms"] = ms;
    if (!error.empty()) json["error"] = error;
    fmt::print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
  } else if (options.list) {
    fmt::print("{:<8} {}\n", state, error.empty() ? printable(piece.data) : withData(piece, error));
  } else if (!error.empty()) {
    log::warning(withData(piece, error));
  }
  std::fflush(stdout);
}

void fail(const EachVerb& options, const session::Piece& piece, Tally& tally, double ms, const std::string& error) {
  ++tally.failed;
  if (tally.firstError.empty()) tally.firstError = withData(piece, error);
  tell(options, piece, "failed", ms, error);
}

void makeAndRecord(const EachVerb& options, PieceMaker& maker, const session::Piece& piece,
                   const session::FilmIdentity& wanted, Tally& tally) {
  auto start = Clock::now();
  session::PieceRecord record(piece.record);
  record.begin(wanted);
  try {
    maker.make(piece);
    record.done(msSince(start), piece.outputs);
  } catch (const Cancelled&) {
    record.stopped();
    throw;
  } catch (const std::exception& error) {
    std::string why = dynamic_cast<const std::bad_alloc*>(&error) ? "the machine has no memory left" : error.what();
    record.failed(msSince(start), why);
    return fail(options, piece, tally, msSince(start), why);
  }
  ++tally.done;
  tell(options, piece, "done", msSince(start), {});
}

bool hasDied(const session::PieceState& state) {
  return state.is == session::PieceState::Is::Begun && state.begun >= kMostDeaths;
}
std::string whyDied(const session::PieceState& state) {
  return fmt::format("{} processes have ended while they made this; --retry tries once more", state.begun);
}

/// @return whether it is done already
bool isKept(const EachVerb& options, const session::Piece& piece, const session::PieceState& state, Tally& tally) {
  if (state.is != session::PieceState::Is::Done) return false;
  ++tally.kept;
  tell(options, piece, "kept", state.ms, {});
  return true;
}

/// @param isAnew  makes it whether it is done or not  @return false while another process makes one of its files
bool workAt(const EachVerb& options, PieceMaker& maker, const session::FilmIdentity& common,
            const session::Piece& piece, bool isAnew, Tally& tally) try {
  session::FilmIdentity wanted = identityOf(common, piece);
  auto now = [&] { return session::stateOf(piece.record, wanted, piece.outputs); };
  if (!isAnew && isKept(options, piece, now(), tally)) return true;
  auto locks = session::OutputLocks::take(piece.outputs);
  if (!locks) return false;
  session::PieceState state = now();  // what another process has made of it meanwhile
  if (!isAnew && isKept(options, piece, state, tally)) return true;
  if (!isAnew && !options.retry && hasDied(state)) return fail(options, piece, tally, 0.0, whyDied(state)), true;
  makeAndRecord(options, maker, piece, wanted, tally);
  return true;
} catch (const InputError& error) {
  return fail(options, piece, tally, 0.0, error.what()), true;
}

/// What other processes were making when it was asked for is there in the end, too: what they leave undone is made
/// here.
void waitFor(const EachVerb& options, PieceMaker& maker, const session::FilmIdentity& common,
             std::vector<session::Piece> others, Tally& tally) {
  if (others.empty()) return;
  log::say(sayCount(others.size(), "note: waiting for 1 piece that another process makes",
                    "note: waiting for {} pieces that other processes make"));
  for (;;) {
    std::erase_if(others,
                  [&](const session::Piece& piece) { return workAt(options, maker, common, piece, false, tally); });
    if (others.empty()) return;
    consoleProgress().throwIfCancelled();
    std::this_thread::sleep_for(kAskAgainAfter);
  }
}

/// Every so many-th piece is of a part. Says so where that is none.
std::vector<session::Piece> piecesOf(const TaskPart& task, const std::vector<session::Piece>& all) {
  std::vector<session::Piece> mine;
  for (std::size_t i = std::size_t(task.part.number) - 1; i < all.size(); i += std::size_t(task.part.parts))
    mine.push_back(all[i]);
  if (!mine.empty()) return mine;
  std::string none =
      sayCount(all.size(), "part {1} of {2} has nothing to do, as there is 1 piece",
               "part {1} of {2} has nothing to do, as there are {0} pieces", task.part.number, task.part.parts);
  if (task.task.empty())
    log::say(fmt::format("note: {}", none));
  else
    log::warning(fmt::format("{}: {}; where each task has data of its own, say --part 1/1", task.task, none));
  return mine;
}

void list(const EachVerb& options, const session::FilmIdentity& common, const std::vector<session::Piece>& pieces) {
  constexpr const char* kNames[] = {"missing", "begun", "failed", "done"};
  for (const session::Piece& piece : pieces) {
    session::PieceState state;
    try {
      state = session::stateOf(piece.record, identityOf(common, piece), piece.outputs);
    } catch (const InputError& error) {
      state = {session::PieceState::Is::Failed, 0, error.what(), 0.0};
    }
    if (hasDied(state)) state = {session::PieceState::Is::Failed, 0, whyDied(state), 0.0};
    tell(options, piece, kNames[int(state.is)], state.ms, state.error);
  }
}

void expectEach(const EachVerb& options) {
  pictureOf(options.drawn), sectionOf(options.drawn);
  for (const std::string& output : options.names.outputs)
    if (!isTable(output)) session::expectPictureFormat(output);
  bool readsOwnWay = !options.input.series.empty() || !options.input.raw.empty() || !options.input.spacing.empty() ||
                     options.input.level != scene::kFittingLevel;
  if (!options.scene.empty() && readsOwnWay)
    throw ArgumentError("--series, --raw, --spacing and --level are for data without --scene");
  if (!options.by.empty() && options.input.labels.empty())
    throw ArgumentError("--by: a structure is found in labels; give those of each data set with --labels");
}

int run(EachVerb options) {
  expectEach(options);
  options.names.data = options.input.inputs;
  options.names.labels = options.input.labels;
  std::vector<session::Piece> pieces = session::findPieces(options.names);
  session::FilmIdentity common = commonIdentity(options);
  const std::vector<session::Piece> mine = piecesOf(taskPart(options.part), pieces);
  if (options.list) return list(options, common, mine), 0;
  if (mine.empty()) return 0;
  PieceMaker maker(options);
  Tally tally;
  std::vector<session::Piece> others;
  for (std::size_t i = 0; i < mine.size(); ++i) {
    consoleProgress().throwIfCancelled();
    consoleProgress().report(double(i) / double(mine.size()),
                             fmt::format("{} ({} of {})", mine[i].name, i + 1, mine.size()));
    if (!workAt(options, maker, common, mine[i], options.again, tally)) others.push_back(mine[i]);
  }
  consoleProgress().report(1.0, "");
  waitFor(options, maker, common, std::move(others), tally);
  if (tally.failed == 0) return 0;
  throw InputError(fmt::format("{} of {} pieces failed, {} could be made; the first: {}", tally.failed, mine.size(),
                               tally.done + tally.kept, tally.firstError));
}

/// The words of the command line on which pieces depend: all but those that say which pieces, and how to report.
std::vector<std::string> wordsOf(const CLI::App& verb) {
  std::vector<std::string> words;
  for (const CLI::Option* option : verb.get_options()) {
    std::string name = option->get_name();
    bool isOfRun = name == "input" || name == "--output" || name == "--part" || name == "--records" ||
                   name == "--again" || name == "--retry" || name == "--list" || name == "--json" ||
                   name == "--verbose" || name == "--timeout" || name == "--scene";
    if (isOfRun || option->count() == 0) continue;
    words.push_back(name);
    for (const std::string& value : option->results()) words.push_back(value);
  }
  return words;
}

}  // namespace

Run registerEach(CLI::App& verb) {
  auto options = std::make_shared<EachVerb>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.get_option("input")
      ->description("data sets: files, DICOM folders, or patterns in quotes: 'studies/*/ct.nii.gz'")
      ->required();
  verb.get_option("--labels")->description("labels of each: studies/{name}/labels.nii.gz");
  verb.add_option("--scene", options->scene,
                  "a scene that is carried over to each: camera and cuts go by the data's box, curves by modality");
  verb.add_option("--by", options->by, "name of a structure of both labels by which the scene goes, not the box");
  verb.add_option("-o,--output", options->names.outputs,
                  "what to make of each: a picture (.png, .tif, .exr, .svg, .pdf), or a table of all marks (.csv, "
                  ".json); {name} is what the pattern's * stands for, {dir} the data's folder; repeatable")
      ->allow_extra_args(false)
      ->required();
  verb.add_option("--part", options->part,
                  "K/N: the K-th of N parts, every N-th piece; default: all, in a task of a Slurm array the task's");
  verb.add_option("--records", options->names.records,
                  "folder for what became of each piece; default: pieces, beside the outputs");
  verb.add_flag("--again", options->again, "make all anew, also what is done");
  verb.add_flag("--retry", options->retry, "try once more what has ended its process three times");
  verb.add_flag("--list", options->list,
                "make nothing: say of each piece whether it is done, failed and why, or missing");
  verb.add_flag("--structures", options->structures, "tables hold what the cuts leave of each structure, too");
  verb.add_flag("--faces", options->faces, "tables hold the areas of the cuts' faces, too");
  addDrawn(verb, options->drawn);
  verb.add_flag("--transparent", options->drawn.picture.transparent, "no background, with alpha");
  addLettering(verb, options->lettering);
  verb.footer(
      "Exit codes: 0 all pieces of the part are there, whoever made them, also where it has none; 2 some failed.");
  return withTimeout(verb, [options, &verb] {
    options->words = wordsOf(verb);
    return run(*options);
  });
}

}  // namespace velum::app
