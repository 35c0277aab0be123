#pragma once
#include <filesystem>

namespace velum::io {

/// A cheap test before GDCM reads a file, so that a folder of other files costs next to nothing.
bool mayBeDicom(const std::filesystem::path& path);

/// Walks over the elements of a DICOM file, up to its pixels, and checks that it is built as the standard says: known
/// value representations, lengths within their surroundings, delimiters where they belong. GDCM must not read files
/// that fail this check: it allocates the size that an element claims before it reads, so that four bytes could ask for
/// four gigabytes, and Debian builds it with assertions, so that a misplaced delimiter ends the program.
bool isSoundDicom(const std::filesystem::path& path);

}  // namespace velum::io
