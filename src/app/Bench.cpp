#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "render/Renderer.h"
#include "scene/Navigate.h"
#include "session/picture/Picture.h"

namespace velum::app {

namespace {

/// Radians. A complete picture is not drawn again, so a camera that rests is turned by less than anybody sees.
constexpr double kLeastTurn = 1e-6;

struct BenchOptions {
  Common common;
  InputOptions input;
  std::string size = "800x600";
  int frames = 10;
  double turnDeg = 360.0, coarse = 1.0;
};

int run(const BenchOptions& options) {
  glm::ivec2 size = session::parsePictureSize(options.size, 0);
  session::Session session;
  session.setContextKind(options.common.context);
  render::Renderer& renderer = session.renderer();
  openInputs(session, options.input, double(size.x) / size.y);
  render::Frame frame;
  frame.scene = session.settled(consoleProgress());
  frame.scene.rayCast.samplesPerPixel = 1;
  // As the window draws while the camera moves: a smaller picture, which is stretched on the screen.
  frame.pictureSize = glm::max(glm::ivec2(glm::dvec2(size) / options.coarse), 1);
  frame.isPreview = options.coarse > 1.0;
  Progress& progress = consoleProgress();
  renderer.render(frame, progress);  // uploads, shaders
  double uploadMs = renderer.stats().uploadMs;
  // What a first picture finds empty, such as who was seen before, has the driver compile once more.
  scene::Camera start = frame.scene.camera;
  frame.scene.camera = scene::turntable(start, kLeastTurn);
  renderer.render(frame, progress);
  std::vector<double> times;
  std::map<std::string, double> passes;
  for (int i = 0; i < options.frames; ++i) {
    double turn = glm::radians(options.turnDeg) * (i + 0.37) / options.frames;
    frame.scene.camera = scene::turntable(start, turn + (i % 2 ? -kLeastTurn : 0.0));
    renderer.render(frame, progress);
    times.push_back(renderer.stats().frameMs);
    for (const auto& [name, ms] : renderer.stats().passesMs) passes[name] += ms / options.frames;
  }
  progress.report(1.0, "");
  std::sort(times.begin(), times.end());
  double median = times[times.size() / 2];
  if (options.common.json)
    printJson({{"renderer", renderer.stats().renderer},
               {"size", {size.x, size.y}},
               {"frames", options.frames},
               {"uploadMs", uploadMs},
               {"frameMs", {{"min", times.front()}, {"median", median}, {"max", times.back()}}},
               {"longestStepMs", renderer.stats().longestStepMs},
               {"passes", passes}});
  else
    fmt::print("{}\n{} frames of {} x {}: {:.1f} ms (min {:.1f}, max {:.1f})\n", renderer.stats().renderer,
               options.frames, size.x, size.y, median, times.front(), times.back());
  return 0;
}

}  // namespace

Run registerBench(CLI::App& verb) {
  auto options = std::make_shared<BenchOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  verb.add_option("--frames", options->frames, "camera positions round the scene")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  verb.add_option("--turn", options->turnDeg, "degrees by which the camera goes round in all; 0: it rests")
      ->capture_default_str();
  verb.add_option("--coarse", options->coarse,
                  "by how much pictures are smaller along each edge, as the window draws them while the camera moves")
      ->check(CLI::Range(1.0, 16.0))
      ->capture_default_str();
  return [options] { return run(*options); };
}

}  // namespace velum::app
