#pragma once
#include <vector>

#include "io/read/Refuse.h"
#include "io/volumes/ReadVolume.h"

namespace velum::io {

/// The images and labels in a store, as listSeries() lists them. @throw InputError, Cancelled
std::vector<SeriesInfo> seriesInStore(const Path& path, Progress& progress);

/// The middle plane of the first image in a store, at its coarsest level. @throw InputError, Cancelled
Volume readStorePicture(const Path& path, Progress& progress);

}  // namespace velum::io
