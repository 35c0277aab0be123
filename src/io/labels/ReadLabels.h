#pragma once
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Source.h"

namespace velum::io {

/// The grid of the scan that labels are of.
struct LabelGrid {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};
  LengthUnit unit = LengthUnit::Millimetre;
};

/// Reads a label volume: any integer volume format, 3D Slicer .seg.nrrd, DICOM SEG; of a folder that holds DICOM
/// segmentations and no images the largest. Names and colours come from the file (Slicer segments, TotalSegmentator's
/// NIfTI extension, DICOM segments) or from a table beside it with the same stem (.txt, .ctbl, .label, .lut), else are
/// made up.
/// @param scan  whose place labels of its dimensions take where their file says none (TIFF, raw samples, NIfTI without
/// forms): no spacing, or that of a default or of the scan, and neither axes nor origin; others lie where it says
/// @throw InputError as readVolume; also when values are not whole numbers in 0..65535
LabelVolume readLabels(const scene::Source& source, Progress& progress,
                       const std::optional<LabelGrid>& scan = std::nullopt);

/// Reads names and colours: ITK-SNAP label description, 3D Slicer .ctbl/.txt colour table, MRIcron "id name" text.
/// @throw InputError when no line can be used
std::vector<LabelInfo> readLabelTable(const std::filesystem::path& path);

/// True when the file may be meant as labels: .seg.nrrd, DICOM SEG, a folder of these without images, NIfTI with a
/// label intent or label extension, or a name that says so ("labels", "seg", "mask"). Looks at headers only: of the
/// last two readVoxels() knows better.
bool looksLikeLabels(const std::filesystem::path& path);

/// Reads what the file holds. DICOM SEG and .seg.nrrd are labels. What only a name or an intent calls labels is so if
/// its values are, too: whole numbers in 0..65535, and most neighbours of one structure have the same. Without any such
/// hint a few whole numbers in areas are labels.
/// @throw InputError as readVolume and readLabels; Cancelled
std::variant<Volume, LabelVolume> readVoxels(const scene::Source& source, Progress& progress);

}  // namespace velum::io
