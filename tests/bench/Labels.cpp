#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "Data.h"
#include "Sections.h"
#include "velum/core/LabelVolume.h"
#include "velum/render/Renderer.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// As a window shows it while a brush paints: 320 x 180 of 1280 x 720, double steps.
render::Frame brushFrame(const scene::Scene& scene) {
  render::Frame frame{scene, {320, 180}};
  frame.scene.rayCast.samplesPerPixel = 1;
  frame.stepFactor = 2.0;
  frame.isPreview = true;
  return frame;
}

/// Slabs of eight structures.
LabelVolume makeSlabs(int n, const glm::dmat4& frame) {
  LabelVolume labels({n, n, n}, frame);
  std::vector<std::uint16_t> slab(std::size_t(n) * std::size_t(n) * 32);
  for (int z = 0; z < n; z += 32) {
    for (std::size_t i = 0; i < slab.size(); ++i) slab[i] = std::uint16_t(1 + (i / 40 + std::size_t(z) / 32) % 8);
    labels.write({0, 0, z}, {n, n, 32}, slab);
  }
  for (std::uint16_t id = 1; id <= 8; ++id)
    labels.table.push_back({id, fmt::format("slab {}", id), defaultLabelColor(id), 1.0f});
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
  std::vector<double> ms;
  std::size_t bytes = 0;  ///< Sent for the last one.
};

/// From the edit to its picture, read back.
template <class Edit>
void time(Timed& timed, render::Renderer& renderer, render::Frame& frame, Edit&& edit) {
  Progress progress;
  auto start = Clock::now();
  edit();
  renderer.render(frame, progress);
  renderer.read();
  timed.ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  timed.bytes = renderer.stats().labelBytes;
}

}  // namespace

void measureLabels(const Options& options, Report& report) {
  report.section("labels", "Editing labels");
  int n = options.quick ? 128 : 512, turns = options.quick ? 3 : 15;
  Shared<Volume> volume(makeShells(n));
  scene::Scene scene = plain(makeShellScene(volume, Opacity::SkinOverBone, 16.0 / 9.0));
  LabelVolume slabs = makeSlabs(n, volume->worldFromVoxel);
  scene.labels.data = Shared<LabelVolume>(slabs);
  scene::completeStructures(scene.labels);
  render::Renderer renderer(sharedContext());
  render::Frame rest{scene, {64, 36}}, frame = brushFrame(scene);
  Progress progress;
  renderer.render(rest, progress);
  renderer.render(frame, progress);
  Timed known, fresh, whole;
  auto place = [&](int turn) { return glm::ivec3(n / 4 + 20 * turn % (n / 2), n / 2, n / 8); };
  for (int turn = 0; turn < turns; ++turn) {
    time(known, renderer, frame, [&] { paint(frame.scene.labels, place(turn), 3); });
    time(fresh, renderer, frame, [&] { paint(frame.scene.labels, place(turn) + 12, std::uint16_t(300 + 7 * turn)); });
  }
  for (int turn = 0; turn < 3; ++turn) {
    // The same labels as other bricks.
    LabelVolume other = makeSlabs(n, volume->worldFromVoxel);
    time(whole, renderer, frame, [&] { frame.scene.labels.data = Shared<LabelVolume>(std::move(other)); });
  }
  std::vector<std::vector<std::string>> rows;
  auto add = [&](const char* key, const char* what, Timed& timed) {
    double middle = median(timed.ms), worst = *std::max_element(timed.ms.begin(), timed.ms.end());
    rows.push_back({what, formatMs(middle), formatMs(worst), fmt::format("{:.1f}", double(timed.bytes) / 1024)});
    report.figure(key, {{"medianMs", middle}, {"worstMs", worst}, {"bytes", timed.bytes}});
  };
  add("known", "a thousand voxels of an id that is there", known);
  add("new", "a thousand voxels of an id never seen before", fresh);
  add("whole", "all labels, as when they are loaded", whole);
  report.note(fmt::format(
      "From an edit of {}^3 labels over a volume as large to its coarse picture (320 x 180 of 1280 x 720), ms.", n));
  report.table({"what changes", "edit to picture, median", "worst", "KiB sent"}, rows);
}

}  // namespace velum::bench
