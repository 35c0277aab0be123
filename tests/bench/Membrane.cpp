// The membrane: how long a step and an edit take.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "Data.h"
#include "Sections.h"
#include "core/Clock.h"
#include "gpu/Program.h"
#include "membrane/forces/Kernels.h"
#include "membrane/sheet/Solver.h"
#include "scene/Scene.h"

namespace velum::bench {

namespace {

struct StepCase {
  int particles, kernels;
  std::unique_ptr<membrane::Solver> sided, paper;
  std::vector<double> sidedMs, paperMs;
};

/// A solver over a frame with so many kernels in it.
std::unique_ptr<membrane::Solver> solverOf(int particles, int kernels, bool isSided) {
  auto solver = std::make_unique<membrane::Solver>();
  membrane::SheetSetup setup;
  setup.particles = glm::ivec2(particles);
  setup.half = {64, 64, 20};
  setup.isAlongNormal = isSided;
  solver->setSheet(setup);
  membrane::PushField field;
  int along = std::max(2, int(std::cbrt(kernels * 3.2)));
  field.dims = {along, along, std::max(1, kernels / (along * along))};
  field.strengths.assign(std::size_t(field.dims.x) * std::size_t(field.dims.y) * std::size_t(field.dims.z),
                         glm::vec2(isSided ? 5.0f : 0.0f, isSided ? 0.0f : 5.0f));
  glm::dmat4 localFromKernel(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    localFromKernel[axis][axis] = 2.0 * setup.half[axis] / field.dims[axis];
    localFromKernel[3][axis] = -setup.half[axis] + 0.5 * localFromKernel[axis][axis];
  }
  field.kernelFromLocal = glm::inverse(localFromKernel);
  solver->setField(field);
  solver->step(3);
  return solver;
}

double stepMs(membrane::Solver& solver) {
  gpu::finish();
  auto start = Clock::now();
  solver.step(1);
  gpu::finish();
  return msSince(start);
}

void measureSteps(const Options& options, Report& report) {
  sharedContext().makeCurrent();
  std::vector<StepCase> cases;
  for (auto [particles, kernels] : {std::pair(50, 300), std::pair(50, 16000), std::pair(50, 1000000),
                                    std::pair(25, 16000), std::pair(100, 16000), std::pair(200, 16000)})
    cases.push_back(
        {particles, kernels, solverOf(particles, kernels, true), solverOf(particles, kernels, false), {}, {}});
  // In turn, so that whatever else the machine does falls on all alike.
  for (int round = 0; round < (options.quick ? 11 : 61); ++round)
    for (auto& one : cases) {
      one.sidedMs.push_back(stepMs(*one.sided));
      one.paperMs.push_back(stepMs(*one.paper));
    }
  std::vector<std::vector<std::string>> rows;
  for (const auto& one : cases) {
    double sided = median(one.sidedMs), paper = median(one.paperMs);
    auto digits = [](double ms) { return fmt::format("{:.2f}", ms); };
    rows.push_back(
        {fmt::format("{0} x {0}", one.particles), std::to_string(one.kernels), digits(sided), digits(paper)});
    report.figure(fmt::format("step/{}/{}", one.particles, one.kernels), {{"sidedMs", sided}, {"paperMs", paper}});
  }
  report.note(
      "One step of the solver with all its eight passes over the constraints, ms, median of 61 (11 with --quick), all "
      "rows in turn. Goal: under 5 ms with 50 x 50 particles and 16,000 kernels, and within a tenth of that with 300.");
  report.table({"particles", "kernels", "sided", "paper's rule"}, rows);
}

void measureEdits(const Options& options, Report& report) {
  Volume volume;
  volume.dims = options.quick ? glm::ivec3(128, 128, 278) : glm::ivec3(256, 256, 556);
  volume.type = SampleType::Int16;
  volume.voxels.resize(timeStepBytes(volume));
  auto* samples = reinterpret_cast<std::int16_t*>(volume.voxels.data());
  for (std::size_t i = 0; i < voxelCount(volume); ++i) samples[i] = std::int16_t(i * 2654435761u >> 20);
  computeRange(volume);
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(std::move(volume));
  membrane::Potential potential(scene);
  Progress progress;
  std::vector<std::vector<std::string>> rows;
  for (int level : {1, 2, 3, 4}) {
    std::vector<double> times;
    for (int i = 0; i < 7; ++i) {
      scene::ForceField field;
      field.level = level;
      field.byValue = {{500.0 + i, 100.0}, {2000.0, 300.0}};
      auto start = Clock::now();
      potential.computeKernels(field, progress);
      times.push_back(msSince(start));
    }
    rows.push_back({std::to_string(level), formatMs(median(times))});
    report.figure(fmt::format("edit/{}", level), median(times));
  }
  glm::ivec3 n = scene.volume.data->dims;
  report.note(fmt::format("From an edited curve to new kernels, {} x {} x {} voxels of 16 bits, ms. Goal: under 100.",
                          n.x, n.y, n.z));
  report.table({"level", "ms"}, rows);
}

}  // namespace

void measureMembrane(const Options& options, Report& report) {
  report.section("membrane", "The membrane");
  sharedContext().makeCurrent();
  measureSteps(options, report);
  measureEdits(options, report);
  measureMembraneTable(options, report);
}

}  // namespace velum::bench
