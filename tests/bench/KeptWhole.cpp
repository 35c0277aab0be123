// How much of what a membrane protects it keeps whole, against the limit.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "Data.h"
#include "Frames.h"
#include "Sections.h"
#include "io/phantoms/Sample.h"
#include "io/volumes/ReadVolume.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::bench {

namespace {

/// Data, and the values of what is clicked on to keep it whole.
struct Protected {
  const char* name;
  const char* source;  ///< a phantom, or a file of VELUM_TEST_DATA/volumes
  double low, high;
};
constexpr Protected kPhantoms[] = {{"vessels (phantom)", "vessels", 700, 2000},
                                   {"torso bones (phantom)", "torso", 250, 1000}};
constexpr Protected kScans[] = {{"aneurysm", "xa_aneurism.vti", 60, 256},
                                {"aortic dissection", "ct_heart_aorta_cta.nii.gz", 200, 4000},
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

/// The frame that the window hangs across an axis of the volume, at a share of its depth, and what a click protects.
scene::Cut membraneAt(const scene::Scene& scene, glm::dvec3 click, int axis, double share) {
  scene::Cut cut = membraneAcross(scene, direction(*scene.volume.data)[axis], share);
  session::protectTissue(*cut.membrane, scene.volume, click);
  return cut;
}

struct Plane {
  double paper = 0, sided = 0, limit = 0, paperMm = 0, sidedMm = 0, limitMm = 0, paperMs = 0, sidedMs = 0;
};

std::vector<Plane> sweep(const Protected& what, bool isPhantom, int positions) {
  Progress progress;
  std::vector<Plane> planes;
  scene::Scene scene = sceneOf(what, isPhantom);
  glm::dvec3 click = clickPlace(*scene.volume.data, what.low, what.high).value_or(centreOf(*scene.volume.data));
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < positions; ++i) {
      scene.cuts = {membraneAt(scene, click, axis, (i + 1.0) / (positions + 1))};
      auto sided = session::settleMembranes(scene, {true, true}, progress);
      if (sided[0].kept->cutAreaPlane < kLeastPairs) continue;
      scene.cuts[0].membrane->shape = {};
      session::setRule(*scene.cuts[0].membrane, scene::KernelRule::Paper);
      auto paper = session::settleMembranes(scene, {true, false}, progress);
      planes.push_back({paper[0].kept->ratio, sided[0].kept->ratio, sided[0].limit->figure.ratio,
                        paper[0].kept->meanDistance, sided[0].kept->meanDistance, sided[0].limit->figure.meanDistance,
                        paper[0].totalMs, sided[0].totalMs});
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
                  "section as those of the limit (goal 1.3).",
                  all.size(), median(excess), worst, distance));
  report.figure("goals", {{"median", median(excess)}, {"nineInTen", worst}, {"distance", distance}});
}

}  // namespace

void measureKeptWhole(const Options& options, Report& report) {
  report.section("kept-whole", "What the membrane keeps whole");
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  std::vector<Plane> all;
  auto add = [&](const Protected& what, bool isPhantom) {
    fmt::print(stderr, "{}\n", what.name);
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
      "Protected is what one click protects, on the material that the row names, nearest to the middle. Medians over "
      "planes at 10 places (3 with --quick) along each axis of the volume, where the plane cuts at "
      "least 30 pairs of protected voxels. Ratio: pairs cut by the sheet / by the plane. Time: from the scene to the "
      "sheet at rest.");
  report.table({"data", "planes", "paper's rule", "sided", "limit", "paper, mm", "sided, mm", "limit, mm", "paper, ms",
                "sided, ms"},
               rows);
  if (!all.empty()) noteGoals(all, report);
}

}  // namespace velum::bench
