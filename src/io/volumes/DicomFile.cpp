#include "DicomFile.h"

#include <gdcmReader.h>
#include <gdcmTrace.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <mutex>

#include "DicomSoundness.h"
#include "DicomTags.h"
#include "read/Refuse.h"
#include "velum/io/volumes/ReadVolume.h"

namespace velum::io {

namespace {

using gdcm::DataSet;
using gdcm::Tag;

const Tag kPixelData(0x7fe0, 0x0010);
constexpr int kMostFrames = 1 << 20;

/// GDCM talks to stdout and stderr on its own; people get our one line instead.
void silenceGdcm() {
  static std::once_flag once;
  std::call_once(once, [] {
    gdcm::Trace::DebugOff();
    gdcm::Trace::WarningOff();
    gdcm::Trace::ErrorOff();
    static std::ostream nowhere(nullptr);
    gdcm::Trace::SetStream(nowhere);
  });
}

/// Names in Latin-1 become UTF-8; bytes of sets that we do not know become question marks.
std::string utf8(const std::string& text, const std::string& charset) {
  if (charset.find("192") != std::string::npos) return text;
  bool isLatin1 = charset.find("100") != std::string::npos;
  std::string result;
  for (char c : text) {
    auto byte = static_cast<unsigned char>(c);
    if (byte < 128) {
      result += c;
    } else if (isLatin1) {
      result += char(0xc0 | byte >> 6);
      result += char(0x80 | (byte & 0x3f));
    } else {
      result += '?';
    }
  }
  return result;
}

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

void takeRescale(DicomFrame& frame, const DataSet& set) {
  double slope = numberOf(set, Tag(0x0028, 0x1053), frame.slope),
         intercept = numberOf(set, Tag(0x0028, 0x1052), frame.intercept);
  if (!std::isfinite(slope) || !std::isfinite(intercept) || slope == 0.0) return;
  frame.slope = slope;
  frame.intercept = intercept;
}

/// One functional group macro, from the frame's own item, or from the shared one.
void takeFunctionalGroups(DicomFrame& frame, const DataSet& set, bool& hasPosition, bool& hasOrientation) {
  if (auto item = firstItem(set, Tag(0x0020, 0x9113))) takePosition(frame, *item, hasPosition);
  if (auto item = firstItem(set, Tag(0x0020, 0x9116))) takeOrientation(frame, *item, hasOrientation);
  if (auto item = firstItem(set, Tag(0x0028, 0x9110))) takeMeasures(frame, *item);
  if (auto item = firstItem(set, Tag(0x0028, 0x9145))) takeRescale(frame, *item);
  if (auto item = firstItem(set, Tag(0x0062, 0x000a)))
    frame.segment = binaryOf<std::uint16_t>(*item, Tag(0x0062, 0x000b), 0);
  if (auto item = firstItem(set, Tag(0x0020, 0x9111))) {
    double temporal = binaryOf<std::uint32_t>(*item, Tag(0x0020, 0x9128), 0);
    if (temporal > 0) frame.timeKey = {temporal};
  }
}

std::vector<DicomFrame> framesOf(const DataSet& set, int count) {
  DicomFrame base;
  bool hasPosition = false, hasOrientation = false;
  takePosition(base, set, hasPosition);
  takeOrientation(base, set, hasOrientation);
  takeMeasures(base, set);
  takeRescale(base, set);
  base.instance = int(std::clamp(numberOf(set, Tag(0x0020, 0x0013), 0), -2e9, 2e9));
  const Tag kTimeTags[] = {Tag(0x0020, 0x0100), Tag(0x0018, 0x1060), Tag(0x0020, 0x0012), Tag(0x0018, 0x0081),
                           Tag(0x0008, 0x0032)};
  for (Tag tag : kTimeTags) base.timeKey.push_back(numberOf(set, tag, 0));
  auto shared = firstItem(set, Tag(0x5200, 0x9229));
  if (shared) takeFunctionalGroups(base, *shared, hasPosition, hasOrientation);
  auto perFrame = sequenceOf(set, Tag(0x5200, 0x9230));
  std::vector<DicomFrame> frames;
  for (int i = 0; i < count; ++i) {
    DicomFrame frame = base;
    bool ownPosition = hasPosition && (count == 1), ownOrientation = hasOrientation;
    frame.index = i;
    if (perFrame && std::size_t(i) < perFrame->GetNumberOfItems())
      takeFunctionalGroups(frame, perFrame->GetItem(std::size_t(i) + 1).GetNestedDataSet(), ownPosition,
                           ownOrientation);
    // Nuclear medicine gives the first plane and a distance, along the normal.
    if (!ownPosition && hasPosition && frame.sliceSpacing > 0) {
      frame.position += glm::cross(frame.rowDirection, frame.columnDirection) * (frame.sliceSpacing * i);
      ownPosition = true;
    }
    frame.hasPlace = ownPosition && ownOrientation;
    frames.push_back(std::move(frame));
  }
  return frames;
}

DicomFile fileOf(const DataSet& set, const gdcm::FileMetaInformation& meta, const Path& path) {
  DicomFile file;
  file.path = path;
  file.seriesUid = textOf(set, Tag(0x0020, 0x000e));
  file.instanceUid = textOf(set, Tag(0x0008, 0x0018));
  file.modality = textOf(set, Tag(0x0008, 0x0060));
  file.sopClass = textOf(set, Tag(0x0008, 0x0016));
  if (file.sopClass.empty()) file.sopClass = textOf(meta, Tag(0x0002, 0x0002));
  file.photometric = textOf(set, Tag(0x0028, 0x0004));
  file.unit = textOf(set, file.modality == "PT" ? Tag(0x0054, 0x1001) : Tag(0x0028, 0x1054));
  std::string charset = textOf(set, Tag(0x0008, 0x0005));
  file.description = utf8(textOf(set, Tag(0x0008, 0x103e)), charset);
  file.rows = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0010), 0);
  file.columns = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0011), 0);
  file.samplesPerPixel = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0002), 1);
  file.bitsAllocated = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0100), 0);
  file.bitsStored = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0101), std::uint16_t(file.bitsAllocated));
  file.isSigned = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0103), 0) == 1;
  file.isJpeg = textOf(meta, Tag(0x0002, 0x0010)).starts_with("1.2.840.10008.1.2.4");
  constexpr std::uint16_t kDose = 0x3004, kGridFrameOffsets = 0x000c;
  file.hasBadOffsets =
      set.FindDataElement(Tag(kDose, kGridFrameOffsets)) && numbersOf(set, Tag(kDose, kGridFrameOffsets)).size() < 2;
  file.isFloat = set.FindDataElement(Tag(0x7fe0, 0x0008)) || set.FindDataElement(Tag(0x7fe0, 0x0009));
  file.timeStepSeconds = std::max(0.0, numberOf(set, Tag(0x0020, 0x0110), 0) * 1e-3);
  double count = numberOf(set, Tag(0x0028, 0x0008), 1);
  if (count >= 1 && count <= kMostFrames) file.frames = framesOf(set, int(count));
  return file;
}

/// Cheap test before GDCM is asked, so that a folder of other files costs next to nothing.
bool mayBeDicom(const Path& path) {
  std::ifstream stream(path, std::ios::binary);
  char head[132] = {};
  stream.read(head, sizeof head);
  if (stream.gcount() == 132 && std::memcmp(head + 128, "DICM", 4) == 0) return true;
  return stream.gcount() >= 16 && (head[0] == 2 || head[0] == 8) && head[1] == 0 && head[3] == 0;
}

std::vector<Path> filesOf(const Path& folder) {
  std::vector<Path> files;
  std::error_code error;
  // An empty folder is the parent of a bare file name; its files keep bare names in messages.
  for (const auto& entry : std::filesystem::directory_iterator(folder.empty() ? Path(".") : folder, error))
    if (entry.is_regular_file(error)) files.push_back(folder.empty() ? entry.path().filename() : entry.path());
  if (error) refuse(folder, error.message());
  std::sort(files.begin(), files.end());  // so that equal slices are met in the same order on every disk
  return files;
}

}  // namespace

std::optional<DicomFile> readDicomHeader(const std::filesystem::path& path) {
  silenceGdcm();
  if (!mayBeDicom(path) || !isSoundDicom(path)) return std::nullopt;
  try {
    std::ifstream stream(path, std::ios::binary);
    gdcm::Reader reader;
    reader.SetStream(stream);
    if (!reader.ReadUpToTag(kPixelData)) return std::nullopt;
    return fileOf(reader.GetFile().GetDataSet(), reader.GetFile().GetHeader(), path);
  } catch (const std::exception&) {
    return std::nullopt;  // GDCM throws on damage; the caller says so in one line
  }
}

std::vector<DicomFile> scanDicomFolder(const std::filesystem::path& folder, Progress& progress) {
  auto paths = filesOf(folder);
  std::vector<std::optional<DicomFile>> found(paths.size());
  std::mutex mutex;
  std::size_t done = 0;
  tbb::parallel_for(std::size_t(0), paths.size(), [&](std::size_t i) {
    found[i] = readDicomHeader(paths[i]);
    std::lock_guard lock(mutex);
    progress.report(0.2 * double(++done) / double(paths.size()), "Looking for DICOM images");
  });
  std::vector<DicomFile> files;
  for (auto& file : found)
    if (file && file->hasImage() && !file->frames.empty()) files.push_back(std::move(*file));
  return files;
}

bool holdsDicom(const std::filesystem::path& folder) {
  for (const Path& path : filesOf(folder))
    if (auto file = readDicomHeader(path); file && file->hasImage()) return true;
  return false;
}

bool isDicomSeg(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  auto file = readDicomHeader(path);
  return file && file->isSegmentation();
}

std::vector<SeriesInfo> listSeries(const std::filesystem::path& path, Progress& progress) {
  if (!std::filesystem::exists(path)) refuse(path, "there is no such file or folder");
  bool isFolder = std::filesystem::is_directory(path);
  // What lies beside a file of another format is none of its business.
  if (!isFolder && !mayBeDicom(path)) return {};
  Path folder = isFolder ? path : path.parent_path();
  std::vector<SeriesInfo> series;
  for (const DicomFile& file : scanDicomFolder(folder, progress)) {
    auto at = std::find_if(series.begin(), series.end(), [&](const SeriesInfo& s) { return s.uid == file.seriesUid; });
    if (at == series.end())
      at = series.insert(series.end(), {file.seriesUid, file.description, file.modality, 0, {file.columns, file.rows}});
    at->imageCount += int(file.frames.size());
  }
  std::stable_sort(series.begin(), series.end(), [](auto& a, auto& b) { return a.imageCount > b.imageCount; });
  return series;
}

}  // namespace velum::io
