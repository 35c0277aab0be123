#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "Data.h"
#include "Sections.h"
#include "core/Clock.h"
#include "core/LabelVolume.h"
#include "gui/view/CoarseScale.h"
#include "render/Renderer.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kView(1280, 720);
constexpr int kCoarse = 4;

/// As a window shows it while a brush paints. @param scale  how much coarser than the view
render::Frame brushFrame(const scene::Scene& scene, double scale) {
  render::Frame frame{scene, glm::ivec2(glm::round(glm::dvec2(kView) / scale))};
  frame.scene.rayCast.samplesPerPixel = 1;
  frame.stepFactor = 2.0;
  frame.isPreview = true;
  return frame;
}

/// Eight balls, a structure each.
LabelVolume makeBalls(int n, const glm::dmat4& frame) {
  LabelVolume labels({n, n, n}, frame);
  std::vector<std::uint16_t> slab(std::size_t(n) * std::size_t(n) * 32);
  int half = n / 2;
  for (int z0 = 0; z0 < n; z0 += 32) {
    for (std::size_t i = 0; i < slab.size(); ++i) {
      glm::ivec3 p(int(i) % n, int(i) / n % n, z0 + int(i) / (n * n)), octant = p / half;
      glm::dvec3 fromMiddle = glm::dvec3(p - octant * half) - 0.5 * half;
      bool isInside = glm::dot(fromMiddle, fromMiddle) < 0.18 * half * half;
      slab[i] = isInside ? std::uint16_t(1 + octant.x + 2 * octant.y + 4 * octant.z) : std::uint16_t(0);
    }
    labels.write({0, 0, z0}, {n, n, 32}, slab);
  }
  for (std::uint16_t id = 1; id <= 8; ++id)
    labels.table.push_back({id, fmt::format("ball {}", id), defaultLabelColor(id), 1.0f});
  return labels;
}

/// A thousand voxels of one id, and its row in the table where it is new.
void paint(scene::LabelLayer& layer, glm::ivec3 at, std::uint16_t id) {
  LabelVolume labels = *layer.data;
  labels.write(at, {10, 10, 10}, std::vector<std::uint16_t>(1000, id));
  if (id > labels.table.back().id) labels.table.push_back({id, "new", defaultLabelColor(id), 1.0f});
  layer.data = Shared<LabelVolume>(std::move(labels));
  scene::completeStructures(layer);
}

struct Timed {
  std::vector<double> ms, otherMs;  ///< From the edit to its picture; of it what is not the rays'.
  std::vector<double> workMs;       ///< Processor time.
  std::size_t bytes = 0;            ///< Sent for the last one.
};

/// From the edit to its picture, read back.
template <class Edit>
void time(Timed& timed, render::Renderer& renderer, render::Frame& frame, Edit&& edit) {
  Progress progress;
  double work = processorMs();
  auto start = Clock::now();
  edit();
  renderer.render(frame, progress);
  renderer.read();
  timed.ms.push_back(msSince(start));
  timed.otherMs.push_back(timed.ms.back() - renderer.stats().passesMs.at("RayCast"));
  timed.workMs.push_back(processorMs() - work);
  timed.bytes = renderer.stats().labelBytes;
}

/// Turn by turn in other places, so that neither sends what the other has.
void paintByTurns(render::Renderer& renderer, render::Frame& frame, int turns, Timed& known, Timed& fresh) {
  int n = frame.scene.labels.data->dims().x;
  for (int turn = 0; turn < turns; ++turn) {
    glm::ivec3 at(n / 4 + 20 * turn % (n / 2), n / 2, n / 8);
    time(known, renderer, frame, [&] { paint(frame.scene.labels, at, 3); });
    auto id = std::uint16_t(frame.scene.labels.data->table.back().id + 7);
    time(fresh, renderer, frame, [&] { paint(frame.scene.labels, at + 12, id); });
  }
}

/// The scale at which a window of this scene stays.
double windowScale(render::Renderer& renderer, const scene::Scene& scene) {
  Progress progress;
  double scale = gui::kFirstScaleSoftware;
  for (int turn = 0; turn < 8; ++turn) {
    render::Frame frame = brushFrame(scene, scale);
    frame.scene.camera = turned(scene.camera, turn, 1000);
    renderer.render(frame, progress);
    scale = gui::adaptedScale(scale, renderer.stats().passesMs.at("RayCast"));
  }
  return scale;
}

class LabelTable {
 public:
  void add(Report& report, const std::string& key, const std::string& what, glm::ivec2 size, const Timed& timed) {
    double worst = *std::max_element(timed.ms.begin(), timed.ms.end());
    mRows.push_back({what, fmt::format("{} x {}", size.x, size.y), formatMs(median(timed.ms)), formatMs(worst),
                     formatMs(median(timed.otherMs)), formatMs(median(timed.workMs)),
                     fmt::format("{:.1f}", double(timed.bytes) / 1024)});
    report.figure(key, {{"medianMs", median(timed.ms)},
                        {"worstMs", worst},
                        {"withoutRaysMs", median(timed.otherMs)},
                        {"processorMs", median(timed.workMs)},
                        {"bytes", timed.bytes}});
  }
  void write(Report& report) const {
    report.table({"what changes", "picture", "edit to picture, median", "worst", "of it not the rays", "processor time",
                  "KiB sent"},
                 mRows);
  }

 private:
  std::vector<std::vector<std::string>> mRows;
};

/// @param key  of the figures  @param name  of the scene
void measureScene(const Options& options, Report& report, LabelTable& table, const std::string& key,
                  const std::string& name, const scene::Scene& scene) {
  int turns = options.quick ? 3 : 15;
  render::Renderer renderer(sharedContext());
  Progress progress;
  renderer.render({scene, {64, 36}}, progress);
  for (bool isWindow : {false, true}) {
    render::Frame frame = brushFrame(scene, isWindow ? windowScale(renderer, scene) : kCoarse);
    renderer.render(frame, progress);
    Timed known, fresh;
    paintByTurns(renderer, frame, turns, known, fresh);
    const char* size = isWindow ? "window" : "coarse";
    table.add(report, fmt::format("{}/{}/known", key, size), name + ": an id that is there", frame.pictureSize, known);
    table.add(report, fmt::format("{}/{}/new", key, size), name + ": a new id", frame.pictureSize, fresh);
  }
  // The same labels as other bricks.
  render::Frame frame = brushFrame(scene, kCoarse);
  Timed whole;
  for (int turn = 0; turn < 3; ++turn) {
    LabelVolume other = makeBalls(scene.labels.data->dims().x, scene.labels.data->worldFromVoxel());
    time(whole, renderer, frame, [&] { frame.scene.labels.data = Shared<LabelVolume>(std::move(other)); });
  }
  table.add(report, key + "/whole", name + ": all labels, as when they are loaded", frame.pictureSize, whole);
}

}  // namespace

void measureLabels(const Options& options, Report& report) {
  report.section("labels", "Editing labels");
  int n = options.quick ? 128 : 512;
  Shared<Volume> volume(makeShells(n));
  Shared<LabelVolume> balls(makeBalls(n, volume->worldFromVoxel));
  LabelTable table;
  for (Opacity opacity : {Opacity::Opaque, Opacity::SkinOverBone}) {
    scene::Scene scene = plain(makeShellScene(volume, opacity, double(kView.x) / kView.y));
    scene.labels.data = balls;
    scene::completeStructures(scene.labels);
    std::string name(kOpacityNames[static_cast<int>(opacity)]);
    measureScene(options, report, table, opacity == Opacity::Opaque ? "opaque" : "skin-bone", name, scene);
    if (opacity == Opacity::SkinOverBone) continue;
    scene.volume.data = {};
    measureScene(options, report, table, "alone", "labels alone", scene);
  }
  report.note(fmt::format(
      "A thousand voxels of {}^3 labels over a volume as large, and of labels alone: from the edit to its picture as a "
      "window of 1280 x 720 shows it while a brush paints (double steps), ms; first at a fixed size, then at the size "
      "to which the window goes, so that the rays take {:.0f} ms. Not the rays: copying the labels, what is sent, the "
      "map of empty space, tables, reading the picture.",
      n, gui::kCoarseTargetMs));
  table.write(report);
}

}  // namespace velum::bench
