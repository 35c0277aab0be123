#include "Verbs.h"
#include "velum/core/Log.h"
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
  if (session::isLookFile(options.output)) {
    session::convertLook(source.path, options.output);
  } else if (options.labels || (source.raw.dims.x == 0 && io::looksLikeLabels(source.path))) {
    LabelVolume labels = io::readLabels(source, progress);
    io::writeLabels(labels, options.output, progress);
    json["structures"] = labels.table.size();
  } else {
    Volume volume = io::readVolume(source, progress);
    for (const auto& warning : volume.warnings) log::warning(warning);
    io::writeVolume(volume, options.output, progress);
    json["dims"] = {volume.dims.x, volume.dims.y, volume.dims.z};
    json["type"] = std::string(enumName(volume.type));
  }
  progress.report(1.0, "");
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
