// Table 1 of [ACS] on our phantoms: plain pictures, pictures while structures are pulled out, and with a finish.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <vector>

#include "Data.h"
#include "Sections.h"
#include "core/Clock.h"
#include "gpu/Program.h"
#include "io/phantoms/Sample.h"
#include "render/Renderer.h"
#include "scene/Presets.h"
#include "session/extrusion/Extrusion.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kPicture(800, 600);
constexpr std::size_t kPulled = 6;  ///< structures that stand out of each plane

/// A row of the paper's table (GeForce GTX 280), and the phantom that stands in for its data.
struct PaperRow {
  const char* name;
  const char* phantom;
  const char* preset;
  int voxels;  ///< along the longest edge
  double paperPlain, paperOne, paperTwo, paperFinal;
};
const PaperRow kRows[] = {{"body", "torso", "ct-skin", 512, 16.3, 14.2, 12.2, 14.1},
                          {"head", "skull", "ct-skin", 460, 33.2, 23.7, 21.9, 23.5},
                          {"foot", "foot", "ct-skin", 512, 41.6, 30.2, 28.5, 30.6},
                          {"hand", "hand", "ct-skin", 512, 48.2, 33.6, 31.2, 32.9},
                          {"tooth", "lesion", "ct-skin", 256, 100, 69.4, 69.4, 69.2}};

enum Way { Plain, OnePlane, TwoPlanes, OneFinal, TwoFinal, kWays };

/// The structures that a plane cuts most of.
std::vector<int> largestAcross(const LabelVolume& labels, const scene::Cut& plane) {
  std::vector<std::int64_t> count(65536, 0);
  glm::ivec3 n = labels.dims();
  double thick = glm::length(glm::dvec3(labels.worldFromVoxel()[0]));
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        glm::dvec3 world(labels.worldFromVoxel() * glm::dvec4(x, y, z, 1.0));
        if (std::abs(glm::dot(world - plane.centre, plane.axis)) < thick) ++count[labels.at({x, y, z})];
      }
  std::vector<int> ids;
  for (int id = 1; id < 65536; ++id)
    if (count[std::size_t(id)] > 0) ids.push_back(id);
  std::sort(ids.begin(), ids.end(), [&](int a, int b) { return count[std::size_t(a)] > count[std::size_t(b)]; });
  // The largest is what holds the others.
  if (ids.size() > 1) ids.erase(ids.begin());
  ids.resize(std::min(ids.size(), kPulled));
  return ids;
}

scene::Cut planeThrough(const scene::Scene& scene, glm::dvec3 axis) {
  scene::Bounds bounds = scene::computeBounds(scene);
  scene::Cut cut;
  cut.centre = (bounds.min + bounds.max) * 0.5;
  cut.axis = axis;
  return cut;
}

/// One of the ways to draw the same data.
struct Drawn {
  scene::Scene scene;
  std::vector<std::vector<int>> pulled;  ///< of each cut
  double most = 0.0;                     ///< how far out at most
  std::unique_ptr<render::Renderer> renderer;

  /// What a hand that pulls them out and back shows at one moment.
  void moveTo(double share) {
    for (std::size_t i = 0; i < pulled.size(); ++i)
      for (std::size_t k = 0; k < pulled[i].size(); ++k)
        session::setExtrusion(scene.cuts[i], pulled[i][k], most * (0.5 + 0.5 * std::sin(6.28 * share + double(k))));
  }
};

/// Of all threads where the processor draws, so that other programs do not count; else by the clock on the wall.
double nowMs(bool isSoftware) {
  if (isSoftware) return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC;
  static const auto begin = Clock::now();
  return msSince(begin);
}

std::array<Drawn, kWays> waysOf(const PaperRow& row, const Options& options) {
  Progress progress;
  io::Sample sample = io::makeSample(row.phantom, options.quick ? row.voxels / 4 : row.voxels, progress);
  scene::Scene plainScene;
  plainScene.volume.data = Shared<Volume>(std::move(sample.volume));
  scene::applyPreset(plainScene, row.preset);
  plainScene.camera = scene::frameCamera(plainScene, scene::StandardView::Oblique, double(kPicture.x) / kPicture.y);
  plainScene.lighting.shadow = plainScene.lighting.occlusion = 0.0;
  plainScene.rayCast.samplesPerPixel = 1;
  scene::addCut(plainScene, planeThrough(plainScene, {0, -1, 0}));
  scene::Scene edited = plainScene;
  edited.labels.data = Shared<LabelVolume>(std::move(sample.labels));
  edited.labels.tint = 0.0;
  scene::completeStructures(edited.labels);
  for (auto& structure : edited.labels.structures) structure.opacity = 1.0;  // both pictures show the same material
  scene::Bounds bounds = scene::computeBounds(edited);
  std::array<Drawn, kWays> ways;
  for (int way = 0; way < kWays; ++way) {
    Drawn& drawn = ways[std::size_t(way)];
    drawn.scene = way == Plain ? plainScene : edited;
    if (way == Plain) continue;
    drawn.most = 0.25 * (bounds.max.y - bounds.min.y);
    if (way == TwoPlanes || way == TwoFinal) session::addJoinedPlane(drawn.scene, drawn.scene.cuts[0].id);
    for (const auto& cut : drawn.scene.cuts) drawn.pulled.push_back(largestAcross(*drawn.scene.labels.data, cut));
    if (way != OneFinal && way != TwoFinal) continue;
    scene::Finish& finish = drawn.scene.finish;
    finish.contours = 0.9;
    finish.litSphere = 0.5;
    finish.sphere = "flesh";
    finish.paper = scene::Paper::Rough;
  }
  return ways;
}

/// How long a picture takes by each way, the ways in turn so that none has a quieter machine.
std::array<double, kWays> pictureMs(std::array<Drawn, kWays>& ways, int pictures) {
  Progress progress;
  bool isSoftware = sharedContext().limits().renderer.find("llvmpipe") != std::string::npos;
  std::array<std::vector<double>, kWays> times;
  for (auto& way : ways) way.renderer = std::make_unique<render::Renderer>(sharedContext());
  for (int i = -2; i < pictures; ++i)
    for (std::size_t way = 0; way < kWays; ++way) {
      Drawn& drawn = ways[way];
      drawn.moveTo(double(i + 2) / (pictures + 2));
      render::Frame frame;
      frame.scene = drawn.scene;
      frame.scene.camera = turned(drawn.scene.camera, i + 2, 200);
      frame.pictureSize = kPicture;
      double start = nowMs(isSoftware);
      drawn.renderer->render(frame, progress);
      gpu::finish();
      if (i >= 0) times[way].push_back(nowMs(isSoftware) - start);
    }
  std::array<double, kWays> out{};
  for (std::size_t way = 0; way < kWays; ++way) out[way] = median(times[way]);
  return out;
}

}  // namespace

void measureCrossSections(const Options& options, Report& report) {
  report.section("cross-sections", "Structures pulled out of cuts");
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  for (const PaperRow& row : kRows) {
    if (std::string(row.phantom).find(options.match) == std::string::npos) continue;
    std::array<Drawn, kWays> ways = waysOf(row, options);
    std::array<double, kWays> ms = pictureMs(ways, options.quick ? 5 : 15);
    auto ratio = [&](Way way, Way by) { return ms[std::size_t(way)] / ms[std::size_t(by)]; };
    auto number = [](double value) { return fmt::format("{:.2f}", value); };
    glm::ivec3 n = ways[Plain].scene.volume.data->dims;
    rows.push_back({row.name, row.phantom, fmt::format("{} x {} x {}", n.x, n.y, n.z), formatMs(ms[Plain]),
                    number(ratio(OnePlane, Plain)), number(row.paperPlain / row.paperOne),
                    number(ratio(TwoPlanes, Plain)), number(row.paperPlain / row.paperTwo),
                    number(ratio(OneFinal, OnePlane)), number(ratio(TwoFinal, TwoPlanes)),
                    number(row.paperOne / row.paperFinal)});
    report.figure(fmt::format("acsTable1/{}", row.name), {{"plainMs", ms[Plain]},
                                                          {"onePlane", ratio(OnePlane, Plain)},
                                                          {"twoPlanes", ratio(TwoPlanes, Plain)},
                                                          {"finishOne", ratio(OneFinal, OnePlane)},
                                                          {"finishTwo", ratio(TwoFinal, TwoPlanes)}});
  }
  report.note(fmt::format(
      "Table 1 of the paper (GeForce GTX 280) on phantoms: {} x {} pixels of one ray, shaded, without shadows, a "
      "picture with a plane and no labels; the same with labels, of which six move in and out of each plane, as a "
      "hand pulls; and with contours, lit sphere and paper. Where the processor draws, its time is counted, of all "
      "cores.",
      kPicture.x, kPicture.y));
  report.table(
      {"paper's data", "phantom", "voxels", "plain, ms", "one plane, times plain", "the paper's",
       "two planes, times plain", "the paper's", "finish, times one plane", "finish, times two planes", "the paper's"},
      rows);
}

}  // namespace velum::bench
