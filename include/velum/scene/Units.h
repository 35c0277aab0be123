#pragma once
#include <string>

#include "velum/scene/Scene.h"

namespace velum::scene {

/// Multiplies every length of a scene, and divides what is per length: the same picture in another unit, or of a copy
/// of the data that is so much larger. Data that the scene holds stay as they are.
void scaleLengths(Scene& scene, double factor);

/// How lengths are told to people: in the scene's unit, with as many decimals as its data is fine.
struct LengthFormat {
  LengthUnit unit = LengthUnit::Millimetre;
  int decimals = 1;  ///< down to a tenth of a voxel, about
  bool operator==(const LengthFormat&) const = default;
};
LengthFormat lengthFormat(const Scene& scene);

/// "12.3", UTF-8 as all of these; what rounds to zero has no sign. @param isSigned  "+12.3"
std::string lengthNumber(const LengthFormat& format, double length, bool isSigned = false);
/// "12.3 mm".
std::string lengthText(const LengthFormat& format, double length, bool isSigned = false);

}  // namespace velum::scene
