#include "io/labels/WriteLabels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/Memory.h"
#include "core/ReplaceFile.h"
#include "core/SayCount.h"
#include "core/VoxelSource.h"
#include "io/labels/DicomSegWriter.h"
#include "io/labels/LabelStore.h"
#include "io/read/FileNames.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"
#include "io/volumes/Writers.h"

namespace velum::io {

namespace {

/// The ids as a plain volume, uint8 where they fit, filled slab by slab. @throw InputError where they do not fit into
/// memory
Volume volumeOf(const LabelVolume& labels, const Path& path, Progress& progress) {
  Volume v;
  v.dims = labels.dims();
  auto used = labels.idsInUse();
  v.type = used.empty() || used.back() < 256 ? SampleType::UInt8 : SampleType::UInt16;
  v.worldFromVoxel = labels.worldFromVoxel();
  v.lengthUnit = labels.lengthUnit();
  v.name = labels.name;
  if (double bytes = levelBytes(VolumeSource(v), 0), most = machineBytes() / 2; bytes > most)
    refuse(path, fmt::format("labels of {:.1f} GB do not fit into half of the memory, {:.1f} GB, as this format needs; "
                             "write a store (.zarr)",
                             bytes / 1e9, most / 1e9));
  v.voxels.resize(timeStepBytes(v));
  std::size_t plane = std::size_t(v.dims.x) * std::size_t(v.dims.y);
  std::vector<std::uint16_t> slab(plane * LabelVolume::kBrickSize);
  for (int z = 0; z < v.dims.z; z += LabelVolume::kBrickSize) {
    int depth = std::min(LabelVolume::kBrickSize, v.dims.z - z);
    std::size_t count = plane * std::size_t(depth), first = std::size_t(z) * plane;
    labels.read({0, 0, z}, {v.dims.x, v.dims.y, depth}, slab);
    if (v.type == SampleType::UInt16)
      std::memcpy(v.voxels.data() + first * 2, slab.data(), count * 2);
    else
      std::transform(slab.begin(), slab.begin() + std::ptrdiff_t(count), v.voxels.begin() + std::ptrdiff_t(first),
                     [](std::uint16_t id) { return std::byte(id); });
    progress.throwIfCancelled();
  }
  return v;
}

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// 3D Slicer's names for what a segment is.
LabelExtras extrasOf(const LabelVolume& labels, bool isNifti) {
  LabelExtras extras;
  auto add = [&](std::size_t i, const char* what, std::string value) {
    extras.nrrdKeyValues.emplace_back(fmt::format("Segment{}_{}", i, what), std::move(value));
  };
  glm::ivec3 last = labels.dims() - 1;
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>\n";
  for (std::size_t i = 0; i < labels.table.size(); ++i) {
    const LabelInfo& label = labels.table[i];
    std::string name = oneLine(label.name);
    bool isChanged = name != label.name;
    add(i, "ID", fmt::format("Segment_{}", label.id));
    add(i, "Name", name);
    add(i, "Color", fmt::format("{} {} {}", label.color.r, label.color.g, label.color.b));
    add(i, "Extent", fmt::format("0 {} 0 {} 0 {}", last.x, last.y, last.z));
    add(i, "LabelValue", fmt::format("{}", label.id));
    add(i, "Layer", "0");
    if (label.opacity != 1.0f) add(i, "VelumOpacity", fmt::format("{}", label.opacity));
    for (auto at = name.find("]]>"); isNifti && at != std::string::npos; at = name.find("]]>")) {
      name.erase(at, 3);
      isChanged = true;
    }
    extras.changedNames += isChanged;
    xml += fmt::format("<Label Key=\"{}\" Red=\"{}\" Green=\"{}\" Blue=\"{}\" Alpha=\"{}\"><![CDATA[{}]]></Label>\n",
                       label.id, label.color.r, label.color.g, label.color.b, label.opacity, name);
  }
  if (!labels.table.empty()) extras.nrrdKeyValues.emplace_back("Segmentation_MasterRepresentation", "Binary labelmap");
  extras.niftiExtension =
      xml + "</LabelTable><VolumeType><![CDATA[Label]]></VolumeType></VolumeInformation></CaretExtension>\n";
  return extras;
}

using WriteWith = std::vector<std::string> (*)(const Volume&, ReplaceFile&, const LabelExtras&, Progress&);

std::vector<std::string> writeAsVolume(const LabelVolume& labels, ReplaceFile& file, bool isNifti, WriteWith write,
                                       Progress& progress) {
  Volume v = volumeOf(labels, file.target(), progress);
  checkWhole(v, file.target());
  LabelExtras extras = extrasOf(labels, isNifti);
  auto losses = write(v, file, extras, progress);
  Losses more;
  auto wide =
      std::count_if(labels.table.begin(), labels.table.end(), [](const auto& info) { return info.fileId != 0; });
  more.say(wide > 0, "{}",
           sayCount(wide, "1 structure has another id than in the file that it comes from; a store keeps that",
                    "{} structures have other ids than in the file that they come from; a store keeps those"));
  more.say(extras.changedNames > 0, "{}",
           sayCount(extras.changedNames,
                    "1 name of a structure is changed: line ends, or what ends a name in XML, cannot stand in it",
                    "{} names of structures are changed: line ends, or what ends a name in XML, cannot stand in them"));
  for (std::string& line : more.take()) losses.push_back(std::move(line));
  return losses;
}

std::vector<std::string> writeNrrdLabels(const LabelVolume& labels, ReplaceFile& file, Progress& progress) {
  return writeAsVolume(labels, file, false, writeNrrdWith, progress);
}
std::vector<std::string> writeNiftiLabels(const LabelVolume& labels, ReplaceFile& file, Progress& progress) {
  return writeAsVolume(labels, file, true, writeNiftiWith, progress);
}

std::vector<std::string> writeNewestStore(const LabelVolume& labels, const Path& path, Progress& progress) {
  return writeLabelStore(labels, path, OmeVersion::V05, progress);
}

struct Row {
  LabelFormat format;
  /// The caller commits. Returns what was lost.
  std::vector<std::string> (*write)(const LabelVolume&, ReplaceFile&, Progress&);
  /// Writes a format of many files in its own safe way; null: `write` does.
  std::vector<std::string> (*writeAlone)(const LabelVolume&, const Path&, Progress&) = nullptr;
};
// A new format is one row.
constexpr Row kTable[] = {
    {{"3D Slicer segmentation", ".seg.nrrd .nrrd"}, writeNrrdLabels},
    {{"NIfTI", ".nii.gz .nii"}, writeNiftiLabels},
    {{"DICOM segmentation", ".dcm"}, writeDicomSeg},
    {{"OME-Zarr", ".zarr .ozx"}, nullptr, writeNewestStore},
};

constexpr auto kFormats = [] {
  std::array<LabelFormat, std::size(kTable)> formats{};
  for (std::size_t i = 0; i < formats.size(); ++i) formats[i] = kTable[i].format;
  return formats;
}();

const Row* chooseRow(const Path& path) {
  std::string extension = lowerExtension(path);
  for (const Row& row : kTable) {
    std::string all = " " + std::string(row.format.extensions) + " ";
    if (!extension.empty() && all.find(" " + extension + " ") != std::string::npos) return &row;
  }
  return nullptr;
}

}  // namespace

std::span<const LabelFormat> labelFormats() { return kFormats; }

bool isLabelFormat(const Path& path) { return chooseRow(path) != nullptr; }

void expectLabelFormat(const Path& path) {
  if (!isLabelFormat(path)) refuse(path, "labels are written as .seg.nrrd, .nrrd, .nii, .nii.gz, .dcm, .zarr or .ozx");
}

std::vector<std::string> writeLabels(const LabelVolume& labels, const std::filesystem::path& path, Progress& progress) {
  expectLabelFormat(path);
  const Row* row = chooseRow(path);
  if (row->writeAlone) return row->writeAlone(labels, path, progress);
  ReplaceFile file(path);
  auto losses = row->write(labels, file, progress);
  file.commit();
  progress.report(1.0, "Wrote " + path.filename().string());
  return losses;
}

}  // namespace velum::io
