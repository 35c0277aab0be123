#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include "Verbs.h"
#include "velum/render/Renderer.h"
#include "velum/scene/Navigate.h"
#include "velum/session/membrane/Membranes.h"
#include "velum/session/picture/Picture.h"

namespace velum::app {

namespace {

struct BenchOptions {
  Common common;
  InputOptions input;
  std::string size = "800x600";
  int frames = 10;
};

int run(const BenchOptions& options) {
  glm::ivec2 size = session::parsePictureSize(options.size, 0);
  auto context = gpu::Context::create(options.common.context);
  render::Renderer renderer(*context);
  render::Frame frame;
  frame.scene = openScene(options.input, double(size.x) / size.y);
  frame.scene.rayCast.samplesPerPixel = 1;
  frame.pictureSize = size;
  Progress& progress = consoleProgress();
  session::settleMembranes(frame.scene, {}, progress);
  renderer.render(frame, progress);  // uploads, shaders
  double uploadMs = renderer.stats().uploadMs;
  std::vector<double> times;
  std::map<std::string, double> passes;
  scene::Camera start = frame.scene.camera;
  for (int i = 0; i < options.frames; ++i) {
    frame.scene.camera = scene::turntable(start, 2.0 * 3.14159265358979 * (i + 0.37) / options.frames);
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
  return [options] { return run(*options); };
}

}  // namespace velum::app
