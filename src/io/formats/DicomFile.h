#pragma once
#include <filesystem>

namespace velum::io {

/// True when the file is a DICOM segmentation. Reads its header only; false for what is no DICOM file.
bool isDicomSeg(const std::filesystem::path& path);

}  // namespace velum::io
