#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/Task.h"
#include "core/Volume.h"
#include "scene/Source.h"

namespace velum::io {

/// One DICOM series found in a folder.
struct SeriesInfo {
  std::string uid;
  std::string description;
  std::string modality;  ///< DICOM code: "CT", "MR", "SEG", ...
  int imageCount = 0;    ///< Sections, or frames of a multi-frame file.
  glm::ivec2 size{0};    ///< Columns, rows.
  std::string date;      ///< "2024-03-15"; empty when unknown.
  bool isSegmentation = false;
  std::string referencedSeries;  ///< For a segmentation: UID of the series that was segmented; empty when unknown.
  /// File of the image in the middle of the series; for a multi-frame file the file itself.
  std::filesystem::path middleFile;
  bool operator==(const SeriesInfo&) const = default;
};

/// The DICOM series in a folder and all folders below it (or in the folder of a DICOM file; for an index, DICOMDIR, in
/// its folder and all folders below), largest first. Empty when there are none. Reads headers only. Any thread. @throw
/// InputError when the path does not exist; Cancelled
std::vector<SeriesInfo> listSeries(const std::filesystem::path& path, Progress& progress);

/// The middle image of a series, as a volume of one section, for people to recognise the series by. @throw InputError,
/// Cancelled. Any thread.
Volume readSeriesImage(const SeriesInfo& series, Progress& progress);

/// Reads a volume of any of formats().
///
/// Orientation, spacing, rescale and modality are those of the file, in the frame of Volume. What the reader had to
/// assume is noted in Volume::warnings. No more memory is allocated than the file's own size can justify.
/// @param source  path and how to read it; the path is used as it is
/// @throw InputError for a file that is missing, damaged or not supported, naming the file and the reason; Cancelled
/// @note Any thread. Peak memory at most 2.2 times the voxels.
Volume readVolume(const scene::Source& source, Progress& progress);

}  // namespace velum::io
