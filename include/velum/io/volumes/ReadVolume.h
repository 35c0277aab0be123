#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "velum/core/LabelVolume.h"
#include "velum/core/Mesh.h"
#include "velum/core/Task.h"
#include "velum/core/Volume.h"
#include "velum/scene/Source.h"

namespace velum::io {

/// One DICOM series found in a folder.
struct SeriesInfo {
  std::string uid;
  std::string description;
  std::string modality;  ///< DICOM code: "CT", "MR", "SEG", ...
  int imageCount = 0;    ///< Slices, or frames of a multi-frame file.
  glm::ivec2 size{0};    ///< Columns, rows.
  bool operator==(const SeriesInfo&) const = default;
};

/// The DICOM series in a folder (or in the folder of a file), largest first. Empty when there is none.
/// Reads headers only. Any thread. @throw InputError when the path does not exist; Cancelled
std::vector<SeriesInfo> listSeries(const std::filesystem::path& path, Progress& progress);

/// Reads a volume: DICOM, NIfTI, NRRD, MetaImage, MRC, VTI, VTK structured points, SEG-Y, TIFF, .vdb, raw.
///
/// Orientation, spacing, rescale and modality are those of the file, in the frame of Volume. What the reader had to
/// assume stands in Volume::warnings. Nothing is allocated that the file's own size cannot justify.
/// @param source  path and how to read it; the path is used as it is
/// @throw InputError for a file that is missing, damaged or not supported, naming the file and the reason; Cancelled
/// @note Any thread. Peak memory at most 2.2 times the voxels.
Volume readVolume(const scene::Source& source, Progress& progress);

/// Reads a label volume: any integer volume format, 3D Slicer .seg.nrrd, DICOM SEG. Names and colours come from the
/// file (Slicer segments, TotalSegmentator's NIfTI extension, DICOM segments) or from a table beside it with the same
/// stem (.txt, .ctbl, .label, .lut), else are made up.
/// @throw InputError as readVolume; also when values are not whole numbers in 0..65535
LabelVolume readLabels(const scene::Source& source, Progress& progress);

/// Reads names and colours: ITK-SNAP label description, 3D Slicer .ctbl/.txt colour table, MRIcron "id name" text.
/// @throw InputError when no line can be used
std::vector<LabelInfo> readLabelTable(const std::filesystem::path& path);

/// True when the file is meant as labels: .seg.nrrd, DICOM SEG, NIfTI with a label intent or label extension, or a
/// name that says so ("labels", "seg", "mask"). Looks at the header only.
bool looksLikeLabels(const std::filesystem::path& path);

/// Reads a surface: STL, PLY, OBJ, VTP. @throw InputError
Mesh readMesh(const std::filesystem::path& path, Progress& progress);

}  // namespace velum::io
