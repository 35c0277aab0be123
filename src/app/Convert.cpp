#include "Verbs.h"
#include "velum/io/labels/ReadLabels.h"
#include "velum/io/volumes/ReadVolume.h"
#include "velum/io/volumes/WriteVolume.h"
#include "velum/session/look/Look.h"

namespace velum::app {

namespace {

struct ConvertOptions {
  Common common;
  InputOptions input;
  std::string output;
  bool labels = false;
};

int run(const ConvertOptions& options) {
  Progress& progress = consoleProgress();
  scene::Source source = firstSource(options.input);
  Json json = {{"output", options.output}};
  std::vector<std::string> warnings;
  auto tell = [&](const std::string& path, const std::vector<std::string>& lines) {
    printWarnings(path, lines);
    warnings.insert(warnings.end(), lines.begin(), lines.end());
  };
  if (session::isLookFile(options.output)) {
    tell(options.output, session::convertLook(source.path, options.output));
  } else if (options.labels || (source.raw.dims.x == 0 && io::looksLikeLabels(source.path))) {
    LabelVolume labels = io::readLabels(source, progress);
    tell(source.path, labels.warnings);
    tell(options.output, io::writeLabels(labels, options.output, progress));
    json["structures"] = labels.table.size();
  } else {
    Volume volume = io::readVolume(source, progress);
    tell(source.path, volume.warnings);
    tell(options.output, io::writeVolume(volume, options.output, progress));
    json["dims"] = {volume.dims.x, volume.dims.y, volume.dims.z};
    json["type"] = std::string(enumName(volume.type));
  }
  progress.report(1.0, "");
  json["warnings"] = warnings;
  if (options.common.json) printJson(json);
  return 0;
}

}  // namespace

Run registerConvert(CLI::App& verb) {
  auto options = std::make_shared<ConvertOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, false);
  verb.get_option("input")->expected(1)->allow_extra_args(false);  // the second word is the output
  verb.add_option("output", options->output,
                  "file to write: .nrrd, .nii, .nii.gz, .vti, .vdb; the transfer function of a scene or another file: "
                  ".velum-transfer.json, .vp.json, .vp")
      ->required();
  verb.add_flag("--labels", options->labels, "the input is labels");
  return [options] { return run(*options); };
}

}  // namespace velum::app
