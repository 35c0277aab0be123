// The membrane: how much it keeps whole against the limit, and how long it takes.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "Data.h"
#include "Sections.h"
#include "velum/gpu/Program.h"
#include "velum/io/ReadVolume.h"
#include "velum/io/Sample.h"
#include "velum/membrane/Sheet.h"
#include "velum/membrane/Simulation.h"
#include "velum/render/Renderer.h"
#include "velum/scene/Presets.h"
#include "velum/session/CutEdit.h"
#include "velum/session/MembraneEdit.h"
#include "velum/session/Membranes.h"

namespace velum::bench {

namespace {

using Clock = std::chrono::steady_clock;
double msSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Data, and the values that one click on what is to be kept whole protects.
struct Protected {
  const char* name;
  const char* source;  ///< a phantom, or a file of VELUM_TEST_DATA/volumes
  double low, high;
};
constexpr Protected kPhantoms[] = {{"vessels (phantom)", "vessels", 700, 2000},
                                   {"torso bones (phantom)", "torso", 250, 1000}};
constexpr Protected kScans[] = {{"aneurysm", "xa_aneurism.vti", 60, 256},
                                {"heart and aorta", "ct_heart_aorta_cta.nii.gz", 200, 4000},
                                {"arteriovenous malformation", "ct_head_avm_angio.nii.gz", 250, 1000},
                                {"abdomen bones", "ct_abdomen_3mm.nii.gz", 200, 4000},
                                {"mouse embryo", "embryo_mouse.nrrd", 110, 256},
                                {"mouse brain", "micro_mousebrain_100um.tiff", 2000, 65536},
                                {"thorax", "ct_torso_contrast_lidc2.mha", 170, 256}};

/// Fewer pairs than this make no ratio.
constexpr std::int64_t kLeastPairs = 30;

scene::Scene sceneOf(const Protected& what, bool isPhantom) {
  Progress progress;
  scene::Scene scene;
  if (isPhantom) {
    scene.volume.data = Shared<Volume>(io::makeSample(what.source, 160, progress).volume);
  } else {
    scene::Source source;
    source.path = (std::filesystem::path(std::getenv("VELUM_TEST_DATA")) / "volumes" / what.source).string();
    scene.volume.data = Shared<Volume>(io::readVolume(source, progress));
  }
  return scene;
}

/// The frame that the window hangs across an axis of the volume, at a share of its depth.
scene::Cut membraneAt(const scene::Scene& scene, const Protected& what, int axis, double share) {
  const Volume& volume = *scene.volume.data;
  glm::dvec3 along = direction(volume)[axis];
  scene::Scene seen = scene;
  seen.camera.targetMm = centreMm(volume);
  seen.camera.eyeMm = seen.camera.targetMm + along * 1000.0;
  scene::Cut cut = session::makeCut(seen, scene::CutShape::Membrane);
  cut.centreMm = centreMm(volume) + along * (spacingMm(volume)[axis] * volume.dims[axis] * (share - 0.5));
  session::protectValues(cut.membrane, what.low, what.high);
  return cut;
}

struct Plane {
  double paper = 0, sided = 0, limit = 0, paperMm = 0, sidedMm = 0, limitMm = 0, paperMs = 0, sidedMs = 0;
};

std::vector<Plane> sweep(const Protected& what, bool isPhantom, int positions) {
  Progress progress;
  std::vector<Plane> planes;
  scene::Scene scene = sceneOf(what, isPhantom);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < positions; ++i) {
      scene.cuts = {membraneAt(scene, what, axis, (i + 1.0) / (positions + 1))};
      auto sided = session::settleMembranes(scene, {true, true}, progress);
      if (sided[0].kept->cutAreaPlane < kLeastPairs) continue;
      scene.cuts[0].membrane.shape = {};
      session::setRule(scene.cuts[0].membrane, scene::KernelRule::Paper);
      auto paper = session::settleMembranes(scene, {true, false}, progress);
      planes.push_back({paper[0].kept->ratio, sided[0].kept->ratio, sided[0].limit->figure.ratio,
                        paper[0].kept->meanDistanceMm, sided[0].kept->meanDistanceMm,
                        sided[0].limit->figure.meanDistanceMm, paper[0].totalMs, sided[0].totalMs});
    }
  return planes;
}

double middleOf(const std::vector<Plane>& planes, double Plane::*member, double share = 0.5) {
  std::vector<double> values;
  for (const auto& plane : planes) values.push_back(plane.*member);
  std::sort(values.begin(), values.end());
  return values.empty() ? 0.0 : values[std::size_t(share * double(values.size() - 1))];
}

std::string number(double value) { return fmt::format("{:.2f}", value); }

std::vector<std::string> rowOf(const std::string& name, const std::vector<Plane>& planes) {
  std::vector<std::string> row{name, std::to_string(planes.size())};
  for (auto member : {&Plane::paper, &Plane::sided, &Plane::limit, &Plane::paperMm, &Plane::sidedMm, &Plane::limitMm})
    row.push_back(number(middleOf(planes, member)));
  row.push_back(formatMs(middleOf(planes, &Plane::paperMs)));
  row.push_back(formatMs(middleOf(planes, &Plane::sidedMs)));
  return row;
}

/// Of all planes: how the ratio compares with its goals, and the distance.
void noteGoals(const std::vector<Plane>& all, Report& report) {
  std::vector<double> excess, far;
  for (const auto& plane : all) {
    excess.push_back((plane.sided - 0.02) / std::max(plane.limit, 1e-3));
    far.push_back((plane.sided - 0.05) / std::max(plane.limit, 1e-3));
  }
  std::sort(far.begin(), far.end());
  double sided = 0, limit = 0;
  for (const auto& plane : all) sided += plane.sidedMm, limit += plane.limitMm;
  double worst = far[std::size_t(0.9 * double(far.size() - 1))], distance = sided / std::max(limit, 1e-9);
  report.note(
      fmt::format("Over all {} planes: (sided - 0.02) / limit is {:.2f} in the median (goal 1.25), (sided - 0.05) / "
                  "limit at most {:.2f} for nine in ten (goal 1.6); the sheets are {:.2f} times as far from the "
                  "slice as those of the limit (goal 1.3).",
                  all.size(), median(excess), worst, distance));
  report.figure("goals", {{"median", median(excess)}, {"nineInTen", worst}, {"distance", distance}});
}

void measureQuality(const Options& options, Report& report) {
  std::vector<std::vector<std::string>> rows;
  std::vector<Plane> all;
  auto add = [&](const Protected& what, bool isPhantom) {
    std::vector<Plane> planes = sweep(what, isPhantom, options.quick ? 3 : 10);
    all.insert(all.end(), planes.begin(), planes.end());
    rows.push_back(rowOf(what.name, planes));
    report.figure(std::string("kept/") + what.name, {{"paper", middleOf(planes, &Plane::paper)},
                                                     {"sided", middleOf(planes, &Plane::sided)},
                                                     {"limit", middleOf(planes, &Plane::limit)}});
  };
  for (const auto& what : kPhantoms) add(what, true);
  if (std::getenv("VELUM_TEST_DATA"))
    for (const auto& what : kScans) add(what, false);
  report.note(
      "Medians over planes at 10 places (3 with --quick) along each axis of the volume, where the plane cuts at "
      "least 30 pairs of protected voxels. Ratio: pairs cut by the sheet / by the plane. Time: from the scene to the "
      "sheet at rest.");
  report.table({"data", "planes", "paper's rule", "sided", "limit", "paper, mm", "sided, mm", "limit, mm", "paper, ms",
                "sided, ms"},
               rows);
  if (!all.empty()) noteGoals(all, report);
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
  measureQuality(options, report);
}

}  // namespace velum::bench
