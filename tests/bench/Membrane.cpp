// The membrane: how long a step and an edit take.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "Data.h"
#include "Sections.h"
#include "velum/gpu/Program.h"
#include "velum/membrane/Kernels.h"
#include "velum/membrane/Solver.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A solver over a frame with so many kernels in it.
double stepMs(int particles, int kernels, bool isSided) {
  membrane::Solver solver;
  membrane::SheetSetup setup;
  setup.particles = glm::ivec2(particles);
  setup.halfMm = {64, 64, 20};
  setup.isAlongNormal = isSided;
  solver.setSheet(setup);
  membrane::PushField field;
  int along = std::max(2, int(std::cbrt(kernels * 3.2)));
  field.dims = {along, along, std::max(1, kernels / (along * along))};
  field.strengths.assign(std::size_t(field.dims.x) * std::size_t(field.dims.y) * std::size_t(field.dims.z),
                         glm::vec2(isSided ? 5.0f : 0.0f, isSided ? 0.0f : 5.0f));
  glm::dmat4 localFromKernel(1.0);
  for (int axis = 0; axis < 3; ++axis) {
    localFromKernel[axis][axis] = 2.0 * setup.halfMm[axis] / field.dims[axis];
    localFromKernel[3][axis] = -setup.halfMm[axis] + 0.5 * localFromKernel[axis][axis];
  }
  field.kernelFromLocal = glm::inverse(localFromKernel);
  solver.setField(field);
  solver.step(3);
  gpu::finish();
  std::vector<double> times;
  for (int i = 0; i < (particles > 100 ? 7 : 31); ++i) {
    auto start = Clock::now();
    solver.step(1);
    gpu::finish();
    times.push_back(msSince(start));
  }
  return median(times);
}

void measureSteps(Report& report) {
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  auto add = [&](int particles, int kernels) {
    double sided = stepMs(particles, kernels, true), paper = stepMs(particles, kernels, false);
    rows.push_back({fmt::format("{0} x {0}", particles), std::to_string(kernels), formatMs(sided), formatMs(paper)});
    report.figure(fmt::format("step/{}/{}", particles, kernels), {{"sidedMs", sided}, {"paperMs", paper}});
  };
  for (int kernels : {300, 16000, 1000000}) add(50, kernels);
  for (int particles : {25, 100, 200}) add(particles, 16000);
  report.note(
      "One step of the solver with all its eight passes over the constraints, ms. Goal: under 5 ms with 50 x 50 "
      "particles "
      "and 16,000 kernels, and within a tenth of that with 300.");
  report.table({"particles", "kernels", "sided", "paper's rule"}, rows);
}

void measureEdits(const Options& options, Report& report) {
  Volume volume;
  volume.dims = options.quick ? glm::ivec3(128, 128, 278) : glm::ivec3(256, 256, 556);
  volume.type = SampleType::Int16;
  volume.voxels.resize(frameBytes(volume));
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
  measureSteps(report);
  measureEdits(options, report);
  measureMembraneTable(options, report);
}

}  // namespace velum::bench
