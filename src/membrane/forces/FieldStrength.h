#pragma once
#include <cstdint>

#include "scene/Membrane.h"

namespace velum::membrane {

/// The largest strength above 0 (repelling) in a field; 0 when nothing repels.
double strongestOf(const scene::ForceField& field);
/// True when everything in the field that repels has the same strength.
bool isAlike(const scene::ForceField& field);
/// True when something in the field attracts the sheet.
bool attracts(const scene::ForceField& field);

/// The weight, see ProtectedVoxels::weight, of a strength in a field whose largest strength is `strongest`.
std::uint8_t weightOf(double strength, double strongest);

}  // namespace velum::membrane
