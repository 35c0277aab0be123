#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "core/Text.h"
#include "scene/Scene.h"
#include "session/measure/Table.h"
#include "session/membrane/Membranes.h"

namespace velum::app {

namespace {

struct MeasureOptions {
  Common common;
  InputOptions input;
  std::vector<std::string> marks;
  std::string output, profiles;
  bool structures = false, faces = false;
};

bool isJsonFile(const std::filesystem::path& path) { return path.extension() == ".json"; }

void expectTableFormat(const std::filesystem::path& path) {
  if (path != "-" && path.extension() != ".csv" && !isJsonFile(path))
    throw InputError(fmt::format("{}: tables are written as .csv or .json", path.string()));
}
void expectCsv(const std::filesystem::path& path) {
  if (path != "-" && path.extension() != ".csv")
    throw InputError(fmt::format("{}: profiles are written as .csv", path.string()));
}

void write(const std::string& path, const std::string& text) {
  if (path == "-")
    fmt::print("{}", text);
  else
    replaceFile(path, text);
}

/// A line a row; the lines of a measure one after the other.
void print(const std::vector<session::MeasureRow>& rows) {
  for (const session::MeasureRow& row : rows) {
    std::string what = row.measured.problem.empty() ? row.measured.text : "not measured: " + row.measured.problem;
    std::string lines;
    for (char c : what) lines += c == '\n' ? std::string("; ") : std::string(1, c);
    fmt::print("{} {}{}{}: {}\n", row.kind, row.id, row.name.empty() ? "" : " ", printable(row.name), lines);
  }
}

/// @param text  arguments of the command mark.add: "distance points=0,0,0;10,0,0"
void addMark(session::Session& session, const std::string& text) {
  try {
    app::run(session, session::parseCall("mark.add " + text));
  } catch (const ArgumentError& error) {
    throw ArgumentError(fmt::format("--mark: {}", error.what()));
  }
}

int run(const MeasureOptions& options) {
  expectOutput(options.output, expectTableFormat);
  expectOutput(options.profiles, expectCsv);
  session::Session session;
  session.setContextKind(options.common.context);
  openInputs(session, options.input, 1.0);
  for (const std::string& text : options.marks) addMark(session, text);
  Progress& progress = consoleProgress();
  // Only sheets need a driver.
  scene::Scene scene = session::hasMembranes(session.scene()) ? session.settled(progress) : session.scene();
  session::TableParts parts{true, options.structures, options.faces};
  if (scene.lettering.marks.empty() && !options.structures && !options.faces)
    throw ArgumentError("there is nothing to measure: the scene has no marks; give --mark, --structures or --faces");
  bool wantsLabels = options.structures || options.faces;
  if (wantsLabels && !scene.labels.data)
    throw InputError("there are no structures to measure: name a file that has labels");
  auto rows = session::measureAll(scene, parts, progress);
  progress.report(1.0, "");
  if (!options.profiles.empty()) write(options.profiles, session::profilesCsv(rows));
  bool isJson = isJsonFile(options.output);
  std::string json = isJson || options.common.json ? session::tableJson(rows, scene.unit) : std::string();
  if (!options.output.empty()) write(options.output, isJson ? json : session::tableCsv(rows));
  if (options.common.json && options.output != "-")
    fmt::print("{}", json);
  else if (options.output != "-" && options.profiles != "-")
    print(rows);
  return 0;
}

}  // namespace

Run registerMeasure(CLI::App& verb) {
  auto options = std::make_shared<MeasureOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--mark", options->marks,
                  "measure this, too, as the command mark.add has it: KIND points=x,y,z;x,y,z;... [alongSurface=true] "
                  "[structure=NAME] [text=\"WORDS\"]; kinds are distance, angle, path, area, circle, box, region, "
                  "profile; repeatable")
      ->allow_extra_args(false);
  verb.add_flag("--structures", options->structures,
                "what the cuts leave of each structure: volume, share, surface, values");
  verb.add_flag("--faces", options->faces, "the area of the face of each cut in each structure");
  verb.add_option("--profiles", options->profiles, "write the samples of all profiles: .csv, or - for standard output");
  verb.add_option("-o,--output", options->output, "the table: .csv, .json, or - for CSV on standard output");
  return withTimeout(verb, [options] { return run(*options); });
}

}  // namespace velum::app
