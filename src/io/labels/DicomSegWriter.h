#pragma once
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/ReplaceFile.h"
#include "core/Task.h"

namespace velum::io {

/// Writes a binary DICOM segmentation: a segment for each structure of the table that has voxels. Segments are numbered
/// from 1, as DICOM requires; the structure's own id is kept as tracking id. The first segment has all planes, so that
/// the whole grid is known; the others have only planes that hold some of their voxels. No patient is named.
/// @return what the file could not hold, one line each @throw InputError where the grid's axes are not at right angles,
/// its lengths are no millimetres, or nothing is labelled; Cancelled. The caller commits.
std::vector<std::string> writeDicomSeg(const LabelVolume& labels, ReplaceFile& file, Progress& progress);

}  // namespace velum::io
