#pragma once
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/ReadVolume.h"

namespace velum::io {

/// The images and labels in a store, as listSeries() lists them. @throw InputError, Cancelled
std::vector<SeriesInfo> seriesInStore(const Path& path, Progress& progress);

/// The middle plane of an image in a store, at its coarsest level. @param key  empty: of the first
/// @throw InputError, Cancelled
Volume readStorePicture(const Path& path, const std::string& key, Progress& progress);

}  // namespace velum::io
