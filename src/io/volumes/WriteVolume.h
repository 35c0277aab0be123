#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"

namespace velum::io {

/// Checks, before the volume is made, that its path has an extension that can be written. @throw InputError when the
/// extension is unknown
void expectVolumeFormat(const std::filesystem::path& path);

/// Writes .nrrd, .nii, .nii.gz, .vti, .vdb, .zarr (a folder) or .ozx, by extension; to a temporary beside it, then
/// renamed; stores as writeStore() does. Orientation,
/// spacing, scale and offset survive. VDB gets the values as floats, or as doubles where floats do not hold them; all
/// other formats get exactly the raw samples.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the format cannot hold the volume, or the disk refuses
std::vector<std::string> writeVolume(const Volume& volume, const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
