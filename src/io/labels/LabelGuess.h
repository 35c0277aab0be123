#pragma once
#include <filesystem>

#include "core/Volume.h"

/// Whether a file that does not say so holds labels.
namespace velum::io {

/// Values so near to a whole number are it: what scales in single precision leave.
inline constexpr double kWhole = 1e-3;

/// Values that can be ids, and areas of one id: of two neighbours along a row, both of them something, most are the
/// same. Of scans few are, as their values have noise.
bool holdsAreasOfIds(const Volume& v);

/// Without any hint: few whole numbers, counted from one with hardly a gap, in areas with hardly an edge, and nothing
/// that scanners write. What has only one number may as well be a shape that somebody has drawn.
bool holdsNothingButIds(const Volume& v);

/// The name has one of the words that people use.
bool nameSaysLabels(const std::filesystem::path& path);

}  // namespace velum::io
