#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/Inputs.h"
#include "app/TaskPart.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "render/Renderer.h"
#include "scene/timeline/SceneAt.h"
#include "session/Session.h"
#include "session/command/DocumentCommands.h"
#include "session/command/FilmCommands.h"
#include "session/command/SaveFilm.h"
#include "session/document/Open.h"
#include "session/film/JoinFrames.h"
#include "session/film/MakeFilm.h"
#include "session/film/Retarget.h"

namespace velum::app {

namespace {

struct FilmVerb {
  Common common;
  InputOptions input;
  LetteringOptions lettering;
  std::vector<std::string> animate, retarget, retargetLabels;
  std::string retargetBy;
  DrawnOptions drawn;
  std::string output, part, saveScene;
  int frames = 0;
  double seconds = 0.0, framesPerSecond = 0.0;
  session::FilmOutput made;  ///< filled from the options; where texts are read by filmOutput()
};

session::FilmOutput filmOutput(const FilmVerb& options) {
  session::FilmOutput output = options.made;
  output.path = options.output;
  // A video is whole: an array may make one a task.
  TaskPart task = options.part.empty() && io::isVideo(output.path) ? TaskPart() : taskPart(options.part);
  output.part = task.part;
  if (!task.task.empty())
    log::say(fmt::format("note: {}, so this is part {} of {} of the frames; --part 1/1 draws all", task.task,
                         task.part.number, task.part.parts));
  output.picture = pictureOf(options.drawn);
  output.section = sectionOf(options.drawn);
  if (options.framesPerSecond > 0.0) output.framesPerSecond = options.framesPerSecond;
  return output;
}

/// Brings the film that is asked for into the scene: the scene's own, or ready-made ones in its place.
void chooseFilm(session::Session& session, const FilmVerb& options) {
  if (options.framesPerSecond > 0.0)
    run(session, session::SetField{"timeline.framesPerSecond", fmt::format("{:.17g}", options.framesPerSecond)});
  session::SaveFilm asked;
  asked.animate = options.animate;
  asked.seconds = options.frames > 0 ? options.frames / session.scene().timeline.framesPerSecond : options.seconds;
  const char* timed = options.frames > 0 ? "--frames:" : "--seconds:";
  withOptionsNamed({{"animate", "--animate"}, {"film.", "--animate "}, {"seconds:", timed}}, [&] {
    session.document().replace(session::filmedScene(session.scene(), asked, consoleProgress()));
  });
  for (const std::string& line : scene::tracksThatDoNotFit(session.scene())) log::warning(line);
}

/// Makes a video of the frames that a folder holds. @return nothing where the input is no such folder
std::optional<int> joinFolder(const FilmVerb& options, const session::FilmOutput& output) {
  const auto& inputs = options.input.inputs;
  if (inputs.size() != 1 || !std::filesystem::is_directory(inputs.front())) return std::nullopt;
  auto names = session::namesInFolder(inputs.front());
  if (!names) return std::nullopt;
  int frames = session::joinFrames(
      *names, output.path, {options.framesPerSecond, output.quality, output.picture.transparent}, consoleProgress());
  consoleProgress().report(1.0, "");
  if (options.common.json) printJson({{"frames", frames}, {"output", options.output}});
  return 0;
}

void printFilm(const session::FilmReport& report, const FilmVerb& options, const session::FilmOutput& output,
               const std::string& renderer, double ms) {
  Json json = {{"renderer", renderer},    {"size", {output.picture.size.x, output.picture.size.y}},
               {"frames", report.frames}, {"drawn", report.drawn},
               {"kept", report.kept},     {"totalMs", ms},
               {"output", options.output}};
  for (const auto& [frame, why] : report.failed) json["failed"].push_back({{"frame", frame}, {"error", why}});
  printJson(json);
}

/// What is there of a film that was stopped, or of which frames are missing.
void tellFilm(const session::FilmReport& report, const session::FilmOutput& output, Progress& progress) {
  int there = report.drawn + report.kept;
  bool isVideo = io::isVideo(output.path);
  if (report.isStopped && (!isVideo || there > 0))
    log::say(fmt::format("note: {} holds {} of {} frames{}", output.path.string(), there, report.frames,
                         isVideo ? "" : "; --resume draws the others"));
  progress.throwIfCancelled();
  if (std::string failed = session::failedFrames(report); !failed.empty()) throw InputError(failed);
}

/// Draws the film of a session, and says what has become of it.
void drawFilm(session::Session& session, const FilmVerb& options, const session::FilmOutput& output) {
  if (std::string note = session::filmNote(output); !note.empty()) log::warning(note);
  auto start = Clock::now();
  Progress& progress = consoleProgress();
  session::FilmReport report = session.film(output, progress);
  if (!report.isStopped) progress.report(1.0, "");
  if (options.common.json)
    printFilm(report, options, output, output.section ? "" : session.renderer().stats().renderer, msSince(start));
  tellFilm(report, output, progress);
}

/// The name of data's file without its endings: "scan7" of "in/scan7.nii.gz".
std::string nameOfData(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  return name.substr(0, name.find('.', 1));
}

/// The same film of other data, one after the other. "{}" in the output's name is the data's name.
void drawOfOthers(session::Session& session, const FilmVerb& options, const session::FilmOutput& output) {
  const scene::Scene scene = session.scene();
  for (std::size_t i = 0; i < options.retarget.size(); ++i) {
    session::NewData data{options.retarget[i], {}, options.retargetBy};
    if (!options.retargetLabels.empty()) data.labels = options.retargetLabels[i];
    std::vector<std::string> notes;
    scene::Scene other = session::retargeted(scene, data, consoleProgress(), notes);
    for (const std::string& note : notes) log::say(fmt::format("note: {}: {}", data.volume, note));
    session.document().replace(std::move(other));
    session::FilmOutput own = output;
    std::string path = output.path.string();
    if (std::size_t at = path.find("{}"); at != path.npos) own.path = path.replace(at, 2, nameOfData(data.volume));
    drawFilm(session, options, own);
  }
}

void expectOthers(const FilmVerb& options) {
  std::size_t count = options.retarget.size(), labels = options.retargetLabels.size();
  if (labels > 0 && labels != count)
    throw ArgumentError(fmt::format("--retarget-labels: {} files for {} of --retarget", labels, count));
  if (count > 1 && options.output.find("{}") == options.output.npos)
    throw ArgumentError("--retarget: with several files the output's name needs {}, where each file's name comes");
  if (!options.retargetBy.empty() && (labels == 0))
    throw ArgumentError(
        "--retarget-by: a structure is found in labels; give those of the new data with --retarget-labels");
}

int runFilm(const FilmVerb& options) {
  session::FilmOutput output = filmOutput(options);
  session::expectFilmOutput(output);
  expectOthers(options);
  if (auto code = joinFolder(options, output)) return *code;
  session::Session session;
  session.setContextKind(options.common.context);
  if (!output.section) session.renderer();  // before data is read: without a driver there is no film
  openInputs(session, options.input, double(output.picture.size.x) / output.picture.size.y);
  chooseFilm(session, options);
  writeOver(session, options.lettering);
  output.framesPerSecond = session.scene().timeline.framesPerSecond;
  if (!options.saveScene.empty()) session::saveScene(session.scene(), options.saveScene);
  if (options.retarget.empty())
    drawFilm(session, options, output);
  else
    drawOfOthers(session, options, output);
  return 0;
}

void addRetarget(CLI::App& verb, FilmVerb& options) {
  verb.add_option(
      "--retarget", options.retarget,
      "the same film of other volumes: camera and cuts go by the data's box, curves by modality; of several, "
      "each has a film of its own, whose name has the file's in the place of {}: -o \"{}.mp4\"");
  verb.add_option("--retarget-labels", options.retargetLabels, "labels of these, in the same order");
  verb.add_option("--retarget-by", options.retargetBy,
                  "name of a structure of both labels by which camera and cuts go, in the place of the box");
}

}  // namespace

Run registerFilm(CLI::App& verb) {
  auto options = std::make_shared<FilmVerb>();
  session::FilmOutput& made = options->made;
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("-o,--output", options->output,
                  "what to write: film.mp4 (H.264), .webm (VP9), .gif; a folder FRAMES/ of PNGs; or pictures turn.png, "
                  ".tif, .exr, as turn-0000.png ...")
      ->required();
  addDrawn(verb, options->drawn);
  verb.add_option("--fps", options->framesPerSecond,
                  "frames a second; else as the scene's film says, or what the frames were drawn for")
      ->check(CLI::Range(0.01, 1000.0));
  auto* seconds = verb.add_option("--seconds", options->seconds, "how long a ready-made film lasts")
                      ->check(CLI::Range(0.001, scene::kLongestFilm));
  verb.add_option("--frames", options->frames, "how many frames it has, instead of --seconds")
      ->check(CLI::Range(1, 1000000))
      ->excludes(seconds);
  verb.add_option(
          "--animate", options->animate,
          "a ready-made film in the place of the scene's own: turn (once round; the default where the scene has "
          "no film), time (through the time steps; the default where there are some), cut (cuts come in), membrane "
          "(membranes sink in), pull (structures come out of the cuts one after the other), equalize (a model from "
          "whole to what its cuts leave), fly (to a structure), compare (whole, then cut), title (words); with what "
          "the command of "
          "that name takes: \"turn turns=2 gently=true\"; may be repeated")
      ->allow_extra_args(false);
  addLettering(verb, options->lettering);
  addRetarget(verb, *options);
  verb.add_option("--save-scene", options->saveScene, "write the scene with its film as JSON, too");
  verb.add_option(
      "--part", options->part,
      "K/N: the K-th of N parts of the frames, for several machines; default: all, in a task of a Slurm array the "
      "task's");
  verb.add_flag("--resume", made.old.resume, "draw only frames that are missing, broken or failed");
  verb.add_flag("--overwrite", made.old.overwrite, "write over the frames of another film");
  verb.add_option("--blur", made.blur, "blur what moves: each frame is the mean of so many pictures, 1 to 256")
      ->check(CLI::Range(1, 256));
  verb.add_option("--shutter", made.shutter, "the share of the time between frames that --blur takes, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--quality", made.quality, "of a video, 0 to 100")->check(CLI::Range(0, 100))->capture_default_str();
  verb.add_flag("--transparent", options->drawn.picture.transparent, "no background, with alpha: not in .mp4");
  verb.add_flag("--layers", options->drawn.picture.layers,
                "also alpha, normal, depth and more of each frame, as in render");
  return withTimeout(verb, [options] { return runFilm(*options); });
}

}  // namespace velum::app
