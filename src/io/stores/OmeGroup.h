#pragma once
#include <nlohmann/json_fwd.hpp>

#include "io/read/JsonParts.h"
#include "io/stores/Store.h"

namespace velum::io {

/// What OME-Zarr keeps at a group: of Zarr 3 the attribute `ome`, of Zarr 2 all attributes; null where there is no
/// group of that key. @throw InputError for damaged metadata
Json omeAttributes(const Store& store, const std::string& key);

/// All attributes of a group; null where it has none. @throw InputError for damaged metadata
Json attributesOf(const Store& store, const std::string& key);

/// The file with these attributes, for messages.
Path omePath(const Store& store, const std::string& key);

}  // namespace velum::io
