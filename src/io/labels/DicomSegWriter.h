#pragma once
#include <string>
#include <vector>

#include "core/LabelVolume.h"
#include "core/ReplaceFile.h"
#include "core/Task.h"

namespace velum::io {

/// A DICOM segmentation, binary: a segment for each structure of the table that has voxels, numbered from 1 as DICOM
/// wants it, with its own number as tracking id. The first one has all planes, so that the grid is known whole; others
/// have those in which they are. Of no patient.
/// @return what it could not hold  @throw InputError where the grid's axes are not at right angles, its lengths are no
/// millimetres, or nothing is labelled; Cancelled. The caller commits.
std::vector<std::string> writeDicomSeg(const LabelVolume& labels, ReplaceFile& file, Progress& progress);

}  // namespace velum::io
