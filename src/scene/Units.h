#pragma once
#include <string>
#include <string_view>

#include "core/Units.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// Multiplies every length of a scene by the factor, and divides every quantity per length by it: for the same picture
/// in another unit, or of data enlarged by the factor. The data themselves are not changed.
void scaleLengths(Scene& scene, double factor);

/// How lengths are shown to people: in a unit, and with as many decimals, as suit the fineness of the data.
struct LengthFormat {
  LengthUnit unit = LengthUnit::Millimetre;  ///< of the scene, and of the lengths that are given
  std::string_view symbol = "mm";            ///< of the unit that is shown: for data finer than 20 um that is um or nm
  double toldPerLength = 1.0;                ///< factor that turns a length into the shown unit
  int decimals = 1;                          ///< down to a tenth of a voxel, about
  bool operator==(const LengthFormat&) const = default;
};
LengthFormat lengthFormat(const Scene& scene);

/// A length as "12.3", in UTF-8 as all these texts; lengths that round to zero have no sign. @param isSigned  "+12.3"
std::string lengthNumber(const LengthFormat& format, double length, bool isSigned = false);
/// "12.3 mm".
std::string lengthText(const LengthFormat& format, double length, bool isSigned = false);

/// A round length in the unit that people use for so much of it: "50 \u00b5m", "2 km", "5 nm".
std::string roundLengthText(double length, LengthUnit unit);

}  // namespace velum::scene
