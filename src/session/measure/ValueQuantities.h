#pragma once
#include <glm/glm.hpp>
#include <string>

#include "core/Volume.h"
#include "session/measure/Measure.h"
#include "session/structure/StructureValues.h"

namespace velum::session {

/// A value of a volume, with as many decimals as its values have: whole numbers by their scale, others by how far they
/// reach. @param range  of what was measured
Quantity valueQuantity(const Volume& volume, std::string name, double value, glm::dvec2 range);
/// The same of a mean of values, which is known a digit better.
Quantity meanQuantity(const Volume& volume, std::string name, double value, glm::dvec2 range);
/// quantityText() without the unit.
std::string bareText(Quantity quantity);

/// Adds what is known of values to quantities and text: "mean 41.2 HU \u00b1 8.3", then their range, then how many
/// voxels.
void addValues(Measured& measured, const Volume& volume, const StructureValues& values);

}  // namespace velum::session
