#pragma once
#include "app/Text.h"
#include "scene/Source.h"

namespace velum::app {

/// What is known of a store of chunked voxels without reading any of them: all levels and how they are stored.
/// @throw InputError
Json describeStore(const scene::Source& source);

}  // namespace velum::app
