#pragma once
#include <memory>

#include "core/VoxelSource.h"
#include "scene/Source.h"

namespace velum::io {

/// Volumes with fewer bytes of voxels than this are read whole by whoever may choose: then their range is known, and
/// whether they hold labels.
inline constexpr double kLargeVolumeBytes = 64 << 20;

/// Opens the file of a volume to read its voxels brick by brick: NRRD, MetaImage, NIfTI and MRC whose samples lie in it
/// as they are, headerless files of a given layout, and TIFF. Headers are read, and no voxel. The head says what
/// readVolume() says, but the range.
/// @return null where the file can only be read whole, as readVolume() does: samples that are packed as one, integers
/// of 64 bits, other formats
/// @throw InputError for a file that is missing, damaged or cut short. Any thread.
std::unique_ptr<VoxelSource> openSource(const scene::Source& source);

/// The same for a volume that is too large to be read whole without need; null for all others.
std::unique_ptr<VoxelSource> openLargeSource(const scene::Source& source);

}  // namespace velum::io
