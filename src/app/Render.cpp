#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/StandardInput.h"
#include "app/Targets.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "io/images/ImageFile.h"
#include "render/Renderer.h"
#include "session/cut/NothingLeft.h"
#include "session/document/Open.h"
#include "session/growth/Growths.h"
#include "session/membrane/Membranes.h"
#include "session/picture/Film.h"

namespace velum::app {

namespace {

struct RenderOptions {
  Common common;
  InputOptions input;
  TargetOptions targets;
  std::string output, size = "1280x720", saveScene, section, animate;
  int samples = 0, frames = 0;
  double dpi = 0, timeout = 0;
  bool layers = false, transparent = false, bruteForce = false;
};

/// name.png, or name-0000.png ... for an animation.
std::vector<std::string> outputNames(const RenderOptions& options) {
  if (options.frames == 0) return {options.output};
  if (options.output == "-") throw ArgumentError("--frames writes several files; name one with -o, e.g. turn.png");
  std::vector<std::string> names;
  for (const auto& path : session::framePaths(options.output, options.frames)) names.push_back(path.string());
  return names;
}

/// Refuses what cannot be written, before anything is read.
void expectOutputs(const RenderOptions& options) {
  expectOutput(outputNames(options).front(), io::expectImageFormat);
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

/// The scenes of its pictures, with all that has grown, in their order.
class Frames {
 public:
  Frames(const RenderOptions& options, const scene::Scene& scene)
      : mScene(scene), mMotion(motionOf(options, scene)), mCount(options.frames) {}

  scene::Scene at(int frame) {
    if (!mMotion) return mScene;
    scene::Scene step = session::frameOf(mScene, *mMotion, frame, mCount);
    session::settleGrowths(step, mGrowths, consoleProgress());
    return step;
  }

 private:
  const scene::Scene& mScene;
  std::optional<session::Motion> mMotion;
  int mCount;
  growth::GrowOverTime mGrowths;
};

scene::SectionKind sectionKind(const std::string& name) {
  if (auto kind = enumValue<scene::SectionKind>(name)) return *kind;
  throw ArgumentError(
      fmt::format("--section {}: not one of {}", name, fmt::join(EnumNames<scene::SectionKind>::kNames, ", ")));
}

/// Says so when a picture is empty for its cuts. @param drawn  with its sheets at rest
void sayWhatCutsTake(const scene::Scene& drawn) {
  if (session::cutsTakeAll(drawn, consoleProgress())) log::warning(session::kNothingLeft);
}

/// A section view instead of the 3D picture; needs no graphics driver, unless there are membranes.
int runSection(const RenderOptions& options) {
  scene::SectionKind kind = sectionKind(options.section);
  glm::ivec2 size = session::parsePictureSize(options.size, options.dpi);
  if (options.layers) throw ArgumentError("--layers: a section has none; leave it out with --section");
  double aspect = double(size.x) / size.y;
  scene::Scene scene = openScene(options.input, aspect);
  settleTargets(scene, options.targets, aspect, nullptr);
  Frames frames(options, scene);
  session::PictureOptions picture{size, 0, options.transparent, false, options.dpi};
  std::vector<std::string> outputs = outputNames(options);
  std::unique_ptr<gpu::Context> context;
  if (session::hasMembranes(scene)) context = gpu::Context::create(options.common.context);
  session::SheetsOverTime sheets;
  double ms = 0;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    scene::Scene step = frames.at(int(i));
    auto start = Clock::now();
    Image image = session::drawSectionPicture(context ? sheets.settle(step, consoleProgress()) : step, kind, picture);
    ms = msSince(start);
    session::savePicture(image, step, picture, outputs[i]);
  }
  if (!options.saveScene.empty()) session::saveScene(session::sceneForPicture(scene, picture), options.saveScene);
  if (!options.common.json) return 0;
  glm::dvec3 at = scene.sections.crosshair;
  Json json = {{"section", options.section},
               {"crosshair", {at.x, at.y, at.z}},
               {"size", {size.x, size.y}},
               {"frameMs", ms},
               {"output", options.output}};
  if (options.frames > 0) json["outputs"] = outputs;
  printJson(json, options.output == "-" ? stderr : stdout);
  return 0;
}

int run(const RenderOptions& options) {
  const auto& inputs = options.input.inputs;
  bool isFromStandardInput = std::find(inputs.begin(), inputs.end(), kStandardInput) != inputs.end();
  if (isFromStandardInput && !options.saveScene.empty())
    throw ArgumentError("--save-scene: data from standard input has no file that a scene could name; give its path");
  expectOutputs(options);
  if (!options.section.empty()) return runSection(options);
  glm::ivec2 size = session::parsePictureSize(options.size, options.dpi);
  auto context = gpu::Context::create(options.common.context);
  render::Renderer renderer(*context);
  double aspect = double(size.x) / size.y;
  scene::Scene scene = openScene(options.input, aspect);
  session::PictureCounter counter(renderer, size, context->limits(), consoleProgress());
  auto settled = settleTargets(scene, options.targets, aspect, &counter);
  if (options.bruteForce) scene.rayCast.skipEmpty = scene.rayCast.stopOpaque = false;
  session::PictureOptions picture{size, options.samples, options.transparent, options.layers, options.dpi};

  // Picture by picture: an animation is several.
  Frames frames(options, scene);
  auto start = Clock::now();
  std::vector<std::string> outputs = outputNames(options);
  session::SheetsOverTime sheets;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    scene::Scene step = frames.at(int(i));
    scene::Scene drawn = sheets.settle(step, consoleProgress());
    Image image = session::drawPicture(renderer, drawn, picture, context->limits(), consoleProgress());
    if (options.frames == 0) sayWhatCutsTake(drawn);
    consoleProgress().report(1.0, "");
    session::savePicture(image, step, picture, outputs[i]);
  }
  double ms = msSince(start);
  if (!options.saveScene.empty()) session::saveScene(session::sceneForPicture(scene, picture), options.saveScene);

  // What there is to say of it; the picture itself may have gone to stdout.
  const render::Stats& stats = renderer.stats();
  if (!stats.reduction.empty()) log::say("note: " + stats.reduction);
  if (options.common.json) {
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
    if (options.frames > 0) json["outputs"] = outputs;
    if (settled)
      for (const auto& target : settled->targets) json["targets"].push_back(targetJson(target));
    printJson(json, options.output == "-" ? stderr : stdout);
  }
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
