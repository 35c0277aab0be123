#include "io/kinds/FileKind.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <time.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <string_view>

#include "core/Error.h"
#include "core/FileName.h"
#include "io/images/ImageFile.h"
#include "io/labels/ReadLabels.h"
#include "io/labels/WriteLabels.h"
#include "io/looks/TransferFile.h"
#include "io/meshes/ReadMesh.h"
#include "io/meshes/WriteMesh.h"
#include "io/models/ReadModel.h"
#include "io/models/WriteModel.h"
#include "io/stores/OpenStore.h"
#include "io/volumes/Formats.h"

namespace velum::io {

namespace fs = std::filesystem;

namespace {

bool isSurface(std::string_view ending) {
  auto known = meshExtensions();
  return std::find(known.begin(), known.end(), ending) != known.end();
}

bool carriesScene(const fs::path& path) {
  try {
    return !readImageDescription(path).empty();
  } catch (const InputError&) {
    return false;  // what is wrong with it the volume's reader says
  }
}

WrittenFormat formatOf(std::string_view name, std::string_view endings) {
  WrittenFormat format{std::string(name), {}};
  std::istringstream words{std::string(endings)};
  for (std::string word; words >> word;) format.endings.push_back(word);
  return format;
}

FileKind kindByContents(const fs::path& path) {
  std::string ending = lowerExtension(path);
  if (isTransferFile(path)) return FileKind::Look;
  if (isSurface(ending)) return FileKind::Surface;
  if (looksLikeModel(path)) return FileKind::Model;
  if (ending == ".json") return FileKind::Scene;
  if (ending == ".png" || ending == ".exr" || isDrawing(path)) return FileKind::Picture;
  if ((ending == ".tif" || ending == ".tiff") && carriesScene(path)) return FileKind::Picture;
  return looksLikeLabels(path) ? FileKind::Labels : FileKind::Volume;
}

/// What a file is and when it or the names beside it have changed.
using FileStamp = std::array<std::int64_t, 8>;
std::optional<FileStamp> fileStampOf(const fs::path& path) {
  struct stat file {
  }, folder{};
  fs::path beside = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (::stat(path.c_str(), &file) != 0 || !S_ISREG(file.st_mode) || ::stat(beside.c_str(), &folder) != 0)
    return std::nullopt;
  return FileStamp{std::int64_t(file.st_dev), std::int64_t(file.st_ino), file.st_size,
                   file.st_ctim.tv_sec,       file.st_ctim.tv_nsec,      std::int64_t(folder.st_ino),
                   folder.st_ctim.tv_sec,     folder.st_ctim.tv_nsec};
}

/// A file that has just been changed may be changed again within the same tick of the disk's clock, and the stamp would
/// be the same. @param stamp  of now
bool isYoung(const FileStamp& stamp) {
  constexpr std::int64_t kYoungS = 3;  // as coarse as the clocks of file servers and old file systems are
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return std::max(stamp[3], stamp[6]) > now.tv_sec - kYoungS;
}

/// What an image is stands in the header beside it, whose stamp is another one.
bool isOfPair(const fs::path& path) {
  std::string ending = lowerExtension(path);
  return ending.starts_with(".img") || ending.starts_with(".hdr");
}

/// Kinds of files that have been looked into. A load asks eight times, and each look opens a file a dozen times, which
/// file servers of clusters feel.
class KnownKinds {
 public:
  FileKind kindOf(const fs::path& path) {
    auto stamp = fileStampOf(path);
    if (!stamp || isYoung(*stamp) || isOfPair(path)) return kindByContents(path);
    {
      std::lock_guard lock(mMutex);
      auto known = mKinds.find(*stamp);
      if (known != mKinds.end() && known->second.first == path) return known->second.second;
    }
    FileKind kind = kindByContents(path);
    std::lock_guard lock(mMutex);
    if (mKinds.size() >= kMost) mKinds.clear();
    mKinds.insert_or_assign(*stamp, std::pair(path, kind));
    return kind;
  }

 private:
  static constexpr std::size_t kMost = 256;
  std::mutex mMutex;
  std::map<FileStamp, std::pair<fs::path, FileKind>> mKinds;
};

}  // namespace

bool isDrawing(const fs::path& path) {
  std::string ending = lowerExtension(path);
  return ending == ".svg" || ending == ".pdf";
}

FileKind kindOf(const fs::path& path) {
  static KnownKinds known;
  std::error_code error;
  if (fs::is_directory(path, error)) return looksLikeLabels(path) ? FileKind::Labels : FileKind::Volume;
  return known.kindOf(path);
}

FileKind kindOf(const scene::Source& source) {
  if (source.raw.dims.x > 0) return FileKind::Volume;
  if (!source.series.empty() && isStore(source.path))
    return holdsLabels(source.path, source.series) ? FileKind::Labels : FileKind::Volume;
  return kindOf(fs::path(source.path));
}

std::vector<WrittenFormat> writable(FileKind kind) {
  std::vector<WrittenFormat> all;
  switch (kind) {
    case FileKind::Scene:
      return {formatOf("Velum scene", ".json")};
    case FileKind::Picture:
      return {formatOf("PNG", ".png"), formatOf("OpenEXR", ".exr"), formatOf("TIFF", ".tif .tiff")};
    case FileKind::Look:
      return {formatOf("Velum", ".velum-transfer.json"), formatOf("3D Slicer", ".vp.json"),
              formatOf("3D Slicer, old", ".vp")};
    case FileKind::Model:
      for (const auto& format : modelWriteFormats()) all.push_back(formatOf(format.name, format.extensions));
      return all;
    case FileKind::Surface:
      for (const auto& format : meshFormats()) all.push_back(formatOf(format.name, format.extension));
      return all;
    case FileKind::Labels:
      for (const auto& format : labelFormats()) all.push_back(formatOf(format.name, format.extensions));
      return all;
    case FileKind::Volume:
      for (const auto& format : formats())
        if (!format.written.empty()) all.push_back(formatOf(format.name, format.written));
      return all;
  }
  return all;
}

std::string endingsOf(FileKind kind) {
  std::string all;
  for (const WrittenFormat& format : writable(kind))
    for (const std::string& ending : format.endings) all += (all.empty() ? "" : ", ") + ending;
  return all;
}

}  // namespace velum::io
