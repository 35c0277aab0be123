#include <fmt/format.h>
#include <gdcmReader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>

#include "core/SayCount.h"
#include "io/Plugins.h"
#include "io/labels/DicomColor.h"
#include "io/labels/LabelTables.h"
#include "io/read/Refuse.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/DicomSoundness.h"
#include "io/volumes/DicomStack.h"
#include "io/volumes/DicomTags.h"
#include "io/volumes/Readers.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

/// What numbers stand for here: themselves, or the ids that our own writer keeps beside them.
using Ids = std::map<std::uint16_t, std::uint16_t>;

Ids idsOf(const DataSet& set) {
  Ids ids;
  std::set<std::uint16_t> taken;
  auto segments = sequenceOf(set, Tag(0x0062, 0x0002));
  for (std::size_t i = 1; segments && i <= segments->GetNumberOfItems(); ++i) {
    const DataSet& item = segments->GetItem(i).GetNestedDataSet();
    auto id = idOfTrackingId(textOf(item, Tag(0x0062, 0x0020)));
    if (!id || !taken.insert(*id).second) return {};
    ids[binaryOf<std::uint16_t>(item, Tag(0x0062, 0x0004), 0)] = *id;
  }
  return ids;
}

std::uint16_t idOf(const Ids& ids, std::uint16_t number) {
  auto found = ids.find(number);
  return found == ids.end() ? number : found->second;
}

std::vector<LabelInfo> segmentTable(const DataSet& set, const Ids& ids) {
  std::vector<LabelInfo> table;
  auto segments = sequenceOf(set, Tag(0x0062, 0x0002));
  for (std::size_t i = 1; segments && i <= segments->GetNumberOfItems(); ++i) {
    const DataSet& item = segments->GetItem(i).GetNestedDataSet();
    LabelInfo label;
    label.id = idOf(ids, binaryOf<std::uint16_t>(item, Tag(0x0062, 0x0004), 0));
    label.name = textOf(item, Tag(0x0062, 0x0005));
    label.color = defaultLabelColor(label.id);
    std::string lab = item.FindDataElement(Tag(0x0062, 0x000d)) ? std::string() : "none";
    const gdcm::ByteValue* bytes = lab.empty() ? item.GetDataElement(Tag(0x0062, 0x000d)).GetByteValue() : nullptr;
    if (bytes && bytes->GetLength() >= 6) {
      DicomLab numbers;
      std::memcpy(numbers.data(), bytes->GetPointer(), 6);
      label.color = srgbFromDicomLab(numbers);
    }
    table.push_back(std::move(label));
  }
  return table;
}

/// What the file's pixel bytes say of a voxel.
struct Mask {
  std::string_view bytes;
  int bits = 1;               ///< 1: packed over all frames, lowest bit first; 8, 16: one sample each.
  bool isLabelMap = false;    ///< Samples are segment numbers themselves.
  bool isFractional = false;  ///< Samples say how much of the voxel is in the segment.
  double threshold = 0;       ///< A sample over this is inside.
  std::uint64_t timeStepVoxels = 0;

  /// The segment number of a voxel, 0 for none. @param segment  of the frame
  std::uint16_t at(std::uint64_t frame, std::uint64_t voxel, std::uint16_t segment) const {
    std::uint64_t i = frame * timeStepVoxels + voxel;
    std::uint16_t sample = 0;
    if (bits == 16)
      std::memcpy(&sample, bytes.data() + 2 * i, 2);
    else
      sample = static_cast<unsigned char>(bytes[bits == 1 ? i / 8 : i]);
    if (isLabelMap) return sample;
    bool isInside = bits == 1 ? sample >> (i % 8) & 1 : sample > threshold;
    return isInside ? segment : std::uint16_t(0);
  }
};

Mask maskOf(const DataSet& set, const DicomFile& file) {
  if (!set.FindDataElement(Tag(0x7fe0, 0x0010))) refuse(file.path, "the segmentation has no pixel data");
  const gdcm::ByteValue* value = set.GetDataElement(Tag(0x7fe0, 0x0010)).GetByteValue();
  if (!value) refuse(file.path, "compressed DICOM segmentations are not supported");
  std::string type = textOf(set, Tag(0x0062, 0x0001));
  Mask mask;
  mask.bytes = {value->GetPointer(), value->GetLength()};
  mask.bits = file.bitsAllocated;
  mask.isLabelMap = type == "LABELMAP";
  mask.isFractional = type == "FRACTIONAL";
  mask.timeStepVoxels = std::uint64_t(file.rows) * std::uint64_t(file.columns);
  if (mask.isFractional) mask.threshold = 0.5 * binaryOf<std::uint16_t>(set, Tag(0x0062, 0x000e), 255);
  bool isRead = mask.isLabelMap ? mask.bits == 8 || mask.bits == 16 : mask.bits == 1 || mask.bits == 8;
  if (!isRead) refuse(file.path, fmt::format("segmentations of {} bits are not supported", mask.bits));
  std::uint64_t wanted = (mask.timeStepVoxels * file.frames.size() * std::uint64_t(mask.bits) + 7) / 8;
  if (mask.bytes.size() < wanted)
    refuse(file.path, fmt::format("the pixel data is cut off: {} bytes of {}", mask.bytes.size(), wanted));
  return mask;
}

/// Plane of each frame: segments share places, so every place counts once, and empty planes may be left out of a file.
struct Planes {
  std::vector<int> ofFrame;
  int count = 0;
  glm::dmat4 worldFromVoxel{1.0};
};

Planes planesOf(const DicomFile& file, std::vector<std::string>& warnings) {
  Planes planes;
  const DicomFrame& any = file.frames[0];
  bool havePlaces = std::all_of(file.frames.begin(), file.frames.end(), [](const DicomFrame& f) { return f.hasPlace; });
  glm::dvec3 normal = glm::normalize(glm::cross(any.rowDirection, any.columnDirection));
  std::vector<double> distances;
  for (std::size_t i = 0; i < file.frames.size(); ++i) {
    const DicomFrame& frame = file.frames[i];
    if (glm::dot(frame.rowDirection, any.rowDirection) < 0.999 ||
        glm::dot(frame.columnDirection, any.columnDirection) < 0.999)
      refuse(file.path, "frames of the segmentation lie in several directions; one is supported");
    distances.push_back(havePlaces ? glm::dot(frame.position, normal) : double(i));
  }
  std::vector<double> sorted = distances;
  std::sort(sorted.begin(), sorted.end());
  // The smallest gap that is not rounding is the distance of planes; the file's own claim fills in for a single one.
  double step = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (double gap = sorted[i] - sorted[i - 1]; gap > 0.01 && (step == 0 || gap < step)) step = gap;
  if (step == 0) step = any.sliceSpacing > 0 ? any.sliceSpacing : 1.0;
  double span = (sorted.back() - sorted.front()) / step;
  // Segments may be apart by empty planes, but not by more than a body has.
  if (span > 65535) refuse(file.path, "the places of its frames do not fit on a grid");
  planes.count = int(std::lround(span)) + 1;
  const DicomFrame* first = &any;
  double worst = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    double place = (distances[i] - sorted.front()) / step;
    planes.ofFrame.push_back(int(std::lround(place)));
    worst = std::max(worst, std::abs(place - std::round(place)) * step);
    if (distances[i] == sorted.front()) first = &file.frames[i];
  }
  if (worst > 0.05 * step)
    warnings.push_back(fmt::format(
        "planes are not evenly apart; each was put on the nearest of {:.3f} mm, by up to {:.3f} mm", step, worst));
  if (!havePlaces) warnings.push_back("frames of the segmentation have no position; they are stacked as they come");
  if (!(any.spacing.x > 0 && any.spacing.y > 0))
    warnings.push_back("the segmentation has no pixel spacing; 1 mm was taken");
  glm::dvec2 spacing = any.spacing.x > 0 && any.spacing.y > 0 ? any.spacing : glm::dvec2(1.0);
  auto& m = planes.worldFromVoxel;
  m[0] = glm::dvec4(any.rowDirection * spacing.x, 0);
  m[1] = glm::dvec4(any.columnDirection * spacing.y, 0);
  m[2] = glm::dvec4(normal * step, 0);
  m[3] = glm::dvec4(first->position, 1);
  return planes;
}

/// Frames by plane, slab by slab. @return how many voxels more than one segment claims
std::uint64_t fill(LabelVolume& labels, const DicomFile& file, const Mask& mask, const Planes& planes, const Ids& ids,
                   Progress& progress) {
  std::multimap<int, std::size_t> byPlane;
  for (std::size_t i = 0; i < planes.ofFrame.size(); ++i) byPlane.emplace(planes.ofFrame[i], i);
  std::uint64_t overlaps = 0;
  std::vector<std::uint16_t> slab;
  for (int z = 0; z < planes.count; z += LabelVolume::kBrickSize) {
    int depth = std::min(LabelVolume::kBrickSize, planes.count - z);
    auto begin = byPlane.lower_bound(z), end = byPlane.lower_bound(z + depth);
    if (begin == end) continue;
    slab.assign(mask.timeStepVoxels * std::uint64_t(depth), 0);
    for (auto at = begin; at != end; ++at) {
      auto segment = idOf(ids, std::uint16_t(std::max(1, file.frames[at->second].segment)));
      std::uint16_t* to = slab.data() + mask.timeStepVoxels * std::uint64_t(at->first - z);
      for (std::uint64_t v = 0; v < mask.timeStepVoxels; ++v) {
        std::uint16_t id = mask.at(at->second, v, segment);
        if (id == 0) continue;
        overlaps += to[v] != 0 && to[v] != id;
        to[v] = id;
      }
    }
    labels.write({0, 0, z}, {file.columns, file.rows, depth}, slab);
    progress.report(double(z + depth) / planes.count, "Reading segments");
  }
  return overlaps;
}

/// Frames of a segment at a place that has one of it already: of another moment, as a rule.
std::size_t repeatsOf(const DicomFile& file, const Planes& planes) {
  std::set<std::pair<int, int>> seen;
  std::size_t repeats = 0;
  for (std::size_t i = 0; i < planes.ofFrame.size(); ++i)
    repeats += !seen.emplace(planes.ofFrame[i], file.frames[i].segment).second;
  return repeats;
}

}  // namespace

LabelVolume plugin::readDicomSeg(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  auto file = readDicomHeader(path);
  if (!file || !file->hasImage() || file->frames.empty()) refuse(path, "is damaged, or no DICOM segmentation");
  std::ifstream stream(path, std::ios::binary);
  gdcm::Reader reader;
  reader.SetStream(stream);
  try {
    if (!reader.Read()) refuse(path, "the DICOM segmentation cannot be read");
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {
    refuse(path, "the DICOM segmentation is damaged");
  }
  const DataSet& set = reader.GetFile().GetDataSet();
  Mask mask = maskOf(set, *file);
  Ids ids = mask.isLabelMap ? Ids() : idsOf(set);
  std::vector<std::string> warnings;
  Planes planes = planesOf(*file, warnings);
  LabelVolume labels({file->columns, file->rows, planes.count}, planes.worldFromVoxel);
  std::uint64_t overlaps = fill(labels, *file, mask, planes, ids, progress);
  if (mask.isFractional)
    warnings.push_back("the segmentation says how much of a voxel is inside; what is over half is taken as inside");
  if (std::size_t repeats = repeatsOf(*file, planes))
    warnings.push_back(sayCount(repeats, "1 frame repeats a segment at its place; it is joined",
                                "{} frames repeat a segment at its place; they are joined"));
  if (overlaps > 0)
    warnings.push_back(sayCount(overlaps, "1 voxel belongs to several segments; the last one has it",
                                "{} voxels belong to several segments; the last one has them"));
  labels.name = file->description.empty() ? path.stem().string() : file->description;
  labels.table = completeTable(segmentTable(set, ids), labels.idsInUse());
  labels.warnings = std::move(warnings);
  return labels;
}

}  // namespace velum::io
