#pragma once
#include <nlohmann/json_fwd.hpp>

#include "io/read/JsonParts.h"
#include "io/stores/ZarrArray.h"

/// The codecs that the metadata of Zarr names.
namespace velum::io {

/// Fills codecs and packing of an array of version 2. @throw InputError
void readCompressor(ZarrArray& array, const Json& metadata, const Path& path);

/// Fills brick, order, codecs, shard, byte order and packing of an array of version 3, whose shape, chunk and type are
/// known. @throw InputError
void readCodecs(ZarrArray& array, const Json& codecs, const Path& path);

/// A list of sizes, each from 1 to 2^62. @param what  for messages @throw InputError
std::vector<std::uint64_t> sizesOf(const Json& value, const Path& path, std::string_view what);

/// The name of an extension, which is a bare word or an object with a name; empty where it is neither.
std::string extensionName(const Json& value);

}  // namespace velum::io
