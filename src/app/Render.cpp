#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/Inputs.h"
#include "app/StandardInput.h"
#include "app/Targets.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "io/images/ImageFile.h"
#include "render/Renderer.h"
#include "session/command/DocumentCommands.h"
#include "session/cut/NothingLeft.h"
#include "session/document/Open.h"
#include "session/picture/Film.h"

namespace velum::app {

namespace {

struct RenderOptions {
  Common common;
  InputOptions input;
  TargetOptions targets;
  std::string output, size = "1280x720", saveScene, section, animate;
  int samples = 0, frames = 0, bits = 8;
  double dpi = 0, timeout = 0;
  bool layers = false, transparent = false, bruteForce = false, legend = false, scaleBar = false;
};

/// Refuses outputs that cannot be written, before anything is read.
void expectOutputs(const RenderOptions& options) {
  const auto& inputs = options.input.inputs;
  bool isFromStandardInput = std::find(inputs.begin(), inputs.end(), kStandardInput) != inputs.end();
  if (isFromStandardInput && !options.saveScene.empty())
    throw ArgumentError("--save-scene: data from standard input has no file that a scene could name; give its path");
  bool isSeveral = options.frames > 0;
  if (isSeveral && options.output == "-")
    throw ArgumentError("--frames writes several files; name one with -o, e.g. turn.png");
  expectOutput(isSeveral ? session::framePaths(options.output, 1).front().string() : options.output,
               io::expectImageFormat);
  expectOutput(options.saveScene);
}

/// What moves in an animation; nothing for a single picture.
std::optional<session::Motion> motionOf(const RenderOptions& options, const scene::Scene& scene) {
  if (options.frames == 0 && !options.animate.empty())
    throw ArgumentError("--animate: say how many pictures, with --frames");
  if (options.frames == 0) return std::nullopt;
  auto motion = options.animate.empty() ? session::usualMotion(scene) : enumValue<session::Motion>(options.animate);
  if (!motion)
    throw ArgumentError(fmt::format("--animate {}: not one of {}", options.animate,
                                    fmt::join(EnumNames<session::Motion>::kNames, ", ")));
  if (std::string why = session::whyStill(scene, *motion); !why.empty())
    throw ArgumentError(fmt::format("--animate {}: {}", enumName(*motion), why));
  if (*motion == session::Motion::Turn && !options.section.empty())
    throw ArgumentError(
        "--frames with --section goes through time steps, or with --animate pull or cut through the cuts");
  return motion;
}

scene::SectionKind sectionKind(const std::string& name) {
  if (auto kind = enumValue<scene::SectionKind>(name)) return *kind;
  throw ArgumentError(
      fmt::format("--section {}: not one of {}", name, fmt::join(EnumNames<scene::SectionKind>::kNames, ", ")));
}

session::FilmOptions filmOf(const RenderOptions& options, const scene::Scene& scene, glm::ivec2 size) {
  session::FilmOptions film{{size, options.samples, options.transparent, options.layers, options.dpi, options.bits},
                            motionOf(options, scene),
                            std::max(options.frames, 1),
                            {}};
  if (!options.section.empty()) film.section = sectionKind(options.section);
  return film;
}

/// What there is to say of the pictures; they may have gone to stdout.
Json reportOf(const RenderOptions& options, session::Session& session, glm::ivec2 size, double ms) {
  if (!options.section.empty()) {
    glm::dvec3 at = session.scene().sections.crosshair;
    return {{"section", options.section},
            {"crosshair", {at.x, at.y, at.z}},
            {"size", {size.x, size.y}},
            {"frameMs", ms / std::max(options.frames, 1)},
            {"output", options.output}};
  }
  const render::Stats& stats = session.renderer().stats();
  Json json = {{"renderer", stats.renderer},
               {"size", {size.x, size.y}},
               {"frameMs", stats.frameMs},
               {"uploadMs", stats.uploadMs},
               {"totalMs", ms},
               {"samples", stats.samples},
               {"longestStepMs", stats.longestStepMs},
               {"passes", stats.passesMs},
               {"reduction", stats.reduction},
               {"output", options.output}};
  const render::Streaming& streaming = stats.streaming;
  if (!streaming.shares.empty())
    json["streaming"] = {{"shares", streaming.shares},
                         {"missing", streaming.missing},
                         {"coarser", streaming.coarser},
                         {"usedBytes", streaming.usedBytes},
                         {"budgetBytes", streaming.budgetBytes}};
  return json;
}

int run(const RenderOptions& options) {
  expectOutputs(options);
  bool isSection = !options.section.empty();
  if (isSection) sectionKind(options.section);
  if (isSection && options.layers) throw ArgumentError("--layers: a section has none; leave it out with --section");
  glm::ivec2 size = session::parsePictureSize(options.size, options.dpi);
  double aspect = double(size.x) / size.y;
  session::Session session;
  session.setContextKind(options.common.context);
  Progress& progress = consoleProgress();
  if (!isSection) session.renderer();  // before data is read: without a driver there is no picture
  openInputs(session, options.input, aspect);
  std::optional<session::PictureCounter> counter;
  if (!isSection) counter.emplace(session.counter(size, progress));
  auto settled = settleTargets(session, options.targets, aspect, counter ? &*counter : nullptr);
  if (options.bruteForce)
    for (const char* field : {"rayCast.skipEmpty", "rayCast.stopOpaque"})
      app::run(session, session::SetField{field, "false"});

  if (options.legend) app::run(session, session::SetField{"lettering.legend", "true"});
  if (options.scaleBar) app::run(session, session::SetField{"lettering.scaleBar", "true"});

  auto start = Clock::now();
  session::FilmOptions film = filmOf(options, session.scene(), size);
  auto files = session.film(film, options.output, progress);
  double ms = msSince(start);
  bool isEmpty = !isSection && !film.motion && session::cutsTakeAll(session.settled(progress), progress);
  if (isEmpty) log::warning(session::kNothingLeft);
  progress.report(1.0, "");
  if (!options.saveScene.empty())
    session::saveScene(session::sceneForPicture(session.scene(), film.picture), options.saveScene);

  if (std::string note = isSection ? "" : session.renderer().stats().reduction; !note.empty())
    log::say("note: " + note);
  if (!options.common.json) return 0;
  Json json = reportOf(options, session, size, ms);
  if (film.motion)
    for (const auto& file : files) json["outputs"].push_back(file.string());
  if (settled && !isSection)
    for (const auto& target : settled->targets) json["targets"].push_back(targetJson(target));
  printJson(json, options.output == "-" ? stderr : stdout);
  return 0;
}

}  // namespace

Run registerRender(CLI::App& verb) {
  auto options = std::make_shared<RenderOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("-o,--output", options->output, "picture to write: .png, .tif, .exr; - writes PNG to stdout")
      ->required();
  verb.add_option("--size", options->size, "WIDTHxHEIGHT in pixels, or with a unit: 12x8cm, 120x80mm, 5x3in")
      ->capture_default_str();
  verb.add_option("--dpi", options->dpi,
                  "pixels an inch in print: for sizes with a unit (else 300), and told in the file")
      ->check(CLI::Range(1.0, 10000.0));
  verb.add_option("--bits", options->bits, "levels of colour: 8 bits, or 16, also in .exr")
      ->check(CLI::IsMember({8, 16}));
  addTargets(verb, options->targets);
  verb.add_option("--section", options->section, "a section view instead of the 3D picture: axial, coronal, sagittal");
  verb.add_option("--samples", options->samples, "pictures that are averaged, 1 to 256; default: as the scene says")
      ->check(CLI::Range(1, 256));
  verb.add_option("--frames", options->frames, "an animation of so many pictures: NAME-0000 ...")
      ->check(CLI::Range(1, 9999));
  verb.add_option(
      "--animate", options->animate,
      "what moves in it: turn (once round), time (through the time steps; the default where there are "
      "some), pull (structures come out of the cuts one after the other), cut (the instances of a model go one by "
      "one, or cuts come in, then what they leave comes back)");
  verb.add_flag(
      "--layers", options->layers,
      "also alpha, normal, depth, structure id, position, of models type and (EXR) Cryptomatte, and of illustrative "
      "sections front, inlay and behind: "
      "in the EXR, or as PNGs beside");
  verb.add_flag("--transparent", options->transparent, "no background, with alpha");
  verb.add_flag("--legend", options->legend,
                "colours and names of a model's types and of structures over the picture (lettering.legend)");
  verb.add_flag("--scale-bar", options->scaleBar, "a bar that says how long things are (lettering.scaleBar)");
  verb.add_flag("--brute-force", options->bruteForce,
                "without skipping and early ends: the reference for every acceleration");
  verb.add_option("--save-scene", options->saveScene, "write the scene as JSON, too");
  verb.add_option("--timeout", options->timeout, "give up after so many seconds, with exit code 142; 0: never")
      ->check(CLI::Range(0.0, 1e6));
  return [options] {
    stopAfter(options->timeout);
    return run(*options);
  };
}

}  // namespace velum::app
