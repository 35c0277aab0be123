#include "io/stores/OpenStore.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/FileName.h"
#include "core/Memory.h"
#include "io/read/ByteSource.h"
#include "io/stores/WriteStore.h"

namespace velum::io {

namespace {

constexpr double kGb = 1e9;

constexpr std::string_view kMetadata[] = {"zarr.json", ".zgroup", ".zattrs", ".zarray", kUnfinishedName};

/// @throw InputError for one that was not written to its end, too
std::unique_ptr<Store> openWhole(const Path& path) {
  if (isUnfinished(path))
    refuse(path, "is not whole: writing it was stopped; give the same command again, which goes on, or remove it");
  return openStore(path);
}

}  // namespace

bool isStore(const Path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error))
    return std::any_of(std::begin(kMetadata), std::end(kMetadata),
                       [&](std::string_view name) { return std::filesystem::is_regular_file(path / name, error); });
  if (!std::filesystem::is_regular_file(path, error)) return false;
  try {
    return isStoreArchive(path, readHead(path, 4096));
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

bool isStoreArchive(const Path& path, std::string_view head) {
  if (!head.starts_with("PK\x03\x04")) return false;
  std::string name = lowerCase(path.filename().string());
  if (name.ends_with(".ozx") || name.ends_with(".zarr.zip") || name.ends_with(".zarr")) return true;
  try {
    auto store = openStore(path);
    return std::any_of(std::begin(kMetadata), std::end(kMetadata),
                       [&](std::string_view file) { return store->open(std::string(file)) != nullptr; });
  } catch (const InputError&) {
    return false;  // some other archive
  }
}

std::vector<StoreImage> imagesIn(const Path& path) { return listImages(*openWhole(path)); }

std::unique_ptr<ZarrSource> openImage(const Path& path, const std::string& wanted) {
  std::shared_ptr<const Store> store = openWhole(path);
  std::string key = keyBelow(*store, "", wanted);
  std::vector<std::string> notes;
  if (wanted.empty()) {
    auto images = listImages(*store);
    if (images.empty())
      refuse(path, "the store holds no image: none of its groups has multiscales, and it is no array");
    key = images.front().key;
    auto count = std::count_if(images.begin(), images.end(), [](const auto& image) { return !image.isLabels; });
    if (count > 1)
      notes.push_back(fmt::format("the store holds {} images; {} was taken; choose by series", count,
                                  inQuotes(images.front().name)));
  }
  auto image = readOmeImage(*store, key);
  if (!image) refuse(path, fmt::format("the store holds no image {}", inQuotes(key)));
  return std::make_unique<ZarrSource>(store, std::move(*image), std::move(notes));
}

int levelToRead(const VoxelSource& of, const scene::Source& source) {
  double machine = machineBytes();
  int count = int(of.levels().size());
  if (source.level >= count)
    refuse(source.path, fmt::format("there is no level {}; they are 0 to {}", source.level, count - 1));
  int level = source.level >= 0 ? source.level : levelWithin(of, machine / 8).value_or(count - 1);
  double most = source.level >= 0 ? machine / 2 : machine / 8, bytes = levelBytes(of, level);
  if (bytes > most)
    refuse(
        source.path,
        fmt::format("its level {} has {:.1f} GB of voxels, and {:.1f} GB, {} of the memory, are the most that is read",
                    level, bytes / kGb, most / kGb, source.level >= 0 ? "a half" : "an eighth"));
  return level;
}

bool holdsLabels(const Path& path, const std::string& image) {
  if (!isStore(path)) return false;
  try {
    return openImage(path, image)->image().isLabels;
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

}  // namespace velum::io
