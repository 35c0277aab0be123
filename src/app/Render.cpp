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
#include "render/Renderer.h"
#include "session/command/DocumentCommands.h"
#include "session/command/FilmCommands.h"
#include "session/cut/NothingLeft.h"
#include "session/document/Open.h"
#include "session/picture/Picture.h"

namespace velum::app {

namespace {

struct RenderOptions {
  Common common;
  InputOptions input;
  TargetOptions targets;
  LetteringOptions lettering;
  std::string output, size = "1280x720", saveScene, section;
  int samples = 0, bits = 8;
  double at = -1.0;
  double dpi = 0, timeout = 0;
  bool layers = false, transparent = false, bruteForce = false;
};

/// Refuses outputs that cannot be written, before anything is read.
void expectOutputs(const RenderOptions& options) {
  const auto& inputs = options.input.inputs;
  bool isFromStandardInput = std::find(inputs.begin(), inputs.end(), kStandardInput) != inputs.end();
  if (isFromStandardInput && !options.saveScene.empty())
    throw ArgumentError("--save-scene: data from standard input has no file that a scene could name; give its path");
  expectOutput(options.output, session::expectPictureFormat);
  expectOutput(options.saveScene);
}

scene::SectionKind sectionKind(const std::string& name) {
  if (auto kind = enumValue<scene::SectionKind>(name)) return *kind;
  throw ArgumentError(
      fmt::format("--section {}: not one of {}", name, fmt::join(EnumNames<scene::SectionKind>::kNames, ", ")));
}

/// What there is to say of the pictures; they may have gone to stdout.
Json reportOf(const RenderOptions& options, session::Session& session, glm::ivec2 size, double ms) {
  if (!options.section.empty()) {
    glm::dvec3 at = session.scene().sections.crosshair;
    return {{"section", options.section},
            {"crosshair", {at.x, at.y, at.z}},
            {"size", {size.x, size.y}},
            {"frameMs", ms},
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

  if (options.lettering.pageWidth > 0.0 && options.dpi > 0.0)
    throw ArgumentError(
        "--page-width: with --dpi the picture's pixels say how wide the page is; leave out one of the two");
  writeOver(session, options.lettering);
  if (options.at >= 0.0) app::run(session, session::MovePlayhead{options.at});

  auto start = Clock::now();
  session::PictureOptions picture{size,           options.samples, options.transparent,
                                  options.layers, options.dpi,     options.bits};
  std::optional<scene::SectionKind> section;
  if (isSection) section = sectionKind(options.section);
  for (const std::string& note : session.savePicture(picture, section, options.output, progress)) log::warning(note);
  double ms = msSince(start);
  bool isEmpty = !isSection && session::cutsTakeAll(session.settled(progress), progress);
  if (isEmpty) log::warning(session::kNothingLeft);
  progress.report(1.0, "");
  if (!options.saveScene.empty())
    session::saveScene(session::sceneForPicture(session.shown(), picture), options.saveScene);

  if (std::string note = isSection ? "" : session.renderer().stats().reduction; !note.empty())
    log::say("note: " + note);
  if (!options.common.json) return 0;
  Json json = reportOf(options, session, size, ms);
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
  verb.add_option("-o,--output", options->output,
                  "picture to write: .png, .tif, .exr; with lines and letters .svg, .pdf; - writes PNG to stdout")
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
  verb.add_option("--at", options->at, "a moment of the scene's film, in seconds")
      ->check(CLI::Range(0.0, scene::kLongestFilm));
  verb.add_flag(
      "--layers", options->layers,
      "also alpha, normal, depth, structure id, position, of models type and (EXR) Cryptomatte, and of illustrative "
      "sections front, inlay and behind: "
      "in the EXR, or as PNGs beside");
  verb.add_flag("--transparent", options->transparent, "no background, with alpha");
  addLettering(verb, options->lettering);
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
