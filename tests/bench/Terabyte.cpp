// A virtual terabyte, whose bricks are computed when they are read, and one of real files: opened, and flown through.
#include "Terabyte.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>

#include "Data.h"
#include "RepeatedStore.h"
#include "Sections.h"
#include "TempFolder.h"
#include "core/BrickCache.h"
#include "core/Memory.h"
#include "io/phantoms/Brain.h"
#include "io/volumes/ReadLevel.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// A line of /proc/self/status, bytes.
double statusBytes(std::string_view key) {
  std::ifstream in("/proc/self/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size() + 1)) * 1024.0;
  return 0.0;
}

/// Towards the middle and about it, nearer and farther.
scene::Camera flightCamera(const scene::Camera& start, double turn) {
  scene::Camera camera = turned(start, int(turn * 1000.0), 1000);
  double near = 0.5 + 0.48 * std::cos(6.283 * (3.0 * turn + 0.5));
  camera.eye = camera.target + (camera.eye - camera.target) * (1.0 - near);
  return camera;
}

struct Flight {
  std::vector<double> answers, settled;  ///< ms: of a moving picture; of a picture at rest with all its bricks
  double longestPiece = 0, mostAllocated = 0, mostResident = 0, mostOnGpu = 0;
  double minutes = 0;
};

Flight fly(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size, double seconds) {
  constexpr int kMovesOfOneRest = 40;
  Flight flight;
  // The programs of moving pictures are compiled before.
  render::Frame moving{.scene = scene,
                       .pictureSize = size,
                       .stepFactor = 2.0,
                       .isPreview = true,
                       .brickBytes = memoryBudget().gpuBrickBytes};
  Progress progress;
  renderer.render(moving, progress);
  Clock::time_point start = Clock::now();
  for (int i = 0; msFrom(start) < seconds * 1000.0; ++i) {
    render::Frame frame{.scene = scene, .pictureSize = size, .brickBytes = memoryBudget().gpuBrickBytes};
    frame.scene.camera = flightCamera(scene.camera, double(i) / 1200.0);
    bool rests = i % kMovesOfOneRest == kMovesOfOneRest - 1;
    frame.isPreview = !rests;
    if (!rests) frame.stepFactor = 2.0;
    Clock::time_point before = Clock::now();
    bool isDone = false;
    while (!isDone && (rests ? msFrom(start) < seconds * 1000.0 : msFrom(before) < 250.0)) {
      Clock::time_point piece = Clock::now();
      isDone = renderer.work(frame, 8.0);
      flight.longestPiece = std::max(flight.longestPiece, msFrom(piece));
    }
    if (isDone || !rests) (rests ? flight.settled : flight.answers).push_back(msFrom(before));
    flight.mostAllocated = std::max(flight.mostAllocated, double(velum::allocatedBytes()));
    flight.mostResident = std::max(flight.mostResident, statusBytes("VmRSS"));
    flight.mostOnGpu = std::max(flight.mostOnGpu, renderer.stats().streaming.usedBytes);
  }
  flight.minutes = msFrom(start) / 60000.0;
  return flight;
}

/// A terabyte that is opened.
struct Terabyte {
  std::string key, title;
  std::function<std::unique_ptr<VoxelSource>()> open;
  /// What a voxel of the finest level holds, where a formula says it.
  std::function<std::uint16_t(glm::ivec3)> formula;
};

/// Draws voxels deep in a volume twice: streamed, and from a part in memory that a formula gives.
/// @return mean difference of pixels, of 255
double differenceAt(const Terabyte& terabyte, scene::Scene scene, glm::ivec3 place) {
  constexpr int kHalf = 48;
  glm::dmat4 world = worldFromLevel(*scene.volume.data, 0);
  double voxel = smallestSpacing(world);
  scene.camera = {};
  scene.camera.target = glm::dvec3(world * glm::dvec4(glm::dvec3(place), 1.0));
  scene.camera.eye = scene.camera.target + glm::dvec3(-0.5, -1.0, 0.4) * (300.0 * voxel);
  scene.camera.projection = scene::Projection::Orthographic;
  scene.camera.height = 60.0 * voxel;
  scene::Cut box;
  box.shape = scene::CutShape::Box;
  box.centre = scene.camera.target + voxel * glm::dvec3(0.13, 0.21, 0.37);  // no edge lies between two pixels
  box.size = glm::dvec3(40.0 * voxel);
  box.invert = true;
  scene.cuts = {box};
  Volume part = *scene.volume.data;
  part.finer = nullptr;
  part.dims = glm::ivec3(2 * kHalf);
  part.worldFromVoxel = world * glm::translate(glm::dmat4(1.0), glm::dvec3(place - kHalf));
  part.voxels.resize(voxelCount(part) * sizeof(std::uint16_t));
  auto* to = reinterpret_cast<std::uint16_t*>(part.voxels.data());
  for (int z = 0; z < part.dims.z; ++z)
    for (int y = 0; y < part.dims.y; ++y)
      for (int x = 0; x < part.dims.x; ++x) *to++ = terabyte.formula(place - kHalf + glm::ivec3(x, y, z));
  Image images[2];
  for (Image& image : images) {
    render::Renderer renderer(sharedContext());
    Progress progress;
    renderer.render({.scene = scene, .pictureSize = {160, 160}}, progress);
    image = renderer.read();
    scene.volume.data = Shared<Volume>(part);
  }
  double sum = 0;
  std::size_t count = std::min(images[0].pixels.size(), images[1].pixels.size());
  for (std::size_t i = 0; i < count; ++i) sum += std::abs(double(images[0].pixels[i]) - double(images[1].pixels[i]));
  return 255.0 * sum / double(count);
}

/// The largest difference of pictures at several places.
std::string comparedWithFormula(const Terabyte& terabyte, const scene::Scene& scene, Report& report) {
  glm::ivec3 dims = finestDims(*scene.volume.data);
  double most = 0;
  for (glm::dvec3 share : {glm::dvec3(0.7, 0.21, 0.9), glm::dvec3(0.11, 0.5, 0.33), glm::dvec3(0.98, 0.97, 0.03)})
    most = std::max(most, differenceAt(terabyte, scene, glm::ivec3(share * glm::dvec3(dims))));
  report.figure(terabyte.key + "Difference", most);
  return fmt::format("{:.2f} of 255", most);
}

/// Until a picture at rest is there, ms.
struct FirstPicture {
  double first = 0;  ///< with the bricks that are there
  double whole = 0;  ///< with all its bricks
};
FirstPicture drawFirst(render::Renderer& renderer, const render::Frame& frame) {
  FirstPicture picture;
  Clock::time_point drawing = Clock::now();
  while (!renderer.work(frame, 8.0))
    if (picture.first == 0 && renderer.stats().samples > 0) picture.first = msFrom(drawing);
  picture.whole = msFrom(drawing);
  if (picture.first == 0) picture.first = picture.whole;
  return picture;
}

void measureTerabyte(const Options& options, const Terabyte& terabyte, Report& report) {
  glm::ivec2 size(1280, 720);
  Progress progress;
  double before = double(velum::allocatedBytes());
  Clock::time_point start = Clock::now();
  auto source = terabyte.open();
  double known = msFrom(start), bytes = levelBytes(*source, 0);
  Volume volume = io::readFitting(std::move(source), {}, false, progress);
  double opened = msFrom(start);
  glm::ivec3 coarse = volume.dims, fine = finestDims(volume);
  scene::Scene scene = brightScene(std::move(volume), double(size.x) / size.y);
  FirstPicture picture;
  Flight flight;
  {
    render::Renderer renderer(sharedContext());
    picture = drawFirst(renderer, {.scene = scene, .pictureSize = size, .brickBytes = memoryBudget().gpuBrickBytes});
    flight = fly(renderer, scene, size, options.quick ? 20.0 : 600.0);
  }
  report.note(fmt::format("{}: {:.2f} TB of 16 bits, {} x {} x {} voxels; {} x {} pixels.", terabyte.title,
                          bytes / 1e12, fine.x, fine.y, fine.z, size.x, size.y));
  std::vector<std::vector<std::string>> rows = {
      {"what it holds is known", formatMs(known) + " ms"},
      {fmt::format("a coarse level of {} x {} x {} is in memory", coarse.x, coarse.y, coarse.z),
       formatMs(opened) + " ms"},
      {"first picture, at rest", formatMs(picture.first) + " ms"},
      {"all its bricks", formatMs(picture.whole) + " ms"},
      {fmt::format("a flight of {:.1f} minutes, {} moving pictures: median, longest", flight.minutes,
                   flight.answers.size()),
       fmt::format("{}, {} ms", formatMs(median(flight.answers)), formatMs(largest(flight.answers)))},
      {"longest piece of work in it", formatMs(flight.longestPiece) + " ms"},
      {fmt::format("{} rests in it, until all bricks are there: median, longest", flight.settled.size()),
       fmt::format("{}, {} ms", formatMs(median(flight.settled)), formatMs(largest(flight.settled)))},
      {"most memory that was allocated, above what the program had",
       fmt::format("{:.0f} MB", (flight.mostAllocated - before) / 1e6)},
      {"most memory of the process", fmt::format("{:.0f} MB", flight.mostResident / 1e6)},
      {"most in the cache of bricks on the GPU", fmt::format("{:.0f} MB", flight.mostOnGpu / 1e6)}};
  if (terabyte.formula)
    rows.push_back({"pictures of three places deep in it, against its formula in memory: mean difference at most",
                    comparedWithFormula(terabyte, scene, report)});
  report.table({"of a terabyte", "measured"}, rows);
  report.figure(terabyte.key, {{"openMs", opened},
                               {"firstMs", picture.first},
                               {"wholeMs", picture.whole},
                               {"minutes", flight.minutes},
                               {"movingMs", median(flight.answers)},
                               {"longestMovingMs", largest(flight.answers)},
                               {"longestPieceMs", flight.longestPiece},
                               {"restMs", median(flight.settled)},
                               {"allocatedMb", (flight.mostAllocated - before) / 1e6},
                               {"residentMb", flight.mostResident / 1e6},
                               {"gpuMb", flight.mostOnGpu / 1e6}});
}

}  // namespace

Volume openBrain(int size, Progress& progress) {
  return io::readFitting(io::makeBrain(size, progress), {}, false, progress);
}

scene::Scene brightScene(Volume volume, double aspect) {
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

double largest(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void measureTerabytes(const Options& options, Report& report) {
  MemoryBudget former = memoryBudget(), budget = former;
  budget.gpuBrickBytes = double(1 << 30);
  budget.brickBytes = 2.0 * (1 << 30);
  setMemoryBudget(budget);
  Progress progress;
  std::unique_ptr<VoxelSource> brain = io::makeBrain(10410, progress);
  measureTerabyte(options, {"terabyte", "Computed when it is read", [&] { return std::move(brain); }, {}}, report);

  TempFolder folder;
  io::RepeatedField field;
  io::writeRepeatedStore(folder / "large.ome.zarr", {10240, 10240, 5120}, field);
  scene::Source source;
  source.path = folder / "large.ome.zarr";
  measureTerabyte(options,
                  {"terabyteOnDisk", "Of real files, each of which is there many times",
                   [&] { return io::openPyramid(source); }, [&](glm::ivec3 p) { return field.at(0, p); }},
                  report);
  setMemoryBudget(former);
}

}  // namespace velum::bench
