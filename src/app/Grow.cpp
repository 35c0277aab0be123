#include <fmt/format.h>

#include <cmath>

#include "app/Inputs.h"
#include "app/Text.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "core/FinestVoxels.h"
#include "core/Text.h"
#include "io/labels/WriteLabels.h"
#include "scene/GreyWindows.h"
#include "scene/Scene.h"
#include "session/extrusion/GrowStructure.h"
#include "session/structure/StructureExport.h"
#include "session/structure/StructureSizes.h"

namespace velum::app {

namespace {

struct GrowOptions {
  Common common;
  InputOptions input;
  std::vector<std::string> seeds, strokes, others, otherStrokes;
  std::vector<double> range, plane;
  std::optional<double> distance, steepest, closing;
  int within = 0;
  bool guard = false, fillHoles = false;
  std::string name, output;
};

/// Which options stand for the fields of a command.
const Words kOptions{{"growth.grow seed or strokes", "--seed or --stroke"},
                     {"growth.grow distance needs plane", "--distance needs --plane"},
                     {"growth.grow guard needs plane", "--guard needs --plane"},
                     {"growth.grow guard and others", "--guard and --not"},
                     {"growth.grow seed", "--seed"},
                     {"growth.grow strokes", "--stroke"},
                     {"growth.grow others", "--not"},
                     {"growth.grow otherStrokes", "--not-stroke"},
                     {"growth.grow range", "--range"},
                     {"growth.grow plane", "--plane"},
                     {"growth.grow within", "--within"}};

std::vector<glm::dvec3> placesOf(const char* option, const std::vector<std::string>& texts) {
  std::vector<glm::dvec3> places;
  for (const auto& text : texts) {
    auto n = numbersOf(option, text, 3, "x,y,z");
    places.emplace_back(n[0], n[1], n[2]);
  }
  return places;
}

session::GrowStructure askedOf(const GrowOptions& options) {
  if (options.distance && *options.distance < 0.0)
    throw ArgumentError(fmt::format("--distance {}: it must not be less than 0", *options.distance));
  session::GrowStructure asked;
  asked.seeds = placesOf("--seed", options.seeds);
  asked.strokes = options.strokes;
  asked.others = placesOf("--not", options.others);
  asked.otherStrokes = options.otherStrokes;
  asked.range = options.range;
  asked.plane = options.plane;
  asked.distance = options.distance.value_or(scene::Growth::kEndless);
  asked.steepest = options.steepest.value_or(scene::Growth::kEndless);
  asked.closing = options.closing.value_or(0.0);
  asked.within = options.within;
  asked.fillHoles = options.fillHoles;
  asked.guard = options.guard;
  asked.name = options.name;
  return asked;
}

/// Refuses a range that was not typed where the guard of the growth has doubts. @throw ArgumentError
void refuseDoubts(const session::GrowthStatus& status, const scene::Growth& step) {
  if (status.leak && status.leak->times == 0.0)
    throw ArgumentError(
        fmt::format("--guard: the material at the seed, {:.6g} to {:.6g}, reaches the darkest values of the data, or "
                    "is most of what there is at the plane; give a --range, another --seed, or leave --guard out",
                    step.low, step.high));
}

Json pointOf(glm::ivec3 v) { return {v.x, v.y, v.z}; }

Json reportOf(const scene::Growth& step, const session::GrowthStatus& status, const session::StructureSize& size,
              const Volume& volume) {
  double voxelSize = std::abs(glm::determinant(glm::dmat3(FinestVoxels(volume).grid().worldFromVoxel)));
  const session::GrowthFigures& figures = status.figures;
  Json json = {{"structure", step.structure},
               {"voxels", size.voxels},
               {"smoothed", figures.smoothed},
               {"slabs", figures.slabs},
               {"ms", figures.ms},
               {"range", {step.low, step.high}},
               {"distance", std::isfinite(step.distance) ? Json(step.distance) : Json()},
               {"volume", double(size.voxels) * voxelSize}};
  if (volume.lengthUnit == LengthUnit::Millimetre) json["volumeMl"] = double(size.voxels) * voxelSize / 1000.0;
  if (size.voxels > 0) json["box"] = {{"first", pointOf(size.low)}, {"last", pointOf(size.high)}};
  if (status.leak)
    json["leak"] = {{"depth", figures.leakDepth}, {"area", figures.leakArea}, {"widestBefore", figures.widestBefore}};
  return json;
}

void print(const Json& report) {
  fmt::print("{} voxels in {} slabs, {:.2f} ms", report["voxels"].get<std::size_t>(), report["slabs"].get<int>(),
             report["ms"].get<double>());
  if (report.contains("volumeMl")) fmt::print(", {:.6g} ml", report["volumeMl"].get<double>());
  if (report.contains("values"))
    fmt::print(", mean {} {}", tidyNumber(report["values"]["mean"].get<double>()),
               report["valueUnit"].get<std::string>());
  fmt::print("\n");
  if (report.contains("leak"))
    fmt::print("stopped at {:.6g}: the slab behind is {:.4g} wide, {:.4g} was to be expected\n",
               report["distance"].get<double>(), report["leak"]["area"].get<double>(),
               report["leak"]["widestBefore"].get<double>());
}

int run(const GrowOptions& options) {
  expectOutput(options.output, io::expectLabelFormat);
  session::GrowStructure asked = askedOf(options);
  session::Session session;
  openInputs(session, options.input, 1.0);
  bool hasLabels(session.scene().labels.data);
  Progress& progress = consoleProgress();
  app::run(session, asked, kOptions);
  session.grow(progress);
  const scene::Scene& scene = session.scene();
  const scene::Growth& step = scene.labels.growths.back();
  session::GrowthStatus status = session.growth().status();
  refuseDoubts(status, step);
  LabelVolume result = session::labelsOf(scene);
  auto warnings = hasLabels ? result.warnings : std::vector<std::string>();
  printWarnings(options.input.labels.empty() ? options.output : options.input.labels, warnings);
  auto lost = io::writeLabels(result, options.output, progress);
  printWarnings(options.output, lost);
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  progress.report(1.0, "");
  const Volume& volume = *scene.volume.data;
  auto sizes = session::countStructures(result, progress);
  Json report = reportOf(step, status, sizes[step.structure], volume);
  auto values = session::measureValues(result, volume, step.channel, step.timeStep, progress);
  if (auto found = values.find(step.structure); found != values.end()) report["values"] = valuesJson(found->second);
  report["valueUnit"] = scene::valueUnit(volume);
  report["name"] = options.name;
  report["guarded"] = options.guard;
  report["output"] = options.output;
  report["warnings"] = warnings;
  options.common.json ? printJson(report) : print(report);
  return 0;
}

}  // namespace

Run registerGrow(CLI::App& verb) {
  auto options = std::make_shared<GrowOptions>();
  options->name = "grown";
  addCommon(verb, options->common);
  addInput(verb, options->input, true);
  verb.add_option("--seed", options->seeds, "a place on the structure, x,y,z; repeatable")->allow_extra_args(false);
  verb.add_option("--stroke", options->strokes,
                  "a line over the structure, x,y,z;x,y,z;...: it grows from all of it that has its values; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--not", options->others,
                  "a place that is not of it, x,y,z, where it leaks: it gives up what is nearer to that by values and "
                  "form; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--not-stroke", options->otherStrokes, "the same for a line, x,y,z;x,y,z;...; repeatable")
      ->allow_extra_args(false);
  verb.add_option("--range", options->range, "values that belong to it: A,B; default: the material at the first seed")
      ->delimiter(',')
      ->expected(2);
  verb.add_option("--plane", options->plane,
                  "grow on one side of a plane only: nx,ny,nz,d, where n.p > d; default: everywhere")
      ->delimiter(',')
      ->expected(4);
  verb.add_option("--distance", options->distance, "no deeper than so much away from the plane");
  verb.add_option("--steepest", options->steepest, "stop where the gradient is as large or larger, value per length")
      ->check(CLI::NonNegativeNumber);
  verb.add_option("--within", options->within,
                  "take a part of the structure with this label; default: of what has none")
      ->check(CLI::Range(0, 65535));
  verb.add_option("--closing", options->closing,
                  "close gaps and pores in what has grown that no ball of this radius gets into")
      ->check(CLI::NonNegativeNumber);
  verb.add_flag("--fill-holes", options->fillHoles, "what it encloses becomes part of it");
  verb.add_flag("--guard", options->guard, "stop before it leaks into what it touches");
  verb.add_option("--name", options->name, "of the new structure")->capture_default_str();
  verb.add_option("-o,--output", options->output, "labels, with those of the input: .nrrd, .seg.nrrd, .nii, .nii.gz")
      ->required();
  return [options] { return run(*options); };
}

}  // namespace velum::app
