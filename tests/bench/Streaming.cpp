// Volumes larger than memory: sections of them, and a volume that fits.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "Data.h"
#include "Sections.h"
#include "Terabyte.h"
#include "io/phantoms/Brain.h"
#include "io/volumes/ReadLevel.h"
#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "scene/SectionPlane.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// The same level streamed, and in memory.
void measureAgainstMemory(const Options& options, Report& report) {
  int n = options.quick ? 320 : 640;
  glm::ivec2 size(960, 720);
  Progress progress;
  auto frameMs = [&](Volume volume) {
    scene::Scene scene = brightScene(std::move(volume), double(size.x) / size.y);
    // Everywhere the same level is wanted.
    scene.camera.projection = scene::Projection::Orthographic;
    scene.camera.height = 7.0;
    std::vector<double> times;
    {
      render::Renderer renderer(sharedContext());
      for (int turn = 0; turn < (options.quick ? 3 : 7); ++turn) {
        // The first brings the data; the same picture again would not be drawn, so that its light changes.
        render::Frame frame{.scene = scene, .pictureSize = size};
        frame.scene.camera = turned(scene.camera, turn, 40);
        renderer.render(frame, progress);
        double start = processorMs();
        frame.scene.lighting.ambient *= 0.9;
        renderer.render(frame, progress);
        times.push_back(processorMs() - start);
      }
    }
    return median(times);
  };
  setenv("VELUM_WHOLE_MB", "1", 1);
  Volume streamed = openBrain(n, progress);
  setenv("VELUM_WHOLE_MB", "100000", 1);
  Volume whole = openBrain(n, progress);
  unsetenv("VELUM_WHOLE_MB");
  whole.range = streamed.range;
  std::string dims = fmt::format("{} x {} x {}", whole.dims.x, whole.dims.y, whole.dims.z);
  double ofStreamed = frameMs(std::move(streamed)), ofWhole = frameMs(std::move(whole));
  report.table({"a volume that fits", "in memory, ms", "streamed, ms", "ratio (at most 1.1)"},
               {{dims, formatMs(ofWhole), formatMs(ofStreamed), fmt::format("{:.2f}", ofStreamed / ofWhole)}});
  report.note("Processor time of a picture of which all bricks are there, from several sides: its light is changed.");
  report.figure("fits", {{"wholeMs", ofWhole}, {"streamedMs", ofStreamed}, {"ratio", ofStreamed / ofWhole}});
}

void measureSections(const Options& options, Report& report) {
  int n = options.quick ? 1300 : 10410;
  Progress progress;
  scene::Scene scene = brightScene(openBrain(n, progress), 1.0);
  std::vector<double> first, sharp;
  for (int turn = 0; turn < (options.quick ? 3 : 9); ++turn) {
    scene::SectionPlane plane = scene::makeSectionPlane(scene, scene::SectionKind(turn % 3), {1000, 800});
    plane.lengthPerPixel *= 0.3;
    plane.centre += 20.0 * double(turn) * plane.right * plane.lengthPerPixel;
    Clock::time_point start = Clock::now();
    (void)render::drawSection(scene, plane, {}, render::SectionDetail::AtOnce);
    first.push_back(msFrom(start));
    start = Clock::now();
    (void)render::drawSection(scene, plane, {}, render::SectionDetail::Whole);
    sharp.push_back(msFrom(start));
  }
  report.table({"a section of 1000 x 800 pixels", "median, ms", "longest, ms", "goal, ms"},
               {{"what is there", formatMs(median(first)), formatMs(largest(first)), "50"},
                {"sharp", formatMs(median(sharp)), formatMs(largest(sharp)), "500"}});
  report.figure("section", {{"firstMs", median(first)}, {"sharpMs", median(sharp)}});
}

}  // namespace

void measureStreaming(const Options& options, Report& report) {
  report.section("streaming", "Volumes larger than memory");
  measureStreamedMembranes(options, report);
  measureAgainstMemory(options, report);
  measureSections(options, report);
  measureTerabytes(options, report);
}

}  // namespace velum::bench
