#pragma once
#include <string>

#include "scene/SceneFwd.h"

namespace velum::session {

/// A number that was measured, in the unit of tables: "mm", "mm\u00b2", "mm\u00b3", or those of um or nm where the data
/// are finer or are molecules; "voxels" where nobody knows how long a voxel is.
struct Quantity {
  std::string name;  ///< "length", "angle", "area", "volume", "surface", "share", "voxels", "mean", "deviation",
                     ///< "least", "most"
  double value = 0.0;
  std::string unit;  ///< UTF-8; empty: none, or not known
  int decimals = 0;  ///< behind the point, as the data's resolution justifies; below zero: tens, hundreds
  bool operator==(const Quantity&) const = default;
};
/// "23.4 mm", "12.3 ml", "37.5\u00b0", "1,204 voxels": in the unit that people use for so much of it, with no more
/// digits than are justified, five at most.
std::string quantityText(const Quantity& quantity);
/// The number of quantityText() in the quantity's own unit, for tables: a digit more than is justified, so that sums of
/// rows lose nothing.
std::string quantityNumber(const Quantity& quantity);

/// How lengths, areas and volumes of a scene are told.
struct Telling {
  std::string unit = "mm";
  double perLength = 1.0;   ///< factor from the scene's unit to the one that is told
  double resolution = 0.1;  ///< how well places are known: a tenth of the finest voxel, or of an angstrom; told unit
};
Telling tellingOf(const scene::Scene& scene);

// Of scene units, their squares and cubes. What a line, a border or a surface encloses is as uncertain as that is long.
Quantity lengthQuantity(const Telling& telling, double length);
Quantity areaQuantity(const Telling& telling, double area);
Quantity volumeQuantity(const Telling& telling, double volume);
/// @param shortest  arm of the angle, scene units
Quantity angleQuantity(const Telling& telling, double degrees, double shortest);

}  // namespace velum::session
