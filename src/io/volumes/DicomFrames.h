#pragma once
#include <vector>

#include "io/volumes/DicomFile.h"

namespace gdcm {
class DataSet;
}

namespace velum::io {

/// The planes of a file: where they lie and what their samples mean.
/// @param[in,out] file  whose modality, table and samples per pixel are known; gets warnings of what had to be assumed,
/// and its flaw
std::vector<DicomFrame> dicomFramesOf(const gdcm::DataSet& set, DicomFile& file, int count);

}  // namespace velum::io
