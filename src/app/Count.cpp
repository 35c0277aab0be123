#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/CountAreas.h"
#include "app/CountTable.h"
#include "app/Inputs.h"
#include "app/Targets.h"
#include "app/Verbs.h"
#include "core/Clock.h"
#include "core/Error.h"
#include "core/ReplaceFile.h"
#include "render/Renderer.h"
#include "session/command/ModelCommands.h"
#include "session/document/Open.h"
#include "session/model/CountFiles.h"
#include "session/model/WhatHides.h"
#include "session/picture/Picture.h"

namespace velum::app {

namespace {

struct CountOptions {
  Common common;
  InputOptions input;
  TargetOptions targets;
  std::vector<std::string> areas;
  std::string size, csv, svg, instances, whatHides, clearTheWay, output;
};

Json rowJson(const session::CountRow& row) {
  Json json = {{"name", row.name}, {"path", row.path}};
  json.update(countJson(row.count));
  return json;
}

Json hidingJson(const session::Hiding& hiding) {
  Json hiders = Json::array();
  for (const session::Hider& hider : hiding.hiders)
    hiders.push_back({{"type", hider.path}, {"pixels", hider.pixels}, {"share", hider.share}});
  return {{"type", hiding.path},
          {"pixels", hiding.pixels},
          {"seen", hiding.seen},
          {"hiders", hiders},
          {"words", hiding.words}};
}

void printHiding(const session::Hiding& hiding) {
  fmt::print("\n{}\n", hiding.words);
  for (const session::Hider& hider : hiding.hiders)
    fmt::print("  {:>8} pixels  {:>5.1f} %  {}\n", hider.pixels, 100.0 * hider.share,
               hider.path.empty() ? "what is no model" : hider.path);
}

/// True for options that only instances of a model can meet.
bool wantsModel(const CountOptions& options) {
  return !options.targets.counts.empty() || !options.targets.visibles.empty() || !options.instances.empty() ||
         !options.whatHides.empty() || !options.clearTheWay.empty();
}

/// The usual size of the picture: for the areas of structures a small one is enough, instances are often small and need
/// a larger one.
std::string sizeOf(const CountOptions& options, bool hasModel) {
  return options.size.empty() ? hasModel ? "1280x720" : "320x180" : options.size;
}

int countInstances(session::Session& session, const CountOptions& options, session::PictureCounter& counter) {
  if (!options.clearTheWay.empty()) app::run(session, session::KeepInView{options.clearTheWay});
  Progress& progress = consoleProgress();
  session.settle(progress);

  auto start = Clock::now();
  auto settled = settleTargets(session, options.targets, counter.aspect(), &counter);
  scene::Scene scene = session.settled(progress);
  const Model& model = *scene.model.data;
  render::InstanceBits bits = counter.count(scene);
  std::vector<session::CountRow> rows = session::countRows(scene.model, render::countTypes(model, bits));
  std::optional<session::Hiding> hiding;
  if (!options.whatHides.empty())
    hiding = session::whatHides(scene, options.whatHides, [&](const scene::Scene& of) { return counter.types(of); });
  double ms = msSince(start);
  progress.report(1.0, "");

  std::string title = fmt::format("{}, {} x {} pixels", model.name, counter.size().x, counter.size().y);
  if (!options.csv.empty()) replaceFile(options.csv, session::countsCsv(rows));
  if (!options.svg.empty()) replaceFile(options.svg, session::countsSvg(rows, title));
  if (!options.instances.empty()) replaceFile(options.instances, session::instancesCsv(model, bits));
  if (!options.output.empty()) session::saveScene(session.scene(), options.output);
  if (options.common.json) {
    Json json = {{"renderer", session.renderer().stats().renderer},
                 {"size", {counter.size().x, counter.size().y}},
                 {"ms", ms},
                 {"all", countJson(rows.front().count)},
                 {"perType", Json::array()},
                 {"perCompartment", Json::array()}};
    for (const auto& row : rows) json[row.isCompartment ? "perCompartment" : "perType"].push_back(rowJson(row));
    if (settled) {
      json["targets"] = Json::array();
      for (const auto& target : settled->targets) json["targets"].push_back(targetJson(target));
      json["residual"] = settled->residual;
      json["pictures"] = settled->pictures;
    }
    if (hiding) json["whatHides"] = hidingJson(*hiding);
    printJson(json);
    return 0;
  }
  printCounts(rows);
  if (settled) fmt::print("\n");
  if (settled)
    for (const auto& target : settled->targets) fmt::print("{}\n", target.words);
  if (hiding) printHiding(*hiding);
  return 0;
}

int run(const CountOptions& options) {
  for (const std::string& path : {options.csv, options.svg, options.instances, options.output}) expectOutput(path);
  glm::ivec2 size = session::parsePictureSize(sizeOf(options, true), 0);
  session::Session session;
  session.setContextKind(options.common.context);
  session.renderer();  // before data is read: without a driver nothing is counted
  openInputs(session, options.input, double(size.x) / size.y);
  const scene::Scene& scene = session.scene();
  bool hasModel(scene.model.data), hasLabels = scene.labels.data || !scene.labels.growths.empty();
  if (!hasModel && (!hasLabels || wantsModel(options)))
    throw InputError(hasLabels ? "there is no model, and of structures pixels are counted: see --set-area"
                               : "there is no model to count in, nor structures: name a file that has them");
  if (hasModel && !options.areas.empty())
    throw InputError("--set-area is of structures, and what is counted is a model: see --set-count");
  size = session::parsePictureSize(sizeOf(options, hasModel), 0);
  session::PictureCounter counter = session.counter(size, consoleProgress());
  if (hasModel) return countInstances(session, options, counter);
  AreaOptions areas{options.areas, options.csv, options.svg, options.output, options.common.json};
  return countAreas(session, areas, counter);
}

}  // namespace

Run registerCount(CLI::App& verb) {
  auto options = std::make_shared<CountOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--size", options->size,
                  "WIDTHxHEIGHT in pixels of the picture that is counted in; 1280x720, of structures 320x180");
  addTargets(verb, options->targets);
  verb.add_option(
          "--set-area", options->areas,
          "pull a structure out of the cuts until cuts leave N pixels of it, or P % of those that it has in the "
          "picture: STRUCTURE=N, STRUCTURE=P%, by its name or number; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--what-hides", options->whatHides, "say which types hide a type or compartment, and by how much");
  verb.add_option("--clear-the-way", options->clearTheWay,
                  "first remove what stands before a type or compartment: adds a cut that keeps it in view");
  verb.add_option("--csv", options->csv, "write the numbers as a table");
  verb.add_option("--svg", options->svg, "write them as bars");
  verb.add_option("--instances", options->instances, "write a table of all instances: visible, hidden or clipped");
  verb.add_option("-o,--output", options->output, "write the scene as JSON, with the cuts as they were set");
  return withTimeout(verb, [options] { return run(*options); });
}

}  // namespace velum::app
