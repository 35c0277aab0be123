#include "io/labels/ReadLabels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/SayCount.h"
#include "io/labels/LabelGuess.h"
#include "io/labels/LabelTables.h"
#include "io/labels/LargeLabels.h"
#include "io/read/ByteSource.h"
#include "io/read/FileNames.h"
#include "io/read/Placement.h"
#include "io/stores/OpenStore.h"
#include "io/stores/WideIds.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/FormatTable.h"
#include "io/volumes/NiftiHeader.h"
#include "io/volumes/NrrdHeader.h"
#include "io/volumes/ReadVolume.h"

namespace velum::io {

namespace {

constexpr int kSlab = LabelVolume::kBrickSize;

/// Segments of a 3D Slicer file; empty for any other.
std::vector<SlicerSegment> segmentsOf(const Path& path) {
  if (!std::filesystem::is_regular_file(path) || !readHead(path, 8).starts_with("NRRD000")) return {};
  return parseSlicerSegments(readNrrdHeader(path).keyValues);
}

bool isNifti(const Path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  const FormatRow* row = chooseReader(readFileHead(path));
  return row && row->format.name == "NIfTI";
}

/// "scan.nii.gz" and "scan.seg.nrrd" have tables "scan.txt", "scan.ctbl", ...; "scan.nii.txt" is MRIcron's way.
std::vector<Path> tablesBeside(const Path& path) {
  Path stem = path;
  if (lowerCase(stem.extension().string()) == ".gz") stem.replace_extension();
  Path withoutExtension = stem;
  withoutExtension.replace_extension();
  std::vector<Path> found;
  for (const Path& base : {withoutExtension, stem})
    for (const char* extension : {".txt", ".ctbl", ".label", ".lut"}) {
      Path table = base;
      table += extension;
      if (table != path && std::filesystem::is_regular_file(table)) found.push_back(table);
    }
  return found;
}

/// Names and colours in a Caret extension, as TotalSegmentator writes them; empty when there is none.
std::vector<LabelInfo> namesInNifti(const NiftiHeader& header) {
  for (const std::string& text : readNiftiExtensions(header))
    if (auto table = parseCaretLabels(text); !table.empty()) return table;
  return {};
}

std::vector<LabelInfo> tableOf(const scene::Source& source, std::vector<std::string>& warnings) {
  Path path = source.path;
  if (isStore(path)) return openImage(path, source.series)->facts().structures;
  if (isNifti(path))
    if (auto table = namesInNifti(readNiftiHeader(path)); !table.empty()) return table;
  for (const Path& beside : tablesBeside(path)) {
    try {
      return readLabelTable(beside);
    } catch (const InputError& error) {
      // The volume is what was asked for; a file beside it that only looks like a table must not hide it.
      warnings.push_back(error.what());
    }
  }
  return {};
}

/// An id out of a sample; the caller has checked the range of all.
template <class T>
std::uint16_t idFrom(T raw, const Volume& v, const Path& path) {
  if constexpr (std::is_integral_v<T>)
    if (v.scale == 1.0 && v.offset == 0.0) return std::uint16_t(raw);
  double value = double(raw) * v.scale + v.offset;
  double whole = std::round(value);
  if (!(std::abs(value - whole) < kWhole)) refuse(path, fmt::format("is no label volume: it has the value {}", value));
  return std::uint16_t(whole);
}

/// Which id a sample of a layer stands for: itself, or what the segments say.
using LayerMap = std::vector<std::uint16_t>;

std::vector<LayerMap> layerMaps(const std::vector<SlicerSegment>& segments, int channels) {
  std::vector<LayerMap> maps;
  if (channels == 1) return maps;
  maps.assign(std::size_t(channels), LayerMap(65536, 0));
  for (const SlicerSegment& s : segments)
    if (s.layer < channels) maps[std::size_t(s.layer)][s.value] = s.label.id;
  return maps;
}

/// One of several layers has an id of its own for each voxel; the last that has one wins.
struct Overlay {
  const std::vector<LayerMap>& maps;
  std::uint64_t overlaps = 0;  ///< Voxels that several layers claim.
  std::uint64_t strays = 0;    ///< Samples that no segment has.

  template <class T>
  std::uint16_t idOf(const T* samples, const Volume& v, const Path& path) {
    std::uint16_t result = 0;
    for (std::size_t c = 0; c < maps.size(); ++c) {
      std::uint16_t sample = idFrom(samples[c], v, path), id = maps[c][sample];
      strays += sample != 0 && id == 0;
      overlaps += id != 0 && result != 0 && id != result;
      if (id != 0) result = id;
    }
    return result;
  }
};

/// Slab by slab, so that no second array of all ids is ever held.
LabelVolume convert(const Volume& v, Overlay& overlay, const Path& path, Progress& progress) {
  LabelVolume labels(v.dims, v.worldFromVoxel, v.lengthUnit);
  std::size_t plane = std::size_t(v.dims.x) * std::size_t(v.dims.y), channels = std::size_t(v.channels);
  std::vector<std::uint16_t> slab(plane * std::size_t(std::min(kSlab, v.dims.z)));
  for (int z = 0; z < v.dims.z; z += kSlab) {
    int depth = std::min(kSlab, v.dims.z - z);
    std::size_t count = plane * std::size_t(depth);
    visitSamples(v, [&](auto* samples) {
      auto* from = samples + std::size_t(z) * plane * channels;
      for (std::size_t i = 0; i < count; ++i)
        slab[i] = overlay.maps.empty() ? idFrom(from[i], v, path) : overlay.idOf(from + i * channels, v, path);
    });
    labels.write({0, 0, z}, {v.dims.x, v.dims.y, depth}, std::span(slab).first(count));
    progress.report(double(z + depth) / v.dims.z, "Sorting labels");
  }
  return labels;
}

LabelVolume labelsFrom(const Volume& v, const scene::Source& source, Progress& progress, const KnownIds& known = {}) {
  Path path = source.path;
  auto segments = segmentsOf(path);
  if (v.channels > 1 && (segments.empty() || v.isColor))
    refuse(path, fmt::format("is no label volume: it has {} samples per voxel", v.channels));
  bool isWide = v.range.y > double(kLargestLabel);
  if (v.range.x < 0 || (isWide && v.channels > 1))
    refuse(path, fmt::format("is no label volume: values run from {:.6g} to {:.6g}, ids from 0 to {}", v.range.x,
                             v.range.y, v.channels > 1 ? "65535" : "2^63"));
  if (isWide) {
    LabelBrickOptions how;
    how.path = path;
    how.known = known;
    std::vector<std::string> notes;
    auto named = tableOf(source, notes);
    LabelVolume labels = labelsByBricks(VolumeSource(v), v, how, std::move(named), progress);
    labels.warnings.insert(labels.warnings.end(), notes.begin(), notes.end());
    return labels;
  }
  auto maps = layerMaps(segments, v.channels);
  Overlay overlay{maps};
  LabelVolume labels = convert(v, overlay, path, progress);
  labels.name = v.name;
  labels.warnings = v.warnings;
  if (v.timeSteps > 1)
    labels.warnings.push_back(fmt::format("the file has {} time frames; the first was taken", v.timeSteps));
  if (overlay.overlaps > 0)
    labels.warnings.push_back(sayCount(overlay.overlaps, "1 voxel belongs to several segments; the last one has it",
                                       "{} voxels belong to several segments; the last one has them"));
  if (overlay.strays > 0)
    labels.warnings.push_back(sayCount(overlay.strays, "1 voxel of the layers is of no segment; it is left out",
                                       "{} voxels of the layers are of no segment; they are left out"));
  std::vector<LabelInfo> table;
  std::size_t renumbered = 0;
  for (const SlicerSegment& segment : segments) {
    renumbered += segment.label.id != segment.value;
    table.push_back(segment.label);
  }
  if (renumbered > 0)
    labels.warnings.push_back(
        sayCount(renumbered, "1 segment has a number of its own here: in the file its value is another layer's, too",
                 "{} segments have numbers of their own here: in the file they share values of other layers"));
  if (table.empty()) table = tableOf(source, labels.warnings);
  labels.table = completeTable(std::move(table), labels.idsInUse());
  return labels;
}

/// The voxels of labels, in the place of the scan where the file has none of its own.
Volume readOn(const LabelGrid& scan, const scene::Source& source, Progress& progress) {
  scene::Source asItIs = source;
  asItIs.spacing = glm::dvec3(0.0);
  Volume v = readVolume(asItIs, progress);
  if (v.dims == scan.dims && hasNoPlace(v, scan)) {
    placeOn(v, scan.worldFromVoxel, scan.unit);
    return v;
  }
  return source.spacing == glm::dvec3(0.0) ? v : readVolume(source, progress);
}

/// Files of segments where a folder, or a medium, holds no images; nothing for all else.
std::vector<DicomFile> labelsAloneIn(const Path& path, Progress& progress) {
  bool isFolder = std::filesystem::is_directory(path);
  if (isFolder && isStore(path)) return {};
  if (!isFolder && !isDicomIndex(path)) return {};
  try {
    return labelsWithoutImages(isFolder ? path : path.parent_path(), progress);
  } catch (const InputError&) {
    return {};  // of a folder that cannot be searched the volume's reader says why
  }
}

/// Segments of DICOM: of a file, or the ones of a folder, or of a medium, that holds no images.
std::optional<LabelVolume> readDicomLabels(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  scene::Source one = source;
  std::string note;
  if (auto files = labelsAloneIn(path, progress); !files.empty()) {
    auto weight = [&](const DicomFile& file) { return std::pair(file.seriesUid == source.series, file.frames.size()); };
    auto chosen = std::max_element(files.begin(), files.end(),
                                   [&](const auto& a, const auto& b) { return weight(a) < weight(b); });
    one.path = chosen->path.string();
    if (files.size() > 1)
      note =
          fmt::format("the folder holds no images and {} files of segments; {} was taken", files.size(),
                      inQuotes(chosen->description.empty() ? chosen->path.filename().string() : chosen->description));
  }
  std::optional<LabelVolume> labels;
  if (isDicomSeg(one.path)) labels = readDicomSeg(one, progress);
  if (isRtStruct(one.path)) labels = readRtStruct(one, progress);
  if (labels && !note.empty()) labels->warnings.push_back(note);
  return labels;
}

/// An image of a store that holds whole numbers of 64 bits, as only ids need.
bool hasWideNumbers(const scene::Source& source) {
  if (!isStore(source.path)) return false;
  auto image = openImage(source.path, source.series);
  image->carryIds();
  return image->carriesIds();
}

}  // namespace

LabelVolume readLabels(const scene::Source& source, Progress& progress, const std::optional<LabelGrid>& scan,
                       const KnownIds& known) {
  if (auto labels = readDicomLabels(source, progress)) return std::move(*labels);
  if (segmentsOf(source.path).empty())
    if (auto labels = readLargeLabels(source, scan, known, progress)) return std::move(*labels);
  Volume volume = scan ? readOn(*scan, source, progress) : readVolume(source, progress);
  return labelsFrom(volume, source, progress, known);
}

std::variant<Volume, LabelVolume> readVoxels(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  bool hasLayout = source.raw.dims.x > 0;
  if (hasLayout) return readVolume(source, progress);
  if (auto labels = readDicomLabels(source, progress)) return std::move(*labels);
  if (!looksLikeLabels(path) && !holdsLabels(path, source.series)) {
    Volume volume = readVolume(source, progress);
    if (!holdsNothingButIds(volume)) return volume;
    if (volume.finer) return readLabels(source, progress);  // this was a coarse level
    return labelsFrom(volume, source, progress);
  }
  if (!segmentsOf(path).empty() || holdsLabels(path, source.series) || hasWideNumbers(source))
    return readLabels(source, progress);
  Volume volume = readVolume(source, progress);
  if (!holdsAreasOfIds(volume)) return volume;
  if (volume.finer) return readLabels(source, progress);  // this was a coarse level
  return labelsFrom(volume, source, progress);
}

bool looksLikeLabels(const std::filesystem::path& path) {
  try {
    if (nameSaysLabels(path)) return true;
    Progress unseen;
    if (!labelsAloneIn(path, unseen).empty() || holdsLabels(path, "")) return true;
    if (!std::filesystem::is_regular_file(path)) return false;
    if (isDicomSeg(path) || isRtStruct(path) || !segmentsOf(path).empty()) return true;
    if (!isNifti(path)) return false;
    NiftiHeader header = readNiftiHeader(path);
    return header.intent == 1002 || !namesInNifti(header).empty();
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

}  // namespace velum::io
