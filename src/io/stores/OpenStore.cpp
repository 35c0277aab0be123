#include "io/stores/OpenStore.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/Error.h"
#include "io/read/Refuse.h"

namespace velum::io {

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

bool holdsLabels(const Path& path, const std::string& image) {
  if (!isStore(path)) return false;
  try {
    return openImage(path, image)->facts().isLabels;
  } catch (const InputError&) {
    return false;  // the reader will say what is wrong
  }
}

}  // namespace velum::io
