#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"

namespace velum::io {

/// One row of the table of formats that labels are written in.
struct LabelFormat {
  std::string_view name;        ///< "DICOM segmentation"
  std::string_view extensions;  ///< ".nii.gz .nii", the usual one first.
};
/// For file dialogs, `--help` and the docs.
std::span<const LabelFormat> labelFormats();

/// Whether the extension of a path is that of a format of labels.
bool isLabelFormat(const std::filesystem::path& path);
/// Checks, before the labels are made, that their path has an extension that can be written. @throw InputError when the
/// extension is unknown
void expectLabelFormat(const std::filesystem::path& path);

/// Writes labels with names, colours and opacities, by extension: .seg.nrrd or .nrrd (3D Slicer's segments), .nii.gz or
/// .nii (Caret's table), both uint8 when ids fit, else uint16; .dcm (DICOM segmentation); .zarr and .ozx
/// as writeStore() does.
/// @return what the format could not hold, one line each, for people
/// @throw InputError when the extension is not one of these, the format cannot hold the labels, or the disk refuses;
/// Cancelled
std::vector<std::string> writeLabels(const LabelVolume& labels, const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
