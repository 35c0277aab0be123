#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <random>

#include "Data.h"
#include "Sections.h"
#include "core/Clock.h"
#include "makeModel.h"
#include "render/Renderer.h"
#include "scene/Navigate.h"
#include "session/document/Open.h"
#include "session/model/RenderedSolver.h"
#include "session/model/TypesAt.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kView(1280, 720);
constexpr double kAspect = double(kView.x) / kView.y;
/// Radians. A picture that is there is not drawn again: one that rests is moved by less than anybody sees.
constexpr double kLeastTurn = 1e-6;

/// HIV in blood plasma where it is at hand, else the phantom of a virion, in the look of a plate.
scene::Scene openModel(bool completes) {
  const char* folder = std::getenv("VELUM_TEST_DATA");
  auto file = std::filesystem::path(folder ? folder : ".") / "mesoscale/hiv-blood/BloodHIV1.0_mixed_fixed_nc1.cpr";
  bool isThere = std::filesystem::exists(file);
  Progress progress;
  scene::Source source;
  source.path = file.string();
  scene::Scene scene = isThere ? session::open(source, progress)
                               : session::openSample("virion", 0, std::filesystem::temp_directory_path(), progress);
  if (isThere && !completes) {
    scene.model.completes = false;
    scene.model.data = {};
    scene.model.levels = {};
    session::loadData(scene, "/", progress);
  }
  scene.rayCast.samplesPerPixel = 1;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, kAspect);
  return scene;
}

std::uint64_t instancesOf(const scene::Scene& scene) {
  return std::uint64_t(scene.model.data->instances.size()) * std::uint64_t(std::max(1, scene.model.copies));
}

/// Every shape, so far away that none removes anything: all are asked about each instance, and the picture stays.
std::vector<scene::Cut> distantCuts(const scene::Scene& scene) {
  scene::Bounds bounds = scene::computeBounds(scene);
  double size = glm::length(bounds.max - bounds.min);
  std::vector<scene::Cut> cuts;
  for (int i = 0; i < 5; ++i) {
    scene::Cut cut;
    cut.id = i + 1;
    cut.shape = static_cast<scene::CutShape>(i);
    cut.axis = {1, 0.2, 0.1 * i};
    cut.centre = 0.5 * (bounds.min + bounds.max) + 5.0 * size * glm::dvec3(1, 0, 0);
    cut.size = glm::dvec3(size);
    cuts.push_back(cut);
  }
  return cuts;
}

/// The type with the median number of instances.
std::string focusOf(const scene::Scene& scene) {
  const Model& model = *scene.model.data;
  std::vector<std::uint32_t> order(model.types.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](auto a, auto b) { return model.types[a].instanceCount < model.types[b].instanceCount; });
  return pathOf(model, model.types[order[order.size() / 2]]);
}

/// A cut everywhere that keeps a type in view and clears all that hides it.
scene::Cut focusCut(const scene::Scene& scene, double aperture) {
  scene::Cut cut;
  cut.id = 9;
  cut.shape = scene::CutShape::Everywhere;
  scene::TypeSpare row;
  row.type = scene.model.data->compartments.front().name;
  row.aperture = aperture;
  cut.model.spares = {row};
  cut.model.focus.emplace().types = {{focusOf(scene)}};
  return cut;
}

struct Timed {
  double frameMs = 0, processor = 0, instances = 0, clipping = 0, focus = 0, counts = 0;
};

/// Medians over frames of a picture at rest.
Timed timeFrames(render::Frame frame, int frames) {
  Progress progress;
  render::Renderer renderer(sharedContext());
  scene::Camera start = frame.scene.camera;
  std::vector<Timed> all;
  for (int i = -2; i < frames; ++i) {
    frame.scene.camera = scene::turntable(start, kLeastTurn * (i + 2));
    double work = processorMs();
    renderer.render(frame, progress);
    work = processorMs() - work;
    const render::Stats& stats = renderer.stats();
    auto msOf = [&](const char* name) {
      auto found = stats.passesMs.find(name);
      return found == stats.passesMs.end() ? 0.0 : found->second;
    };
    if (i < 0) continue;  // those compile
    all.push_back({stats.frameMs, work, msOf("Instances"), msOf("Clipping"), msOf("Focus"), msOf("Counts")});
  }
  auto middle = [&](double Timed::*member) {
    std::vector<double> values;
    for (const Timed& one : all) values.push_back(one.*member);
    return median(values);
  };
  return {middle(&Timed::frameMs),  middle(&Timed::processor), middle(&Timed::instances),
          middle(&Timed::clipping), middle(&Timed::focus),     middle(&Timed::counts)};
}

std::string shareText(double part, double whole) { return fmt::format("{:.1f} %", 100.0 * part / whole); }

/// A frame with more and more of the equalizer on. The picture is the same but where a focus clears.
void measureFrame(const Options& options, Report& report, const std::string& key, const scene::Scene& scene) {
  struct Row {
    const char* name;
    bool hasCuts, counts;
    double aperture;  ///< below 0: no focus
  };
  constexpr Row kRows[] = {{"no clip objects", false, false, -1.0},
                           {"five clip objects", true, false, -1.0},
                           {"the same, counted", true, true, -1.0},
                           {"the same, and a focus", true, true, 1.0},
                           {"the same with an aperture", true, true, 0.5}};
  std::vector<std::vector<std::string>> table;
  for (const Row& row : kRows) {
    render::Frame frame{scene, kView};
    if (row.hasCuts) frame.scene.cuts = distantCuts(scene);
    if (row.aperture >= 0.0) frame.scene.cuts.push_back(focusCut(scene, row.aperture));
    frame.countsInstances = row.counts;
    Timed timed = timeFrames(frame, options.quick ? 3 : 9);
    table.push_back({row.name, formatMs(timed.frameMs), formatMs(timed.processor), formatMs(timed.instances),
                     formatMs(timed.clipping), formatMs(timed.focus), formatMs(timed.counts),
                     shareText(timed.clipping + timed.focus + timed.counts, timed.frameMs)});
    report.figure(fmt::format("{}/{}", key, row.name), {{"frameMs", timed.frameMs},
                                                        {"processorMs", timed.processor},
                                                        {"instancesMs", timed.instances},
                                                        {"clippingMs", timed.clipping},
                                                        {"focusMs", timed.focus},
                                                        {"countsMs", timed.counts}});
  }
  report.note(fmt::format("{}, {} instances, {} x {}, milliseconds:", key, instancesOf(scene), kView.x, kView.y));
  report.table(
      {"frame", "time", "processor time", "instances", "clipping", "focus", "counting", "the last three of the frame"},
      table);
}

/// How long a handle takes from when it is taken hold of, and at every step of the pointer.
void measureSolver(const Options& options, Report& report, const std::string& key, scene::Scene scene) {
  scene.cuts = distantCuts(scene);
  scene.cuts[0].centre = 0.5 * (scene::computeBounds(scene).min + scene::computeBounds(scene).max);
  std::vector<std::vector<std::string>> table;
  for (bool hasFocus : {false, true}) {
    if (hasFocus) scene.cuts.push_back(focusCut(scene, 1.0));
    for (const std::string& path : {focusOf(scene), scene.model.data->compartments.front().name}) {
      std::vector<double> made, solved;
      std::size_t types = session::typesAt(*scene.model.data, path).types.size();
      for (int i = 0; i < (options.quick ? 3 : 9); ++i) {
        auto start = Clock::now();
        session::RenderedSolver solver(scene, {1}, path, {}, kAspect);
        made.push_back(msSince(start));
        session::CountRange range = solver.range();
        start = Clock::now();
        solver.solve(double(range.least) + (i + 0.5) / 9.0 * double(range.most - range.least));
        solved.push_back(msSince(start));
      }
      table.push_back(
          {path, std::to_string(types), hasFocus ? "yes" : "no", formatMs(median(made)), formatMs(median(solved))});
      report.figure(fmt::format("{}/{}/{}", key, path, hasFocus ? "focus" : "plain"),
                    {{"types", types}, {"makeMs", median(made)}, {"solveMs", median(solved)}});
    }
  }
  report.note(fmt::format("A handle over {} instances, the median of milliseconds:", instancesOf(scene)));
  report.table({"handle of", "types", "a focus is on", "taken hold of", "a step of the pointer"}, table);
}

/// A cube of molecules in so many types.
scene::Scene madeScene(int types, int instances) {
  scene::Scene scene;
  scene.unit = LengthUnit::Angstrom;
  scene.model.data =
      Shared<Model>(ModelMaker{.types = types, .atoms = 20, .instances = instances, .halfEdge = 2000.0f}.make());
  scene.rayCast.samplesPerPixel = 1;
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, kAspect);
  return scene;
}

/// What all that is asked once for each instance and pixel costs, on the GPU and when it has arrived.
std::vector<std::string> scalingRow(const Options& options, Report& report, const std::string& key,
                                    const std::string& name, scene::Scene scene) {
  scene.cuts = distantCuts(scene);
  scene.cuts.push_back(focusCut(scene, 0.5));
  scene.lighting.shadow = 0.0;
  render::Frame frame{scene, kView};
  frame.countsInstances = true;
  Timed timed = timeFrames(frame, options.quick ? 1 : 3);
  Progress progress;
  render::Renderer renderer(sharedContext());
  renderer.render(frame, progress);
  auto bits = renderer.bits(true);
  auto start = Clock::now();
  if (bits) render::countTypes(*scene.model.data, *bits);
  double counted = msSince(start);
  start = Clock::now();
  session::RenderedSolver solver(scene, {1}, scene.model.data->compartments.front().name, {}, kAspect);
  double made = msSince(start);
  report.figure(key + "/" + name, {{"instances", instancesOf(scene)},
                                   {"frameMs", timed.frameMs},
                                   {"clippingMs", timed.clipping},
                                   {"focusMs", timed.focus},
                                   {"countsMs", timed.counts},
                                   {"typesCountedMs", counted},
                                   {"solverMs", made}});
  return {name,
          formatMs(timed.frameMs),
          formatMs(timed.clipping),
          formatMs(timed.focus),
          formatMs(timed.counts),
          formatMs(counted),
          formatMs(made)};
}

void measureGrowth(const Options& options, Report& report, scene::Scene scene) {
  std::vector<std::string> columns{"frame",    "clipping",         "focus",
                                   "counting", "added up by type", "a handle of all is taken hold of"};
  std::vector<std::vector<std::string>> table;
  std::vector<int> copies{1, 4, 13, 43};
  if (options.quick) copies.resize(2);
  for (int count : copies) {
    scene.model.copies = count;
    table.push_back(scalingRow(options, report, "instances", fmt::format("{}", instancesOf(scene)), scene));
  }
  columns.insert(columns.begin(), "instances");
  report.note("More and more copies, without shadows, five clip objects and a focus, milliseconds:");
  report.table(columns, table);
  table.clear();
  std::vector<int> types{10, 100, 1000, 10000};
  if (options.quick) types.resize(2);
  for (int count : types)
    table.push_back(scalingRow(options, report, "types", std::to_string(count), madeScene(count, 200'000)));
  columns.front() = "types";
  report.note("200,000 instances of more and more types:");
  report.table(columns, table);
}

}  // namespace

void measureEqualizer(const Options& options, Report& report) {
  report.section("equalizer", "The visibility equalizer");
  scene::Scene bare = openModel(false), full = openModel(true);
  measureFrame(options, report, "proteins alone", bare);
  measureFrame(options, report, "with lipids and strand", full);
  measureSolver(options, report, "solver", full);
  measureGrowth(options, report, full);
}

}  // namespace velum::bench
