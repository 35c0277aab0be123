#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"

namespace velum::io {

/// The format of a volume that is to be written, before there is one. @throw InputError when the extension is unknown
void expectVolumeFormat(const std::filesystem::path& path);

/// Writes .nrrd, .nii, .nii.gz, .vti or .vdb, by extension; to a temporary beside it, then renamed. Orientation,
/// spacing, scale and offset survive (VDB: values as floats, or as doubles where floats do not hold them; all else
/// exactly the raw samples).
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the format cannot hold the volume, or the disk refuses
std::vector<std::string> writeVolume(const Volume& volume, const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
