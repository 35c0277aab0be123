#pragma once
#include <nlohmann/json_fwd.hpp>

#include "core/Volume.h"
#include "io/read/JsonParts.h"

/// What OME-Zarr has no words for and we keep in an attribute of the image, `velum`: how a volume is turned, what its
/// samples mean.
namespace velum::io {

Json describeOwn(const Volume& head);

/// Takes what the attribute says into a head that was read from a store. One that does not fit the store's own scales
/// was overtaken by another program, and is left out.
void applyOwn(const Json& own, Volume& head);

}  // namespace velum::io
