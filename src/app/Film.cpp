#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "render/Renderer.h"
#include "session/Session.h"
#include "session/film/JoinFrames.h"
#include "session/film/MakeFilm.h"
#include "session/picture/Film.h"

namespace velum::app {

namespace {

struct FilmVerb {
  Common common;
  InputOptions input;
  std::string output, size = "1280x720", animate, part = "1/1";
  int frames = 0;
  double seconds = 10.0, framesPerSecond = 0.0, timeout = 0.0;
  session::FilmOutput made;  ///< filled from the options; where texts are read by filmOutput()
};

constexpr double kUsualRate = 25.0;

session::FilmOutput filmOutput(const FilmVerb& options) {
  session::FilmOutput output = options.made;
  output.path = options.output;
  output.part = session::parseFilmPart(options.part);
  output.picture.size = session::parsePictureSize(options.size, output.picture.dpi);
  output.framesPerSecond = options.framesPerSecond > 0.0 ? options.framesPerSecond : kUsualRate;
  return output;
}

int frameCount(const FilmVerb& options, double framesPerSecond) {
  return options.frames > 0 ? options.frames : std::max(1, int(std::lround(options.seconds * framesPerSecond)));
}

session::Motion filmMotion(const FilmVerb& options, const scene::Scene& scene) {
  if (options.animate.empty()) return session::usualMotion(scene);
  if (auto motion = enumValue<session::Motion>(options.animate)) return *motion;
  throw ArgumentError(
      fmt::format("--animate {}: not one of {}", options.animate, fmt::join(EnumNames<session::Motion>::kNames, ", ")));
}

/// Draws the moments of a film in a context. What is between two frames is one of so many fine steps.
session::FrameSource frameSource(const scene::Scene& scene, session::Motion motion, int count,
                                 const session::FilmOutput& output, gpu::Context& context, render::Renderer& renderer) {
  constexpr int kFineSteps = 256;
  int steps = output.blur > 1 ? kFineSteps : 1;
  session::FilmOptions options{output.picture, motion, count * steps};
  auto film = std::make_shared<session::Film>(scene, options);
  return {count, [=, &context, &renderer](int frame, double share, Progress& progress) {
            context.makeCurrent();
            auto at = film->at(std::max(0, int(std::lround((frame + share) * steps))), progress);
            Image image = session::drawPicture(renderer, at.drawn, output.picture, context.limits(), progress);
            return session::FilmFrame{std::move(image), std::move(at.scene)};
          }};
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
  if (report.failed.empty()) return;
  std::vector<int> frames;
  for (const auto& [frame, why] : report.failed) frames.push_back(frame);
  throw InputError(fmt::format("{} of {} frames could not be drawn: {} ({})", frames.size(), report.frames,
                               session::rangesOf(frames), report.failed.front().second));
}

int runFilm(const FilmVerb& options) {
  session::FilmOutput output = filmOutput(options);
  session::expectFilmOutput(output);
  if (auto code = joinFolder(options, output)) return *code;
  Progress& progress = consoleProgress();
  auto context =
      gpu::Context::create(options.common.context);  // before data is read: without a driver there is no film
  render::Renderer renderer(*context);
  session::Session session;
  session.setContextKind(options.common.context);
  openInputs(session, options.input, double(output.picture.size.x) / output.picture.size.y);

  auto start = Clock::now();
  const scene::Scene& scene = session.scene();
  session::Motion motion = filmMotion(options, scene);
  int count = frameCount(options, output.framesPerSecond);
  auto source = frameSource(scene, motion, count, output, *context, renderer);
  if (std::string note = session::filmNote(output); !note.empty()) log::warning(note);
  std::string driver = fmt::format("{}, velum {}", context->limits().renderer, VELUM_VERSION);
  session::FilmIdentity film = session::filmIdentity(scene, output, driver);
  film.emplace_back("motion", enumName(motion));
  session::FilmReport report = session::makeFilm(source, output, film, progress);
  if (!report.isStopped) progress.report(1.0, "");
  if (options.common.json) printFilm(report, options, output, context->limits().renderer, msSince(start));
  tellFilm(report, output, progress);
  return 0;
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
  verb.add_option("--size", options->size, "WIDTHxHEIGHT in pixels, or with a unit: 12x8cm, 120x80mm, 5x3in")
      ->capture_default_str();
  verb.add_option("--samples", made.picture.samples, "pictures that are averaged, 1 to 256; default: as the scene says")
      ->check(CLI::Range(1, 256));
  verb.add_option("--fps", options->framesPerSecond, "frames a second; default 25, or what the frames were drawn for")
      ->check(CLI::Range(0.01, 1000.0));
  auto* seconds = verb.add_option("--seconds", options->seconds, "how long it lasts")
                      ->check(CLI::Range(0.001, 1e5))
                      ->capture_default_str();
  verb.add_option("--frames", options->frames, "how many frames it has, instead of --seconds")
      ->check(CLI::Range(1, 1000000))
      ->excludes(seconds);
  verb.add_option("--animate", options->animate, "what moves: turn, time, pull, cut, as in render");
  verb.add_option("--part", options->part, "K/N: the K-th of N parts of the frames, for several machines");
  verb.add_flag("--resume", made.old.resume, "draw only frames that are missing, broken or failed");
  verb.add_flag("--overwrite", made.old.overwrite, "write over the frames of another film");
  verb.add_option("--blur", made.blur, "blur what moves: each frame is the mean of so many pictures, 1 to 256")
      ->check(CLI::Range(1, 256));
  verb.add_option("--shutter", made.shutter, "the share of the time between frames that --blur takes, 0 to 1")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  verb.add_option("--quality", made.quality, "of a video, 0 to 100")->check(CLI::Range(0, 100))->capture_default_str();
  verb.add_option("--bits", made.picture.bits, "levels of colour: 8 bits, or 16, also in .exr")
      ->check(CLI::IsMember({8, 16}));
  verb.add_flag("--transparent", made.picture.transparent, "no background, with alpha: not in .mp4");
  verb.add_flag("--layers", made.picture.layers, "also alpha, normal, depth and more of each frame, as in render");
  verb.add_option("--dpi", made.picture.dpi, "pixels an inch in print: for sizes with a unit (else 300)")
      ->check(CLI::Range(1.0, 10000.0));
  verb.add_option("--timeout", options->timeout, "give up after so many seconds, with exit code 142; 0: never")
      ->check(CLI::Range(0.0, 1e6));
  return [options] {
    stopAfter(options->timeout);
    return runFilm(*options);
  };
}

}  // namespace velum::app
