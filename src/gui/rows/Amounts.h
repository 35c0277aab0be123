#pragma once
#include <QString>

#include "core/Units.h"

namespace velum::gui {

/// A measured volume and area in the unit that people use for so much of it: "1650 ml", "523 \u00b5m\u00b3".
/// @param volume  in cubed units of length  @param area  in squared ones
QString volumeText(double volume, LengthUnit unit);
QString areaText(double area, LengthUnit unit);

}  // namespace velum::gui
