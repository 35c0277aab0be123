#include "io/stores/OpenStore.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "core/Memory.h"
#include "io/read/Refuse.h"

namespace velum::io {

namespace {

constexpr double kGb = 1e9;


}  // namespace

bool isStore(const Path& path) { return storeKind(path) != StoreKind::None; }

std::vector<StoreImage> imagesIn(const Path& path) { return openImageStore(path)->list(); }

std::unique_ptr<StoreSource> openImage(const Path& path, const std::string& wanted) {
  auto store = openImageStore(path);
  if (!wanted.empty()) return store->open(wanted, {});
  auto images = store->list();
  if (images.empty()) refuse(path, "the store holds no image: no group of it says that it is one, and it is no array");
  std::vector<std::string> notes;
  auto count = std::count_if(images.begin(), images.end(), [](const auto& image) { return !image.isLabels; });
  if (count > 1)
    notes.push_back(
        fmt::format("the store holds {} images; {} was taken; choose by series", count, inQuotes(images.front().name)));
  return store->open(images.front().key, std::move(notes));
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
    return openImage(path, image)->facts().isLabels;
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

}  // namespace velum::io
