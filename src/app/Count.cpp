#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "Targets.h"
#include "Verbs.h"
#include "velum/core/Clock.h"
#include "velum/core/Error.h"
#include "velum/core/ReplaceFile.h"
#include "velum/render/Renderer.h"
#include "velum/session/document/Open.h"
#include "velum/session/membrane/Membranes.h"
#include "velum/session/model/CountFiles.h"
#include "velum/session/model/WhatHides.h"
#include "velum/session/picture/Picture.h"

namespace velum::app {

namespace {

struct CountOptions {
  Common common;
  InputOptions input;
  TargetOptions targets;
  std::string size = "1280x720", csv, svg, instances, whatHides, clearTheWay, output;
  double timeout = 0;
};

Json countJson(const render::TypeCount& count) {
  return {{"visible", count.visible}, {"hidden", count.hidden}, {"clipped", count.clipped}, {"total", count.total()}};
}

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

/// Columns are as wide as what they hold.
void printTable(const std::vector<session::CountRow>& rows) {
  std::size_t width = 4;
  for (const auto& row : rows) width = std::max(width, std::size_t(2 * row.depth) + row.name.size());
  fmt::print("{:<{}} {:>10} {:>10} {:>10} {:>10}\n", "", width, "visible", "hidden", "clipped", "total");
  for (const auto& row : rows)
    fmt::print("{:<{}} {:>10} {:>10} {:>10} {:>10}\n", std::string(std::size_t(2 * row.depth), ' ') + row.name, width,
               row.count.visible, row.count.hidden, row.count.clipped, row.count.total());
}

void printHiding(const session::Hiding& hiding) {
  fmt::print("\n{}\n", hiding.words);
  for (const session::Hider& hider : hiding.hiders)
    fmt::print("  {:>8} pixels  {:>5.1f} %  {}\n", hider.pixels, 100.0 * hider.share,
               hider.path.empty() ? "what is no model" : hider.path);
}

int run(const CountOptions& options) {
  glm::ivec2 size = session::parsePictureSize(options.size, 0);
  auto context = gpu::Context::create(options.common.context);
  render::Renderer renderer(*context);
  scene::Scene scene = openScene(options.input, double(size.x) / size.y);
  if (!scene.model.data) throw InputError("there is no model to count in: name a file that has one");
  if (!options.clearTheWay.empty()) session::clearTheWay(scene, options.clearTheWay);
  const Model& model = *scene.model.data;
  Progress& progress = consoleProgress();
  if (session::hasMembranes(scene)) session::settleMembranes(scene, {}, progress);
  session::PictureCounter counter(renderer, size, context->limits(), progress);

  auto start = Clock::now();
  auto settled = settleTargets(scene, options.targets, counter.aspect(), &counter);
  render::InstanceBits bits = counter.count(scene);
  std::vector<session::CountRow> rows = session::countRows(model, render::countTypes(model, bits));
  std::optional<session::Hiding> hiding;
  if (!options.whatHides.empty())
    hiding = session::whatHides(scene, options.whatHides, [&](const scene::Scene& of) { return counter.types(of); });
  double ms = msSince(start);
  progress.report(1.0, "");

  std::string title = fmt::format("{}, {} x {} pixels", model.name, size.x, size.y);
  if (!options.csv.empty()) replaceFile(options.csv, session::countsCsv(rows));
  if (!options.svg.empty()) replaceFile(options.svg, session::countsSvg(rows, title));
  if (!options.instances.empty()) replaceFile(options.instances, session::instancesCsv(model, bits));
  if (!options.output.empty()) session::saveScene(scene, options.output);
  if (options.common.json) {
    Json json = {
        {"renderer", renderer.stats().renderer}, {"size", {size.x, size.y}}, {"ms", ms},
        {"all", countJson(rows.front().count)},  {"perType", Json::array()}, {"perCompartment", Json::array()}};
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
  printTable(rows);
  if (settled) fmt::print("\n");
  if (settled)
    for (const auto& target : settled->targets) fmt::print("{}\n", target.words);
  if (hiding) printHiding(*hiding);
  return 0;
}

}  // namespace

Run registerCount(CLI::App& verb) {
  auto options = std::make_shared<CountOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--size", options->size, "WIDTHxHEIGHT in pixels of the picture that is counted in")
      ->capture_default_str();
  addTargets(verb, options->targets);
  verb.add_option("--what-hides", options->whatHides, "say which types hide a type or compartment, and by how much");
  verb.add_option("--clear-the-way", options->clearTheWay,
                  "first remove what stands before a type or compartment: adds a cut that keeps it in view");
  verb.add_option("--csv", options->csv, "write the numbers as a table");
  verb.add_option("--svg", options->svg, "write them as bars");
  verb.add_option("--instances", options->instances, "write a table of all instances: visible, hidden or clipped");
  verb.add_option("-o,--output", options->output, "write the scene as JSON, with the cuts as they were set");
  verb.add_option("--timeout", options->timeout, "give up after so many seconds, with exit code 142; 0: never")
      ->check(CLI::Range(0.0, 1e6));
  return [options] {
    stopAfter(options->timeout);
    return run(*options);
  };
}

}  // namespace velum::app
