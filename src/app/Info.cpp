#include <fmt/format.h>

#include <variant>

#include <filesystem>

#include "app/Inputs.h"
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

template <class V>
Json list(const V& v, int n) {
  Json out = Json::array();
  for (int i = 0; i < n; ++i) out.push_back(v[i]);
  return out;
}

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

Json describe(const Volume& v) {
  Json json = {{"kind", "volume"},
               {"name", v.name},
               {"dims", list(v.dims, 3)},
               {"type", std::string(enumName(v.type))},
               {"spacingMm", list(spacingOf(v) * unitsPer(v.lengthUnit, LengthUnit::Millimetre), 3)},
               {"originMm", list(glm::dvec3(worldFromVoxelIn(LengthUnit::Millimetre, v)[3]), 3)},
               {"lengthUnit", std::string(enumName(v.lengthUnit))},
               {"direction", directionRows(direction(v))},
               {"range", list(v.range, 2)},
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
               {"preset", std::string(scene::choosePreset(v))},
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
                          {"name", info.name},
                          {"color", list(info.color, 3)},
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
          {"dims", list(labels.dims(), 3)},
          {"spacingMm", list(spacing * mm, 3)},
          {"originMm", list(glm::dvec3(labels.worldFromVoxel()[3]) * mm, 3)},
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
  LabelVolume labels =
      io::readLabels(source, consoleProgress(), io::LabelGrid{scan.dims, scan.worldFromVoxel, scan.lengthUnit});
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
  if (mesh.color) json["color"] = list(*mesh.color, 3);
  return json;
}

Json describe(const Model& model, const MoleculeType& type) {
  std::size_t atoms = 0, beads = 0;
  for (std::uint32_t m = type.firstMolecule; m < type.firstMolecule + type.moleculeCount; ++m) {
    const Molecule& molecule = model.molecules[m];
    atoms = std::max(atoms, molecule.atoms.size());
    if (!molecule.beads.empty()) beads = std::max(beads, molecule.beads.front().size());
  }
  Json json = {{"name", type.name},
               {"path", pathOf(model, type)},
               {"kind", std::string(enumName(type.kind))},
               {"function", type.function},
               {"instances", type.instanceCount},
               {"atoms", atoms},
               {"beads", beads},
               {"atomsInAll", atomCount(model, type)},
               {"mass", type.mass},
               {"massFrom", std::string(enumName(type.massSource))},
               {"structure", type.structure}};
  if (type.moleculeCount > 1) json["molecules"] = type.moleculeCount;
  return json;
}

/// Counts what the files hold; molecules that were made from curves, or to complete them, are listed apart.
Json describe(const Model& model) {
  std::size_t types = 0;
  std::uint64_t instances = 0, atoms = 0, beads = 0;
  Json perType = Json::array(), added = Json::array(), fibres = Json::array();
  for (std::size_t i = 0; i < model.types.size(); ++i) {
    const MoleculeType& type = model.types[i];
    std::size_t curves = 0, points = 0;
    for (const Fibre& fibre : model.fibres)
      if (fibre.type == i) ++curves, points += fibre.points.size();
    if (curves > 0)
      fibres.push_back(
          {{"name", type.name}, {"curves", curves}, {"points", points}, {"instances", type.instanceCount}});
    if (type.origin == Origin::Added) added.push_back(describe(model, type));
    if (type.origin != Origin::File) continue;
    ++types;
    instances += type.instanceCount;
    atoms += atomCount(model, type);
    beads += beadCount(model, type);
    perType.push_back(describe(model, type));
  }
  return {{"kind", "model"},
          {"name", model.name},
          {"types", types},
          {"instances", instances},
          {"atoms", atoms},
          {"beads", beads},
          {"bounds", {list(model.low, 3), list(model.high, 3)}},
          {"lengthUnit", std::string(enumName(LengthUnit::Angstrom))},
          {"perType", perType},
          {"fibres", fibres},
          {"added", added},
          {"completed", model.added},
          {"warnings", model.warnings}};
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
      json = {{"kind", "scene"}, {"scene", Json::parse(*scene)}};
      fmt::print("{}\n", json.dump(2));
      return 0;
    }
    io::FileKind kind = io::kindOf(source);
    if (kind == io::FileKind::Surface)
      json = describe(io::readMesh(path, progress));
    else if (kind == io::FileKind::Model && !options.labels)
      json = describe(io::readModel(path, progress));
    else if (io::isStore(path) && !options.labels && options.input.inputs.size() == 1)
      json = describeStore(source);
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
                                {"size", list(s.size, 2)}});
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
