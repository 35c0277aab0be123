// Membranes over a phantom of vessels of 40 GB, whose bricks are computed when they are read.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "Data.h"
#include "Sections.h"
#include "VesselSource.h"
#include "core/BrickCache.h"
#include "core/Memory.h"
#include "io/volumes/ReadLevel.h"
#include "membrane/forces/FinerSource.h"
#include "membrane/forces/KeptWhole.h"
#include "membrane/sheet/SheetIndex.h"
#include "session/cut/CutEdit.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/Membranes.h"

namespace velum::bench {

namespace {

/// A membrane across z of so large a share of the window's own frame.
scene::Scene membraneScene(const Shared<Volume>& volume, double share) {
  scene::Scene scene;
  scene.volume.data = volume;
  scene.camera.target = centreOf(*volume);
  scene.camera.eye = scene.camera.target + glm::dvec3(0.0, 0.0, 1000.0);
  scene.cuts = {session::makeCut(scene, scene::CutShape::Membrane)};
  scene.cuts[0].centre = centreOf(*volume) + glm::dvec3(9.0, 6.0, 5.0);
  scene.cuts[0].size *= share;
  session::protectValues(*scene.cuts[0].membrane, 700, 4000);
  return scene;
}

/// What the sheet cuts of what its plane cuts, counted in the finest voxels, whatever level the forces came from: block
/// by block, pairs between blocks left out, and only where sheet or plane pass.
double finestRatio(const scene::Scene& scene, Progress& progress) {
  constexpr int kBlock = 256;
  scene::Cut cut = scene.cuts[0];
  cut.membrane->field.leastPiece = 1;  // a block knows no pieces
  membrane::PotentialSource source = membrane::sourceOf(scene);
  const VoxelLevel& finest = scene.volume.data->finer->bricks->source().levels().front();
  glm::dmat4 localFromVoxel =
      glm::inverse(scene::worldFromCut(cut)) * worldFromLevel(*scene.volume.data, 0);  // along the same axes
  auto index = std::make_shared<const membrane::SheetIndex>(
      membrane::makeSheetIndex(cut.membrane->shape, glm::ivec2(2), cut.size));
  auto side = [index](std::span<const glm::vec3> local, std::span<std::uint8_t> above) {
    for (std::size_t i = 0; i < local.size(); ++i) above[i] = membrane::isAbove(*index, local[i]) ? 1 : 0;
  };
  auto isMet = [&](glm::dvec3 low, glm::dvec3 high) {
    if (low.z <= 0.0 && high.z >= 0.0) return true;
    double around = 2.0 * cut.size.x / cut.membrane->shape.particles.x;
    for (glm::vec3 p : cut.membrane->shape.places)
      if (p.x > low.x - around && p.x < high.x + around && p.y > low.y - around && p.y < high.y + around &&
          p.z > low.z - around && p.z < high.z + around)
        return true;
    return false;
  };
  membrane::VoxelBox reach = membrane::voxelsInReach(finest.dims, worldFromLevel(*scene.volume.data, 0), cut);
  std::int64_t sheet = 0, plane = 0;
  for (glm::ivec3 at = reach.min; at.z < reach.end.z; at.z += kBlock)
    for (at.y = reach.min.y; at.y < reach.end.y; at.y += kBlock)
      for (at.x = reach.min.x; at.x < reach.end.x; at.x += kBlock) {
        membrane::FinerBox box{0, {at, glm::min(at + kBlock, reach.end)}, true};
        glm::dvec3 a(localFromVoxel * glm::dvec4(glm::dvec3(box.box.min), 1.0));
        glm::dvec3 b(localFromVoxel * glm::dvec4(glm::dvec3(box.box.end), 1.0));
        if (!isMet(glm::min(a, b), glm::max(a, b))) continue;
        membrane::Potential potential(membrane::finerSource(source, box, progress));
        auto voxels = potential.computeProtected(cut.membrane->field, {glm::ivec3(0), potential.dims()}, progress);
        auto counted = membrane::measureKeptWhole(voxels, cut, side, 0.0, progress);
        sheet += counted.cutAreaMembrane, plane += counted.cutAreaPlane;
      }
  return double(sheet) / double(std::max<std::int64_t>(plane, 1));
}

}  // namespace

void measureStreamedMembranes(const Options& options, Report& report) {
  int size = options.quick ? 1100 : 2714;  // 40 GB
  Progress progress;
  auto source = makeVesselSource(size, progress);
  double bytes = levelBytes(*source, 0);
  Shared<Volume> volume(io::readFitting(std::move(source), {}, false, progress));
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  for (double share : {0.22, 0.45, 1.0}) {
    scene::Scene scene = membraneScene(volume, share), again = scene;
    double before = double(velum::allocatedBytes());
    auto start = std::chrono::steady_clock::now();
    auto first = session::settleMembranes(scene, {}, progress).at(0);
    double cold = msFrom(start), held = double(velum::allocatedBytes()) - before;
    scene = again;
    start = std::chrono::steady_clock::now();
    (void)session::settleMembranes(scene, {}, progress);
    double warm = msFrom(start);
    scene = again;
    auto figures = session::settleMembranes(scene, {true, true}, progress).at(0);
    double finest = finestRatio(scene, progress);
    double ratio = figures.kept->ratio, limit = figures.limit->figure.ratio;
    glm::dvec3 frame = scene.cuts[0].size;
    rows.push_back({fmt::format("{:.0f} x {:.0f} x {:.0f}", frame.x, frame.y, frame.z),
                    std::to_string(first.voxels.level), formatMs(cold), formatMs(warm), formatMs(first.kernelsMs),
                    formatMs(first.leastCutMs), fmt::format("{:.3f}", ratio), fmt::format("{:.3f}", limit),
                    fmt::format("{:.2f}", ratio / std::max(limit, 1e-6)), fmt::format("{:.3f}", finest),
                    fmt::format("{:.0f}", held / 1e6)});
    report.figure(fmt::format("membrane/{:.2f}", share), {{"level", first.voxels.level},
                                                          {"coldMs", cold},
                                                          {"warmMs", warm},
                                                          {"ratio", ratio},
                                                          {"limit", limit},
                                                          {"finestRatio", finest}});
  }
  report.note(
      fmt::format("Membranes over vessels of {:.1f} GB, {} voxels along each axis, of {:.3f} mm, computed when they "
                  "are read; {} x {} x {} are in memory. Cold: no brick is in memory.",
                  bytes / 1e9, size, 128.0 / size, volume->dims.x, volume->dims.y, volume->dims.z));
  report.table({"frame and reach, mm", "level", "at rest, cold, ms", "again, ms", "kernels, ms", "least cut, ms",
                "ratio", "limit", "ratio / limit (goal 1.25)", "ratio in the finest voxels", "memory kept, MB"},
               rows);
}

}  // namespace velum::bench
