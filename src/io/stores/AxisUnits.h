#pragma once
#include <optional>
#include <string_view>

/// The units of axes in OME-Zarr, by their names in UDUNITS-2.
namespace velum::io {

/// Millimetres of a unit of length; none for a name that is no unit of length.
std::optional<double> millimetresOf(std::string_view unit);
/// Seconds of a unit of time; none for a name that is no unit of time.
std::optional<double> secondsPer(std::string_view unit);
bool isAngstrom(std::string_view unit);

}  // namespace velum::io
