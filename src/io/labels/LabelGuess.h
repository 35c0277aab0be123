#pragma once
#include <filesystem>

#include "core/Volume.h"

/// Guesses whether a file that does not say so holds labels.
namespace velum::io {

/// Values this near to a whole number count as whole: scales in single precision leave such differences.
inline constexpr double kWhole = 1e-3;

/// True when all values can be ids (whole numbers from 0 on, of at most 16 bits if they are not stored as such) and lie
/// in areas of one id: most pairs of neighbours along a row, both not 0, have equal values. In scans few pairs do, as
/// their values have noise.
bool holdsAreasOfIds(const Volume& v);

/// For files without any hint: true when the values are few whole numbers, counted from one with hardly a gap, in areas
/// with hardly an edge, and the file has nothing that scanners write. A file with only one number may as well be a
/// shape that somebody has drawn.
bool holdsNothingButIds(const Volume& v);

/// True when the file's name has one of the words by which people call labels.
bool nameSaysLabels(const std::filesystem::path& path);

}  // namespace velum::io
