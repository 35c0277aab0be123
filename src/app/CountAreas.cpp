#include "app/CountAreas.h"
#include "app/Inputs.h"

#include <fmt/format.h>

#include "app/CountTable.h"
#include "app/Targets.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "core/ReplaceFile.h"
#include "session/document/Open.h"
#include "session/extrusion/AreaSolver.h"
#include "session/model/CountFiles.h"
#include "session/structure/StructureAreas.h"
#include "session/structure/StructureEdit.h"
#include "session/structure/StructureExport.h"

namespace velum::app {

namespace {

/// A target as it was asked for; its number is in pixels, or a percentage of all pixels whose rays meet the structure.
struct WantedArea {
  int structure = 0;
  WantedNumber number;
};

WantedArea wantedOf(const scene::Scene& scene, const std::string& text) {
  WantedNumber number = wantedNumber("--set-area", text, "STRUCTURE=PIXELS, or STRUCTURE=PERCENT%", true);
  try {
    return {session::findStructures(session::labelsOf(scene).table, {number.name}).front(), number};
  } catch (const ArgumentError& error) {
    throw ArgumentError(fmt::format("--set-area {}: {}", text, error.what()));
  }
}

std::vector<session::SolvedArea> settleAreas(scene::Scene& scene, const std::vector<WantedArea>& wanted,
                                             const std::vector<int>& cuts,
                                             const std::vector<render::StructureHit>& hits) {
  std::vector<session::SolvedArea> solved;
  for (const WantedArea& want : wanted) {
    session::AreaSolver solver(scene, cuts, want.structure, hits);
    solved.push_back(solver.solve(want.number.of(solver.range().total)));
    scene = solved.back().scene;
    if (solved.back().reached != solved.back().wanted) log::warning(solved.back().words);
  }
  return solved;
}

std::vector<session::CountRow> rowsOf(const std::vector<session::StructureArea>& areas) {
  std::vector<session::CountRow> rows;
  for (const session::StructureArea& area : areas) rows.push_back({area.name, area.name, false, 0, area.count});
  return rows;
}

Json areaJson(const session::StructureArea& area, double pixels) {
  Json json = {{"id", area.structure}, {"name", area.name}};
  json.update(countJson(area.count));
  json["visibleShare"] = double(area.count.visible()) / pixels;
  json["totalShare"] = double(area.count.total()) / pixels;
  return json;
}

Json targetJson(const WantedArea& wanted, const session::SolvedArea& solved) {
  return {{"structure", wanted.structure},
          {"wanted", solved.wanted},
          {"reached", solved.reached},
          {"distance", solved.distance},
          {"met", solved.wanted == solved.reached},
          {"words", solved.words}};
}

}  // namespace

int countAreas(session::Session& session, const AreaOptions& options, session::PictureCounter& counter) {
  std::vector<WantedArea> wanted;
  for (const std::string& text : options.areas) wanted.push_back(wantedOf(session.scene(), text));
  Progress& progress = consoleProgress();
  scene::Scene scene = session.settled(progress);

  auto start = Clock::now();
  std::vector<int> cuts = session::cutsToPullFrom(scene);
  auto hits = render::structureHits(scene, counter.size(), cuts, progress);
  std::vector<session::SolvedArea> solved = settleAreas(scene, wanted, cuts, hits);
  if (!solved.empty()) hits = render::structureHits(scene, counter.size(), cuts, progress);
  auto areas = session::structureAreas(scene, hits, counter.structures(scene));
  double ms = msSince(start);
  progress.report(1.0, "");

  glm::ivec2 size = counter.size();
  double pixels = double(size.x) * double(size.y);
  std::vector<session::CountRow> rows = rowsOf(areas);
  if (!options.csv.empty()) replaceFile(options.csv, session::areasCsv(areas));
  std::string title = fmt::format("Pixels of structures, {} x {}", size.x, size.y);
  if (!options.svg.empty()) replaceFile(options.svg, session::countsSvg(rows, title));
  if (!options.output.empty()) session::saveScene(scene, options.output);
  if (options.json) {
    Json json = {{"renderer", session.renderer().stats().renderer},
                 {"size", {size.x, size.y}},
                 {"ms", ms},
                 {"perStructure", Json::array()}};
    for (const auto& area : areas) json["perStructure"].push_back(areaJson(area, pixels));
    for (std::size_t i = 0; i < solved.size(); ++i) json["targets"].push_back(targetJson(wanted[i], solved[i]));
    printJson(json);
    return 0;
  }
  printCounts(rows, pixels);
  if (!solved.empty()) fmt::print("\n");
  for (const session::SolvedArea& area : solved) fmt::print("{}\n", area.words);
  return 0;
}

}  // namespace velum::app
