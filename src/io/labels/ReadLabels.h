#pragma once
#include <filesystem>
#include <optional>
#include <variant>
#include <vector>

#include "core/LabelVolume.h"
#include "core/Task.h"
#include "core/Volume.h"
#include "io/labels/LabelGrid.h"
#include "io/labels/LabelNumbers.h"
#include "scene/Source.h"

namespace velum::io {

/// Reads a label volume: any integer volume format, 3D Slicer .seg.nrrd, DICOM SEG; of a folder that holds DICOM
/// segmentations and no images, the largest segmentation. Names and colours come from the file (Slicer segments,
/// TotalSegmentator's NIfTI extension, DICOM segments) or from a table beside it with the same stem (.txt, .ctbl,
/// .label, .lut), else are made up.
///
/// Ids of more than 16 bits become others (LabelInfo::fileId, LabelNumbers). Stores, and files that are larger than
/// wholeBudget() and can be read piece by piece, are read brick by brick (readLabelBricks()): at the finest level that
/// fits into labelBudget(), or at the one that the source asks for.
/// @param scan  labels of the same dimensions are placed on this grid where their own file gives no place (TIFF, raw
/// samples, NIfTI without forms): neither axes nor origin, and no spacing, a default one, or that of the scan. Other
/// labels lie where their file says
/// @param known  ids that a scene has for those of the file
/// @throw InputError as readVolume; also when values are not whole numbers from 0 on
LabelVolume readLabels(const scene::Source& source, Progress& progress,
                       const std::optional<LabelGrid>& scan = std::nullopt, const KnownIds& known = {});

/// Bytes that bricks of labels may take: what bricks of a streamed volume may (brickBudget()), or, where that is more,
/// what a volume takes that is read whole.
double labelBudget();

/// Reads names and colours: ITK-SNAP label description, 3D Slicer .ctbl/.txt colour table, MRIcron "id name" text.
/// @throw InputError when no line can be used
std::vector<LabelInfo> readLabelTable(const std::filesystem::path& path);

/// True when the file may be meant as labels: .seg.nrrd, DICOM SEG, a folder of DICOM SEG files without images, NIfTI
/// with a label intent or label extension, or a name that says so ("labels", "seg", "mask"). Looks at headers only;
/// readVoxels(), which looks at the values, may find that a NIfTI file or a file with such a name holds no labels.
bool looksLikeLabels(const std::filesystem::path& path);

/// Reads a file as a volume or as labels, whichever it holds. DICOM SEG and .seg.nrrd are labels. A file that only its
/// name or an intent calls labels is taken as labels if its values fit: whole numbers from 0 on, most of them equal
/// to their neighbour's (holdsAreasOfIds()). A file without any such hint is labels if it has few whole numbers, in
/// areas (holdsNothingButIds()).
/// @throw InputError as readVolume and readLabels; Cancelled
std::variant<Volume, LabelVolume> readVoxels(const scene::Source& source, Progress& progress);

}  // namespace velum::io
