#include "io/volumes/DicomFile.h"

#include <fmt/format.h>
#include <gdcmReader.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <mutex>

#include "core/Parallel.h"
#include "io/Plugins.h"
#include "io/read/Refuse.h"
#include "io/volumes/DicomFrames.h"
#include "io/volumes/DicomSoundness.h"
#include "io/volumes/DicomTags.h"
#include "io/volumes/ReadVolume.h"

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

/// "20240315" as people write it.
std::string dateOf(const DataSet& set) {
  std::string text = textOf(set, Tag(0x0008, 0x0021));
  if (text.empty()) text = textOf(set, Tag(0x0008, 0x0020));
  bool isDate = text.size() == 8 && text.find_first_not_of("0123456789") == text.npos;
  return isDate ? text.substr(0, 4) + "-" + text.substr(4, 2) + "-" + text.substr(6, 2) : std::string();
}

/// What a structure set is of, and what it is called.
void describeRtStruct(DicomFile& file, const DataSet& set, const std::string& charset) {
  if (file.description.empty()) file.description = utf8(textOf(set, Tag(0x3006, 0x0002)), charset);
  auto frame = firstItem(set, Tag(0x3006, 0x0010));
  auto study = frame ? firstItem(*frame, Tag(0x3006, 0x0012)) : std::nullopt;
  auto series = study ? firstItem(*study, Tag(0x3006, 0x0014)) : std::nullopt;
  if (series) file.referencedSeries = textOf(*series, Tag(0x0020, 0x000e));
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
  std::string charset = textOf(set, Tag(0x0008, 0x0005));
  file.description = utf8(textOf(set, Tag(0x0008, 0x103e)), charset);
  file.date = dateOf(set);
  if (auto referenced = firstItem(set, Tag(0x0008, 0x1115)))
    file.referencedSeries = textOf(*referenced, Tag(0x0020, 0x000e));
  if (file.isRtStruct()) describeRtStruct(file, set, charset);
  file.rows = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0010), 0);
  file.columns = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0011), 0);
  file.samplesPerPixel = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0002), 1);
  file.bitsAllocated = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0100), 0);
  file.bitsStored = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0101), std::uint16_t(file.bitsAllocated));
  file.isSigned = binaryOf<std::uint16_t>(set, Tag(0x0028, 0x0103), 0) == 1;
  file.isJpeg = textOf(meta, Tag(0x0002, 0x0010)).starts_with("1.2.840.10008.1.2.4");
  file.isFloat = set.FindDataElement(Tag(0x7fe0, 0x0008)) || set.FindDataElement(Tag(0x7fe0, 0x0009));
  file.timeStepSeconds = std::max(0.0, numberOf(set, Tag(0x0020, 0x0110), 0) * 1e-3);
  file.table = modalityTableOf(set, file.isSigned, file.flaw);
  if (file.hasPalette()) file.palette = paletteOf(set, file.isSigned, file.flaw);
  if (file.modality == "PT") file.pet = petOf(set);
  double count = numberOf(set, Tag(0x0028, 0x0008), 1);
  if (count >= 1 && count <= kMostFrames) file.frames = dicomFramesOf(set, file, int(count));
  return file;
}

constexpr std::size_t kMostFiles = 100'000;

template <class Iterator>
std::vector<Path> filesIn(const Path& folder, Progress& progress) {
  std::vector<Path> files;
  std::error_code error;
  // An empty folder is the parent of a bare file name; its files keep bare names in messages.
  for (Iterator at(folder.empty() ? Path(".") : folder, std::filesystem::directory_options::skip_permission_denied,
                   error);
       !error && at != Iterator(); at.increment(error)) {
    progress.throwIfCancelled();
    std::error_code isGone;
    if (at->is_regular_file(isGone)) files.push_back(folder.empty() ? at->path().filename() : at->path());
    if (files.size() > kMostFiles)
      refuse(folder, fmt::format("the folder holds more than {} files; choose one further down", kMostFiles));
  }
  if (error) refuse(folder, error.message());
  std::sort(files.begin(), files.end());  // so that equal slices are met in the same order on every disk
  return files;
}

std::vector<Path> filesOf(const Path& folder, Depth depth, Progress& progress) {
  if (depth == Depth::Folder) return filesIn<std::filesystem::directory_iterator>(folder, progress);
  if (folder == "/") refuse(folder, "all of the computer is too much to search; choose a folder further down");
  return filesIn<std::filesystem::recursive_directory_iterator>(folder, progress);
}

/// What an index lists, relative to its folder.
std::vector<Path> indexedFiles(const Path& index) {
  std::vector<Path> files;
  std::ifstream stream(index, std::ios::binary);
  gdcm::Reader reader;
  reader.SetStream(stream);
  if (!reader.Read()) return files;
  auto records = sequenceOf(reader.GetFile().GetDataSet(), Tag(0x0004, 0x1220));
  for (std::size_t i = 1; records && i <= records->GetNumberOfItems(); ++i) {
    std::string id = textOf(records->GetItem(i).GetNestedDataSet(), Tag(0x0004, 0x1500));
    std::replace(id.begin(), id.end(), '\\', '/');
    if (!id.empty()) files.emplace_back(id);
  }
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

std::vector<DicomFile> scanDicomFolder(const std::filesystem::path& folder, Depth depth, Progress& progress) {
  auto paths = filesOf(folder, depth, progress);
  std::vector<std::optional<DicomFile>> found(paths.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallelFor(std::size_t(0), paths.size(), [&](std::size_t i) {
    found[i] = readDicomHeader(paths[i]);
    std::lock_guard lock(mutex);
    progress.report(0.2 * double(++done) / double(paths.size()), "Looking for DICOM images");
  });
  std::vector<DicomFile> files;
  std::map<std::string, Path> known;  // media often hold images twice, in folders of their own
  for (auto& file : found) {
    bool isOfUse = file && (file->isRtStruct() || (file->hasImage() && !file->frames.empty()));
    if (!isOfUse) continue;
    Path place = file->path.parent_path();
    bool isCopy = !file->instanceUid.empty() && known.try_emplace(file->instanceUid, place).first->second != place;
    if (!isCopy) files.push_back(std::move(*file));
  }
  return files;
}

bool plugin::holdsDicom(const std::filesystem::path& folder, Depth depth, Progress& progress) {
  for (const Path& path : filesOf(folder, depth, progress)) {
    progress.throwIfCancelled();
    if (auto file = readDicomHeader(path); file && file->hasImage()) return true;
  }
  return false;
}

std::vector<DicomFile> plugin::labelsWithoutImages(const std::filesystem::path& folder, Progress& progress) {
  std::vector<DicomFile> labels;
  for (const Path& path : filesOf(folder, Depth::AllBelow, progress)) {
    progress.throwIfCancelled();
    auto file = readDicomHeader(path);
    if (!file) continue;
    if (file->holdsLabels())
      labels.push_back(std::move(*file));
    else if (file->hasImage())
      return {};
  }
  return labels;
}

bool plugin::isDicomIndex(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  auto file = readDicomHeader(path);
  return file && file->sopClass == "1.2.840.10008.1.3.10";
}

void checkDicomIndex(const std::filesystem::path& path) {
  std::vector<Path> files = indexedFiles(path);
  auto isThere = [&](const Path& file) { return std::filesystem::exists(path.parent_path() / file); };
  if (!files.empty() && std::none_of(files.begin(), files.end(), isThere))
    refuse(path, fmt::format("none of the {} files that this index lists lies beside it", files.size()));
}

bool plugin::isDicomSeg(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  auto file = readDicomHeader(path);
  return file && file->isSegmentation();
}

bool plugin::isRtStruct(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return false;
  auto file = readDicomHeader(path);
  return file && file->isRtStruct();
}

std::vector<SeriesInfo> plugin::listSeries(const std::filesystem::path& path, Progress& progress) {
  if (!std::filesystem::exists(path)) refuse(path, "there is no such file or folder");
  bool isFolder = std::filesystem::is_directory(path);
  bool isIndex = !isFolder && isDicomIndex(path);
  if (isIndex) checkDicomIndex(path);
  Path folder = isFolder ? path : path.parent_path();
  std::vector<SeriesInfo> series;
  std::vector<std::vector<Path>> files;
  for (const DicomFile& file :
       scanDicomFolder(folder, isFolder || isIndex ? Depth::AllBelow : Depth::Folder, progress)) {
    auto at = std::find_if(series.begin(), series.end(), [&](const SeriesInfo& s) { return s.uid == file.seriesUid; });
    if (at == series.end()) {
      SeriesInfo info{file.seriesUid, file.description, file.modality, 0, {file.columns, file.rows}};
      info.date = file.date;
      info.isSegmentation = file.holdsLabels();
      info.referencedSeries = file.referencedSeries;
      at = series.insert(series.end(), std::move(info));
      files.emplace_back();
    }
    at->imageCount += int(file.frames.size());
    files[std::size_t(at - series.begin())].push_back(file.path);
  }
  for (std::size_t i = 0; i < series.size(); ++i) series[i].middleFile = files[i][files[i].size() / 2];
  std::stable_sort(series.begin(), series.end(), [](auto& a, auto& b) { return a.imageCount > b.imageCount; });
  return series;
}

}  // namespace velum::io
