#include "app/CountAreas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/Clock.h"
#include "core/Error.h"
#include "core/Log.h"
#include "core/ReplaceFile.h"
#include "core/Text.h"
#include "session/document/Open.h"
#include "session/extrusion/AreaSolver.h"
#include "session/model/CountFiles.h"
#include "session/structure/StructureAreas.h"
#include "session/structure/StructureEdit.h"
#include "session/structure/StructureExport.h"

namespace velum::app {

namespace {

/// A target as it was asked for.
struct WantedArea {
  int structure = 0;
  double number = 0.0;
  bool isPercent = false;  ///< of all pixels whose rays meet the structure; else pixels
};

WantedArea wantedOf(const scene::Scene& scene, const std::string& text) {
  std::size_t equals = text.rfind('=');
  std::string_view number = equals == std::string::npos ? "" : std::string_view(text).substr(equals + 1);
  WantedArea wanted;
  wanted.isPercent = number.ends_with('%');
  if (wanted.isPercent) number.remove_suffix(1);
  auto value = numberIn(number);
  if (!value || !std::isfinite(*value) || *value < 0.0 || (wanted.isPercent && *value > 100.0))
    throw ArgumentError(fmt::format("--set-area {}: expected STRUCTURE=PIXELS, or STRUCTURE=PERCENT%", text));
  wanted.number = *value;
  try {
    wanted.structure = session::findStructures(session::labelsOf(scene).table, {text.substr(0, equals)}).front();
  } catch (const ArgumentError& error) {
    throw ArgumentError(fmt::format("--set-area {}: {}", text, error.what()));
  }
  return wanted;
}

std::vector<session::SolvedArea> settleAreas(scene::Scene& scene, const std::vector<WantedArea>& wanted,
                                             const std::vector<int>& cuts,
                                             const std::vector<render::StructureHit>& hits) {
  std::vector<session::SolvedArea> solved;
  for (const WantedArea& want : wanted) {
    session::AreaSolver solver(scene, cuts, want.structure, hits);
    double pixels = want.isPercent ? want.number / 100.0 * double(solver.range().total) : want.number;
    solved.push_back(solver.solve(pixels));
    scene = solved.back().scene;
    if (solved.back().reached != solved.back().wanted) log::warning(solved.back().words);
  }
  return solved;
}

std::vector<session::CountRow> rowsOf(const std::vector<session::StructureArea>& areas) {
  std::vector<session::CountRow> rows;
  for (const session::StructureArea& area : areas)
    rows.push_back({area.name, area.name, false, 0, {area.visible, area.hidden, area.clipped}});
  return rows;
}

/// Columns are as wide as what they hold; the last is how much of the picture shows it.
void printTable(const std::vector<session::StructureArea>& areas, double pixels) {
  std::size_t width = 4;
  for (const auto& area : areas) width = std::max(width, area.name.size());
  fmt::print("{:<{}} {:>10} {:>10} {:>10} {:>10} {:>10}\n", "", width, "visible", "hidden", "clipped", "total", "%");
  for (const auto& area : areas)
    fmt::print("{:<{}} {:>10} {:>10} {:>10} {:>10} {:>10.2f}\n", area.name, width, area.visible, area.hidden,
               area.clipped, area.total(), 100.0 * double(area.visible) / pixels);
}

Json areaJson(const session::StructureArea& area, double pixels) {
  return {{"id", area.structure},
          {"name", area.name},
          {"visible", area.visible},
          {"hidden", area.hidden},
          {"clipped", area.clipped},
          {"total", area.total()},
          {"visibleShare", double(area.visible) / pixels},
          {"totalShare", double(area.total()) / pixels}};
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
  printTable(areas, pixels);
  if (!solved.empty()) fmt::print("\n");
  for (const session::SolvedArea& area : solved) fmt::print("{}\n", area.words);
  return 0;
}

}  // namespace velum::app
