// What a picture costs with a finer sheet.
#include <fmt/format.h>

#include "Data.h"
#include "Frames.h"
#include "Sections.h"
#include "core/Clock.h"
#include "gpu/Program.h"
#include "io/phantoms/Sample.h"
#include "render/Renderer.h"
#include "scene/Presets.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::bench {

namespace {

constexpr glm::ivec2 kPicture(800, 600);
constexpr int kPictures = 9;

/// The median of pictures from several sides, after two that do not count. @return ms
double pictureMs(const scene::Scene& scene) {
  Progress progress;
  render::Renderer renderer(sharedContext());
  render::Frame frame;
  frame.scene = scene;
  frame.pictureSize = kPicture;
  std::vector<double> times;
  for (int i = -2; i < kPictures; ++i) {
    frame.scene.camera = turned(scene.camera, i + 2, 200);
    auto start = Clock::now();
    renderer.render(frame, progress);
    gpu::finish();
    if (i >= 0) times.push_back(msSince(start));
  }
  return median(times);
}

}  // namespace

void measureFineSheets(const Options& options, Report& report) {
  report.section("fine-sheets", "Pictures with a fine sheet");
  sharedContext().makeCurrent();
  Progress progress;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(io::makeSample("vessels", options.quick ? 256 : 512, progress).volume);
  scene::applyPreset(scene, "ct-bone");
  scene.camera = scene::frameCamera(scene, scene::StandardView::Anterior, double(kPicture.x) / kPicture.y);
  scene = plain(scene);
  scene.cuts = {membraneAcross(scene, glm::normalize(glm::dvec3(0.3, 1, 0.2)), 0.4)};
  session::protectValues(*scene.cuts[0].membrane, 700, 2000);
  scene::Scene flat = scene;
  flat.cuts[0].membrane.reset();
  flat.cuts[0].shape = scene::CutShape::Plane;
  double plane = pictureMs(flat);
  std::vector<std::vector<std::string>> rows{{"the plane", "", "", formatMs(plane), "1.00"}};
  for (int finest : {50, 128, 260, 512, 1024}) {
    scene::Scene settled = scene;
    settled.cuts[0].membrane->cloth.finest = finest;
    auto start = Clock::now();
    auto reports = session::settleMembranes(settled, {true, false}, progress);
    double settleMs = msSince(start);
    double picture = pictureMs(settled);
    glm::ivec2 n = settled.cuts[0].membrane->shape.particles;
    report.figure(fmt::format("fineSheets/{}", finest),
                  {{"settleMs", settleMs}, {"pictureMs", picture}, {"ratio", reports[0].kept->ratio}});
    rows.push_back({fmt::format("{} x {}", n.x, n.y), formatMs(settleMs), fmt::format("{:.2f}", reports[0].kept->ratio),
                    formatMs(picture), fmt::format("{:.2f}", picture / plane)});
  }
  report.note(fmt::format(
      "Vessels, {} voxels along each edge, protected by value; {} x {} pixels of one ray, shaded, without shadows, "
      "median of {}. Ratio: pairs of protected voxels cut by the sheet / by the plane.",
      options.quick ? 256 : 512, kPicture.x, kPicture.y, kPictures));
  report.table({"particles", "to rest, ms", "ratio", "picture, ms", "by the plane's"}, rows);
}

}  // namespace velum::bench
