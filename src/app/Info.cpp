#include <fmt/format.h>

#include <variant>

#include <filesystem>

#include "app/Inputs.h"
#include "app/ModelInfo.h"
#include "app/StoreInfo.h"
#include "app/Text.h"
#include "app/Verbs.h"
#include "core/Error.h"
#include "io/kinds/FileKind.h"
#include "io/labels/ReadLabels.h"
#include "io/meshes/ReadMesh.h"
#include "io/models/ReadModel.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/Formats.h"
#include "io/volumes/OpenSource.h"
#include "io/volumes/ReadVolume.h"
#include "scene/GreyWindows.h"
#include "scene/Presets.h"
#include "session/document/Open.h"
#include "session/structure/StructureSizes.h"

namespace velum::app {

namespace {

struct InfoOptions {
  Common common;
  InputOptions input;
  bool formats = false, presets = false, labels = false;
};

/// The direction matrix row by row. Its columns are the directions of the voxel axes in the LPS world.
Json directionRows(const glm::dmat3& d) {
  Json out = Json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out.push_back(d[column][row]);
  return out;
}

/// Each gap as {first, count}.
Json listOfGaps(const Volume& v) {
  Json gaps = Json::array();
  for (glm::ivec2 gap : v.gaps) gaps.push_back({gap[0], gap[1]});
  return gaps;
}

/// What depends on the voxels is null of a volume whose voxels were not read.
Json describe(const Volume& v) {
  bool isRead = !v.voxels.empty();
  Json json = {{"kind", "volume"},
               {"name", v.name},
               {"dims", listOf(v.dims, 3)},
               {"type", std::string(enumName(v.type))},
               {"spacingMm", listOf(spacingOf(v) * unitsPer(v.lengthUnit, LengthUnit::Millimetre), 3)},
               {"originMm", listOf(glm::dvec3(worldFromVoxelIn(LengthUnit::Millimetre, v)[3]), 3)},
               {"lengthUnit", std::string(enumName(v.lengthUnit))},
               {"direction", directionRows(direction(v))},
               {"range", isRead ? listOf(v.range, 2) : Json()},
               {"channels", v.channels},
               {"frames", v.timeSteps},
               {"frameSeconds", v.timeStepSeconds},
               {"unit", v.unit},
               {"modality", std::string(enumName(v.modality))},
               {"color", v.isColor},
               {"scale", v.scale},
               {"offset", v.offset},
               {"spacingKnown", v.isSpacingKnown},
               {"orientationKnown", v.isOrientationKnown},
               {"channelNames", v.channelNames},
               {"gaps", listOfGaps(v)},
               {"preset", isRead ? Json(std::string(scene::choosePreset(v))) : Json()},
               {"warnings", v.warnings}};
  return json;
}

/// Each with its size, whatever unit the labels count in.
Json describeStructures(const LabelVolume& labels) {
  auto sizes = session::measureStructures(labels, consoleProgress());
  double mm = unitsPer(labels.lengthUnit(), LengthUnit::Millimetre);
  Json structures = Json::array();
  for (const auto& info : labels.table) {
    const session::StructureSize& size = sizes[info.id];
    structures.push_back({{"id", info.id},
                          {"fileId", info.fileId != 0 ? info.fileId : info.id},
                          {"name", info.name},
                          {"color", listOf(info.color, 3)},
                          {"opacity", info.opacity},
                          {"voxels", size.voxels},
                          {"volumeMl", size.volume * mm * mm * mm},
                          {"surfaceCm2", size.surface * mm * mm}});
  }
  return structures;
}

Json describe(const LabelVolume& labels) {
  glm::dmat3 m(labels.worldFromVoxel());
  glm::dvec3 spacing(glm::length(m[0]), glm::length(m[1]), glm::length(m[2]));
  glm::dmat3 unit(m[0] / spacing.x, m[1] / spacing.y, m[2] / spacing.z);
  double mm = unitsPer(labels.lengthUnit(), LengthUnit::Millimetre);
  return {{"kind", "labels"},
          {"name", labels.name},
          {"dims", listOf(labels.dims(), 3)},
          {"spacingMm", listOf(spacing * mm, 3)},
          {"originMm", listOf(glm::dvec3(labels.worldFromVoxel()[3]) * mm, 3)},
          {"lengthUnit", std::string(enumName(labels.lengthUnit()))},
          {"direction", directionRows(unit)},
          {"storedBytes", labels.storedBytes()},
          {"structures", describeStructures(labels)},
          {"warnings", labels.warnings}};
}

/// Labels beside a scan, with what it measured in each structure.
Json describeBeside(const Volume& scan, const std::string& path) {
  scene::Source source;
  source.path = path;
  LabelVolume labels = io::readLabels(source, consoleProgress(), io::gridOf(scan));
  auto values = session::measureValues(labels, scan, 0, 0, consoleProgress());
  Json json = describe(labels);
  json["valueUnit"] = scene::valueUnit(scan);
  for (Json& structure : json["structures"])
    if (auto found = values.find(structure["id"].get<int>()); found != values.end())
      structure["values"] = valuesJson(found->second);
  return json;
}

Json describe(const Mesh& mesh) {
  Json json = {{"kind", "surface"},
               {"name", mesh.name},
               {"vertices", mesh.positions.size()},
               {"triangles", mesh.indices.size() / 3},
               {"warnings", mesh.warnings}};
  if (mesh.color) json["color"] = listOf(*mesh.color, 3);
  return json;
}

Json listTables(const InfoOptions& options) {
  Json json = Json::object();
  if (options.formats)
    for (const auto& format : io::formats())
      json["formats"].push_back({{"name", std::string(format.name)},
                                 {"extensions", std::string(format.extensions)},
                                 {"read", format.canRead},
                                 {"write", !format.written.empty()}});
  if (options.formats)
    for (const auto& format : io::modelFormats())
      json["models"].push_back({{"name", std::string(format.name)}, {"extensions", std::string(format.extensions)}});
  if (options.presets)
    for (const auto& preset : scene::presets())
      json["presets"].push_back({{"name", std::string(preset.name)},
                                 {"title", std::string(preset.title)},
                                 {"modality", std::string(enumName(preset.modality))}});
  if (options.presets)
    for (const auto& window : scene::greyWindows())
      json["windows"].push_back(
          {{"name", std::string(window.name)},
           {"title", fmt::format("{}: W {} L {} {}", window.title, window.width, window.level, window.unit)},
           {"unit", std::string(window.unit)},
           {"width", window.width},
           {"level", window.level}});
  return json;
}

Json describeAll(const Volume& volume, const InfoOptions& options) {
  Json json = describe(volume);
  const auto& inputs = options.input.inputs;
  if (inputs.size() > 1) json["labels"] = describeBeside(volume, inputs[1]);
  return json;
}

Json describeAll(const LabelVolume& labels, const InfoOptions& options) {
  if (options.input.inputs.size() > 1) throw ArgumentError("info: name a scan first, then labels of it");
  return describe(labels);
}

/// A volume of which the header tells enough to leave its many voxels alone.
std::unique_ptr<VoxelSource> openLarge(const scene::Source& source, io::FileKind kind, const InfoOptions& options) {
  bool isAlone = kind == io::FileKind::Volume && !options.labels && options.input.inputs.size() == 1;
  return isAlone ? io::openLargeSource(source) : nullptr;
}

Json describeLarge(const VoxelSource& source) {
  Json json = describe(source.head());
  for (int level = 0; level < int(source.levels().size()); ++level)
    json["levels"].push_back(describeLevel(source, level));
  return json;
}

int run(const InfoOptions& options) {
  Json json;
  if (options.formats || options.presets) {
    json = listTables(options);
  } else {
    if (options.input.inputs.empty()) throw ArgumentError("info: name a file, or --formats, or --presets");
    if (options.input.inputs.size() > 2) throw ArgumentError("info: name one file, or a scan and labels of it");
    scene::Source source = firstSource(options.input);
    Progress& progress = consoleProgress();
    std::filesystem::path path(source.path);
    if (!std::filesystem::exists(path))
      throw InputError(fmt::format("{}: there is no such file or folder", source.path));
    if (auto scene = session::readSceneText(path)) {
      progress.report(1.0, "");
      Json text = Json::parse(*scene, nullptr, false);
      if (text.is_discarded()) throw InputError(fmt::format("{}: the scene in it is no JSON", path.string()));
      json = {{"kind", "scene"}, {"scene", std::move(text)}};
      fmt::print("{}\n", json.dump(2));
      return 0;
    }
    io::FileKind kind = io::kindOf(source);
    if (kind == io::FileKind::Surface)
      json = describe(io::readMesh(path, progress));
    else if (kind == io::FileKind::Model && !options.labels)
      json = describeModel(io::readModel(path, progress));
    else if (io::isStore(path) && !options.labels && options.input.inputs.size() == 1)
      json = describeStore(source);
    else if (auto large = openLarge(source, kind, options))
      json = describeLarge(*large);
    else if (options.labels)
      json = describe(io::readLabels(source, progress));
    else
      json = std::visit([&](const auto& voxels) { return describeAll(voxels, options); },
                        io::readVoxels(source, progress));
    auto series = io::listSeries(path, progress);
    progress.report(1.0, "");
    for (const auto& s : series)
      json["series"].push_back({{"uid", s.uid},
                                {"description", s.description},
                                {"modality", s.modality},
                                {"segmentation", s.isSegmentation},
                                {"images", s.imageCount},
                                {"size", listOf(s.size, 2)}});
  }
  if (options.common.json)
    printJson(json);
  else
    printForPeople(json);
  return 0;
}

}  // namespace

Run registerInfo(CLI::App& verb) {
  auto options = std::make_shared<InfoOptions>();
  addCommon(verb, options->common);
  addInput(verb, options->input, false);
  verb.get_option("input")->required(false);
  verb.add_flag("--labels", options->labels, "read it as labels");
  verb.add_flag("--formats", options->formats, "list the file formats");
  verb.add_flag("--presets", options->presets, "list the presets, and the grey windows of sections");
  return [options] { return run(*options); };
}

}  // namespace velum::app
