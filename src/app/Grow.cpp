#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/Text.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "core/Text.h"
#include "growth/FirstDoubt.h"
#include "growth/Grower.h"
#include "growth/LabelsFor.h"
#include "growth/SmoothRegion.h"
#include "io/labels/WriteLabels.h"
#include "scene/GreyWindows.h"
#include "scene/Scene.h"
#include "session/extrusion/MaterialRange.h"
#include "session/growth/Growths.h"

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

std::string textOf(glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

/// A place. @throw ArgumentError when it lies outside the volume
glm::dvec3 placeOf(const char* option, const std::string& text, const Volume& volume) {
  auto n = numbersOf(option, text, 3, "x,y,z");
  glm::dvec3 place(n[0], n[1], n[2]);
  if (!growth::isInside(volume, growth::voxelAt(volume, place)))
    throw ArgumentError(fmt::format("{} {}: that is outside the volume", option, text));
  return place;
}

std::vector<glm::dvec3> seedsOf(const GrowOptions& options, const Volume& volume) {
  if (options.seeds.empty() && options.strokes.empty())
    throw ArgumentError("--seed or --stroke is needed: a place on the structure");
  std::vector<glm::dvec3> seeds;
  for (const auto& text : options.seeds) seeds.push_back(placeOf("--seed", text, volume));
  return seeds;
}

bool hasValueOf(const scene::Growth& step, const Volume& volume, glm::dvec3 place) {
  double value = valueAt(volume, growth::voxelAt(volume, place), step.channel, step.timeStep);
  return value >= step.low && value <= step.high;
}

/// The voxels along a stroke, a polygon "x,y,z;x,y,z;...", that have values of a step's range.
/// @throw ArgumentError where none has
void addStroke(const char* option, const std::string& text, const scene::Growth& step, const Volume& volume,
               std::vector<glm::dvec3>& places) {
  std::vector<glm::dvec3> path;
  std::istringstream in(text);
  for (std::string point; std::getline(in, point, ';');) path.push_back(placeOf(option, point, volume));
  std::size_t before = places.size();
  for (glm::dvec3 place : session::placesAlong(volume, path))
    if (hasValueOf(step, volume, place)) places.push_back(place);
  if (places.size() == before)
    throw ArgumentError(
        fmt::format("{} {}: no value along it is from {:.6g} to {:.6g}; draw it elsewhere, or "
                    "give --range",
                    option, text, step.low, step.high));
}

void addStrokes(scene::Growth& step, const GrowOptions& options, const Volume& volume) {
  for (const auto& text : options.strokes) addStroke("--stroke", text, step, volume, step.seeds);
}

/// Places that are not of it. @throw ArgumentError where one has no value of it, so that it would say nothing
void addOthers(scene::Growth& step, const GrowOptions& options, const Volume& volume) {
  for (const auto& text : options.others) {
    glm::dvec3 place = placeOf("--not", text, volume);
    if (!hasValueOf(step, volume, place))
      throw ArgumentError(
          fmt::format("--not {}: the value there is not from {:.6g} to {:.6g}, so it does not grow "
                      "there; choose a place that it takes",
                      text, step.low, step.high));
    step.others.push_back(place);
  }
  for (const auto& text : options.otherStrokes) addStroke("--not-stroke", text, step, volume, step.others);
  if (options.guard && !step.others.empty())
    throw ArgumentError("--guard and --not: what is told where it leaks is not guarded; leave one of them out");
}

/// Whose material is meant where no range is given.
glm::dvec3 firstPlace(const GrowOptions& options, const Volume& volume) {
  if (!options.seeds.empty()) return placeOf("--seed", options.seeds.front(), volume);
  return placeOf("--stroke", options.strokes.front().substr(0, options.strokes.front().find(';')), volume);
}

void setRange(scene::Growth& step, const GrowOptions& options, const scene::VolumeLayer& layer) {
  if (options.range.empty()) {
    glm::dvec3 first = firstPlace(options, *layer.data);
    auto material = session::materialRangeAt(layer, first);
    if (!material)
      throw ArgumentError(
          fmt::format("--seed {}: nothing is known of the values there; give --range A,B", textOf(first)));
    step.low = material->low, step.high = material->high;
  } else {
    if (options.range[0] > options.range[1]) throw ArgumentError("--range A,B: A must not be more than B");
    step.low = options.range[0], step.high = options.range[1];
  }
  for (const auto& seed : step.seeds) {
    double value = valueAt(*layer.data, growth::voxelAt(*layer.data, seed), step.channel, step.timeStep);
    if (!(value >= step.low && value <= step.high))
      throw ArgumentError(
          fmt::format("--seed {}: the value there is {:.6g}, not from {:.6g} to {:.6g}; choose another "
                      "place, or --range",
                      textOf(seed), value, step.low, step.high));
  }
}

void setPlane(scene::Growth& step, const GrowOptions& options) {
  if (options.plane.empty()) {
    if (options.distance) throw ArgumentError("--distance needs --plane, from which it is measured");
    if (options.guard) throw ArgumentError("--guard needs --plane: it watches how wide the structure is away from it");
    return;
  }
  glm::dvec3 normal(options.plane[0], options.plane[1], options.plane[2]);
  double squared = glm::dot(normal, normal);
  if (!(squared > 0.0)) throw ArgumentError("--plane nx,ny,nz,d: the normal must not be 0,0,0");
  step.axis = normal;
  step.centre = normal * (options.plane[3] / squared);
  step.distance = options.distance.value_or(scene::Growth::kEndless);
  if (step.distance < 0.0) throw ArgumentError(fmt::format("--distance {}: it must not be less than 0", step.distance));
}

/// One more than the largest label that is in use or has a name.
int freeLabel(const LabelVolume& labels) {
  int largest = 0;
  for (auto id : labels.idsInUse()) largest = std::max(largest, int(id));
  for (const auto& info : labels.table) largest = std::max(largest, int(info.id));
  if (largest == 65535) throw InputError("the labels have no number left for another structure");
  return largest + 1;
}

void setWithin(scene::Growth& step, const GrowOptions& options, const LabelVolume& labels) {
  step.within = options.within;
  auto ids = labels.idsInUse();
  if (step.within != 0 && std::find(ids.begin(), ids.end(), step.within) == ids.end())
    throw ArgumentError(fmt::format("--within {}: no voxel has that label", step.within));
}

/// What a guard asks of a range that nobody has typed. @throw ArgumentError
void refuseDoubts(const scene::Growth& step, const GrowOptions& options, const Shared<Volume>& volume,
                  const Shared<LabelVolume>& labels) {
  if (!options.guard || !options.range.empty()) return;
  const char* kHint = "give a --range, another --seed, or leave --guard out";
  if (growth::reachesTheDarkest(*volume, step))
    throw ArgumentError(
        fmt::format("--guard: the material at the seed, {:.6g} to {:.6g}, reaches the darkest values of "
                    "the data; {}",
                    step.low, step.high, kHint));
  scene::Growth first = step;
  first.distance = std::min(step.distance, growth::firstSlabEnd(*volume, step));
  auto grown = growth::Grower().grow(volume, labels, first, {.guard = false, .begun = {}}, consoleProgress());
  if (growth::isMostOfItsPlane(*volume, *grown.labels, first))
    throw ArgumentError(
        fmt::format("--guard: the material at the seed, {:.6g} to {:.6g}, is most of what there is at "
                    "the plane; {}",
                    step.low, step.high, kHint));
}

Json pointOf(glm::ivec3 v) { return {v.x, v.y, v.z}; }

Json reportOf(const scene::Growth& step, const growth::Grown& grown, std::size_t smoothed, const Volume& volume) {
  double voxelSize = std::abs(glm::determinant(glm::dmat3(volume.worldFromVoxel)));
  std::size_t voxels = grown.voxels + smoothed;
  Json json = {{"structure", step.structure},
               {"voxels", voxels},
               {"smoothed", smoothed},
               {"slabs", grown.slabs},
               {"ms", grown.ms},
               {"range", {step.low, step.high}},
               {"distance", std::isfinite(grown.distance) ? Json(grown.distance) : Json()},
               {"volume", double(voxels) * voxelSize}};
  if (volume.lengthUnit == LengthUnit::Millimetre) json["volumeMl"] = double(voxels) * voxelSize / 1000.0;
  if (!grown.box.isEmpty()) json["box"] = {{"first", pointOf(grown.box.first)}, {"last", pointOf(grown.box.end - 1)}};
  if (grown.leak)
    json["leak"] = {
        {"depth", grown.leak->depth}, {"area", grown.leak->area}, {"widestBefore", grown.leak->widestBefore}};
  return json;
}

void print(const growth::Grown& grown, const Json& report) {
  fmt::print("{} voxels in {} slabs, {:.2f} ms", report["voxels"].get<std::size_t>(), grown.slabs, grown.ms);
  if (report.contains("volumeMl")) fmt::print(", {:.6g} ml", report["volumeMl"].get<double>());
  if (report.contains("values"))
    fmt::print(", mean {} {}", tidyNumber(report["values"]["mean"].get<double>()),
               report["valueUnit"].get<std::string>());
  fmt::print("\n");
  if (grown.leak)
    fmt::print("stopped at {:.6g}: the slab behind is {:.4g} wide, {:.4g} was to be expected\n", grown.distance,
               grown.leak->area, grown.leak->widestBefore);
}

int run(const GrowOptions& options) {
  expectOutput(options.output, io::expectLabelFormat);
  scene::Scene scene = openScene(options.input, 1.0);
  if (!scene.volume.data) throw InputError("there is no volume to grow in: name a file that has one");
  const Volume& volume = *scene.volume.data;
  auto given = scene.labels.growths.empty() ? scene.labels.data : scene.labels.given;
  Shared<LabelVolume> labels = growth::labelsFor(volume, given);
  scene::Growth step;
  step.structure = freeLabel(*labels);
  step.seeds = seedsOf(options, volume);
  step.channel = std::clamp(scene.volume.channel, 0, volume.channels - 1);
  step.timeStep = std::clamp(scene.volume.timeStep, 0, volume.timeSteps - 1);
  step.steepest = options.steepest.value_or(scene::Growth::kEndless);
  step.closing = options.closing.value_or(0.0);
  step.fillHoles = options.fillHoles;
  setRange(step, options, scene.volume);
  addStrokes(step, options, volume);
  addOthers(step, options, volume);
  setPlane(step, options);
  setWithin(step, options, *labels);
  refuseDoubts(step, options, scene.volume.data, labels);
  growth::Grown grown = growth::Grower().grow(scene.volume.data, labels, step, {options.guard}, consoleProgress());
  scene::Growth done = step;
  done.distance = grown.distance;
  auto smoothed = growth::smoothRegion(scene.volume.data, grown.labels, done, consoleProgress(), grown.others);
  LabelVolume result = *smoothed.labels;
  for (auto& info : result.table)
    if (info.id == step.structure) info.name = options.name;
  auto warnings = given ? result.warnings : std::vector<std::string>();
  printWarnings(options.input.labels.empty() ? options.output : options.input.labels, warnings);
  auto lost = io::writeLabels(result, options.output, consoleProgress());
  printWarnings(options.output, lost);
  warnings.insert(warnings.end(), lost.begin(), lost.end());
  consoleProgress().report(1.0, "");
  Json report = reportOf(step, grown, smoothed.voxels, volume);
  auto values = session::measureValues(result, volume, step.channel, step.timeStep, consoleProgress());
  if (auto found = values.find(step.structure); found != values.end()) report["values"] = valuesJson(found->second);
  report["valueUnit"] = scene::valueUnit(volume);
  report["name"] = options.name;
  report["guarded"] = options.guard;
  report["output"] = options.output;
  report["warnings"] = warnings;
  options.common.json ? printJson(report) : print(grown, report);
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
