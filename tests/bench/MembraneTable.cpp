// The paper's Table 1 on our phantoms: pictures a second while the sheet moves, and while it rests.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <memory>

#include "Data.h"
#include "Sections.h"
#include "gpu/Program.h"
#include "membrane/sheet/Sheet.h"
#include "membrane/sheet/Simulation.h"
#include "render/Renderer.h"
#include "scene/Presets.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;

constexpr glm::ivec2 kPicture(800, 600);

/// A row of the paper's table (GeForce GTX 580), and the phantom that stands in for its data.
struct PaperRow {
  const char* name;
  const char* phantom;
  const char* preset;
  glm::ivec3 dims;
  int level;
  std::size_t kernels;
  int paperMoving, paperResting;
};
const PaperRow kRows[] = {{"torso", "torso", "ct-bone", {256, 256, 556}, 3, 2300, 9, 15},
                          {"mouse", "vessels", "angiography", {424, 279, 190}, 2, 15000, 3, 12},
                          {"seismic", "seismic", "seismic", {121, 121, 121}, 2, 16000, 5, 13},
                          {"hippocampus", "neurons", "fluorescence", {212, 191, 44}, 1, 16000, 3, 5},
                          {"ultrasound", "ultrasound", "ultrasound", {181, 245, 190}, 3, 5000, 10, 14},
                          {"torso, coarser", "torso", "ct-bone", {256, 256, 556}, 4, 300, 12, 15}};

/// Protects as many of the largest values as give about so many kernels: their number falls with the lower bound.
std::size_t protectFor(std::size_t kernels, const membrane::Potential& potential, glm::dvec2 range,
                       scene::Membrane& membrane) {
  Progress progress;
  double low = range.x, high = range.y;
  std::size_t count = 0;
  for (int i = 0; i < 16; ++i) {
    double middle = 0.5 * (low + high);
    membrane.field.byValue.clear();
    session::protectValues(membrane, middle, range.y);
    count = potential.computeKernels(membrane.field, progress).count;
    (count > kernels ? low : high) = middle;
  }
  return count;
}

struct Rates {
  double moving = 0, resting = 0, stepMs = 0;
};

/// One step and one picture of one ray a pixel, in turn; then pictures of the sheet where it is, each from another side
/// of the same few degrees.
Rates ratesOf(const scene::Scene& scene, int pictures) {
  Progress progress;
  const scene::Cut& cut = scene.cuts[0];
  membrane::ForceMaker maker(scene);
  membrane::Simulation simulation;
  simulation.begin(cut, maker.compute(cut, {}, progress), {});
  auto sheet = std::make_shared<membrane::Sheet>(scene::SheetShape(), cut.membrane->cloth.particles, cut.size);
  render::Renderer renderer(sharedContext());
  render::Frame frame;
  frame.scene = scene;
  frame.pictureSize = kPicture;
  auto draw = [&](int i) {
    frame.scene.camera = turned(scene.camera, i, 200);
    frame.sheets[cut.id] = {sheet, sheet->revision()};
    renderer.render(frame, progress);
  };
  auto step = [&] {
    simulation.advance(1);
    simulation.places().copyTo(sheet->rows(), 0);
    gpu::barrier();
    sheet->index();
  };
  auto secondsOf = [&](auto work) {
    auto start = Clock::now();
    for (int i = 0; i < pictures; ++i) work(i);
    gpu::finish();
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  for (int i = 0; i < 3; ++i) step(), draw(i);
  gpu::finish();
  Rates rates;
  rates.moving = pictures / secondsOf([&](int i) { step(), draw(i); });
  rates.stepMs = 1000.0 * secondsOf([&](int) { step(), gpu::finish(); }) / pictures;
  rates.resting = pictures / secondsOf(draw);
  return rates;
}

}  // namespace

void measureMembraneTable(const Options& options, Report& report) {
  std::vector<std::vector<std::string>> rows;
  Progress progress;
  for (const PaperRow& row : kRows) {
    scene::Scene scene;
    glm::ivec3 dims = options.quick ? row.dims / 2 : row.dims;
    scene.volume.data = Shared<Volume>(makePhantom(row.phantom, dims));
    scene::applyPreset(scene, row.preset);
    scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kPicture.x) / kPicture.y);
    scene = plain(scene);
    scene.cuts = {session::makeCut(scene, scene::CutShape::Membrane)};
    scene::Membrane& membrane = *scene.cuts[0].membrane;
    membrane.field.level = row.level;
    std::size_t kernels = protectFor(options.quick ? row.kernels / 8 : row.kernels, membrane::Potential(scene),
                                     scene.volume.data->range, membrane);
    membrane.cloth.finest = membrane.cloth.particles.x;
    Rates sided = ratesOf(scene, options.quick ? 5 : 20);
    session::setRule(membrane, scene::KernelRule::Paper);
    Rates paper = ratesOf(scene, options.quick ? 5 : 20);
    auto rate = [](double perSecond) { return fmt::format("{:.1f}", perSecond); };
    rows.push_back({row.name, fmt::format("{} x {} x {}", dims.x, dims.y, dims.z), std::to_string(row.level),
                    std::to_string(kernels), std::to_string(row.paperMoving), rate(paper.moving), rate(sided.moving),
                    std::to_string(row.paperResting), rate(sided.resting), formatMs(paper.stepMs),
                    formatMs(sided.stepMs)});
    report.figure(fmt::format("table1/{}", row.name), {{"kernels", kernels},
                                                       {"paperRulePerS", paper.moving},
                                                       {"sidedPerS", sided.moving},
                                                       {"restingPerS", sided.resting},
                                                       {"paperRuleStepMs", paper.stepMs},
                                                       {"sidedStepMs", sided.stepMs}});
  }
  report.note(
      "The paper's Table 1 (GeForce GTX 580) beside ours on phantoms with as many voxels, kernels at the same level, "
      "50 x "
      "50 particles, 800 x 600 pixels of one ray, shaded, without shadows: pictures a second while the sheet moves (a "
      "step, then a picture) and while it rests.");
  report.table({"data", "voxels", "level", "kernels", "paper, moving", "ours, paper's rule", "ours, sided",
                "paper, at rest", "ours, at rest", "step, paper's rule, ms", "step, sided, ms"},
               rows);
}

}  // namespace velum::bench
