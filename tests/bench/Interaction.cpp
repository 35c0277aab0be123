#include <fmt/format.h>
#include <stdlib.h>

#include <filesystem>

#include "Child.h"
#include "Data.h"
#include "Sections.h"
#include "core/Clock.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kSize(1280, 720);
constexpr int kCoarseDivisor = 4;  // along each side of the picture
constexpr double kCoarseStepFactor = 2.0;

/// What a window shows first while something moves.
render::Frame coarseFrame(const scene::Scene& scene, int divisor = kCoarseDivisor) {
  render::Frame frame{scene, kSize / divisor};
  frame.scene.rayCast.samplesPerPixel = 1;
  frame.stepFactor = kCoarseStepFactor;
  frame.isPreview = true;
  return frame;
}

/// Draws and reads the picture, as a window would show it. @return milliseconds
double show(render::Renderer& renderer, const render::Frame& frame) {
  Progress progress;
  auto start = Clock::now();
  renderer.render(frame, progress);
  renderer.read();
  return msSince(start);
}

/// Median time of coarse pictures from a camera that moves.
double movingMs(render::Renderer& renderer, render::Frame frame, int positions) {
  std::vector<double> times;
  scene::Camera start = frame.scene.camera;
  for (int i = 0; i < positions; ++i) {
    frame.scene.camera = turned(start, i, 3 * positions);
    times.push_back(show(renderer, frame));
  }
  return median(times);
}

/// Median time from an edit of the transfer function to its picture.
double editMs(render::Renderer& renderer, render::Frame frame, int edits) {
  std::vector<double> times;
  for (int i = 0; i < edits; ++i) {
    for (auto& point : frame.scene.volume.transfer.opacities) point.value += 0.7;
    times.push_back(show(renderer, frame));
  }
  return median(times);
}

void measureFirstPicture(const Options& options, Report& report) {
  std::vector<std::vector<std::string>> rows;
  std::string cache = (std::filesystem::temp_directory_path() / fmt::format("velum-bench-{}", getpid())).string();
  for (int n : options.quick ? std::vector{128} : std::vector{256, 512}) {
    std::filesystem::remove_all(cache);
    for (const char* state : {"driver's cache empty", "driver's cache full"}) {
      auto f = runChild({"first-picture", std::to_string(n)}, {{"MESA_SHADER_CACHE_DIR", cache}});
      if (f.is_null()) continue;
      rows.push_back({fmt::format("{}^3 uint8", n), fmt::format("new process, {}", state), formatMs(f["contextMs"]),
                      formatMs(f["uploadMs"]), formatMs(f["drawMs"]), formatMs(f["totalMs"]),
                      formatMs(f["longestStepMs"])});
      report.figure(fmt::format("first/{}/{}", n, state[15] == 'e' ? "cold" : "cached"), f);
    }
    std::filesystem::remove_all(cache);
    render::Renderer renderer(sharedContext());
    double aspect = double(kSize.x) / kSize.y;
    show(renderer, coarseFrame(makeShellScene(Shared<Volume>(makeShells(64)), Opacity::SkinOverBone, aspect)));
    auto frame = coarseFrame(makeShellScene(Shared<Volume>(makeShells(n)), Opacity::SkinOverBone, aspect));
    double total = show(renderer, frame);
    rows.push_back({fmt::format("{}^3 uint8", n), "next volume of a process", "0", formatMs(renderer.stats().uploadMs),
                    formatMs(total - renderer.stats().uploadMs), formatMs(total), "-"});
    report.figure(fmt::format("first/{}/warm", n), {{"uploadMs", renderer.stats().uploadMs}, {"totalMs", total}});
  }
  report.note(
      "First coarse picture (320 x 180 of 1280 x 720, double steps, a copy of the volume of 96 texels along the "
      "longest side) once the data is in memory, ms. The window shows it, then brings the whole volume to the GPU.");
  report.table(
      {"volume", "when", "context", "upload", "programs, tables, light, picture", "sum", "longest piece of work"},
      rows);
}

void measureMoving(const Options& options, Report& report) {
  std::vector<std::vector<std::string>> rows;
  double aspect = double(kSize.x) / kSize.y;
  int positions = options.quick ? 3 : 9;
  for (int n : options.quick ? std::vector{128} : std::vector{256, 512}) {
    Shared<Volume> volume(makeShells(n));
    for (Opacity opacity : {Opacity::Opaque, Opacity::SkinOverBone}) {
      scene::Scene lit = makeShellScene(volume, opacity, aspect);
      for (bool everything : {false, true}) {
        scene::Scene scene = everything ? lit : plain(lit);
        render::Renderer renderer(sharedContext());
        render::Frame rest{scene, kSize / kCoarseDivisor};
        show(renderer, rest);
        show(renderer, coarseFrame(scene));
        double quarter = movingMs(renderer, coarseFrame(scene), positions);
        double half = movingMs(renderer, coarseFrame(scene, 2), positions);
        double edit = editMs(renderer, coarseFrame(scene), positions);
        // A picture at rest, once its programs are there.
        render::Frame full{scene, kSize};
        show(renderer, full);
        full.scene.camera = turned(scene.camera, 1, 9);
        show(renderer, full);
        double longest = renderer.stats().longestStepMs;
        std::string name{kOpacityNames[static_cast<int>(opacity)]};
        rows.push_back({fmt::format("{}^3 uint8, {}", n, name), everything ? "on" : "off",
                        fmt::format("{:.1f}", 1000.0 / quarter), fmt::format("{:.1f}", 1000.0 / half), formatMs(edit),
                        formatMs(longest)});
        report.figure(fmt::format("moving/{}/{}/{}", n, name, everything ? "lit" : "plain"),
                      {{"coarseMs", quarter}, {"halfMs", half}, {"editMs", edit}, {"longestStepMs", longest}});
      }
    }
  }
  report.note(
      "While the camera moves, with the light of the last picture at rest, and from an edit of the opacity curve to "
      "its "
      "coarse picture, as the window shows them. The longest piece of work is that of a whole "
      "picture of 1280 x 720: a dispatch and the wait for it.");
  report.table({"volume", "shadows and occlusion", "pictures/s at 320 x 180", "pictures/s at 640 x 360",
                "edit to picture, ms", "longest dispatch, ms"},
               rows);
}

/// From a move of the mouse in a section view to the other views on the screen.
void measureAnswers(const Options& options, Report& report) {
  int n = options.quick ? 128 : 512;
  auto figures = runChild({"answers", std::to_string(n)});
  if (figures.is_null()) return report.note("Section views: left out, there is no display.");
  std::vector<std::vector<std::string>> rows;
  for (const auto& [when, f] : figures.items()) {
    rows.push_back({when, formatMs(f["medianMs"]), formatMs(f["most90Ms"]), formatMs(f["worstMs"])});
    report.figure("answers/" + when, f);
  }
  report.note(fmt::format(
      "The crosshair is dragged through {}^3 uint8 in a window of 1440 x 900 with four views: from each move's event "
      "to "
      "the end of painting of the two sections that follow it, with the window's composition by the driver, ms. What "
      "is pulled is a shell of some ten million voxels in the 3D view alone, from each move to what is drawn over the "
      "picture.",
      n));
  report.table({"sections answer", "median", "nine of ten", "worst"}, rows);
}

}  // namespace

nlohmann::json childFirstPicture(int size) {
  auto scene = makeShellScene(Shared<Volume>(makeShells(size)), Opacity::SkinOverBone, double(kSize.x) / kSize.y);
  auto start = Clock::now();
  gpu::Context& context = sharedContext();
  double contextMs = msSince(start);
  render::Renderer renderer(context);
  double total = show(renderer, coarseFrame(scene));
  const auto& stats = renderer.stats();
  return {{"contextMs", contextMs},       {"uploadMs", stats.uploadMs},           {"drawMs", total - stats.uploadMs},
          {"totalMs", contextMs + total}, {"longestStepMs", stats.longestStepMs}, {"passesMs", stats.passesMs}};
}

void measureInteraction(const Options& options, Report& report) {
  report.section("interaction", "Answering the user");
  measureFirstPicture(options, report);
  measureMoving(options, report);
  measureAnswers(options, report);
}

}  // namespace velum::bench
