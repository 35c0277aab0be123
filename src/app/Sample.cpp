#include "io/phantoms/Sample.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/Verbs.h"
#include "core/Error.h"
#include "io/labels/WriteLabels.h"
#include "io/models/WriteModel.h"
#include "io/phantoms/Brain.h"
#include "io/phantoms/Virion.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/WriteVolume.h"

namespace velum::app {

namespace {

struct SampleOptions {
  Common common;
  std::string name, output;
  int size = 0, timeSteps = 0;
  double contrast = 0.0;
};

/// A model and no volume: there are no labels, and nothing to choose.
int makeModel(const SampleOptions& options) {
  namespace fs = std::filesystem;
  if (options.size != 0 || options.timeSteps != 0 || options.contrast != 0.0)
    throw ArgumentError("sample virion: a model has no voxels, time steps or contrast; leave these options out");
  fs::path path(options.output);
  if (!path.has_extension()) path = path / (options.name + ".cif");
  if (!io::isModelWritten(path))
    throw ArgumentError(fmt::format("{}: models are written as .cif, .cif.gz, .glb, .csv or .ply", path.string()));
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  Progress& progress = consoleProgress();
  io::writeModel(io::makeVirion(progress), path, progress);
  progress.report(1.0, "");
  if (options.common.json)
    printJson({{"name", options.name}, {"files", {path.string()}}, {"warnings", Json::array()}});
  else
    fmt::print("{}\n", path.string());
  return 0;
}

/// A volume of any size, which goes to the disk as it is made: there is no file of labels.
int makeStore(const SampleOptions& options) {
  namespace fs = std::filesystem;
  if (options.timeSteps != 0 || options.contrast != 0.0)
    throw ArgumentError("sample brain: it has no time steps and no contrast to choose; leave these options out");
  constexpr int kUsual = 1024;
  fs::path path(options.output);
  if (!path.has_extension()) path = path / (options.name + ".ome.zarr");
  if (!io::isStoreFormat(path))
    throw ArgumentError(
        fmt::format("{}: a brain may be larger than memory, and is written as .ome.zarr or .ozx", path.string()));
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  io::expectStoreWritable(path);
  Progress& progress = consoleProgress();
  auto brain = io::makeBrain(options.size == 0 ? kUsual : options.size, progress);
  auto warnings = io::writeStore(*brain, path, {}, progress);
  printWarnings(path.string(), warnings);
  progress.report(1.0, "");
  if (options.common.json)
    printJson({{"name", options.name}, {"files", {path.string()}}, {"warnings", warnings}});
  else
    fmt::print("{}\n", path.string());
  return 0;
}

int run(const SampleOptions& options) {
  if (options.name == "virion") return makeModel(options);
  if (options.name == "brain") return makeStore(options);
  namespace fs = std::filesystem;
  fs::path path(options.output);
  if (!path.has_extension()) path = path / (options.name + ".nrrd");
  io::expectVolumeFormat(path);
  Progress& progress = consoleProgress();
  io::Sample sample = io::makeSample(options.name, options.size, progress, options.timeSteps, options.contrast);
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  auto warnings = io::writeVolume(sample.volume, path, progress);
  printWarnings(path.string(), warnings);
  fs::path labels = path;
  std::string stem = path.filename().string();
  stem = stem.substr(0, stem.find('.'));
  std::string extension = path.filename().string().substr(stem.size());
  labels.replace_filename(stem + "_labels" + (extension == ".nii" || extension == ".nii.gz" ? extension : ".seg.nrrd"));
  auto ofLabels = io::writeLabels(sample.labels, labels, progress);
  printWarnings(labels.string(), ofLabels);
  warnings.insert(warnings.end(), ofLabels.begin(), ofLabels.end());
  progress.report(1.0, "");
  if (options.common.json)
    printJson({{"name", options.name}, {"files", {path.string(), labels.string()}}, {"warnings", warnings}});
  else
    fmt::print("{}\n{}\n", path.string(), labels.string());
  return 0;
}

}  // namespace

Run registerSample(CLI::App& verb) {
  auto options = std::make_shared<SampleOptions>();
  addCommon(verb, options->common);
  std::string names;
  for (const auto& sample : io::samples()) names += fmt::format("{}{}", names.empty() ? "" : ", ", sample.name);
  names += ", virion, brain";
  verb.add_option("name", options->name, names)->required();
  verb.add_option(
          "-o,--output", options->output,
          "volume file (labels go beside it), .cif or .cif.gz of a virion, .ome.zarr or .ozx of a brain, or a folder")
      ->required();
  verb.add_option("--voxels", options->size,
                  "voxels along the longest axis, 16 to 1024, of a brain 64 to 65536; default: the phantom's own");
  verb.add_option("--time-steps", options->timeSteps,
                  "time steps of a phantom that moves (heart), 1 to 100; default: 12");
  verb.add_option("--contrast", options->contrast,
                  "how much brighter than the haze around them all fibres are (fibres), in standard deviations of the "
                  "noise; default: 2, 3 and 4");
  return [options] { return run(*options); };
}

}  // namespace velum::app
