#include "io/volumes/DicomFrames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/volumes/DicomTags.h"
#include "io/volumes/DicomValues.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

void takePosition(DicomFrame& frame, const DataSet& set, bool& hasPosition) {
  auto p = numbersOf(set, Tag(0x0020, 0x0032));
  if (p.size() < 3 || !std::all_of(p.begin(), p.end(), [](double x) { return std::isfinite(x); })) return;
  frame.position = {p[0], p[1], p[2]};
  hasPosition = true;
}

void takeOrientation(DicomFrame& frame, const DataSet& set, bool& hasOrientation) {
  auto o = numbersOf(set, Tag(0x0020, 0x0037));
  if (o.size() < 6) return;
  glm::dvec3 row(o[0], o[1], o[2]), column(o[3], o[4], o[5]);
  double rowLength = glm::length(row), columnLength = glm::length(column);
  // Anything that is not near two perpendicular unit vectors is damage, not orientation.
  bool usable =
      std::abs(rowLength - 1) < 0.1 && std::abs(columnLength - 1) < 0.1 && std::abs(glm::dot(row, column)) < 0.1;
  if (!usable) return;
  frame.rowDirection = row / rowLength;
  frame.columnDirection = column / columnLength;
  hasOrientation = true;
}

void takeMeasures(DicomFrame& frame, const DataSet& set) {
  // Pixel Spacing is in the patient; the other two are what projections have.
  for (Tag tag : {Tag(0x0028, 0x0030), Tag(0x0018, 0x1164), Tag(0x0018, 0x2010)}) {
    auto s = numbersOf(set, tag);
    if (s.size() < 2 || !(s[0] > 0 && s[1] > 0 && std::isfinite(s[0]) && std::isfinite(s[1]))) continue;
    frame.spacing = {s[1], s[0]};  // the standard names the distance between rows first
    break;
  }
  for (Tag tag : {Tag(0x0018, 0x0088), Tag(0x0018, 0x0050)}) {
    double s = std::abs(numberOf(set, tag, 0));
    if (!(s > 0 && std::isfinite(s))) continue;
    frame.sliceSpacing = s;
    break;
  }
}

void warnOnce(DicomFile& file, std::string text) {
  if (std::find(file.warnings.begin(), file.warnings.end(), text) == file.warnings.end())
    file.warnings.push_back(std::move(text));
}

/// Of the file itself, or of a frame's functional group.
void takeRescale(DicomFrame& frame, const DataSet& set, DicomFile& file) {
  const Tag kSlope(0x0028, 0x1053), kIntercept(0x0028, 0x1052);
  std::string type = textOf(set, Tag(0x0028, 0x1054));
  bool has = set.FindDataElement(kSlope) || set.FindDataElement(kIntercept);
  if (!type.empty()) frame.unit = unitOfRescaleType(type);
  // Rescaled values of a CT are Hounsfield's unless the file says otherwise; some programs write "US" for want of it.
  if (has && file.modality == "CT" && file.samplesPerPixel == 1 && frame.unit.empty()) frame.unit = "HU";
  double slope = numberOf(set, kSlope, frame.slope), intercept = numberOf(set, kIntercept, frame.intercept);
  if (!std::isfinite(slope) || !std::isfinite(intercept) || slope == 0.0) {
    warnOnce(
        file,
        fmt::format("a rescale slope of {:.6g} and an intercept of {:.6g} are no numbers to scale by and are left out",
                    slope, intercept));
    return;
  }
  frame.slope = slope;
  frame.intercept = intercept;
}

/// A radiation dose has names of its own for scale, unit and places.
void takeDose(DicomFrame& frame, const DataSet& set, DicomFile& file) {
  double scale = numberOf(set, Tag(0x3004, 0x000e), 0);
  std::string units = textOf(set, Tag(0x3004, 0x0002));
  frame.slope = 1, frame.intercept = 0, frame.unit.clear();
  if (!(scale > 0 && std::isfinite(scale))) {
    warnOnce(file, "the dose has no grid scaling; its values are the stored numbers");
    return;
  }
  frame.slope = scale;
  if (units == "GY")
    frame.unit = "Gy";
  else
    warnOnce(file, "the dose is relative to one that the file does not tell");
}

DicomFrame baseFrameOf(const DataSet& set, DicomFile& file) {
  DicomFrame base;
  takeMeasures(base, set);
  takeRescale(base, set, file);
  if (file.isDose()) takeDose(base, set, file);
  if (file.modality == "PT") base.unit = unitOfPet(set);
  if (!file.table.entries.empty()) base.unit = file.table.unit;
  base.instance = int(std::clamp(numberOf(set, Tag(0x0020, 0x0013), 0), -2e9, 2e9));
  const Tag kTimeTags[] = {Tag(0x0020, 0x0100), Tag(0x0018, 0x1060), Tag(0x0020, 0x0012), Tag(0x0018, 0x0081),
                           Tag(0x0008, 0x0032)};
  for (Tag tag : kTimeTags) base.timeKey.push_back(numberOf(set, tag, 0));
  return base;
}

/// One functional group macro, from the frame's own item, or from the shared one.
void takeFunctionalGroups(DicomFrame& frame, const DataSet& set, DicomFile& file, bool& hasPosition,
                          bool& hasOrientation) {
  if (auto item = firstItem(set, Tag(0x0020, 0x9113))) takePosition(frame, *item, hasPosition);
  if (auto item = firstItem(set, Tag(0x0020, 0x9116))) takeOrientation(frame, *item, hasOrientation);
  if (auto item = firstItem(set, Tag(0x0028, 0x9110))) takeMeasures(frame, *item);
  if (auto item = firstItem(set, Tag(0x0028, 0x9145))) takeRescale(frame, *item, file);
  if (auto item = firstItem(set, Tag(0x0062, 0x000a)))
    frame.segment = binaryOf<std::uint16_t>(*item, Tag(0x0062, 0x000b), 0);
  if (auto item = firstItem(set, Tag(0x0020, 0x9111))) {
    double temporal = binaryOf<std::uint32_t>(*item, Tag(0x0020, 0x9128), 0);
    if (temporal > 0) frame.timeKey = {temporal};
  }
}

}  // namespace

std::vector<DicomFrame> dicomFramesOf(const DataSet& set, DicomFile& file, int count) {
  DicomFrame base = baseFrameOf(set, file);
  bool hasPosition = false, hasOrientation = false;
  takePosition(base, set, hasPosition);
  takeOrientation(base, set, hasOrientation);
  auto shared = firstItem(set, Tag(0x5200, 0x9229));
  if (shared) takeFunctionalGroups(base, *shared, file, hasPosition, hasOrientation);
  glm::dvec3 normal = glm::cross(base.rowDirection, base.columnDirection);
  std::vector<double> offsets;
  std::string warning;
  if (file.isDose()) offsets = doseOffsetsOf(set, count, base.position.z, normal.z, file.flaw, warning);
  if (!warning.empty()) warnOnce(file, warning);
  auto perFrame = sequenceOf(set, Tag(0x5200, 0x9230));
  std::vector<DicomFrame> frames;
  for (int i = 0; i < count; ++i) {
    DicomFrame frame = base;
    bool ownPosition = hasPosition && (count == 1), ownOrientation = hasOrientation;
    frame.index = i;
    if (perFrame && std::size_t(i) < perFrame->GetNumberOfItems())
      takeFunctionalGroups(frame, perFrame->GetItem(std::size_t(i) + 1).GetNestedDataSet(), file, ownPosition,
                           ownOrientation);
    if (!ownPosition && hasPosition && !offsets.empty()) {
      frame.position += normal * offsets[std::size_t(i)];
      ownPosition = true;
    }
    // Nuclear medicine gives the first plane and a distance, along the normal.
    if (!ownPosition && hasPosition && frame.sliceSpacing > 0) {
      frame.position += normal * (frame.sliceSpacing * i);
      ownPosition = true;
    }
    frame.hasPlace = ownPosition && ownOrientation;
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace velum::io
