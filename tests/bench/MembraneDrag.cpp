// How soon a membrane follows whoever drags its frame.
#include <fmt/format.h>

#include <algorithm>

#include "Data.h"
#include "Frames.h"
#include "Sections.h"
#include "velum/core/Clock.h"
#include "velum/io/phantoms/Sample.h"
#include "velum/session/membrane/MembraneEdit.h"
#include "velum/session/membrane/MembranePlayer.h"

namespace velum::bench {

namespace {

constexpr int kMoves = 20;

/// Makes the forces that are wanted, and lets the sheet move until that is seen.
/// @return ms
double answer(session::MembranePlayer& player) {
  Progress progress;
  auto start = Clock::now();
  std::uint64_t shown = player.shownCount();
  if (auto work = player.nextWork()) player.endWork(work(progress));
  while (player.shownCount() == shown && player.isMoving()) player.advance(10.0);
  return msSince(start);
}

std::vector<std::string> rowOf(const char* phantom, int edge, Report& report) {
  Progress progress;
  scene::Scene scene;
  scene.volume.data = Shared<Volume>(io::makeSample(phantom, edge, progress).volume);
  glm::ivec3 n = scene.volume.data->dims;
  scene.cuts = {membraneAcross(scene, glm::normalize(glm::dvec3(1, 0.6, 0.35)), 0.4)};
  session::protectValues(*scene.cuts[0].membrane, 700, 2000);
  session::MembranePlayer player;
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
  report.figure(fmt::format("drag/{}/{}", phantom, edge),
                {{"firstMs", first}, {"exactMs", exact}, {"moveMs", median(moves)}, {"worstMs", worst}});
  return {fmt::format("{} {} x {} x {}", phantom, n.x, n.y, n.z), formatMs(first), formatMs(exact),
          formatMs(median(moves)), formatMs(worst)};
}

}  // namespace

void measureMembraneDrag(const Options& options, Report& report) {
  report.section("drag", "A membrane whose frame is dragged");
  sharedContext().makeCurrent();
  std::vector<std::vector<std::string>> rows;
  for (int edge : options.quick ? std::vector{256, 512} : std::vector{128, 256, 384, 512})
    rows.push_back(rowOf("vessels", edge, report));
  report.note(fmt::format(
      "Vessels protected by value, an oblique frame, ms: from a new membrane to a sheet that moves, from there to "
      "exact "
      "forces (small data has them at once), and from each of {} moves of the frame to a sheet that is seen to move "
      "for it. "
      "Goals at 512: the first within 1 s, moves within 100 ms.",
      kMoves));
  report.table({"data", "first sheet", "exact", "a move", "worst"}, rows);
}

}  // namespace velum::bench
