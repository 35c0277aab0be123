#include <fmt/format.h>

#include <variant>

#include "app/Inputs.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "io/kinds/FileKind.h"
#include "io/labels/LabelStore.h"
#include "io/labels/ReadLabels.h"
#include "io/labels/WriteLabels.h"
#include "io/stores/CroppedSource.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WriteStore.h"
#include "io/volumes/OpenSource.h"
#include "io/volumes/ReadLevel.h"
#include "io/volumes/ReadVolume.h"
#include "io/volumes/WriteVolume.h"
#include "session/document/Open.h"
#include "session/look/Look.h"
#include "session/model/ModelExport.h"
#include "session/structure/StructureExport.h"

namespace velum::app {

namespace {

struct ConvertOptions {
  Common common;
  InputOptions input;
  std::string output;
  bool labels = false;
  std::vector<std::string> structures;
  double smoothness = session::StructureExport().smoothness;
  bool apart = false;
  std::string zarr = "0.5";
  std::vector<int> box;  ///< first voxel, and one past the last one

  io::OmeVersion version() const { return zarr == "0.4" ? io::OmeVersion::V04 : io::OmeVersion::V05; }
};

using Lines = std::vector<std::string>;

/// Writes the labels of a scene with the structures' names and colours, as surfaces or as a label volume.
Lines writeStructures(const scene::Scene& scene, const ConvertOptions& options, Json& json) {
  LabelVolume labels = session::labelsOf(scene);
  session::StructureExport what{session::findStructures(labels.table, options.structures), options.smoothness,
                                options.apart};
  json["structures"] = what.structures.empty() ? labels.idsInUse().size() : what.structures.size();
  bool isWhole = what.structures.empty() && !what.apart && !session::isSurfaceFile(options.output);
  if (isWhole && io::isStoreFormat(options.output))
    return io::writeLabelStore(labels, options.output, options.version(), consoleProgress());
  if (isWhole) return io::writeLabels(labels, options.output, consoleProgress());  // also where nothing is labelled
  return session::exportStructures(scene, options.output, what, consoleProgress());
}

/// Writes what cuts leave of a scene's model. Membranes come to rest first, which needs a graphics driver.
Lines writeModel(session::Session& session, const ConvertOptions& options, Json& json) {
  scene::Scene scene = session.settled(consoleProgress());
  session::ModelExport written = session::exportModel(scene, options.output, consoleProgress());
  json["kind"] = "model";
  json["types"] = written.types;
  json["instances"] = written.instances;
  return written.losses;
}

/// Labels come first where a format is one of their surfaces, too.
bool isOfModel(const scene::Scene& scene, const ConvertOptions& options) {
  bool wantsLabels = session::isSurfaceFile(options.output) && scene.labels.data;
  return scene.model.data && session::isModelFile(options.output) && !wantsLabels;
}

/// A volume is written as fine as it is where nobody asks for another level, or not at all where that does not fit.
scene::Source atItsFinest(scene::Source source) {
  bool isVolume = source.level == scene::kFittingLevel && io::kindOf(source) == io::FileKind::Volume;
  if (isVolume && io::openPyramid(source)) source.level = 0;
  return source;
}

/// Reads the input. @throw ArgumentError when surfaces are to be made and the input holds no labels
std::variant<Volume, LabelVolume> readVoxels(const scene::Source& source, const ConvertOptions& options,
                                             Progress& progress) {
  if (options.labels) return io::readLabels(source, progress);
  bool needsLabels = session::isSurfaceFile(options.output);
  std::variant<Volume, LabelVolume> voxels;
  if (!needsLabels || io::kindOf(source) == io::FileKind::Labels)
    voxels = io::readVoxels(atItsFinest(source), progress);
  if (needsLabels && !std::holds_alternative<LabelVolume>(voxels))
    throw ArgumentError(
        fmt::format("{} does not look like labels, of which surfaces are made; say --labels if it is", source.path));
  return voxels;
}

/// What becomes a store without being held in memory on its way.
struct Streamed {
  std::unique_ptr<VoxelSource> source;
  io::StoreOptions how;
};

/// Opens images of stores, and large volumes of files that can be read brick by brick; nothing for all else.
Streamed openStreamed(const scene::Source& source, const ConvertOptions& options) {
  Streamed streamed;
  bool isStored = io::isStore(source.path);
  if (!io::isStoreFormat(options.output) || !options.structures.empty() || options.apart) return streamed;
  if (isStored && options.input.spacing.empty()) {
    auto image = io::openImage(source.path, source.series);
    streamed.how.isLabels = options.labels || image->facts().isLabels;
    if (streamed.how.isLabels) image->carryIds();
    streamed.how.carriesIds = image->carriesIds();
    streamed.how.structures = image->facts().structures;
    streamed.source = std::move(image);
  } else if (!isStored && !options.labels && io::kindOf(source) == io::FileKind::Volume) {
    streamed.source = io::openLargeSource(source);
  }
  return streamed;
}

/// The level that is asked for, or the finest. @throw ArgumentError where there is none
int levelOf(const VoxelSource& source, int wanted) {
  int level = std::max(wanted, 0), count = int(source.levels().size());
  if (level >= count) throw ArgumentError(fmt::format("--level {}: the levels are 0 to {}", level, count - 1));
  return level;
}

constexpr const char* kNoBox = "--box: takes voxels out of volumes and label volumes only; leave it out";

/// The voxels of a box, and no others. @throw ArgumentError for a box that is not inside, or an input of another kind
void crop(Streamed& streamed, const scene::Source& source, const ConvertOptions& options, Progress& progress) {
  bool isLabels = options.labels || io::kindOf(source) == io::FileKind::Labels;
  if (!isLabels && io::kindOf(source) != io::FileKind::Volume) throw ArgumentError(kNoBox);
  if (!streamed.source && isLabels)
    throw ArgumentError("--box: of labels it is written from a store to a store (.zarr, .ozx)");
  if (!streamed.source && options.input.spacing.empty()) {
    if (io::isStore(source.path))
      streamed.source = io::openImage(source.path, source.series);
    else
      streamed.source = io::openSource(source);
  }
  bool isRead = !streamed.source;
  if (isRead)
    streamed.source = std::make_unique<VolumeSource>(Shared<Volume>(io::readVolume(atItsFinest(source), progress)));
  int level = isRead ? 0 : levelOf(*streamed.source, source.level);
  glm::ivec3 first(options.box[0], options.box[1], options.box[2]), end(options.box[3], options.box[4], options.box[5]);
  streamed.source =
      std::make_unique<io::CroppedSource>(std::move(streamed.source), VoxelBox{level, first, end - first});
}

/// Writes a store, from the source's finest level or the one that is asked for.
Lines writeStreamed(Streamed& streamed, int level, const ConvertOptions& options, Json& json) {
  const VoxelSource& from = *streamed.source;
  streamed.how.version = options.version();
  streamed.how.level = levelOf(from, level);
  printWarnings(options.input.inputs.front(), from.head().warnings);
  glm::ivec3 dims = from.levels()[std::size_t(streamed.how.level)].dims;
  json["dims"] = {dims.x, dims.y, dims.z};
  json["type"] = streamed.how.carriesIds ? "uint64" : std::string(enumName(from.head().type));
  if (!io::isStoreFormat(options.output)) {
    Volume volume = readLevel(from, streamed.how.level, consoleProgress());
    computeRange(volume);
    return io::writeVolume(volume, options.output, consoleProgress());
  }
  return io::writeStore(from, options.output, streamed.how, consoleProgress());
}

/// Refuses an output whose format no kind of data is written in, before the input is read and its kind is known.
/// @param path  of the output
void expectSomeFormat(const std::filesystem::path& path) {
  bool isKnown = session::isLookFile(path) || session::isSurfaceFile(path) || session::isModelFile(path) ||
                 io::isLabelFormat(path);
  if (!isKnown) io::expectVolumeFormat(path);
}

int run(const ConvertOptions& options) {
  expectOutput(options.output, expectSomeFormat);
  Progress& progress = consoleProgress();
  scene::Source source = firstSource(options.input);
  Json json = {{"output", options.output}};
  std::vector<std::string> warnings;
  auto tell = [&](const std::string& path, const std::vector<std::string>& lines) {
    printWarnings(path, lines);
    warnings.insert(warnings.end(), lines.begin(), lines.end());
  };
  bool isScene = !session::isLookFile(options.output) && session::readSceneText(source.path);
  bool isModel = !isScene && !options.labels && io::kindOf(source) == io::FileKind::Model;
  if (!options.input.sets.empty() && !isScene && !isModel)
    throw ArgumentError("--set: changes what is written of scenes and models only; leave it out");
  if (!options.box.empty() && (isScene || isModel || session::isLookFile(options.output))) throw ArgumentError(kNoBox);
  session::Session session;
  session.setContextKind(options.common.context);
  if (isModel && !session::isLookFile(options.output)) {
    openInputs(session, options.input, 1.0);
    tell(options.output, writeModel(session, options, json));
  } else if (session::isLookFile(options.output)) {
    tell(options.output, session::convertLook(source.path, options.output));
  } else if (isScene) {
    openInputs(session, options.input, 1.0);
    if (isOfModel(session.scene(), options))
      tell(options.output, writeModel(session, options, json));
    else
      tell(options.output, writeStructures(session.scene(), options, json));
  } else if (Streamed streamed = openStreamed(source, options); streamed.source || !options.box.empty()) {
    if (!options.box.empty()) crop(streamed, source, options, progress);
    tell(options.output, writeStreamed(streamed, options.box.empty() ? source.level : 0, options, json));
  } else {
    auto voxels = readVoxels(source, options, progress);
    std::visit([&](const auto& data) { tell(source.path, data.warnings); }, voxels);
    if (auto* labels = std::get_if<LabelVolume>(&voxels)) {
      scene::Scene scene;
      scene.labels.data = Shared<LabelVolume>(std::move(*labels));
      tell(options.output, writeStructures(scene, options, json));
    } else {
      const Volume& volume = std::get<Volume>(voxels);
      io::StoreOptions how;
      how.version = options.version();
      tell(options.output, io::isStoreFormat(options.output)
                               ? io::writeStore(VolumeSource(volume), options.output, how, progress)
                               : io::writeVolume(volume, options.output, progress));
      json["dims"] = {volume.dims.x, volume.dims.y, volume.dims.z};
      json["type"] = std::string(enumName(volume.type));
    }
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
  verb.add_option(
          "output", options->output,
          fmt::format("file to write: {}; of labels, or those of a scene, {}, or their surfaces: {}; what shows of "
                      "a model, or that of a scene: {}; the transfer function of a scene or another file: {}",
                      io::endingsOf(io::FileKind::Volume), io::endingsOf(io::FileKind::Labels),
                      io::endingsOf(io::FileKind::Surface), io::endingsOf(io::FileKind::Model),
                      io::endingsOf(io::FileKind::Look)))
      ->required();
  verb.add_option("--set", options->input.sets,
                  "of a model or scene: change a field, e.g. a cut, before it is written: path=value; repeatable");
  verb.add_flag("--labels", options->labels, "the input is labels");
  verb.add_option("--structure", options->structures, "of labels: only this one, by name or number; repeatable");
  verb.add_option("--smooth", options->smoothness,
                  "how far surfaces of structures are rounded off: 0 as pictures show them .. 1")
      ->check(CLI::Range(0.0, 1.0));
  verb.add_flag("--apart", options->apart, "a file for each structure: OUTPUT-aorta.stl");
  verb.add_option("--box", options->box,
                  "of a volume, or of labels in a store: only these voxels of its level: x,y,z of the first and of one "
                  "past the last")
      ->delimiter(',')
      ->expected(6);
  verb.add_option("--zarr", options->zarr, "of .zarr: version of OME-Zarr, 0.4 or 0.5")
      ->check(CLI::IsMember({"0.4", "0.5"}));
  return [options] { return run(*options); };
}

}  // namespace velum::app
