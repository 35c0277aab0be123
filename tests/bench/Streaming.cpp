// Volumes larger than memory: a virtual terabyte, whose bricks are computed when they are read, and a volume that fits.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>

#include "Data.h"
#include "Sections.h"
#include "core/BrickCache.h"
#include "core/Memory.h"
#include "io/phantoms/Brain.h"
#include "io/volumes/ReadLevel.h"
#include "render/Renderer.h"
#include "render/section/SectionImage.h"
#include "scene/SectionPlane.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;
double msFrom(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A line of /proc/self/status, bytes.
double statusBytes(std::string_view key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) * 1024.0;
  return 0.0;
}

/// The phantom's cells, in tissue that one can see through.
scene::Scene brainScene(Volume volume, double aspect) {
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  scene.volume.transfer.colors = {
      {450, {0.55f, 0.36f, 0.33f}}, {1500, {0.95f, 0.75f, 0.42f}}, {4000, {1.0f, 0.95f, 0.8f}}};
  scene.volume.transfer.opacities = {{900, 0.0}, {2500, 0.85}};
  scene.volume.transfer.unitDistance = 0.01;
  scene.rayCast.samplesPerPixel = 1;
  scene.lighting.shadow = scene.lighting.occlusion = 0;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Oblique, aspect);
  return scene;
}

Volume openBrain(int size, Progress& progress) {
  return io::readFitting(io::makeBrain(size, progress), {}, false, progress);
}

/// Towards a place in the cortex and along it, nearer and farther.
scene::Camera flightCamera(const scene::Camera& start, double turn) {
  scene::Camera camera = turned(start, int(turn * 1000.0), 1000);
  double near = 0.5 + 0.48 * std::cos(6.283 * (3.0 * turn + 0.5));
  camera.eye = camera.target + (camera.eye - camera.target) * (1.0 - near);
  return camera;
}

struct Flight {
  std::vector<double> answers, settled;  ///< ms: of a moving picture; of a picture at rest with all its bricks
  double longestPiece = 0, mostAllocated = 0, mostResident = 0, bricksRead = 0;
};

Flight fly(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size, double seconds) {
  constexpr int kMovesOfOneRest = 40;
  Flight flight;
  // The programs of moving pictures are compiled before.
  render::Frame moving{.scene = scene, .pictureSize = size, .stepFactor = 2.0, .isPreview = true};
  Progress progress;
  renderer.render(moving, progress);
  Clock::time_point start = Clock::now();
  for (int i = 0; msFrom(start) < seconds * 1000.0; ++i) {
    render::Frame frame{.scene = scene, .pictureSize = size};
    frame.scene.camera = flightCamera(scene.camera, double(i) / 1200.0);
    bool rests = i % kMovesOfOneRest == kMovesOfOneRest - 1;
    frame.isPreview = !rests;
    if (!rests) frame.stepFactor = 2.0;
    Clock::time_point before = Clock::now();
    bool isDone = false;
    while (!isDone && (rests || msFrom(before) < 250.0)) {
      Clock::time_point piece = Clock::now();
      isDone = renderer.work(frame, 8.0);
      flight.longestPiece = std::max(flight.longestPiece, msFrom(piece));
    }
    (rests ? flight.settled : flight.answers).push_back(msFrom(before));
    flight.mostAllocated = std::max(flight.mostAllocated, double(velum::allocatedBytes()));
    flight.mostResident = std::max(flight.mostResident, statusBytes("VmRSS"));
  }
  return flight;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void measureTerabyte(const Options& options, Report& report) {
  constexpr int kVoxels = 10410;  // along the longest axis: a terabyte
  glm::ivec2 size(1280, 720);
  Progress progress;
  double before = double(velum::allocatedBytes());
  Clock::time_point start = Clock::now();
  auto source = io::makeBrain(kVoxels, progress);
  double planned = msFrom(start);
  double bytes = levelBytes(*source, 0);
  start = Clock::now();
  Volume volume = io::readFitting(std::move(source), {}, false, progress);
  double opened = msFrom(start);
  glm::ivec3 coarse = volume.dims;
  scene::Scene scene = brainScene(std::move(volume), double(size.x) / size.y);
  double first = 0, whole = 0;
  Flight flight;
  {
    render::Renderer renderer(sharedContext());
    render::Frame frame{.scene = scene, .pictureSize = size};
    Clock::time_point drawing = Clock::now();
    while (!renderer.work(frame, 8.0))
      if (first == 0 && renderer.stats().samples > 0) first = msFrom(drawing);
    whole = msFrom(drawing);
    if (first == 0) first = whole;
    flight = fly(renderer, scene, size, options.quick ? 20.0 : 600.0);
  }
  report.note(fmt::format(
      "{:.2f} TB of 16 bits, {} voxels along the longest axis, computed when they are read; {} x {} pixels. "
      "Its cells are found in {} ms, which no file would need.",
      bytes / 1e12, kVoxels, size.x, size.y, formatMs(planned)));
  report.table({"of a terabyte", "measured"},
               {{fmt::format("a coarse level of {} x {} x {} is in memory", coarse.x, coarse.y, coarse.z),
                 formatMs(opened) + " ms"},
                {"first picture, at rest", formatMs(first) + " ms"},
                {"all its bricks", formatMs(whole) + " ms"},
                {fmt::format("a flight of {} moving pictures: median, longest", flight.answers.size()),
                 fmt::format("{}, {} ms", formatMs(median(flight.answers)), formatMs(largest(flight.answers)))},
                {"longest piece of work in it", formatMs(flight.longestPiece) + " ms"},
                {fmt::format("{} rests in it, until all bricks are there: median, longest", flight.settled.size()),
                 fmt::format("{}, {} ms", formatMs(median(flight.settled)), formatMs(largest(flight.settled)))},
                {"most memory that was allocated, above what the program had",
                 fmt::format("{:.0f} MB", (flight.mostAllocated - before) / 1e6)},
                {"most memory of the process", fmt::format("{:.0f} MB", flight.mostResident / 1e6)}});
  report.figure("terabyte", {{"openMs", opened},
                             {"firstMs", first},
                             {"wholeMs", whole},
                             {"movingMs", median(flight.answers)},
                             {"longestMovingMs", largest(flight.answers)},
                             {"longestPieceMs", flight.longestPiece},
                             {"restMs", median(flight.settled)},
                             {"allocatedMb", (flight.mostAllocated - before) / 1e6},
                             {"residentMb", flight.mostResident / 1e6}});
}

/// The same level streamed, and in memory.
void measureAgainstMemory(const Options& options, Report& report) {
  int n = options.quick ? 320 : 640;
  glm::ivec2 size(960, 720);
  Progress progress;
  auto frameMs = [&](Volume volume) {
    scene::Scene scene = brainScene(std::move(volume), double(size.x) / size.y);
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
  scene::Scene scene = brainScene(openBrain(n, progress), 1.0);
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
  measureTerabyte(options, report);
}

}  // namespace velum::bench
