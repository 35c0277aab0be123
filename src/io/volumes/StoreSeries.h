#pragma once
#include <optional>
#include <string>
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/ReadVolume.h"

namespace velum::io {

/// The images and labels in a store, as listSeries() lists them. @throw InputError, Cancelled
std::vector<SeriesInfo> seriesInStore(const Path& path, Progress& progress);

/// An image in a store.
struct StorePlace {
  Path store;
  std::string key;  ///< empty: the first
};

/// What a path means that leads to an image in a store: into a folder of it, or, of a file, further than there are
/// folders. Nothing where it leads into no store.
std::optional<StorePlace> placeInStore(const Path& path);

/// The middle plane of an image in a store, at its coarsest level. @throw InputError, Cancelled
Volume readStorePicture(const StorePlace& place, Progress& progress);

}  // namespace velum::io
