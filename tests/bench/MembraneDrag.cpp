// How soon a membrane follows whoever drags its frame.
#include <fmt/format.h>

#include <algorithm>

#include "Data.h"
#include "Frames.h"
#include "Sections.h"
#include "core/Clock.h"
#include "session/membrane/MembraneEdit.h"
#include "session/membrane/MembraneMover.h"
#include "session/membrane/Membranes.h"

namespace velum::bench {

namespace {

constexpr int kMoves = 20;

/// Makes the forces that are wanted, and lets the sheet move until that is seen.
/// @return ms
double answer(session::MembraneMover& player) {
  Progress progress;
  auto start = Clock::now();
  std::uint64_t shown = player.shownCount();
  if (auto work = player.nextWork()) player.endWork(work(progress));
  while (player.shownCount() == shown && player.isMoving()) player.advance(10.0);
  return msSince(start);
}

struct Data {
  const char* phantom;
  glm::ivec3 dims;
  double low, high;  ///< protected
};

/// From nothing to a sheet at rest, as a command line asks for it. @return ms
double settleMs(scene::Scene scene) {
  Progress progress;
  return session::settleMembranes(scene, {}, progress)[0].totalMs;
}

std::vector<std::string> rowOf(const Data& data, Report& report) {
  Progress progress;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(makePhantom(data.phantom, data.dims));
  glm::ivec3 n = scene.volume.data->dims;
  scene::addCut(scene, membraneAcross(scene, glm::normalize(glm::dvec3(1, 0.6, 0.35)), 0.4));
  session::protectValues(*scene.cuts[0].membrane, data.low, data.high);
  double atRest = settleMs(scene);
  session::MembraneMover player;
  player.follow(scene);
  double first = answer(player), exact = answer(player);
  std::vector<double> moves;
  for (int i = 0; i < kMoves; ++i) {
    scene.cuts[0].centre += scene.cuts[0].axis * (0.005 * scene.cuts[0].size.x);
    player.follow(scene);
    moves.push_back(answer(player));
  }
  player.releaseGpu();
  double worst = *std::max_element(moves.begin(), moves.end());
  report.figure(
      fmt::format("drag/{}/{}x{}x{}", data.phantom, n.x, n.y, n.z),
      {{"restMs", atRest}, {"firstMs", first}, {"exactMs", exact}, {"moveMs", median(moves)}, {"worstMs", worst}});
  return {fmt::format("{} {} x {} x {}", data.phantom, n.x, n.y, n.z),
          formatMs(atRest),
          formatMs(first),
          formatMs(exact),
          formatMs(median(moves)),
          formatMs(worst)};
}

}  // namespace

void measureMembraneDrag(const Options& options, Report& report) {
  report.section("drag", "A membrane whose frame is dragged");
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  // The last one is the usual CT.
  for (const Data& data : {Data{"vessels", glm::ivec3(128), 700, 2000}, Data{"vessels", glm::ivec3(256), 700, 2000},
                           Data{"vessels", glm::ivec3(384), 700, 2000}, Data{"vessels", glm::ivec3(512), 700, 2000},
                           Data{"torso", {512, 512, 300}, 250, 1000}})
    if (!options.quick || data.dims.x <= 256) rows.push_back(rowOf(data, report));
  report.note(fmt::format(
      "Vessels, or bone, protected by value, an oblique frame, ms: from nothing to a sheet at rest; from a new "
      "membrane to a sheet that moves, from there to "
      "exact "
      "forces (small data has them at once), and from each of {} moves of the frame to a sheet that is seen to move "
      "for it. "
      "Goals at 512 x 512 x 300: at rest within 8 s, the first within 1 s, moves within 100 ms.",
      kMoves));
  report.table({"data", "at rest", "first sheet", "exact", "a move", "worst"}, rows);
}

}  // namespace velum::bench
