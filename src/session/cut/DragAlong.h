#pragma once
#include <glm/glm.hpp>

#include "session/ViewSpace.h"

namespace velum::session {

/// How far a drag of the pointer goes along a line through a place, so that what is dragged stays under the pointer.
/// Where the line points at the eye, the drag's height counts: pulling down pulls towards the eye. On a section the
/// part of the line within the section's plane counts.
/// @param from, to   pixels of the view
/// @param direction  of the line: unit, world
/// @return length, scene units
double dragAlong(const ViewSpace& space, glm::dvec2 from, glm::dvec2 to, glm::dvec3 place, glm::dvec3 direction);

}  // namespace velum::session
