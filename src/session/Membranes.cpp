#include "velum/session/Membranes.h"

#include <algorithm>
#include <chrono>

#include "velum/membrane/SheetIndex.h"
#include "velum/membrane/Simulation.h"

namespace velum::session {

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

bool isLive(const scene::Cut& cut) { return cut.enabled && cut.shape == scene::CutShape::Membrane; }

constexpr int kStepsAtOnce = 10;  ///< between two looks at the speed

membrane::ProtectedVoxels protectedVoxels(const membrane::Potential& potential, const scene::Cut& cut,
                                          Progress& progress) {
  return potential.computeProtected(cut.membrane.field, membrane::voxelsInReach(potential, cut), progress);
}

MembraneReport settle(membrane::ForceMaker& maker, scene::Cut& cut, Progress& progress) {
  MembraneReport report;
  report.name = cut.name;
  auto start = Clock::now();
  auto& membrane = cut.membrane;
  bool isActive = membrane.repositioning == scene::Repositioning::Active && membrane.shape.particles.x > 1;
  scene::SheetShape first;
  if (isActive) first = membrane::fitShape(membrane.shape, membrane.shape.particles, cut.sizeMm);
  bool isSided = membrane.field.rule == scene::KernelRule::Sided;
  membrane::HeightOver current;
  if (isActive && isSided) current = membrane::heightOf(first);
  membrane::Forces forces = maker.compute(cut, current, progress);
  report.kernels = forces.kernels;
  report.kernelsMs = forces.kernelsMs;
  report.leastCutMs = forces.leastCutMs;
  membrane::Simulation simulation;
  simulation.begin(cut, std::move(forces), first);
  auto stepping = Clock::now();
  while (simulation.advance(kStepsAtOnce)) progress.report(0.5, "membrane");
  report.steps = simulation.steps();
  report.stepMs = msSince(stepping) / std::max(1, report.steps);
  report.atRest = simulation.isAtRest();
  report.speedMmS = simulation.speed();
  membrane.shape = simulation.shape();
  report.particles = membrane.shape.particles;
  report.totalMs = msSince(start);
  return report;
}

}  // namespace

bool hasMembranes(const scene::Scene& scene) { return std::any_of(scene.cuts.begin(), scene.cuts.end(), isLive); }

membrane::KeptWhole measureMembrane(const membrane::Potential& potential, const scene::Cut& cut,
                                    const scene::SheetShape& shape, Progress& progress) {
  membrane::SheetIndex index = membrane::makeSheetIndex(shape, glm::ivec2(2), cut.sizeMm);
  auto side = [&](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = membrane::isAbove(index, local[i]) ? 1 : 0;
  };
  return membrane::measureKeptWhole(protectedVoxels(potential, cut, progress), cut, side,
                                    membrane::meanDistanceMm(shape), progress);
}

std::vector<MembraneReport> settleMembranes(scene::Scene& scene, MembraneQuestions questions, Progress& progress) {
  std::vector<MembraneReport> reports;
  if (!hasMembranes(scene)) return reports;
  membrane::ForceMaker maker(scene);
  for (std::size_t i = 0; i < scene.cuts.size(); ++i) {
    scene::Cut& cut = scene.cuts[i];
    if (!isLive(cut)) continue;
    MembraneReport report = settle(maker, cut, progress);
    report.cut = int(i);
    if (maker.potential().dims().x > 0) {
      if (questions.kept || questions.limit)
        report.kept = measureMembrane(maker.potential(), cut, cut.membrane.shape, progress);
      if (questions.limit)
        report.limit = membrane::computeLimit(protectedVoxels(maker.potential(), cut, progress), cut, progress);
    }
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace velum::session
