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
  DrawnOptions drawn;
  std::string output, saveScene;
  std::string part;
  double at = -1.0;
  bool bruteForce = false;
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

/// What there is to say of the pictures; they may have gone to stdout.
Json reportOf(const RenderOptions& options, session::Session& session, glm::ivec2 size, double ms) {
  if (!options.drawn.section.empty()) {
    glm::dvec3 at = session.scene().sections.crosshair;
    return {{"section", options.drawn.section},
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
  std::optional<scene::SectionKind> section = sectionOf(options.drawn);
  bool isSection = section.has_value();
  session::PictureOptions picture = pictureOf(options.drawn);
  if (!options.part.empty()) picture.part = session::parsePart(options.part);
  glm::ivec2 size = picture.size;
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

  if (options.lettering.pageWidth > 0.0 && picture.dpi > 0.0)
    throw ArgumentError(
        "--page-width: with --dpi the picture's pixels say how wide the page is; leave out one of the two");
  writeOver(session, options.lettering);
  if (options.at >= 0.0) app::run(session, session::MovePlayhead{options.at});

  auto start = Clock::now();
  for (const std::string& note : session.savePicture(picture, section, options.output, progress))
    picture.part.parts > 1 ? log::say("note: " + note) : log::warning(note);
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
  addDrawn(verb, options->drawn);
  addTargets(verb, options->targets);
  verb.add_option("--at", options->at, "a moment of the scene's film, in seconds")
      ->check(CLI::Range(0.0, scene::kLongestFilm));
  verb.add_flag(
      "--layers", options->drawn.picture.layers,
      "also alpha, normal, depth, structure id, position, of models type and (EXR) Cryptomatte, and of illustrative "
      "sections front, inlay and behind: "
      "in the EXR, or as PNGs beside");
  verb.add_flag("--transparent", options->drawn.picture.transparent, "no background, with alpha");
  verb.add_option("--part", options->part,
                  "K/N: draw the K-th of N bands of rows; whoever is last puts the picture together");
  addLettering(verb, options->lettering);
  verb.add_flag("--brute-force", options->bruteForce,
                "without skipping and early ends: the reference for every acceleration");
  verb.add_option("--save-scene", options->saveScene, "write the scene as JSON, too");
  return withTimeout(verb, [options] { return run(*options); });
}

}  // namespace velum::app
