#include "io/stores/Store.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/read/FileBytes.h"
#include "io/read/FileNames.h"
#include "io/stores/ZipStore.h"

namespace velum::io {

namespace {

constexpr std::uint64_t kMostMetadata = std::uint64_t(64) << 20;

class FileBlob : public Blob {
 public:
  explicit FileBlob(const Path& path) : mFile(path) {}
  std::uint64_t size() const override { return mFile.size(); }
  void read(std::uint64_t at, std::span<std::byte> to) const override { mFile.read(at, to); }

 private:
  FileBytes mFile;
};

class FolderStore : public Store {
 public:
  explicit FolderStore(Path folder) : mFolder(std::move(folder)) {}
  Path pathOf(const std::string& key) const override { return key.empty() ? mFolder : mFolder / key; }
  std::unique_ptr<Blob> open(const std::string& key) const override {
    Path path = mFolder / key;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
      // What a store lacks has its fill value; of one that is gone nothing is known.
      if (!std::filesystem::is_directory(mFolder, error))
        refuse(mFolder, "the store is gone: it was removed or renamed, or its disk is away");
      return nullptr;
    }
    return std::make_unique<FileBlob>(path);
  }
  std::vector<std::string> folders(const std::string& key) const override {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(pathOf(key), error))
      if (std::string name = entry.path().filename().string(); !name.starts_with('.') && entry.is_directory(error))
        names.push_back(std::move(name));
    std::sort(names.begin(), names.end(), naturalLess);
    return names;
  }

 private:
  Path mFolder;
};

}  // namespace

std::vector<std::string> Store::folders(const std::string&) const { return {}; }

std::unique_ptr<Store> openStore(const Path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return std::make_unique<FolderStore>(path);
  return openZipStore(path);
}

Bytes bytesOf(const Blob& blob, const Path& path, std::uint64_t most) {
  if (blob.size() > most)
    refuse(path, fmt::format("has {} bytes, where {} are the most that make sense", blob.size(), most));
  Bytes bytes(std::size_t(blob.size()));
  blob.read(0, bytes);
  return bytes;
}

std::string textOf(const Store& store, const std::string& key) {
  auto blob = store.open(key);
  if (!blob) return {};
  Bytes bytes = bytesOf(*blob, store.pathOf(key), kMostMetadata);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string keyBelow(const Store& store, const std::string& folder, std::string_view name) {
  std::string key = folder;
  for (std::size_t at = 0; at <= name.size();) {
    std::size_t end = std::min(name.find('/', at), name.size());
    std::string_view part = name.substr(at, end - at);
    if (part == ".." || part.find('\0') != part.npos || name.starts_with('/') || name.find('\\') != name.npos)
      refuse(store.pathOf(folder), fmt::format("the path {} leads out of the store", inQuotes(name)));
    if (!part.empty() && part != ".") key += (key.empty() ? "" : "/") + std::string(part);
    at = end + 1;
  }
  return key;
}

}  // namespace velum::io
