#include <fmt/format.h>
#include <stdlib.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "Child.h"
#include "Data.h"
#include "Sections.h"
#include "core/Error.h"

namespace velum::bench {

namespace {

struct Section {
  const char* name;
  void (*measure)(const Options& options, Report& report);
};
constexpr Section kSections[] = {{"vtk", measureAgainstVtk},
                                 {"interaction", measureInteraction},
                                 {"labels", measureLabels},
                                 {"growing", measureGrowing},
                                 {"cross-sections", measureCrossSections},
                                 {"membrane", measureMembrane},
                                 {"drag", measureMembraneDrag},
                                 {"fine-sheets", measureFineSheets},
                                 {"kept-whole", measureKeptWhole},
                                 {"families", measureFamilies},
                                 {"equalizer", measureEqualizer},
                                 {"scaling", measureScaling},
                                 {"fetches", measureFetches},
                                 {"loading", measureLoading},
                                 {"streaming", measureStreaming}};

double load() {
  double averages[1] = {0};
  getloadavg(averages, 1);
  return averages[0];
}

struct Outputs {
  std::string json, markdown;
};

void write(const std::string& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream out(path);
  out << text;
  if (!out.flush()) throw InputError(fmt::format("{} cannot be written", path));
}

constexpr const char* kHead = "<!-- Made by `./dev bench --markdown`; not to be edited by hand. -->\n";

/// What a file of tables holds from before; the head of a new one when it is not there.
std::string tablesSoFar(const std::string& path) {
  std::ifstream in(path);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return text.empty() ? kHead : text;
}

int run(const Options& options, const std::vector<std::string>& only, const Outputs& outputs) {
  if (!options.pictures.empty()) std::filesystem::create_directories(options.pictures);
  Report report;
  std::string renderer = sharedContext().limits().renderer;
  unsigned cores = std::thread::hardware_concurrency();
  report.section("machine", "Measured on");
  report.note(fmt::format("{} cores, {}{}; load of the machine before the start {:.1f}.", cores, renderer,
                          options.quick ? " (--quick: smaller data, fewer positions)" : "", load()));
  report.figure("", {{"renderer", renderer}, {"cores", cores}, {"quick", options.quick}, {"load", load()}});
  for (const Section& section : kSections) {
    // Families take hours: by name only.
    if (only.empty() && section.measure == measureFamilies) continue;
    if (!only.empty() && std::find(only.begin(), only.end(), section.name) == only.end()) continue;
    section.measure(options, report);
    report.figure("load", load());
    report.note(fmt::format("Load of the machine over the last minute: {:.1f}.", load()));
  }
  write(outputs.json, report.figures().dump(2) + "\n");
  write(outputs.markdown, report.markdownInto(tablesSoFar(outputs.markdown)));
  return 0;
}

int parseAndRun(int argc, char** argv) {
  CLI::App app("Measures Velum against VTK, ITK and the driver's own rates; prints Markdown tables.");
  Options options;
  Outputs outputs;
  std::vector<std::string> only, names;
  for (const Section& section : kSections) names.push_back(section.name);
  app.add_option("--only", only,
                 "sections to measure: vtk, interaction, labels, growing, cross-sections, membrane, drag, fine-sheets, "
                 "kept-whole, families, "
                 "equalizer, scaling, "
                 "fetches, loading, streaming")
      ->check(CLI::IsMember(names));
  app.add_flag("--quick", options.quick, "smaller data, fewer positions: a look, not a measurement");
  app.add_flag("--tune", options.tune, "families: the half of the planes on which constants may be chosen");
  app.add_option("--match", options.match, "families, cross-sections: only data that has this in its name");
  app.add_option(
      "--planes", options.planes,
      "families: file (CSV) of the planes; those in it are not measured again, so that hours may be shared out");
  app.add_option("--pictures", options.pictures,
                 "folder for pictures side by side: VTK GPU, VTK CPU, Velum, Velum with everything on");
  app.add_option("--json", outputs.json, "file for the figures");
  app.add_option("--markdown", outputs.markdown,
                 "file for the tables: those of the sections measured are put in the place of older ones");
  CLI11_PARSE(app, argc, argv);
  return run(options, only, outputs);
}

}  // namespace

}  // namespace velum::bench

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::strcmp(argv[1], "--child") == 0)
      return velum::bench::childMain(std::vector<std::string>(argv + 2, argv + argc));
    return velum::bench::parseAndRun(argc, argv);
  } catch (const velum::Error& error) {
    fmt::print(stderr, "velum-bench: {}\n", error.what());
    return static_cast<int>(error.exitCode());
  } catch (const std::exception& error) {
    fmt::print(stderr, "velum-bench: {}\n", error.what());
    return 1;
  }
}
