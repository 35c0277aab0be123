#pragma once
#include <memory>

#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::io {

/// Opens a TIFF file as a source; null where its pages can only be read whole: palettes, samples that are no whole
/// bytes, colours that must be converted. @throw InputError
std::unique_ptr<VoxelSource> openTiff(const scene::Source& source);

}  // namespace velum::io
