#include "session/document/Sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "scene/Scene.h"

namespace velum::session {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHashedBytes = 64 << 10;
constexpr int kDeepest = 5;           ///< folders below the scene's that are looked into
constexpr int kMostEntries = 20'000;  ///< files and folders that are looked at in one search

/// FNV-1a, 64 bits.
struct Hash {
  std::uint64_t value = 14695981039346656037ull;
  void add(std::string_view bytes) {
    for (unsigned char c : bytes) value = (value ^ c) * 1099511628211ull;
  }
};

std::string fingerprintOfFile(const fs::path& path, std::uintmax_t size) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return {};
  Hash hash;
  std::string bytes(kHashedBytes, '\0');
  auto addFrom = [&](std::uintmax_t offset) {
    in.clear();
    in.seekg(std::streamoff(offset));
    in.read(bytes.data(), std::streamsize(bytes.size()));
    hash.add(std::string_view(bytes.data(), std::size_t(in.gcount())));
  };
  addFrom(0);
  if (size > kHashedBytes) addFrom(std::max<std::uintmax_t>(kHashedBytes, size - kHashedBytes));
  return fmt::format("{}-{:016x}", size, hash.value);
}

std::string fingerprintOfFolder(const fs::path& path) {
  std::vector<std::string> rows;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path, error)) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored))
      rows.push_back(fmt::format("{} {}\n", entry.path().filename().string(), entry.file_size(ignored)));
  }
  std::sort(rows.begin(), rows.end());
  Hash hash;
  for (const auto& row : rows) hash.add(row);
  return fmt::format("folder-{}-{:016x}", rows.size(), hash.value);
}

/// One search: what it wants, and how much it may still look at.
struct Search {
  const scene::Source& source;
  fs::path name;
  Progress& progress;
  int entriesLeft = kMostEntries;

  bool fits(const fs::path& path) const {
    return source.fingerprint.empty() || fingerprintOf(path) == source.fingerprint;
  }
  /// Cheap, before anything is read: the same name, or at least the same size.
  bool isCandidate(const fs::directory_entry& entry) const {
    if (entry.path().filename() == name) return true;
    std::error_code error;
    return !source.fingerprint.empty() && entry.is_regular_file(error) &&
           source.fingerprint.starts_with(fmt::format("{}-", entry.file_size(error)));
  }
  std::optional<fs::path> look(const fs::path& folder, int depth);
};

std::optional<fs::path> Search::look(const fs::path& folder, int depth) {
  std::error_code error;
  std::vector<fs::path> below;
  for (fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error), end; at != end;
       at.increment(error)) {
    if (error || --entriesLeft < 0) break;
    progress.throwIfCancelled();
    if (isCandidate(*at) && fits(at->path())) return at->path();
    std::error_code ignored;
    bool isHidden = at->path().filename().string().starts_with('.');
    if (depth > 0 && !isHidden && at->is_directory(ignored) && !at->is_symlink(ignored)) below.push_back(at->path());
  }
  std::sort(below.begin(), below.end());
  for (const auto& next : below)
    if (auto found = look(next, depth - 1)) return found;
  return std::nullopt;
}

void addMissing(std::vector<MissingData>& out, std::string field, std::string what, const scene::Source& source,
                bool hasData) {
  if (!source.path.empty() && !hasData) out.push_back({field + ".source.path", std::move(what), source.path});
}

}  // namespace

std::string fingerprintOf(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return fingerprintOfFolder(path);
  auto size = fs::file_size(path, error);
  return error ? std::string() : fingerprintOfFile(path, size);
}

std::optional<fs::path> findMoved(const scene::Source& source, const fs::path& sceneFolder,
                                  const std::vector<fs::path>& otherFolders, Progress& progress) {
  fs::path path(source.path);
  Search search{source, path.has_filename() ? path.filename() : path.parent_path().filename(), progress};
  std::error_code error;
  auto isThere = [&](const fs::path& place) { return fs::exists(place, error) && search.fits(place); };
  fs::path base = sceneFolder.empty() ? fs::path(".") : sceneFolder;
  if (isThere(base / search.name)) return base / search.name;
  // A tree that was moved or copied as a whole: the end of the old path, below the scene's folder.
  fs::path tail = search.name;
  for (fs::path parent = path.parent_path(); parent.has_filename(); parent = parent.parent_path()) {
    tail = parent.filename() / tail;
    if (isThere(base / tail)) return base / tail;
  }
  if (auto found = search.look(base, kDeepest)) return found;
  // Elsewhere a name alone says nothing: every patient has a ct.nrrd.
  if (source.fingerprint.empty()) return std::nullopt;
  if (auto found = search.look(path.parent_path(), 0)) return found;
  for (const auto& folder : otherFolders)
    if (auto found = search.look(folder, 1)) return found;
  return std::nullopt;
}

std::vector<MissingData> missingData(const scene::Scene& scene) {
  std::vector<MissingData> out;
  addMissing(out, "volume", "volume", scene.volume.source, bool(scene.volume.data));
  addMissing(out, "labels", "labels", scene.labels.source, bool(scene.labels.data));
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
    addMissing(out, fmt::format("surfaces.{}", i), "surface", scene.surfaces[i].source, bool(scene.surfaces[i].data));
  addMissing(out, "model", "model", scene.model.source, bool(scene.model.data));
  return out;
}

std::string sayMissing(const MissingData& missing) {
  return fmt::format("the scene's {} {} is not there, nor near the scene; put it back, or name it with --set {}=FILE",
                     missing.what, missing.path, missing.field);
}

}  // namespace velum::session
