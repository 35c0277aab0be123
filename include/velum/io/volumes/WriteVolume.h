#pragma once
#include <filesystem>

#include "velum/core/LabelVolume.h"
#include "velum/core/Task.h"
#include "velum/core/Volume.h"

namespace velum::io {

/// Writes .nrrd, .nii, .nii.gz, .vti or .vdb, by extension; to a temporary beside it, then renamed. Orientation,
/// spacing, scale and offset survive (VDB: float values, all else exactly the raw samples).
/// @throw InputError when the extension is not one of these, the format cannot hold the volume, or the disk refuses
void writeVolume(const Volume& volume, const std::filesystem::path& path, Progress& progress);

/// Writes labels as .nrrd (.seg.nrrd: with segment names and colours) or .nii(.gz), uint8 when they fit, else uint16,
/// with the table beside it as .txt (3D Slicer colour table) where the format has no place for it.
void writeLabels(const LabelVolume& labels, const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
