#pragma once
#include <QString>

#include "core/Units.h"

namespace velum::gui {

/// A measured volume or area as text, in the unit that people use for an amount of that size: "1650 ml", "523
/// \u00b5m\u00b3".
/// @param volume  in cubed units of length  @param area  in squared units of length
QString volumeText(double volume, LengthUnit unit);
QString areaText(double area, LengthUnit unit);

}  // namespace velum::gui
