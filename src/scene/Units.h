#pragma once
#include <string>
#include <string_view>

#include "core/Units.h"
#include "scene/SceneFwd.h"

namespace velum::scene {

/// Multiplies every length of a scene, and divides what is per length: the same picture in another unit, or of a copy
/// of the data that is so much larger. Data that the scene holds stay as they are.
void scaleLengths(Scene& scene, double factor);

/// How lengths are told to people: in the unit that suits how fine the data is, with as many decimals.
struct LengthFormat {
  LengthUnit unit = LengthUnit::Millimetre;  ///< of the scene, and of the lengths that are given
  std::string_view symbol = "mm";            ///< of the unit that is told: data finer than 20 um are told in um or nm
  double toldPerLength = 1.0;                ///< what a length is multiplied with to be in it
  int decimals = 1;                          ///< down to a tenth of a voxel, about
  bool operator==(const LengthFormat&) const = default;
};
LengthFormat lengthFormat(const Scene& scene);

/// "12.3", UTF-8 as all of these; what rounds to zero has no sign. @param isSigned  "+12.3"
std::string lengthNumber(const LengthFormat& format, double length, bool isSigned = false);
/// "12.3 mm".
std::string lengthText(const LengthFormat& format, double length, bool isSigned = false);

}  // namespace velum::scene
