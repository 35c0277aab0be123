#include "io/volumes/ReadVolume.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Memory.h"
#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/DicomFile.h"
#include "io/volumes/OpenSource.h"
#include "io/volumes/ReadLevel.h"

#include "io/read/Placement.h"

#include "io/volumes/FormatTable.h"

namespace velum::io {

namespace {

/// Any file of the folder with one of these extensions.
bool holdsFiles(const Path& folder, std::initializer_list<std::string_view> extensions) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (std::find(extensions.begin(), extensions.end(), lowerExtension(entry.path())) != extensions.end()) return true;
  return false;
}

Volume readFolder(const scene::Source& source, Progress& progress) {
  Path folder = source.path;
  if (hasRawLayout(source)) return readRaw(source, progress);
  if (isStore(folder)) return readStore(source, progress);
  if (holdsDicom(folder, Depth::Folder, progress)) return readDicom(source, progress);
  if (holdsFiles(folder, {".tif", ".tiff", ".png"})) return readTiff(source, progress);
  if (holdsDicom(folder, Depth::AllBelow, progress)) return readDicom(source, progress);
  refuse(folder,
         "neither the folder nor one below it holds a DICOM series, and it holds no TIFF or PNG planes; for headerless "
         "slices give their size and type");
}

/// Why a file that no reader takes is none, as far as its first bytes tell.
std::string describeStranger(const FileHead& head) {
  if (head.bytes.empty()) return "is empty or cannot be read";
  if (head.bytes.starts_with("PK\x03\x04")) return "is a ZIP archive; unpack it first";
  if (head.bytes.starts_with("version https://git-lfs")) return "is a Git LFS pointer, not the data";
  if (head.bytes.starts_with("\x89PNG")) return "is a PNG picture; a folder of PNG planes can be read";
  return "is of no kind that can be read; for headerless samples give their size and type";
}

/// Refuses what would take more memory than there is before any of it is read.
void expectFits(const scene::Source& source) {
  constexpr std::uintmax_t kSmall = 1u << 30;  // bytes of a file that are not looked at
  std::error_code error;
  if (std::filesystem::file_size(source.path, error) < kSmall || error) return;
  auto opened = openSource(source);
  if (!opened || opened->levels().size() > 1) return;
  double bytes = levelBytes(*opened, 0), most = machineBytes() / 2;
  if (bytes > most)
    refuse(source.path,
           fmt::format("it has {:.1f} GB of voxels in one level, and half of the memory, {:.1f} GB, is the "
                       "most that is read whole; velum-batch convert makes a store of it, which is streamed",
                       bytes / 1e9, most / 1e9));
}

Volume readFile(const scene::Source& source, Progress& progress) {
  Path path = source.path;
  sizeOfFile(path);
  expectFits(source);
  if (hasRawLayout(source)) return readRaw(source, progress);
  FileHead head = readFileHead(path);
  const FormatRow* row = chooseReader(head);
  if (!row) refuse(path, describeStranger(head));
  if (row->format.name == "Raw") refuse(path, "has no header; give its size and type");
  if (head.bytes.starts_with("version https://git-lfs")) refuse(path, describeStranger(head));
  return row->read(source, progress);
}

}  // namespace

Volume readVolume(const scene::Source& source, Progress& progress) {
  progress.throwIfCancelled();
  Path path = source.path;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) refuse(path, "there is no such file or folder");
  bool isFolder = std::filesystem::is_directory(path, error);
  Volume volume = isFolder ? readFolder(source, progress) : readFile(source, progress);
  completeHead(volume, source);
  computeRange(volume);
  widenRange(volume);
  progress.report(1.0, "Read " + volume.name);
  return volume;
}

}  // namespace velum::io
