#pragma once
#include <filesystem>

namespace velum::io {

/// Walks over the elements of a DICOM file and checks that every length lies within the file. GDCM allocates what an
/// element claims before it reads, so that four bytes could ask for four gigabytes. Files in a syntax that cannot be
/// walked (deflated) pass, for their claims are bound by what inflates.
bool dicomLengthsFit(const std::filesystem::path& path);

}  // namespace velum::io
