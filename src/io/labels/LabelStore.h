#pragma once
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "io/stores/WriteStore.h"

namespace velum::io {

/// Writes labels as a store, with names and colours and the ids of the file that they come from (LabelInfo::fileId), as
/// writeStore() does. @throw InputError, Cancelled
std::vector<std::string> writeLabelStore(const LabelVolume& labels, const Path& path, OmeVersion version,
                                         Progress& progress);

}  // namespace velum::io
